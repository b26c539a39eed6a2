// `prs life` as a user runs it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "prs/life/load_history.h"
#include "prs/text.h"
#include "tests/support/program.h"
#include "tests/support/temporary_directory.h"

namespace {

using test::Outcome;

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class LifeCommand : public testing::Test {
 protected:
  test::TemporaryDirectory folder;

  Outcome prs(const std::string& arguments) const { return test::run_prs(arguments); }
};

TEST_F(LifeCommand, WritesWhatItPrints) {
  const fs::path files = folder.path() / "out";
  const Outcome run = prs("life configs/14_flight_spectrum.yaml --output '" + files.string() + "'");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("mechanism, real thread loads"));
  for (const char* name : {"life.json", "life_threads.csv", "cycles.csv", "cycle_matrix.csv", "plots/loads.svg",
                           "plots/rainflow.svg", "plots/thread_lives.svg", "plots/thread_loads.svg"})
    EXPECT_TRUE(fs::exists(files / name)) << name;
  const Outcome json = prs("life configs/14_flight_spectrum.yaml --json --quiet");
  EXPECT_EQ(json.err, "");
  EXPECT_EQ(nlohmann::json::parse(json.out), nlohmann::json::parse(test::content_of(files / "life.json")));
}

/// The lesson's data agree with the heading of its file.
TEST_F(LifeCommand, LessonHasTheDataOfItsHeading) {
  std::vector<double> force;
  double way = 0.0, before = 0.0;
  for (int k = 0; k <= 7200; ++k) {
    const double t = 0.5 * k;
    const auto sine = [t](double period) { return std::sin(2 * M_PI * t / period); };
    const double q = std::min({1.0, t / 300, (3600 - t) / 300});
    const double x = 30 * sine(600) + 12 * sine(47) + 5 * sine(7.3) + 2 * sine(1.9);
    force.push_back(1e3 * (q * (0.30 * x + 4 * sine(3.1) * sine(211) + 2) + 0.8 * std::cos(2 * M_PI * t / 7.3)));
    if (k > 0) way += std::abs(x - before);
    before = x;
  }
  const auto json = nlohmann::json::parse(prs("life configs/14_flight_spectrum.yaml --json").out)["life"];
  // Printed to 0.1 N and 1 um.
  EXPECT_NEAR(json["loads"]["travel_m"].get<double>(), way * 1e-3, 7200e-6);
  EXPECT_NEAR(json["loads"]["largest_force_N"].get<double>(), *std::max_element(force.begin(), force.end()), 0.06);
  EXPECT_NEAR(json["cycles"]["count"].get<double>(), prs::count(prs::rainflow(force, 50.0)), 1.0);
}

TEST_F(LifeCommand, TableHasOneSystemOfUnitsAndFits) {
  const Outcome us = prs("life configs/14_flight_spectrum.yaml --units us");
  for (const char* unit : {" kN", " GPa", " MPa", " mm", " km"})
    EXPECT_EQ(us.out.find(unit), std::string::npos) << unit << us.out;
  EXPECT_THAT(us.out, HasSubstr("roller-screw peak pressure 422 ksi is above 363 ksi"));
  std::istringstream lines(us.out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(prs::width(line), 100u) << line;
}

TEST_F(LifeCommand, MakersScrewsAreNoMeasureOfInvertedOnes) {
  EXPECT_EQ(prs("life configs/14_flight_spectrum.yaml").out.find("maker's"), std::string::npos);
  const std::string standard = prs("life validation/standard_screws/screw_30x10.yaml").out;
  EXPECT_THAT(standard, HasSubstr("by a maker's 23 standard screws"));
  // A spectrum by shares has no number of revolutions.
  EXPECT_EQ(standard.find("spectra"), std::string::npos) << standard;
}

/// Sizes for which a formula or a model was not compared with others are warned of (docs/new_case.md, docs/refined.md).
TEST_F(LifeCommand, SizesBeyondThoseComparedAreNamed) {
  const auto life_of = [&](const std::string& diameter, const std::string& lead) {
    const std::string file = (folder.path() / (diameter + ".yaml")).string();
    const std::string size = " --screw-diameter " + diameter + " --lead " + lead;
    EXPECT_EQ(prs("new standard " + file + size).status, 0);
    const Outcome outcome = prs("life " + file);
    EXPECT_EQ(outcome.status, 0);
    return std::regex_replace(outcome.out, std::regex("\\s+"), " ");
  };
  const std::string smallest = life_of("4mm", "1mm"), fine = life_of("30mm", "2mm"), compared = life_of("25mm", "5mm");
  EXPECT_THAT(smallest, HasSubstr("the capacity was twice the maker's"));
  EXPECT_THAT(smallest, Not(HasSubstr("by a maker's 23 standard screws")));
  EXPECT_THAT(fine, HasSubstr("the pitch is 0.4 mm"));
  EXPECT_THAT(fine, HasSubstr("by a maker's 23 standard screws"));
  for (const char* words : {"twice the maker's", "the pitch is"}) EXPECT_THAT(compared, Not(HasSubstr(words)));
}

/// The film is that of `slip` under the mean load, which for a single load is the load.
TEST_F(LifeCommand, FilmAndDirtGiveTheFactorOfTheStandard) {
  ASSERT_EQ(prs("new standard " + (folder.path() / "a.yaml").string() + " --screw-diameter 25mm --lead 5mm").status, 0);
  const std::string file = (folder.path() / "a.yaml").string();
  const auto life = nlohmann::json::parse(prs("life --set life.contamination=0.5 --json --quiet " + file).out)["life"];
  const auto slip = nlohmann::json::parse(prs("slip --json --quiet " + file).out)["load_cases"][0];
  double film = 1e9, pressure = 0.0;
  for (const char* side : {"screw", "nut"}) {
    for (const double ratio : slip["slip"][side]["film_ratio"]) film = std::min(film, ratio);
    for (const double p : slip[side]["peak_pressure_MPa"]) pressure = std::max(pressure, p);
  }
  const auto& modified = life["modified"];
  EXPECT_NEAR(modified["film_ratio"].get<double>() / film, 1.0, 1e-9);
  EXPECT_NEAR(modified["load_ratio"].get<double>() / std::pow(1500.0 / pressure, 3), 1.0, 1e-9);
  EXPECT_NEAR(modified["system"]["l10_revolutions"].get<double>() /
                  (modified["factor"].get<double>() * life["system"]["l10_revolutions"].get<double>()),
              1.0, 1e-12);
  EXPECT_THAT(prs("life configs/14_flight_spectrum.yaml --set life.contamination=0.5").err,
              HasSubstr("life.contamination: expected `friction`"));
}

/// Under tension the first nut is open; its films are zeros.
TEST_F(LifeCommand, TheFilmOfADoubleNutIsThatOfTheNutThatCarries) {
  const std::string file = (folder.path() / "a.yaml").string();
  ASSERT_EQ(prs("new standard " + file + " --screw-diameter 25mm --lead 5mm").status, 0);
  const std::string of_case = " --json --quiet " + file +
                              " --set 'preload={arrangement: double_nut, force: 100 N, distance: 30 mm, spacer: " +
                              "{length: 4 mm, inner_diameter: 43 mm, outer_diameter: 50 mm}, position: 12 mm, load: "
                              "{from: -10 kN, to: 10 kN}}'";
  const auto life = nlohmann::json::parse(prs("life --set life.contamination=0.5" + of_case).out)["life"];
  const auto loaded = nlohmann::json::parse(prs("slip" + of_case + " --set load_cases[0].direction=tension").out);
  const auto& slip = loaded["load_cases"][0]["slip"];
  double film = 1e9, pressure = 0.0;
  for (const char* side : {"screw", "nut"}) {
    EXPECT_EQ(slip[side]["film_ratio"][0], 0.0);
    for (const double ratio : slip["second_nut"][side]["film_ratio"]) film = std::min(film, ratio);
    for (const double p : loaded["load_cases"][0][side]["peak_pressure_MPa"]) pressure = std::max(pressure, p);
  }
  EXPECT_NEAR(life["modified"]["film_ratio"].get<double>() / film, 1.0, 1e-9);
  EXPECT_NEAR(life["modified"]["load_ratio"].get<double>() / std::pow(1500.0 / pressure, 3), 1.0, 1e-9);
}

TEST_F(LifeCommand, RefusesWhatIsWrongWhereItStands) {
  const std::string lesson = "life configs/14_flight_spectrum.yaml --json ";
  for (const auto& [set, message] : std::initializer_list<std::pair<const char*, const char*>>{
           {"--set life.history.file=missing.csv", "life.history.file: got missing.csv"},
           {"--set life.history.force.unit=mm", "life.history.force.unit: got mm"},
           {"--set life.history.force.column=forc", "did you mean `force_kN`?"},
           {"--set life.position='70 mm'", "life.position"},
           {"--set structure.nut.thrust='{tension: 10 mm}'", "structure.nut.thrust.compression: missing"}}) {
    const Outcome run = prs(lesson + set);
    EXPECT_EQ(run.status, 2) << set;
    EXPECT_EQ(run.out, "") << set;
    EXPECT_THAT(run.err, HasSubstr(message)) << set;
  }
  EXPECT_EQ(prs("life configs/01_config_1_to_3.yaml").status, 2);
}

TEST_F(LifeCommand, OtherCommandsCheckTheBlock) {
  EXPECT_EQ(prs("check configs/14_flight_spectrum.yaml").status, 0);
  EXPECT_EQ(prs("check configs/14_flight_spectrum.yaml --set life.position='70 mm'").status, 2);
}

}  // namespace
