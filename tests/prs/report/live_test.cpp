#include "prs/report/report.h"

#include <gmock/gmock.h>

#include <regex>

#include "prs/configurations/screw_case.h"
#include "prs/page/page.h"
#include "support/made_up_live_parts.h"
#include "support/sanitized.h"
#include "support/temporary_directory.h"

namespace prs {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

input::Source live_lesson(const std::string& name, std::vector<std::string> overrides = {}) {
  return input::load_source(PRS_SOURCE_DIR "/configs/" + name, std::move(overrides));
}

std::vector<std::string> names_of(const LiveAnswer& answer) {
  std::vector<std::string> names;
  for (const auto& item : answer.sections.items()) names.push_back(item.key());
  return names;
}

TEST(LiveReport, OfTheSameCaseIsTheReport) {
  const input::Source source = live_lesson("28_driving_load.yaml");
  const LiveAnswer live = live_sections(source, {});
  std::size_t compared = 0;
  for (const ReportSection& section : report_parts(source, {}).sections)
    if (live.sections.contains(section.id)) {
      EXPECT_EQ(live.sections[section.id], section.body) << section.id;
      compared += section.body.empty() ? 0 : 1;
    }
  EXPECT_GT(compared, 8u);
}

TEST(LiveReport, ShowsTheReportBehindOtherValues) {
  const input::Source changed = live_lesson("04_contacts_from_geometry.yaml", {"structure.nut.outer_diameter=60 mm"});
  const std::string verdict = live_sections(changed, {}).sections["verdict"];
  const std::string before = live_sections(live_lesson("04_contacts_from_geometry.yaml"), {}).sections["verdict"];
  std::smatch found;
  static const std::regex value("<div class=\"value\">([^<]*) <small>");
  ASSERT_TRUE(std::regex_search(before, found, value));
  EXPECT_THAT(verdict, HasSubstr("report: " + found[1].str()));
  EXPECT_THAT(before, Not(HasSubstr("report: ")));
  const auto paths = [](const std::string& text) {
    static const std::regex path("<path ");
    return std::distance(std::sregex_iterator(text.begin(), text.end(), path), {});
  };
  EXPECT_GT(paths(live_sections(changed, {}).sections["loads"]),
            paths(live_sections(changed, {.own = 1}).sections["loads"]));
}

/// A case whose life has the load of its load cases, and overrides that give them another.
input::Source screw_with(std::vector<std::string> overrides) {
  const std::string text = screw_case(complete_screw({.screw_diameter = 25e-3, .lead = 5e-3, .load = 19e3}), {}, "");
  overrides.insert(overrides.begin(), "model.bodies=bars");
  return input::source_of_text("screw.yaml", text, std::move(overrides));
}
const std::string kOfCases = "load_cases[0].axial_force=200 kN", kOfOther = "load_cases[1].axial_force=200 kN",
                  kOfLife = "life.spectrum[0].force=200 kN";

TEST(LiveReport, OneLoadDrivesTheLifeOfTheSameLoads) {
  EXPECT_THAT(report_parts(screw_with({}), {}).controls,
              HasSubstr("data-paths=\"load_cases[0].axial_force life.spectrum[0].force "
                        "load_cases[1].axial_force\""));
  const LiveAnswer live = live_sections(screw_with({kOfCases, kOfOther, kOfLife}), {.own = 1});
  EXPECT_TRUE(live.all_follow);
  for (const char* id : {"verdict", "life"})
    EXPECT_THAT(live.sections[id].get<std::string>(), Not(HasSubstr("class=\"stale\""))) << id;
}

TEST(LiveReport, WhatKeepsItsOwnLoadsIsGreyAndSaysSo) {
  const std::string controls = report_parts(screw_with({"life.spectrum[0].force=9 kN"}), {}).controls;
  EXPECT_THAT(controls, HasSubstr("data-paths=\"load_cases[0].axial_force "
                                  "load_cases[1].axial_force\""));
  EXPECT_THAT(controls, HasSubstr("data-paths=\"life.spectrum[0].force\""));
  const LiveAnswer live = live_sections(screw_with({kOfCases, kOfOther}), {.own = 1});
  EXPECT_FALSE(live.all_follow);
  EXPECT_THAT(live.sections["life"].get<std::string>(),
              AllOf(HasSubstr("does not follow the axial force"), HasSubstr("life.spectrum"),
                    HasSubstr("<div class=\"stale\">")));
  EXPECT_THAT(live.sections["slip"].get<std::string>(), Not(HasSubstr("stale")));
  EXPECT_THAT(live.sections["verdict"].get<std::string>(), HasSubstr("class=\"stale\"><dt>Life"));
}

TEST(LiveReport, HeadAndThreadsFollow) {
  const LiveAnswer live =
      live_sections(screw_with({"mechanism.rollers=6", "mechanism.contacts_per_roller=20"}), {.own = 1});
  EXPECT_THAT(live.head, HasSubstr("6 rollers with 20 threads"));
  EXPECT_EQ(live.threads["threads"], 20);
  EXPECT_EQ(live_sections(screw_with({"mechanism.rollers=6"}), {.own = 1, .quick = true}).head, "");
}

TEST(Report, HeadCountsTheRollersThatAreThere) {
  EXPECT_THAT(report_parts(live_lesson("27_missing_roller.yaml", {"model.bodies=bars"}), {}).head,
              HasSubstr("10 of 11 rollers"));
}

TEST(LiveReport, IsQuickWithWhatFollowsASlider) {
  const input::Source source = live_lesson("28_driving_load.yaml");
  EXPECT_THAT(names_of(live_sections(source, {.quick = true})),
              ElementsAre("verdict", "mechanism", "loads", "pressures", "stiffness"));
  EXPECT_THAT(names_of(live_sections(source, {.quick = true, .sections = {"loads", "slip"}})), ElementsAre("loads"));
}

TEST(LiveReport, ShowsOneThread) {
  const input::Source source = live_lesson("28_driving_load.yaml");
  const LiveAnswer answer = live_sections(source, {.sections = {"thread"}, .thread = ThreadChoice{0, 2}});
  ASSERT_THAT(names_of(answer), ElementsAre("thread"));
  const std::string html = answer.sections["thread"];
  for (const char* part : {"Peak pressure", "thread_pressure", "thread_stress", "thread_friction"})
    EXPECT_THAT(html, HasSubstr(part));
  const LiveAnswer none = live_sections(source, {.sections = {"thread"}, .thread = ThreadChoice{0, 999}});
  EXPECT_THAT(none.sections["thread"].get<std::string>(), HasSubstr("no such thread"));
}

TEST(LiveReport, MovesInputsThatMatter) {
  const std::string controls = report_parts(live_lesson("24_misalignment.yaml"), {}).controls;
  EXPECT_THAT(controls, HasSubstr("data-paths=\"load_cases[0].axial_force "
                                  "load_cases[1].axial_force\" data-value=\"45 kN\""));
  EXPECT_THAT(controls, HasSubstr("min=\"2.2\" max=\"90\" step=\"any\" value=\"45\" "
                                  "data-unit=\"kN\""));
  EXPECT_THAT(controls, HasSubstr("data-value=\"209 GPa\""));
  EXPECT_THAT(controls, HasSubstr("misalignment.nut_tilt.z"));
  // The file overrides the effect of the flank angle.
  EXPECT_THAT(controls, Not(HasSubstr("mechanism.flank_angle")));
  EXPECT_THAT(report_parts(live_lesson("04_contacts_from_geometry.yaml"), {}).controls,
              HasSubstr("mechanism.flank_angle"));
}

TEST(Controls, LongValuesAreShortened) {
  input::Source source = live_lesson("04_contacts_from_geometry.yaml");
  source.overrides.push_back("structure.nut.outer_diameter=2.1 in");  // 53.339999999999996 mm
  source.overrides.push_back("load_cases[0].axial_force=1234.56789012 N");
  const std::string controls = report_parts(source, {}).controls;
  EXPECT_THAT(controls, HasSubstr("data-value=\"2.1 in\""));
  EXPECT_THAT(controls, HasSubstr("data-value=\"1234.57 N\""));
}

TEST(Controls, AddTheirRangeInTheUnitOfTheFile) {
  const std::string controls = report_parts(live_lesson("11_real_parts.yaml"), {}).controls;
  EXPECT_THAT(controls, HasSubstr("data-value=\"2 um\""));
  EXPECT_THAT(controls, HasSubstr("min=\"-2\" max=\"6\" step=\"any\" value=\"2\" "
                                  "data-unit=\"um\""));
}

TEST(Controls, AreInUsUnitsOnSuchAPage) {
  const TableUnits units(UnitSystem::us);
  const std::string controls = report_parts(live_lesson("04_contacts_from_geometry.yaml"), {}).controls;
  for (const char* us : {"data-value=\"0.19685 in\"", "data-unit=\"lbf\"", "data-unit=\"ksi\""})
    EXPECT_THAT(controls, HasSubstr(us));
  for (const char* si : {"data-unit=\"mm\"", "data-unit=\"N\"", "data-unit=\"kN\""})
    EXPECT_THAT(controls, Not(HasSubstr(si)));
}

TEST(LivePage, CarriesTheEngineUnlessStatic) {
  const input::Source source = live_lesson("04_contacts_from_geometry.yaml");
  const std::string still = make_report(source, {.live = false}).html;
  EXPECT_THAT(still, Not(HasSubstr("script-src")));
  const test::TemporaryDirectory parts;
  test::write_live_parts(parts.path());
  const std::string live = make_report(source, {.live_parts = parts.path()}).html;
  EXPECT_THAT(live, HasSubstr("script-src 'sha256-"));
  EXPECT_THAT(live, HasSubstr("connect-src 'none'"));
  EXPECT_GT(live.size(), still.size() + read_live_parts(parts.path()).engine.size());
}

TEST(Report, OfThousandsOfLoadsIsNoLargerThanOthers) {
  SKIP_UNDER_SANITIZERS();
  input::Source source = live_lesson("04_contacts_from_geometry.yaml");
  source.text += "\nlife:\n  position: 29 mm\n  spectrum:\n";
  for (int k = 0; k < 8000; ++k) source.text += "    - {force: 9 kN, direction: tension, share: 0.000125}\n";
  const Report report = make_report(source, {.live = false});
  EXPECT_LT(report.html.size(), 2'500'000u);
  EXPECT_NE(report.html.find("<code>prs check --all</code> shows them"), std::string::npos);
}

TEST(LivePage, IsStaticWhereItsFileIsTooLarge) {
  const test::TemporaryDirectory parts;
  test::write_live_parts(parts.path());
  input::Source source = live_lesson("04_contacts_from_geometry.yaml");
  source.text += "\n# " + std::string(900'000, 'x') + "\n";
  const Report report = make_report(source, {.live_parts = parts.path()});
  EXPECT_LT(report.html.size(), 3'000'000u);
  EXPECT_THAT(report.html, Not(HasSubstr("script-src")));
  EXPECT_THAT(report.notes, Contains(HasSubstr("the page is static: with the engine, the file and its force history")));
  EXPECT_THAT(report.html, HasSubstr("<p id=\"static\">This page is static: with the engine"));
}

}  // namespace
}  // namespace prs
