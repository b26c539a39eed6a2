#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/program.h"
#include "tests/support/sanitized.h"
#include "validation/standard_screws/comparison.h"

namespace prs {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;

using ::testing::Ge;
using ::testing::HasSubstr;
using ::testing::Le;
using ::testing::StartsWith;

class NewCase : public testing::Test {
 protected:
  test::TemporaryDirectory folder;

  test::Outcome prs(const std::string& arguments, const std::string& before = "") const {
    return test::run_prs(arguments, folder.path(), before);
  }
  std::string text(const char* file) const { return test::content_of(folder.path() / file); }

  /// Documents of all commands for which the case must have all inputs, each without error.
  nlohmann::json documents(const std::string& file) const {
    nlohmann::json all;
    for (const char* command : {"check", "contact", "solve", "slip", "measures", "life"}) {
      const test::Outcome run = prs(std::string(command) + " " + file + " --json");
      EXPECT_EQ(run.status, 0) << file << " " << command << "\n" << run.err;
      all[command] = nlohmann::json::parse(run.out, nullptr, false);
    }
    return all;
  }

  /// Warnings of commands: none under the load that the case proposes.
  static std::vector<std::string> unusual(const nlohmann::json& documents) {
    std::vector<std::string> found;
    const auto note = [&](const nlohmann::json& warnings) {
      for (const std::string text : warnings) found.push_back(text);
    };
    for (const auto& document : documents) {
      note(document["warnings"]);
      if (document.contains("load_cases"))
        for (const auto& load : document["load_cases"]) note(load["warnings"]);
    }
    return found;
  }
};

const std::string kOf30 = "--screw-diameter 30mm --lead 10mm ";

TEST_F(NewCase, EveryScrewOfACatalogueRunsThroughAllCommandsNearTheMakersNumbers) {
  SKIP_UNDER_SANITIZERS();
  const auto screws = standard_screws::read_catalogue(PRS_SOURCE_DIR "/validation/standard_screws/screws.csv");
  ASSERT_EQ(screws.size(), 24u);
  const auto between = [](double least, double greatest) { return AllOf(Ge(least), Le(greatest)); };
  for (const standard_screws::CatalogueScrew& s : screws) {
    const std::string file = s.name + ".yaml";
    const test::Outcome run =
        prs(fmt::format("new standard {} --screw-diameter {}mm --lead {}mm --starts {} --nut-diameter {}mm "
                        "--nut-length {}mm",
                        file, 1e3 * s.screw.screw_diameter, 1e3 * s.screw.lead, *s.screw.starts,
                        1e3 * *s.screw.nut_diameter, 1e3 * *s.screw.nut_length));
    ASSERT_EQ(run.status, 0) << run.err;
    const nlohmann::json found = documents(file);
    EXPECT_THAT(unusual(found), testing::IsEmpty()) << s.name;
    EXPECT_GE(found["life"]["life"]["static_safety"], 1.5) << s.name;
    const auto measure = [&](const char* key) { return found["measures"]["measures"][key].get<double>(); };
    EXPECT_THAT(measure("static_capacity_N") / s.static_capacity, between(0.5, 1.8)) << s.name;
    if (s.screw.screw_diameter > 7e-3) {  // For the screw of 4 mm see SOURCE.md.
      EXPECT_THAT(measure("dynamic_capacity_N") / s.dynamic_capacity, between(0.6, 1.6)) << s.name;
    }
    if (s.weight_digit <= 0.1 * s.weight) {
      EXPECT_THAT(measure("weight_kg") / s.weight, between(0.82, 1.18)) << s.name;
    }
    EXPECT_THAT(1e-6 * measure("nut_inertia_kg_mm2") / s.nut_inertia, between(0.82, 1.18)) << s.name;
    EXPECT_THAT(1e-6 * measure("roller_inertia_kg_mm2") / s.roller_inertia, between(0.82, 1.18)) << s.name;
    for (const auto& load : found["slip"]["load_cases"]) {
      EXPECT_EQ(load["slip"]["converged"], true) << s.name;
      EXPECT_THAT(load["slip"]["efficiency"].get<double>() / s.efficiency, between(0.88, 1.06)) << s.name;
    }
  }
}

/// Heads of grooved rollers in guides with clearance have no load where none pushes them.
TEST_F(NewCase, GroovedRollersRunInGuidesWithClearance) {
  ASSERT_EQ(prs("new recirculating a.yaml --screw-diameter 25mm --lead 1mm --load 10kN --speed 300rpm").status, 0);
  const auto efficiency = [&](const std::string& guidance) {
    const test::Outcome run =
        prs("slip a.yaml --json --set 'structure.roller.guidance={ring: 2e4 N/mm" + guidance + "}'");
    EXPECT_EQ(run.status, 0) << run.err;
    return nlohmann::json::parse(run.out)["load_cases"][0]["slip"]["efficiency"].get<double>();
  };
  EXPECT_NEAR(efficiency(", clearance: 20 um"), efficiency(""), 0.02);
}

TEST_F(NewCase, TheCaseAmongTheValidatedOnesIsOneOfThese) {
  EXPECT_EQ(prs("new standard " + kOf30 + "--starts 5 --nut-diameter 64mm --nut-length 85mm").out,
            test::content_of(PRS_SOURCE_DIR "/validation/standard_screws/screw_30x10.yaml"));
}

TEST_F(NewCase, TheProposedConductancesAreACaseOnceTheyAreNoComment) {
  ASSERT_EQ(prs("new standard a.yaml " + kOf30 + "--speed 10rpm").status, 0);
  std::string text = this->text("a.yaml");
  const std::size_t first = text.find("# heat: {"), second = text.find("\n#   screw_rollers", first);
  ASSERT_NE(second, std::string::npos);
  text.erase(second + 1, 1);
  text.erase(first, 2);
  std::ofstream(folder.path() / "b.yaml") << text;
  const test::Outcome run = prs("slip b.yaml --json");
  ASSERT_EQ(run.status, 0) << run.err;
  const auto document = nlohmann::json::parse(run.out);
  EXPECT_GT(document["load_cases"][0]["heat"]["temperature_degC"]["nut"], 25.0);
}

TEST_F(NewCase, FewNumbersMakeACompleteCase) {
  for (const char* arguments : {"standard a.yaml --screw-diameter 25mm --lead 5mm",
                                "inverted b.yaml --screw-diameter '21 mm' --lead '5 mm' --starts 3",
                                "inverted c.yaml --screw-diameter 60mm --lead=-20mm --nut-length 600mm --load 50kN",
                                "standard d.yaml --screw-diameter 30mm --lead=-10mm --rollers 8 --speed 400rpm"}) {
    ASSERT_EQ(prs(std::string("new ") + arguments).status, 0) << arguments;
  }
  for (const char* file : {"a.yaml", "b.yaml", "c.yaml", "d.yaml"})
    EXPECT_THAT(unusual(documents(file)), testing::IsEmpty()) << file;
}

TEST_F(NewCase, AFullMechanismHasAllRollersAndSupportsAndLoadsAcross) {
  const auto load_cases = [&](const std::string& type, const std::string& mechanism) {
    const std::string file = type + mechanism + ".yaml";
    EXPECT_EQ(prs("new " + type + " " + file + " --mechanism " + mechanism).status, 0);
    EXPECT_EQ(prs("check " + file).status, 0);
    EXPECT_EQ(prs("contact " + file).status, 0);
    const test::Outcome run = prs("solve " + file + " --json --set model.bodies=bars");
    EXPECT_EQ(run.status, 0) << run.err;
    return nlohmann::json::parse(run.out, nullptr, false)["load_cases"];
  };
  for (const std::string type : {"standard", "inverted"}) {
    const std::string file = type + "full.yaml";
    const nlohmann::json full = load_cases(type, "full"), sector = load_cases(type, "sector");
    for (std::size_t k = 0; k < 2; ++k) {
      const double displacement = sector[k]["axial_displacement_um"];
      EXPECT_NEAR(full[k]["axial_displacement_um"], displacement, 1e-6 * displacement);
      EXPECT_NEAR(full[k]["screw"]["overload_factor"], 1.0, 1e-6);
    }
    const test::Outcome tilted =
        prs("solve " + file +
            " --json --set load_cases[0].misalignment.nut_tilt.y=1mrad "
            "--set load_cases[0].side_force.y=100N --set structure.nut.housing.tilt=1e5Nm/rad");
    ASSERT_EQ(tilted.status, 0) << tilted.err;
    EXPECT_GT(nlohmann::json::parse(tilted.out)["load_cases"][0]["screw"]["overload_factor"], 1.01);
  }
  EXPECT_THAT(prs("new standard --mechanism half").err, HasSubstr("full"));
}

TEST_F(NewCase, WhatIsGivenStandsInTheCaseAndWhatIsNotHasItsReason) {
  ASSERT_EQ(prs("new standard a.yaml " + kOf30 +
                "--rollers 8 --load '12.5 kN' --speed 300rpm "
                "--temperature 45degC --lubricant iso-vg-220 --nut-length 90mm --nut-diameter 66mm")
                .status,
            0);
  const std::string a = text("a.yaml");
  EXPECT_THAT(a, HasSubstr("rollers: 8 "));
  EXPECT_THAT(a, HasSubstr("axial_force: 12.5 kN"));
  EXPECT_THAT(a, HasSubstr("speed: 300 rpm"));
  EXPECT_THAT(a, HasSubstr("{name: iso-vg-220, temperature: 45 degC}"));
  EXPECT_THAT(a, HasSubstr("length: 90 mm"));
  EXPECT_THAT(a, HasSubstr("outer_diameter: 66 mm"));
  EXPECT_THAT(a, HasSubstr("bodies: refined"));
  EXPECT_THAT(a, HasSubstr("starts: {screw: 5, roller: 1}"));
  EXPECT_THAT(a, HasSubstr("assumed {screw: 5, roller: 1}: of 5, 4, 3"));
}

TEST_F(NewCase, ABlankBeforeTheUnitChangesNothing) {
  const auto case_of = [&](const std::string& options) {
    const std::string all = prs("new standard " + options).out;
    return all.substr(all.find("\nmechanism:"));
  };
  EXPECT_EQ(case_of("--screw-diameter 30mm --lead 10mm"), case_of("--screw-diameter '30 mm' --lead '10 mm'"));
}

TEST_F(NewCase, WhatIsGivenStandsAsItWasWritten) {
  ASSERT_EQ(prs("new standard a.yaml --screw-diameter '1 1/4 in' --lead=-1/4in --nut-length 3in "
                "--nut-diameter '2-3/4 in' --load 2000lbf --speed +300rpm --temperature '140 degF'")
                .status,
            0);
  const std::string a = text("a.yaml");
  for (const char* line :
       {"roller screw, 1 1/4 in x -1/4 in.", "  lead: -1/4 in ", "{screw: 1 1/4 in}", "    length: 3 in ",
        "outer_diameter: 2-3/4 in ", "compression: 3 in}", "{force: 2000 lbf,", "axial_force: 2000 lbf,",
        "operation: {speed: -300 rpm}", "speed: 300 rpm}", "temperature: 140 degF}"})
    EXPECT_THAT(a, HasSubstr(line));
  const std::string check = prs("check a.yaml --all").out;
  for (const char* line :
       {"mechanism.lead                             -6.35 mm", "mechanism.pitch_diameter.screw             31.75 mm",
        "structure.nut.outer_diameter               69.85 mm"})
    EXPECT_THAT(check, HasSubstr(line));
}

TEST_F(NewCase, SaysWhatItAssumes) {
  EXPECT_THAT(prs("new standard a.yaml").err,
              StartsWith("a.yaml: written; an example of 30 mm x 10 mm, as no dimension was given; "));
  const std::string some = prs("new inverted b.yaml --load 9kN " + kOf30).err;
  EXPECT_THAT(some, HasSubstr("b.yaml: written; assumed in it: starts, rollers, "));
  EXPECT_THAT(some, testing::Not(HasSubstr("load")));
}

TEST_F(NewCase, HasNoMoreStartsThanLifeKnowsTheCapacityOf) {
  for (const std::string type : {"standard", "inverted"}) {
    const std::string screw = "new " + type + " " + type + ".yaml " + kOf30 + "--starts ";
    const std::string told = prs(screw + "100").err, limit = "--starts: got 100; expected at most ";
    ASSERT_THAT(told, HasSubstr(limit));
    EXPECT_FALSE(fs::exists(folder.path() / (type + ".yaml")));
    const int most = std::stoi(told.substr(told.find(limit) + limit.size()));
    EXPECT_EQ(prs(screw + std::to_string(most + 1)).status, 2);
    ASSERT_EQ(prs(screw + std::to_string(most)).status, 0);
    const std::string life = "life " + type + ".yaml --set life.share=equal --set mechanism.starts.screw=";
    EXPECT_EQ(prs(life + std::to_string(most)).status, 0);
    EXPECT_THAT(prs(life + std::to_string(most + 1)).err, HasSubstr("Lemor's capacity"));
  }
}

TEST_F(NewCase, WhatCannotBeIsOneErrorAndNoFile) {
  for (const auto& [arguments, message] : std::initializer_list<std::pair<std::string, const char*>>{
           {"--screw-diameter 30mm --lead 0mm", "--lead: got 0 mm; expected "},
           {"--screw-diameter 30mm --lead 10", "--lead: got 10; expected a length with its unit"},
           {"--screw-diameter 30mm", "--lead: missing"},
           {"--lead 10mm", "--screw-diameter: missing"},
           {"--screw-diameter 30m --lead 10mm", "--screw-diameter: got 30m; expected 1 mm to 1 m"},
           {kOf30 + "--starts 1", "--starts: got 1; expected 3 to"},
           {kOf30 + "--rollers 40", "--rollers: got 40; expected 3 to 11"},
           {kOf30 + "--nut-diameter 45mm", "--nut-diameter: got 45 mm; expected 51.4 mm to"},
           {kOf30 + "--nut-length 2mm", "--nut-length: got 2 mm; expected 8.83 mm to"},
           {kOf30 + "--load 0N", "--load: got 0N; expected more than 0"},
           {kOf30 + "--lubricant nosuchoil", "--lubricant: got nosuchoil; expected a name of `prs list lubricants`"},
           {kOf30 + "--temperature 5000degC", "--temperature: got 5000degC"}}) {
    const test::Outcome run = prs("new standard new.yaml " + arguments);
    EXPECT_EQ(run.status, 2) << arguments << run.err;
    EXPECT_EQ(run.out, "") << arguments;
    EXPECT_THAT(run.err, StartsWith("prs: error: ")) << arguments;
    EXPECT_THAT(run.err, HasSubstr(message)) << arguments;
    EXPECT_EQ(std::ranges::count(run.err, '\n'), 1) << run.err;
    EXPECT_FALSE(fs::exists(folder.path() / "new.yaml")) << arguments;
  }
}

TEST_F(NewCase, AnExistingFileStays) {
  std::ofstream(folder.path() / "mine.yaml") << "mine";
  for (const char* arguments :
       {"standard mine.yaml --screw-diameter 30mm --lead 10mm", "standard mine.yaml", "--lesson 1 mine.yaml"}) {
    EXPECT_EQ(prs(std::string("new ") + arguments).status, 2) << arguments;
    EXPECT_EQ(text("mine.yaml"), "mine");
  }
}

TEST_F(NewCase, TheNextStepIsACommandOfAShell) {
  EXPECT_THAT(prs("new standard 'a b;c.yaml'").err, HasSubstr("`prs check 'a b;c.yaml'` is the next step"));
  EXPECT_THAT(prs("new standard -- -c.yaml").err, HasSubstr("`prs check ./-c.yaml` is the next step"));
}

TEST_F(NewCase, AFileThatCannotBeIsNamedWithTheReason) {
  fs::create_symlink("loop", folder.path() / "loop");
  for (const auto& [file, reason] : std::initializer_list<std::pair<std::string, const char*>>{
           {std::string(300, 'n'), "nnn': File name too long"}, {"loop/a.yaml", "loop': Too many levels"}}) {
    const test::Outcome run = prs("new standard " + file);
    EXPECT_EQ(run.status, 1) << run.err;
    EXPECT_THAT(run.err, StartsWith("prs: error: cannot write '"));
    EXPECT_THAT(run.err, HasSubstr(reason));
  }
}

TEST_F(NewCase, ALessonComesWithTheFilesThatItReads) {
  for (const char* lesson : {"14", "14_flight_spectrum", "flight_spectrum"}) {
    const std::string name = std::string("by_") + lesson;
    fs::create_directory(folder.path() / name);
    const std::string file = name + "/mine.yaml";
    ASSERT_EQ(prs(fmt::format("new --lesson {} {}", lesson, file)).status, 0) << lesson;
    EXPECT_EQ(text(file.c_str()), test::content_of(PRS_SOURCE_DIR "/configs/14_flight_spectrum.yaml"));
    EXPECT_EQ(prs("life " + file + " --quiet").status, 0);
  }
  // A history that stands there already serves another lesson; one of other content prevents it.
  EXPECT_EQ(prs("new --lesson 14 by_14/second.yaml").status, 0);
  std::ofstream(folder.path() / "by_14/14_flight_spectrum.csv") << "mine";
  const test::Outcome again = prs("new --lesson 14 by_14/other.yaml");
  EXPECT_EQ(again.status, 2);
  EXPECT_THAT(again.err, HasSubstr("14_flight_spectrum.csv"));
  EXPECT_FALSE(fs::exists(folder.path() / "by_14/other.yaml"));
  EXPECT_EQ(prs("new --lesson 1").out, test::content_of(PRS_SOURCE_DIR "/configs/01_config_1_to_3.yaml"));
}

TEST_F(NewCase, ALessonThatIsNotThereNamesTheOnesThatAre) {
  EXPECT_THAT(prs("new --lesson 99 a.yaml").err, HasSubstr("expected a number from 1 to "));
  EXPECT_THAT(prs("new --lesson preloda a.yaml").err, HasSubstr("did you mean `preload`"));
  EXPECT_EQ(prs("new --lesson 99 a.yaml").status, 2);
  const test::Outcome nowhere = prs("new --lesson 1 a.yaml", "PRS_SHARE='" + folder.path().string() + "'");
  EXPECT_EQ(nowhere.status, 1);
  EXPECT_THAT(nowhere.err, HasSubstr("PRS_SHARE"));
}

}  // namespace
}  // namespace prs
