// The program as a user runs it: exit statuses, streams, files.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "prs/model/command.h"
#include "prs/run/analyses.h"
#include "prs/text.h"
#include "tests/support/program.h"

namespace {

using prs::printable;
using test::Outcome;

namespace fs = std::filesystem;

class CommandLine : public testing::Test {
 protected:
  fs::path folder = fs::temp_directory_path() / ("prs_cli_" + std::to_string(getpid()));
  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }

  static std::string slurp(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  /// Runs `prs ARGUMENTS` from the repository's root.
  Outcome prs(const std::string& arguments) const { return test::run_prs(arguments); }
};

TEST_F(CommandLine, SolvePrintsATableAndNothingElse) {
  const Outcome run = prs("solve configs/01_config_1_to_3.yaml");
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.out.find("config3-compression"), std::string::npos);
  EXPECT_EQ(run.err, "");
}

TEST_F(CommandLine, JsonIsOneDocumentOnStandardOutput) {
  for (const char* arguments :
       {"solve configs/01_config_1_to_3.yaml --json --quiet", "validate validation/sandu_2018 --json", "schema --json",
        "check configs/05_standard_screw.yaml --json --quiet", "contact configs/05_standard_screw.yaml --json --quiet",
        "slip configs/09_slip_and_dissipation.yaml --json --quiet"}) {
    const Outcome run = prs(arguments);
    EXPECT_EQ(run.status, 0) << arguments;
    EXPECT_TRUE(nlohmann::json::accept(run.out)) << arguments;
    EXPECT_EQ(run.err, "") << arguments;
  }
}

TEST_F(CommandLine, TheModelOfTheBodiesIsNamed) {
  const auto model = [&](const std::string& set) {
    const Outcome run = prs("solve configs/13_three_models.yaml --json --quiet " + set);
    return nlohmann::json::parse(run.out).at("model").dump();
  };
  EXPECT_EQ(
      model("--set model.bodies=bars"),
      R"({"bodies":"bars","note":"17 to 32 % stiffer than finite elements on an inverted 21 x 5 mm screw; nearer: )"
      R"(`model: {bodies: refined}`"})");
  EXPECT_NE(prs("solve configs/01_config_1_to_3.yaml")
                .out.find("bodies: bars: 17 to 32 % stiffer than finite elements on an inverted 21 "
                          "x 5 mm screw; nearer:\n`model: {bodies: refined}`; thread loads at rest\n"),
            std::string::npos);
  EXPECT_EQ(model("--set model.refined.hoop=false"),
            R"({"bodies":"refined","effects_off":["hoop"],"roller_contacts":"opposite"})");
  EXPECT_NE(prs("solve configs/13_three_models.yaml").out.find("bodies: refined, roller contacts"), std::string::npos);
  EXPECT_NE(prs("solve configs/13_three_models.yaml --json").err.find("bolted flange"), std::string::npos);
}

TEST_F(CommandLine, WarningsStandBesideTheDocument) {
  const Outcome run = prs("solve configs/01_config_1_to_3.yaml --json");
  EXPECT_TRUE(nlohmann::json::accept(run.out));
  EXPECT_NE(run.err.find("exceeds 4 GPa"), std::string::npos) << run.err;
}

TEST_F(CommandLine, DocumentNamesItsOrigin) {
  const auto json = nlohmann::json::parse(prs("solve configs/01_config_1_to_3.yaml --json").out);
  for (const char* key : {"prs_version", "schema_version", "input_sha256", "warnings"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(json["load_cases"].size(), 6u);
  EXPECT_EQ(json["load_cases"][0]["screw"]["axial_load_N"].size(), 20u);
}

TEST_F(CommandLine, SlipStandsBesideWhatSolveDelivers) {
  const std::string config = "configs/09_slip_and_dissipation.yaml --set model.loads=static --json --quiet";
  const auto slip = nlohmann::json::parse(prs("slip " + config).out)["load_cases"][0];
  const auto solve = nlohmann::json::parse(prs("solve " + config).out)["load_cases"][0];
  for (const auto& [key, value] : solve.items()) {
    if (key == "warnings") continue;
    EXPECT_EQ(slip[key], value) << key;
  }
  EXPECT_EQ(slip["slip"]["nut"]["power_W"].size(), 20u);
  EXPECT_NEAR(slip["slip"]["power_loss_input_output_W"].get<double>() / slip["slip"]["power_loss_W"].get<double>(), 1.0,
              1e-10);
}

TEST_F(CommandLine, WhatSlipCannotTakeIsAnErrorWithItsPlace) {
  const std::string config = "slip configs/09_slip_and_dissipation.yaml --json ";
  struct Wrong {
    const char* override;
    const char* message;
  };
  for (const auto& [override, message] : {Wrong{"--set 'operation.speed=0 rpm'", "speed"},
                                          Wrong{"--set operation.slip_ratio=1.5", "operation.slip_ratio"},
                                          Wrong{"--set 'lubricant.temperature=-300 degC'", "lubricant.temperature"},
                                          Wrong{"--set 'mechanism.pitch={roller: 1.75 mm}'", "mechanism.pitch"}}) {
    const Outcome run = prs(config + override);
    EXPECT_EQ(run.status, 2) << override;
    EXPECT_EQ(run.out, "") << override;
    EXPECT_NE(run.err.find("configs/09_slip_and_dissipation.yaml:"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find(message), std::string::npos) << override << run.err;
  }
}

TEST_F(CommandLine, ACaseWithoutSlipEquilibriumLeavesTheOthers) {
  const Outcome run =
      prs("slip configs/09_slip_and_dissipation.yaml --json --quiet --set 'carrier.nut_torque=150 N m' "
          "--set 'load_cases[0].axial_force=80 kN'");
  EXPECT_EQ(run.status, 3);
  const auto cases = nlohmann::json::parse(run.out)["load_cases"];
  EXPECT_TRUE(cases[0]["slip"]["converged"].get<bool>());
  EXPECT_FALSE(cases[2]["slip"]["converged"].get<bool>());
  EXPECT_EQ(cases[2]["slip"]["status"], "no_equilibrium");
  EXPECT_FALSE(cases[2]["slip"].contains("slip_ratio"));
  EXPECT_TRUE(cases[2].contains("screw"));
}

TEST_F(CommandLine, OverridesReplaceValues) {
  const auto solve = [&](const std::string& more) {
    return nlohmann::json::parse(prs("solve configs/01_config_1_to_3.yaml --json " + more).out)["load_cases"][0];
  };
  const auto plain = solve(""), more = solve("--set mechanism.contacts_per_roller=15"),
             twice = solve(
                 "--set mechanism.contacts_per_roller=15 "
                 "--set 'load_cases[0].axial_force=20 kN'");
  EXPECT_EQ(more["screw"]["axial_load_N"].size(), 15u);
  EXPECT_EQ(twice["axial_force_N"], 20000.0);
  EXPECT_LT(more["axial_stiffness_N_per_um"], plain["axial_stiffness_N_per_um"]);
}

TEST_F(CommandLine, WrongInputIsStatus2WithItsPlaceAndNoOutput) {
  std::ofstream(folder / "bad.yaml") << "mechanism: {rollers: none}\n";
  const std::string file = (folder / "bad.yaml").string();
  for (const std::string& arguments :
       std::vector<std::string>{"solve " + file, "solve --json " + file, "check " + file,
                                "solve " + file + " --output " + (folder / "files").string()}) {
    const Outcome run = prs(arguments);
    EXPECT_EQ(run.status, 2) << arguments;
    EXPECT_EQ(run.out, "") << arguments;
    EXPECT_NE(run.err.find(file + ":1:"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("error: "), std::string::npos) << run.err;
  }
  EXPECT_FALSE(fs::exists(folder / "files"));
}

TEST_F(CommandLine, WrongOverrideIsReportedWhereItTakesEffect) {
  const Outcome run = prs("solve configs/01_config_1_to_3.yaml --set mechanism.lead=5");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err.rfind("configs/01_config_1_to_3.yaml:21:3: error: mechanism.lead: got 5;", 0), 0u) << run.err;
  EXPECT_NE(run.err.find("from --set mechanism.lead=5"), std::string::npos) << run.err;
}

TEST_F(CommandLine, OutputThatGetsLostIsStatus1) {
  const std::string command = std::string("cd '" PRS_SOURCE_DIR "' && '") + test::program() +
                              "' solve configs/01_config_1_to_3.yaml --json --quiet >/dev/full "
                              "2>/dev/null";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 1);
}

TEST_F(CommandLine, WhatOnlyTheGeometryRevealsIsReportedAtItsPlace) {
  const Outcome run =
      prs("solve configs/04_contacts_from_geometry.yaml --json --set "
          "mechanism.profile.roller=straight");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_NE(run.err.find("configs/04_contacts_from_geometry.yaml:"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("roller-screw"), std::string::npos) << run.err;
}

TEST_F(CommandLine, WrongCommandLineIsStatus2) {
  for (const char* arguments :
       {"", "frobnicate", "solve", "solve a.yaml b.yaml", "solve configs/missing.yaml", "solve configs",
        "solve configs/01_config_1_to_3.yaml --set", "check --nonsense x.yaml", "validate /nonexistent"}) {
    const Outcome run = prs(arguments);
    EXPECT_EQ(run.status, 2) << arguments << run.err;
    EXPECT_EQ(run.out, "") << arguments;
    EXPECT_NE(run.err, "") << arguments;
  }
}

TEST_F(CommandLine, ListsTheCommandsThatACaseHasAllFor) {
  const Outcome run = prs("list commands configs/07_contact_geometry.yaml");
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out, "check\ncontact\nsolve\nmeasures\n");
  std::string names;
  for (const prs::AnyAnalysis& analysis : prs::analyses()) names += fmt::format("{}\n", name(analysis.command));
  EXPECT_EQ(prs("list commands").out, names);
  EXPECT_EQ(prs("list commands /nonexistent.yaml").status, 2);
}

TEST_F(CommandLine, HelpAndVersionAreStatus0) {
  for (const char* arguments : {"--help", "--version", "solve --help"}) {
    const Outcome run = prs(arguments);
    EXPECT_EQ(run.status, 0) << arguments;
    EXPECT_NE(run.out, "") << arguments;
  }
}

TEST_F(CommandLine, OutputWritesWhatOtherToolsOpen) {
  const fs::path files = folder / "deep" / "files";
  const Outcome run = prs("solve configs/03_load_sweep.yaml --quiet --output '" + files.string() + "'");
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out, "");
  for (const char* name : {"result.json", "load_cases.csv", "load_distribution.csv", "plots/load_distribution.svg",
                           "plots/stiffness.svg", "plots/butterfly.svg"})
    EXPECT_TRUE(fs::exists(files / name)) << name;
  std::ifstream csv(files / "load_cases.csv");
  std::string line;
  int lines = 0;
  while (std::getline(csv, line)) ++lines;
  EXPECT_EQ(lines, 1 + 270);
}

TEST_F(CommandLine, APageMakesItsFolder) {
  const fs::path page = folder / "deep" / "pages" / "page.html";
  const Outcome run = prs("report configs/05_standard_screw.yaml --output '" + page.string() + "'");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(slurp(page).starts_with("<!DOCTYPE html>"));
}

TEST_F(CommandLine, NewWritesCasesThatSolveWithoutWarning) {
  for (const std::string& type : std::vector<std::string>{"inverted", "standard"}) {
    const std::string file = (folder / (type + ".yaml")).string();
    EXPECT_EQ(prs("new " + type + " " + file).status, 0);
    EXPECT_EQ(prs("new " + type).out, slurp(file));
    EXPECT_EQ(prs("new " + type + " " + file).status, 2);  // it exists now
    const Outcome solved = prs("solve --json " + file);
    EXPECT_EQ(solved.status, 0);
    EXPECT_EQ(solved.err, "");
    EXPECT_EQ(prs("check " + file).status, 0);
  }
  EXPECT_EQ(prs("new sideways").status, 2);
}

TEST_F(CommandLine, OutputThatIsNoFolderIsStatus2) {
  std::ofstream(folder / "file") << "x";
  for (const std::string& place : {(folder / "file").string(), std::string("/dev/null"), std::string("/dev/full")}) {
    const Outcome run = prs("solve configs/01_config_1_to_3.yaml --json --output '" + place + "'");
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find(place + ", which is a file"), std::string::npos) << run.err;
  }
}

TEST_F(CommandLine, OutputThatCannotBeWrittenIsStatus1) {
  const Outcome run = prs("solve configs/01_config_1_to_3.yaml --json --output /proc/nowhere");
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.err.find("cannot write '/proc/nowhere'"), std::string::npos) << run.err;
}

TEST_F(CommandLine, StudyWritesARowADesign) {
  const fs::path files = folder / "study";
  const Outcome run = prs("study configs/10_parametric_study.yaml --output '" + files.string() + "'");
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.err, "");  // Progress is shown on a terminal only.
  EXPECT_NE(run.out.find("* as in the file"), std::string::npos);
  for (const char* name : {"study.csv", "study.json", "plots/01_screw_diameter.svg"})
    EXPECT_TRUE(fs::exists(files / name)) << name;
  const auto json = nlohmann::json::parse(prs("study configs/10_parametric_study.yaml --json").out);
  EXPECT_EQ(json, nlohmann::json::parse(slurp(files / "study.json")));
  for (const char* key : {"prs_version", "schema_version", "input_sha256", "warnings", "designs"})
    EXPECT_TRUE(json.contains(key)) << key;
  int refused = 0;
  for (const auto& design : json["designs"]) refused += design["status"] == "refused" ? 1 : 0;
  EXPECT_EQ(refused, 2);  // 12 and 13 rollers.
}

TEST_F(CommandLine, StudyWithoutSenseIsStatus2) {
  const std::string base = "study configs/10_parametric_study.yaml --json --set ";
  for (const char* set :
       {"'study.responses=[slip.eficiency]'", "study.command=slipp", "'study.factors[0].path=mechanism.size'"}) {
    const Outcome run = prs(base + set);
    EXPECT_EQ(run.status, 2) << set;
    EXPECT_EQ(run.out, "") << set;
    EXPECT_NE(run.err.find(": error: "), std::string::npos) << run.err;
  }
  EXPECT_EQ(prs("study configs/01_config_1_to_3.yaml").status, 2);
  EXPECT_EQ(prs("check configs/10_parametric_study.yaml --set 'study.factors[0].values=[1 kN]'").status, 2);
}

TEST_F(CommandLine, PreloadPrintsTheCurveThroughZero) {
  const fs::path files = folder / "preload";
  const Outcome run = prs("preload configs/12_preload.yaml --output '" + files.string() + "'");
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.err, "");
  EXPECT_NE(run.out.find("a side opens at"), std::string::npos);
  for (const char* name : {"preload.csv", "preload.json", "plots/preload.svg"})
    EXPECT_TRUE(fs::exists(files / name)) << name;
  const auto json = nlohmann::json::parse(prs("preload configs/12_preload.yaml --json").out);
  EXPECT_EQ(json, nlohmann::json::parse(slurp(files / "preload.json")));
  for (const char* key : {"prs_version", "schema_version", "input_sha256", "warnings", "contact"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(json["preload"]["loads"].size(), 41u);
  std::ifstream csv(files / "preload.csv");
  std::string line;
  int lines = 0;
  while (std::getline(csv, line)) ++lines;
  EXPECT_EQ(lines, 1 + 41);
}

TEST_F(CommandLine, PreloadThatCannotBeIsStatus2) {
  for (const char* arguments : {"preload configs/01_config_1_to_3.yaml",
                                "preload configs/12_preload.yaml --set "
                                "model.bodies=influence",
                                "preload configs/12_preload.yaml --set preload.force='1e9 kN'",
                                "check configs/12_preload.yaml --set preload.spacer=3"}) {
    const Outcome run = prs(arguments);
    EXPECT_EQ(run.status, 2) << arguments;
    EXPECT_EQ(run.out, "") << arguments;
    EXPECT_NE(run.err.find(": error: "), std::string::npos) << run.err;
  }
}

TEST_F(CommandLine, SolveSaysThatItLeavesThePreloadOut) {
  const Outcome run = prs("solve configs/12_preload.yaml --json");
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.err.find("without preload"), std::string::npos) << run.err;
}

/// Files below a folder except hidden ones, with their contents.
std::map<std::string, std::string> results_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && !entry.path().filename().string().starts_with('.'))
      files[entry.path().lexically_relative(folder).string()] = test::content_of(entry.path());
  return files;
}

TEST_F(CommandLine, AFolderHoldsTheResultsOfOneCase) {
  const std::string used = "'" + (folder / "used").string() + "'";
  const std::string fresh = "'" + (folder / "fresh").string() + "'";
  const std::string lesson = " configs/04_contacts_from_geometry.yaml --output ";
  ASSERT_EQ(prs("solve configs/03_load_sweep.yaml --output " + used).status, 0);
  ASSERT_EQ(prs("contact configs/03_load_sweep.yaml --output " + used).status, 0);
  ASSERT_TRUE(fs::exists(folder / "used/plots/butterfly.svg"));
  std::ofstream(folder / "used/notes.txt") << "mine";
  const Outcome run = prs("solve" + lesson + used);
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.err.find("files of earlier runs removed"), std::string::npos) << run.err;
  ASSERT_EQ(prs("solve" + lesson + fresh).status, 0);
  std::map<std::string, std::string> expected = results_in(folder / "fresh");
  EXPECT_TRUE(expected.contains("result.json"));
  expected["notes.txt"] = "mine";
  EXPECT_TRUE(results_in(folder / "used") == expected);

  // Commands on one case complement each other.
  for (const char* command : {"check", "contact"}) ASSERT_EQ(prs(command + lesson + used).err, "");
  for (const auto& [name, content] : expected) EXPECT_TRUE(fs::exists(folder / "used" / name)) << name;
}

TEST_F(CommandLine, NamesReachTheTerminalWithoutControls) {
  const std::string nasty = "a\x1b[2J\x7f\u0085\u009b31m\u202e\u2066\u200b\u2028\ufeff\xff=b";
  const std::vector<std::string> forbidden = {"\x1b",   "\x7f",   "\u0085", "\u009b", "\u202e",
                                              "\u2066", "\u200b", "\u2028", "\ufeff", "\xff"};
  const std::string file = " configs/09_slip_and_dissipation.yaml ";
  // Without bytes that are not UTF-8, which YAML refuses.
  const std::string name = file + " --set 'load_cases[0].name=\"" + nasty.substr(0, nasty.find('\xff')) + "b\"'";
  std::vector<std::string> commands = {"solve " + file + "--set 'mechanism." + nasty + "=1'",
                                       "solve '" + nasty + "'",
                                       "solve " + file + "--set 'mechanism.lead=" + nasty + "'",
                                       "'" + nasty + "'",
                                       "study merge '" + nasty + "'",
                                       "solve " + file + "--output '/proc/" + nasty + "'"};
  for (const char* command : {"solve", "slip", "check", "contact", "measures"})
    for (const char* more : {"", " --json"}) commands.push_back(command + name + more);
  for (const std::string& command : commands) {
    const Outcome run = prs(command);
    for (const std::string& text : forbidden) {
      EXPECT_EQ(run.out.find(text), std::string::npos) << printable(command) << ": " << printable(text);
      EXPECT_EQ(run.err.find(text), std::string::npos) << printable(command) << ": " << printable(run.err);
    }
    EXPECT_FALSE(run.out.empty() && run.err.empty());
  }
}

}  // namespace
