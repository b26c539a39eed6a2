#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <set>
#include <tuple>
#include <utility>

#include "prs/report/report.h"
#include "prs/run/analyses.h"
#include "tests/support/program.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

Json checked(const std::string& lesson, std::vector<std::string> overrides = {}) {
  const input::Source source = input::load_source(PRS_SOURCE_DIR "/configs/" + lesson, std::move(overrides));
  return run(analysis_of(Command::check), source).document(document_info(source, Command::check));
}

std::vector<std::string> warnings_of(const std::string& lesson, const std::string& override) {
  return checked(lesson, {override})["warnings"].get<std::vector<std::string>>();
}

TEST(Check, SaysForEachCommandWhetherItIsReadyAndWhatToAdd) {
  const Json commands = checked("01_config_1_to_3.yaml")["commands"];
  EXPECT_EQ(commands["solve"].dump(), R"({"ready":true,"loads":"static"})");
  EXPECT_EQ(commands["compare"].dump(), R"({"ready":true,"loads":"static"})");
  EXPECT_EQ(commands["slip"].dump(), R"({"ready":false,"missing":["friction","operation"]})");
  EXPECT_EQ(commands["study"].dump(), R"({"ready":false,"missing":["study"]})");
  EXPECT_EQ(commands.size(), prs::analyses().size());
  const Json influence = checked("12_preload.yaml", {"model.bodies=influence"})["commands"]["preload"];
  EXPECT_EQ(influence.dump(), R"({"ready":false,"wrong":["model.bodies"]})");
  const Json running = checked("31_running_screw.yaml")["commands"];
  EXPECT_EQ(running["solve"]["loads"], "static");
  EXPECT_EQ(running["slip"]["loads"], "running");
  EXPECT_EQ(running["life"]["loads"], "running");
}

/// A start that is offset takes more load, whichever sense is worse; cases that state errors get no warning.
TEST(Check, SaysWhatPerfectPartsHide) {
  const auto note = [](const char* lesson, const std::vector<std::string>& overrides) {
    const Json checked_case = checked(lesson, overrides);
    for (const std::string warning : checked_case.value("assumptions", Json::array()))
      if (warning.starts_with("deviations.pitch_error: parts are perfect: ")) return warning;
    return std::string();
  };
  EXPECT_THAT(note("31_running_screw.yaml", {}),
              testing::MatchesRegex(".* out of position by 3 um raises the largest load of a thread by [0-9.]+ % and "
                                    "takes [0-9]+ % of the life; .*"));
  // The life is left out for measured histories.
  EXPECT_THAT(note("14_flight_spectrum.yaml", {}), testing::MatchesRegex(".* thread by [0-9.]+ %; .*"));
  EXPECT_EQ(note("14_flight_spectrum.yaml", {"deviations.pitch_error.screw.linear=1 um"}), "");
}

TEST(Check, ReadinessIsWhetherTheCommandReadsTheCase) {
  for (const char* lesson : {"05_standard_screw.yaml", "07_contact_geometry.yaml", "09_slip_and_dissipation.yaml",
                             "14_flight_spectrum.yaml"}) {
    const input::Source source = input::load_source(std::string(PRS_SOURCE_DIR "/configs/") + lesson, {});
    const Json readiness = checked(lesson)["commands"];
    for (const auto& [command, state] : readiness.items()) {
      const AnyAnalysis& row = *std::ranges::find_if(
          analyses(), [&, &named = command](const AnyAnalysis& r) { return name(r.command) == named; });
      if (!row.run) continue;
      bool reads = true;
      try {
        input::read_case_input(source, row.command);
      } catch (const input::InputError&) {
        reads = false;
      }
      EXPECT_EQ(state["ready"], reads) << lesson << ' ' << command;
    }
  }
}

TEST(Check, ACommandIsNotReadyThatFindsAnError) {
  const Json life = checked("14_flight_spectrum.yaml", {"life.history.file=missing.csv"})["commands"]["life"];
  EXPECT_EQ(life["ready"], false);
  EXPECT_THAT(life["error"].get<std::string>(), HasSubstr("missing.csv"));
}

TEST(Check, DefaultsStandInTheTableOnlyWithAll) {
  const std::string file = "check configs/01_config_1_to_3.yaml";
  const test::Outcome brief = test::run_prs(file), all = test::run_prs(file + " --all");
  EXPECT_THAT(brief.out,
              AllOf(StartsWith("Commands\n"), HasSubstr("slip         add friction, "),
                    HasSubstr("add `friction: {model: jacod}`"), HasSubstr("Derived"), Not(HasSubstr("(default)"))));
  EXPECT_THAT(all.out, AllOf(HasSubstr("model.patch_points"), HasSubstr("21   (default)")));
  EXPECT_EQ(test::run_prs(file + " --json --quiet").out, test::run_prs(file + " --all --json --quiet").out);
}

TEST(Check, SaysWhatEachValueRestsOn) {
  input::Source source =
      input::load_source(PRS_SOURCE_DIR "/configs/05_standard_screw.yaml", {"structure.nut.length=101 mm"});
  const std::size_t at = source.text.find("  rollers: 10");
  ASSERT_NE(at, std::string::npos);
  source.text.insert(at, "  # assumed 10: as\n  # drawn\n");
  const Delivery check = run(analysis_of(Command::check), source);
  const Json document = check.document(document_info(source, Command::check));
  const auto entry = [&](const char* path) {
    return *std::ranges::find_if(document["input"], [&](const Json& e) { return e["path"] == path; });
  };
  EXPECT_EQ(entry("mechanism.rollers")["basis"], "assumed");
  EXPECT_EQ(entry("mechanism.rollers")["reason"], "as drawn");
  EXPECT_EQ(entry("mechanism.lead")["basis"], "given");
  EXPECT_EQ(entry("structure.nut.length")["basis"], "given");
  EXPECT_EQ(entry("mechanism.profile_plane")["basis"], "default");
  EXPECT_FALSE(entry("mechanism.lead").contains("reason"));
  EXPECT_THAT(check.full_table(), HasSubstr(" 10   (assumed)\n      as drawn\n"));
  const std::vector<ReportSection> sections = report_parts(source, {}).sections;
  EXPECT_THAT(std::ranges::find(sections, "inputs", &ReportSection::id)->body,
              HasSubstr("<td>10</td><td>assumed: as drawn</td>"));
}

struct Odd {
  const char *lesson, *override, *path, *text;
};

TEST(Check, WarnsOfWhatIsOddTogether) {
  for (const auto& [lesson, override, path, text] :
       {Odd{"04_contacts_from_geometry.yaml", "structure.nut.outer_diameter=35.34 mm", "structure.nut.outer_diameter",
            "got 35.34 mm, a wall of 0.17 mm"},
        Odd{"18_design_measures.yaml", "operation.speed=6000 rpm", "operation.speed",
            "n d = 180000 mm/min; makers allow up to 150000 mm/min"},
        Odd{"09_slip_and_dissipation.yaml", "load_cases[1].speed=-9000 rpm", "load_cases[1].speed",
            "n d = 189000 mm/min"},
        Odd{"08_design_by_backlash.yaml", "mechanism.backlash.nut=-0.5 mm", "mechanism.backlash.nut",
            "backlash -0.5 mm, 30 % of the pitch"},
        Odd{"04_contacts_from_geometry.yaml", "mechanism.centre_distance=13.75 mm", "mechanism.pitch_diameter.screw",
            "check pitch diameters, centre distance"},
        Odd{"07_contact_geometry.yaml", "mechanism.contacts_per_roller=200", "mechanism.contacts_per_roller",
            "39.8 times the roller's diameter"},
        Odd{"04_contacts_from_geometry.yaml", "structure.screw.bore=19 mm", "structure.screw.bore", "a wall of 1 mm"},
        Odd{"04_contacts_from_geometry.yaml", "load_cases[0].axial_force=200 kN", "load_cases[0].axial_force",
            "exceeds 4 GPa"},
        Odd{"04_contacts_from_geometry.yaml", "mechanism.thread.roller={addendum: 0.12 mm, dedendum: 0.3 mm}",
            "load_cases[0].axial_force", "beyond the crest of the roller"},
        Odd{"10_parametric_study.yaml", "mechanism.rollers=9", "roughness", "missing, so that film over roughness"}})
    EXPECT_THAT(warnings_of(lesson, override), Contains(AllOf(StartsWith(std::string(path) + ": "), HasSubstr(text))))
        << override;
  const Json steep = checked("07_contact_geometry.yaml", {"mechanism.lead=60 mm", "mechanism.rollers=7"})["warnings"];
  EXPECT_THAT(steep.get<std::vector<std::string>>(),
              Contains(AllOf(StartsWith("mechanism.lead: "), HasSubstr("a helix angle of 32."))));
}

/// Nominal diameters interfere slightly; the lessons explain it.
TEST(Check, ASmallInterferenceIsToldFromALargeOne) {
  for (const char* lesson : {"01_config_1_to_3.yaml", "21_jung_envelope.yaml"})
    EXPECT_THAT(checked(lesson)["warnings"].get<std::vector<std::string>>(),
                AllOf(Contains(HasSubstr("interfere: backlash -0.")), Not(Contains(HasSubstr("of the pitch: ")))));
}

std::vector<std::string> warned(const input::Source& source, Command command) {
  const Json document = run(analysis_of(command), source).document(document_info(source, command));
  std::vector<std::string> warnings = document["warnings"];
  for (const Json& load_case : document.value("load_cases", Json::array()))
    for (const Json& warning : load_case["warnings"]) warnings.push_back(warning);
  return warnings;
}

/// Also if the most loaded thread, not the mean one, is unusual.
TEST(Check, WarnsOfLoadsAsSolveAndLifeDo) {
  const input::Source source = input::load_source(
      PRS_SOURCE_DIR "/validation/standard_screws/screw_30x10.yaml",
      {"life.spectrum[0].force=60 kN", "load_cases[0].axial_force=140 kN", "load_cases[1].axial_force=140 kN"});
  const std::vector<std::string> by_check = warned(source, Command::check);
  for (const auto& [command, text] : {std::pair{Command::life, "kN at which an ellipse reaches the edge of a flank"},
                                      {Command::solve, "load_cases[0].axial_force: roller-screw peak pressure 4.0"}}) {
    const std::vector<std::string> own = warned(source, command);
    EXPECT_THAT(own, Contains(HasSubstr(text)));
    EXPECT_THAT(by_check, testing::IsSupersetOf(own)) << name(command);
  }
  const input::Source full =
      input::load_source(source.name, {"model.mechanism=full", "load_cases[0].axial_force=300 kN"});
  EXPECT_THAT(warned(full, Command::check), Contains(HasSubstr("GPa, even with equal thread loads")));
}

/// One cause, one warning: an unusual load has no second warning about its pressure.
TEST(Check, AnOddValueHasOneWarning) {
  for (const auto& [lesson, override, path, text] :
       {Odd{"04_contacts_from_geometry.yaml", "load_cases[0].axial_force=1e9 kN", "load_cases[0].axial_force",
            "got 1e9 kN"},
        Odd{"18_design_measures.yaml", "operation.speed=1e6 rpm", "operation.speed", "got 1e6 rpm"}}) {
    int count = 0;
    for (const std::string& warning : warnings_of(lesson, override))
      if (warning.starts_with(std::string(path) + ": ")) {
        ++count;
        EXPECT_THAT(warning, HasSubstr(text));
      }
    EXPECT_EQ(count, 1) << override;
  }
}

TEST(Check, DerivedValuesHaveTheUnitsOfTables) {
  const test::Outcome us = test::run_prs("check configs/01_config_1_to_3.yaml --units us");
  EXPECT_THAT(us.out, HasSubstr("  centre_distance, in                        0.5511811\n"));
  EXPECT_THAT(us.out, HasSubstr("  pitch_diameter.screw, in                   0.8267717\n"));
  EXPECT_THAT(us.out, HasSubstr("backlash -0.00253 in"));
  EXPECT_EQ(us.out.find("_mm"), std::string::npos);
}

/// Equal shares have no preload, which slip would otherwise use.
TEST(Check, SlipSaysWhereNoLoadTakesThePreload) {
  const std::string lesson = PRS_SOURCE_DIR "/configs/34_reversal.yaml";
  const auto note = HasSubstr("preload: the load cases are solved without preload");
  EXPECT_THAT(warned(input::load_source(lesson, {}), Command::slip), Not(Contains(note)));
  EXPECT_THAT(warned(input::load_source(lesson, {"load_cases[0].share=equal"}), Command::slip), Contains(note));
}

TEST(Slip, SaysWhichLoadsTakeNothingOfThePreload) {
  const input::Source source =
      input::load_source(PRS_SOURCE_DIR "/configs/34_reversal.yaml",
                         {"load_cases=[{name: solved, axial_force: 1 kN, direction: tension, position: 12 mm}, "
                          "{name: shared, axial_force: 1 kN, direction: tension, share: equal}]"});
  const Json cases =
      run(analysis_of(Command::slip), source).document(document_info(source, Command::slip))["load_cases"];
  EXPECT_EQ(cases[0]["warnings"].dump().find("external load alone"), std::string::npos);
  EXPECT_THAT(cases[1]["warnings"].dump(),
              HasSubstr("preload: equal thread loads are those of the external load alone"));
}

/// Warnings on single values are first in every command's document.
TEST(Check, OddValuesAreToldByEveryCommand) {
  const input::Source source =
      input::load_source(PRS_SOURCE_DIR "/configs/18_design_measures.yaml", {"materials.poisson_ratio=0.45"});
  for (const Command command : {Command::contact, Command::solve, Command::compare, Command::measures})
    EXPECT_THAT(
        run(analysis_of(command), source).document(document_info(source, command))["warnings"][0].get<std::string>(),
        StartsWith("materials.poisson_ratio: got 0.45; usual is 0.15 to 0.44"))
        << name(command);
}

/// `KEY: what is unusual`, in every lesson and command; code and path distinguish all warnings of a load case.
TEST(Check, WarningsNameTheKey) {
  for (const char* lesson :
       {"01_config_1_to_3.yaml", "09_slip_and_dissipation.yaml", "12_preload.yaml", "13_three_models.yaml",
        "14_flight_spectrum.yaml", "15_sensitivity.yaml", "18_design_measures.yaml"}) {
    const input::Source source = input::load_source(std::string(PRS_SOURCE_DIR "/configs/") + lesson, {});
    const input::CaseInput in = input::read_case_input(source, Command::check);
    for (const AnyAnalysis& row : analyses()) {
      if (!row.run || !input::missing(in, row.command).empty()) continue;
      const Delivery delivery = run(row, source);
      const Json document = delivery.document(document_info(source, row.command));
      std::set<std::tuple<std::string, std::string, std::string>> kinds;
      for (const Warning& warning : delivery.warnings()) {
        EXPECT_NE(warning.code, "") << sentence(warning);
        EXPECT_TRUE(kinds.emplace(warning.load_case, warning.code, warning.path).second)
            << lesson << ", " << name(row.command) << ": " << sentence(warning);
      }
      std::vector<std::string> warnings = document["warnings"];
      for (const Json& load_case : document.value("load_cases", Json::array()))
        for (const Json& warning : load_case["warnings"]) warnings.push_back(warning);
      for (const std::string& warning : warnings) {
        if (warning.starts_with("overridden by ")) continue;  // The warning names its keys later in the text.
        const std::string key = warning.substr(0, warning.find(": "));
        EXPECT_THAT(key, testing::MatchesRegex("[a-z_]+[][0-9a-z_.]*")) << lesson << ": " << warning;
      }
    }
  }
}

}  // namespace
}  // namespace prs
