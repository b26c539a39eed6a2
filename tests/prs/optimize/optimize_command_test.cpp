#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "support/processes.h"
#include "tests/prs/input/abevi.h"
#include "tests/support/program.h"
#include "tests/support/temporary_directory.h"
#include "yao_file.h"

namespace prs {
namespace {

using test::Outcome;

namespace fs = std::filesystem;
using nlohmann::json;
using test::content_of;
using test::files_in;
using testing::HasSubstr;
using testing::StartsWith;

const std::string kPressures =
    "  objectives:\n"
    "    - {minimize: screw.peak_pressure_MPa.max}\n"
    "    - {minimize: nut.peak_pressure_MPa.max}\n";

class OptimizeCommand : public testing::Test {
 protected:
  void write(const std::string& optimize) const {
    std::ofstream(file) << test::yao_mechanism() << test::yao_optimize(optimize);
  }
  Outcome prs(const std::string& arguments, const std::string& before = "") const {
    return test::run_prs(arguments, ".", before);
  }
  std::string optimize(const std::string& more = "") const { return "optimize '" + file.string() + "' " + more; }
  std::string into(const fs::path& output, const std::string& more = "") const {
    return optimize("--quiet --output '" + output.string() + "' " + more);
  }

  const test::TemporaryDirectory temporary;
  const fs::path file = temporary.path() / "case.yaml";
};

TEST_F(OptimizeCommand, FindsYaosOptimum) {
  // Section 4.1: 25 generations of 20 designs lower the contact stresses by 7.45 and 8.04 %.
  write(kPressures + "  thread_constraints: true\n  check: moead\n  population: 20\n  generations: 25");
  const Outcome run = prs(optimize("--json"));
  ASSERT_EQ(run.status, 0) << run.err;
  const json result = json::parse(run.out);
  EXPECT_TRUE(result["initial"]["feasible"]);
  const json& change = result["compromise"]["change_percent"];
  EXPECT_LT(change["screw.peak_pressure_MPa.max"], -7.0);
  EXPECT_LT(change["nut.peak_pressure_MPa.max"], -7.0);
  ASSERT_EQ(result["compromise"]["constraints"].size(), 12);
  for (const json& constraint : result["compromise"]["constraints"]) EXPECT_TRUE(constraint["satisfied"]) << constraint;
  EXPECT_EQ(result["search"]["designs"], 500);
  // Both searches find the same pressures.
  for (const json& best : result["comparison"]["best"])
    EXPECT_NEAR(best["difference_percent"].get<double>(), 0.0, 1.0) << best;
}

/// A force off the axis cancels a moment: at (y, z) = (-M_z, M_y)/F the screw carries as if aligned.
TEST_F(OptimizeCommand, AForceOffTheAxisUndoesAMoment) {
  const std::string lesson = test::content_of(fs::path(PRS_SOURCE_DIR) / "configs/25_side_load.yaml");
  std::string text = lesson.substr(0, lesson.find("load_cases:"));
  text.replace(text.find("rollers: 11"), 11, "rollers: 5");
  text.replace(text.find("contacts_per_roller: 20"), 23, "contacts_per_roller: 4");
  std::ofstream(file) << text
                      << "load_cases:\n"
                         "  - {name: bent, axial_force: 9 kN, direction: tension, position: 29.1666667 mm,\n"
                         "     moment: {y: 6 N m, z: 9 N m}}\n"
                         "optimize:\n"
                         "  command: solve\n"
                         "  variables:\n"
                         "    - {path: 'load_cases[0].eccentricity.y', from: -2 mm, to: 2 mm}\n"
                         "    - {path: 'load_cases[0].eccentricity.z', from: -2 mm, to: 2 mm}\n"
                         "  objectives:\n"
                         "    - {minimize: screw.overload_factor}\n"
                         "  algorithm: sade\n  population: 12\n  generations: 60\n";
  const Outcome run = prs(optimize("--json"));
  ASSERT_EQ(run.status, 0) << run.err;
  const json result = json::parse(run.out);
  EXPECT_GT(result["initial"]["responses"]["screw.overload_factor"].get<double>(), 1.5) << result["initial"];
  const json& best = result["compromise"];
  EXPECT_NEAR(best["responses"]["screw.overload_factor"].get<double>(), 1.0, 1e-3) << best;
}

TEST_F(OptimizeCommand, DesignsAreWhatContactSaysOfThem) {
  write(kPressures + "  population: 8\n  generations: 3");
  const fs::path output = temporary.path() / "o";
  ASSERT_EQ(prs(into(output)).status, 0);
  const json chosen = json::parse(content_of(output / "optimize.json"))["compromise"];
  const std::string best = "contact '" + (output / "best.yaml").string() + "' --json";
  const json result = json::parse(prs(best).out);
  const json& load_case = result["load_cases"][0];
  EXPECT_DOUBLE_EQ(load_case["screw"]["peak_pressure_MPa"][0],
                   chosen["responses"]["screw.peak_pressure_MPa.max"].get<double>());
  EXPECT_DOUBLE_EQ(load_case["nut"]["peak_pressure_MPa"][0],
                   chosen["responses"]["nut.peak_pressure_MPa.max"].get<double>());
  std::string settings;
  for (const json& setting : chosen["set"]) settings += " --set '" + setting.get<std::string>() + "'";
  const json by_settings = json::parse(prs("contact '" + file.string() + "' --json" + settings).out);
  EXPECT_EQ(by_settings["load_cases"], result["load_cases"]);
  // Nothing else changed in the file.
  const std::string text = content_of(output / "best.yaml");
  EXPECT_THAT(text, StartsWith("# Compromise of `prs optimize "));
  EXPECT_THAT(text, HasSubstr("deg}  # these vary\n"));
}

/// The best case reads its history wherever it is written, and keeps its own table of the search beside it.
TEST_F(OptimizeCommand, TheBestCaseFindsItsHistory) {
  const fs::path folder = temporary.path() / "case", output = temporary.path() / "out";
  const std::string lesson = PRS_SOURCE_DIR "/configs/14_flight_spectrum";
  for (const char* name : {"history.csv", "data/loads.csv"}) {
    fs::create_directories((folder / name).parent_path());
    fs::copy_file(lesson + ".csv", folder / name);
    std::string text = content_of(lesson + ".yaml");
    text.replace(text.find("14_flight_spectrum.csv  "), 22, name);
    std::ofstream(folder / "case.yaml") << text << "optimize:\n  command: life\n  population: 8\n  generations: 1\n"
                                        << "  variables: [{path: mechanism.rollers, from: 8, to: 11}]\n"
                                        << "  objectives: [{maximize: life.system.l10_hours}]\n";
    ASSERT_EQ(
        prs("optimize '" + (folder / "case.yaml").string() + "' --quiet --output '" + output.string() + "'").status, 0);
    EXPECT_THAT(content_of(output / "history.csv"), StartsWith("design,algorithm,"));
    const Outcome life = prs("life '" + (output / "best.yaml").string() + "' --json --quiet");
    ASSERT_EQ(life.status, 0) << life.err;
    const json chosen = json::parse(content_of(output / "optimize.json"))["compromise"];
    EXPECT_DOUBLE_EQ(json::parse(life.out)["life"]["system"]["l10_hours"],
                     chosen["responses"]["life.system.l10_hours"].get<double>());
  }
}

TEST_F(OptimizeCommand, FilesDependOnTheSeedNotOnThreads) {
  write(kPressures + "  population: 40\n  generations: 8\n  check: nspso");
  const fs::path one = temporary.path() / "1", three = temporary.path() / "3";
  ASSERT_EQ(prs(into(one, "--threads 1")).status, 0);
  ASSERT_EQ(prs(into(three, "--threads 3")).status, 0);
  const auto files = files_in(one);
  for (const char* name : {"optimize.json", "front.csv", "history.csv", "best.yaml"})
    EXPECT_THAT(files, testing::Contains(testing::Key(name)));
  EXPECT_TRUE(files == files_in(three));
  const fs::path other = temporary.path() / "other";
  ASSERT_EQ(prs(into(other, "--set optimize.seed=2")).status, 0);
  EXPECT_NE(files.at("history.csv"), files_in(other).at("history.csv"));
}

/// Measures under two load cases, by algorithms that request a generation at a time.
TEST_F(OptimizeCommand, ThreadsDoNotMatterWhereLoadCasesAreSolved) {
  std::ofstream(file) << input::kAbevi
                      << "optimize:\n  command: measures\n  variables:\n"
                         "    - {path: deviations.crowning, from: 0 um, to: 20 um}\n"
                         "    - {path: mechanism.flank_angle, from: 40 deg, to: 60 deg}\n"
                         "  objectives: [{minimize: measures.largest_load_rate_percent}]\n"
                         "  constraints: [{response: "
                         "'load_cases[1].measures.largest_load_rate_percent', at_most: {initial: "
                         "1.1}}]\n  algorithm: sade\n  check: cmaes\n  population: 21\n  "
                         "generations: 6\n";
  const fs::path one = temporary.path() / "1", two = temporary.path() / "2";
  ASSERT_EQ(prs(into(one, "--threads 1")).status, 0);
  ASSERT_EQ(prs(into(two, "--threads 2")).status, 0);
  EXPECT_TRUE(files_in(one) == files_in(two));
}

TEST_F(OptimizeCommand, EndsTheSameHoweverOftenItIsStopped) {
  write(kPressures + "  thread_constraints: true\n  population: 100\n  generations: 30");
  const fs::path whole = temporary.path() / "whole", parts = temporary.path() / "parts";
  ASSERT_EQ(prs(into(whole, "--threads 1")).status, 0);
  int stopped = 0;
  for (double patience = 0.03;; patience *= 1.5) {
    const char* signal = stopped % 2 == 0 ? "INT" : "KILL";
    const Outcome run =
        prs(into(parts, "--threads 2"), "timeout --signal=" + std::string(signal) + ' ' + std::to_string(patience));
    if (run.status == 0) break;
    ASSERT_LT(++stopped, 100) << run.err;
  }
  EXPECT_GT(stopped, 0);
  EXPECT_TRUE(files_in(parts) == files_in(whole));
}

TEST_F(OptimizeCommand, AnotherOptimizationDoesNotGoOnWithTheFirst) {
  write(kPressures + "  population: 100\n  generations: 30");
  const fs::path output = temporary.path() / "o";
  fs::create_directory(output);
  std::ofstream(output / "optimize.journal") << "something else";
  EXPECT_EQ(prs(into(output)).status, 2);
  EXPECT_EQ(prs(into(output, "--restart")).status, 0);
  EXPECT_FALSE(fs::exists(output / "optimize.journal"));
}

TEST_F(OptimizeCommand, ErrorsNameWhatAsksForThem) {
  write("  objectives: [{minimize: screw.peak_pressure_GPa.max}]");
  Outcome run = prs(optimize("--json"));
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err, HasSubstr("optimize.objectives[0].minimize: got "
                                 "screw.peak_pressure_GPa.max; expected a number of"));
  EXPECT_THAT(run.err, HasSubstr("did you mean `screw.peak_pressure_MPa.max`?"));
  write("  objectives: [{minimize: screw.peak_pressure_MPa.max}]\n  thread_constraints: true");
  run = prs(optimize("--set mechanism.thread=~"));
  EXPECT_EQ(run.status, 2);
}

TEST_F(OptimizeCommand, WithoutAFeasibleDesignTheStatusIs3) {
  write(kPressures +
        "  constraints: [{response: screw.peak_pressure_MPa.max, at_most: {initial: 0.5}}]\n"
        "  population: 8\n  generations: 3");
  const fs::path output = temporary.path() / "o";
  const Outcome run = prs(optimize("--output '" + output.string() + "'"));
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.out, HasSubstr("No design keeps all constraints"));
  EXPECT_THAT(run.out, HasSubstr("violated: screw.peak_pressure_MPa.max"));
  EXPECT_TRUE(json::parse(content_of(output / "optimize.json")).contains("nearest"));
}

}  // namespace
}  // namespace prs
