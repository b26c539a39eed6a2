
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <regex>
#include <set>

#include "prs/loads/case_table.h"
#include "prs/page/page.h"
#include "prs/record/table_units.h"
#include "prs/report/report.h"
#include "prs/report/tables.h"
#include "prs/run/commands.h"
#include "tests/support/made_up_live_parts.h"
#include "tests/support/program.h"
#include "tests/support/sanitized.h"

namespace prs {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

input::Source lesson_source(const std::string& name, std::vector<std::string> overrides = {}) {
  return input::load_source(PRS_SOURCE_DIR "/configs/" + name, std::move(overrides));
}

/// First element that is not closed as required, or another error of the HTML; empty if there is none.
std::string malformed(const std::string& page) {
  static const std::set<std::string> kVoid = {"meta", "img", "input", "wbr"};
  static const std::regex tag("<(/?)([a-z0-9A-Z]+)((?:\\s+[a-zA-Z:-]+(?:=\"[^\"<>]*\")?)*)\\s*(/?)>");
  std::vector<std::string> open;
  std::size_t at = page.find("<html");
  while ((at = page.find('<', at)) != std::string::npos) {
    std::smatch found;
    const std::size_t end = page.find('>', at);
    if (end == std::string::npos) return "no end of a tag";
    const std::string text = page.substr(at, end + 1 - at);
    // A regular expression recurses over long texts: those of files are checked by their quotes.
    if (text.starts_with("<a download=") || text.starts_with("<img alt=") || text.starts_with("<path d=") ||
        text.starts_with("<image x=")) {
      if (std::ranges::count(text, '"') % 2 != 0) return text.substr(0, 60);
      if (text.starts_with("<a ")) open.push_back("a");
      at = end;
      continue;
    }
    if (text.starts_with("<script")) {  // The text of a script is not HTML.
      at = page.find("</script>", at) + 8;
      continue;
    }
    if (!std::regex_match(text, found, tag)) return text.substr(0, 100);
    const std::string name = found[2];
    if (found[1].length() > 0) {
      if (open.empty() || open.back() != name) return "</" + name + ">";
      open.pop_back();
    } else if (found[4].length() == 0 && !kVoid.contains(name)) {
      open.push_back(name);
    }
    at = end;
  }
  return open.empty() ? "" : "<" + open.back() + ">";
}

/// Legends in which entries share a symbol.
std::vector<std::string> ambiguous_legends(const std::string& page) {
  constexpr std::string_view kLegend = "<ul class=\"legend\">", kEntry = "<li>", kEnd = "</svg>";
  std::vector<std::string> found;
  for (std::size_t at = page.find(kLegend); at != page.npos; at = page.find(kLegend, at + 1)) {
    const std::string legend = page.substr(at, page.find("</ul>", at) - at);
    std::set<std::string> symbols;
    std::size_t count = 0;
    for (std::size_t k = legend.find(kEntry); k != legend.npos; k = legend.find(kEntry, k + 1)) {
      symbols.insert(legend.substr(k, legend.find(kEnd, k) - k));
      ++count;
    }
    if (symbols.size() < count) found.push_back(legend);
  }
  return found;
}

struct LessonReport : testing::TestWithParam<std::string> {};

TEST_P(LessonReport, IsOnePageThatAsksForNothingAndSaysWhatTheCommandsSay) {
  const input::Source source = lesson_source(GetParam());
  const Report report = make_report(source, {.live = false});
  if (!test::sanitized()) {  // With the engine; the rest was computed above.
    const test::TemporaryDirectory parts;
    test::write_live_parts(parts.path());
    const std::string live = make_report(source, {.live_parts = parts.path()}).html;
    EXPECT_THAT(live, HasSubstr("script-src"));
    EXPECT_EQ(malformed(live), "");
    EXPECT_LT(live.size(), 3'000'000u);
  }
  EXPECT_EQ(malformed(report.html), "");
  EXPECT_THAT(report.html, HasSubstr("content=\"default-src 'none'; style-src 'sha256-"));
  for (const char* request : {"http:", "https:", " style=\"", "<link", "@import", "url(h", "onerror="})
    EXPECT_EQ(report.html.find(request), std::string::npos) << request;
  for (const char* none : {">nan", " nan", "Lnan", "inf ", ">inf"})
    EXPECT_EQ(report.html.find(none), std::string::npos) << none;
  EXPECT_TRUE(report.converged);
  EXPECT_THAT(ambiguous_legends(report.html), testing::IsEmpty());
  for (const char* raw : {">lemor<", ">flank edge<", ">Static safety limit<"})
    EXPECT_EQ(report.html.find(raw), std::string::npos) << raw;

  const input::CaseInput in = input::read_case_input(source, Command::check);
  if (!input::missing(in, Command::solve).empty()) return;
  const auto document = run(analysis_of(Command::solve), source).document(document_info(source, Command::solve));
  EXPECT_EQ(report.data["results"]["solve"]["load_cases"], document["load_cases"]);
  const auto& first = document["load_cases"].front();
  if (first.contains("axial_stiffness_N_per_um")) {
    EXPECT_THAT(
        report.html,
        HasSubstr(fmt::format("<td>{}</td>", report_number(first["axial_stiffness_N_per_um"].get<double>(), "N/µm"))));
  }
}

std::vector<std::string> lesson_files() {
  std::set<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(PRS_SOURCE_DIR "/configs"))
    if (file.path().extension() == ".yaml" && !other_file(input::load_source(file.path().string(), {})))
      names.insert(file.path().filename());
  return {names.begin(), names.end()};
}
INSTANTIATE_TEST_SUITE_P(Each, LessonReport, testing::ValuesIn(lesson_files()),
                         [](const auto& lesson) { return lesson.param.substr(0, 2); });

TEST(Report, ShowsTextsOfTheCaseAsText) {
  const std::string hostile = "</script><img src=x onerror=alert(1)>&\"'";
  input::Source source = lesson_source("01_config_1_to_3.yaml");
  const std::string name = "config1-tension";
  source.text.replace(source.text.find(name), name.size(), "'" + hostile + "''");
  source = input::source_of_text("<b>" + hostile + ".yaml", source.text, {});
  const test::TemporaryDirectory parts;
  test::write_live_parts(parts.path());
  const Report report = make_report(source, {.command = "prs report '" + hostile + "'", .live_parts = parts.path()});
  EXPECT_THAT(report.html, HasSubstr("id=\"case\""));
  EXPECT_EQ(malformed(report.html), "");
  EXPECT_THAT(report.html, Not(HasSubstr("<img")));
  EXPECT_THAT(report.html, Not(HasSubstr("<b>")));
  EXPECT_THAT(report.html, HasSubstr("&lt;img src=x onerror=alert(1)&gt;"));
  EXPECT_THAT(report.html, HasSubstr("\\u003c/script>\\u003cimg"));
}

TEST(Report, EachCardNamesItsLimitAndWarningsStandBelowTheVerdict) {
  const std::string page =
      make_report(lesson_source("01_config_1_to_3.yaml", {"limits.stiffness=900 N/um"}), {.live = false}).html;
  EXPECT_THAT(page,
              AllOf(HasSubstr("data-tile=\"static_safety\" class=\"red\""), HasSubstr("at least 1, physical limit"),
                    HasSubstr("at least 900.0 N/µm, limits.stiffness"), HasSubstr("temperature (add heat)")));
  EXPECT_THAT(page, Not(HasSubstr(">1.59")));  // Value for equal shares.
  EXPECT_LT(page.find("id=\"verdict\""), page.find("id=\"warnings\""));
  EXPECT_LT(page.find("id=\"warnings\""), page.find("id=\"mechanism\""));
}

/// Peaks of 2.57, 3.99 and 2.92 GPa: the warning must name the worst, not the last.
TEST(Report, PageAndTableTellTheWorstValueWithItsLoadCase) {
  const std::string rest = ", direction: tension, position: 29.1666667 mm}";
  const input::Source source =
      lesson_source("09_slip_and_dissipation.yaml",
                    {"load_cases=[{name: low, axial_force: 13.6 kN" + rest + ", {name: high, axial_force: 47.5 kN" +
                         rest + ", {name: pull, axial_force: 20 kN" + rest + "]",
                     "model.loads=static"});
  const Delivery slip = analysis_of(Command::slip).run(source, input::read_case_input(source, Command::slip));
  double largest = 0.0;
  for (const Warning& warning : slip.warnings())
    if (warning.code == "screw_running_pressure") largest = std::max(largest, *warning.value);
  EXPECT_NEAR(largest, 3.99e9, 0.03e9);
  const std::vector<WarningGroup> groups = grouped(slip.warnings());
  const auto group =
      std::ranges::find(groups, "screw_running_pressure", [](const WarningGroup& g) { return g.worst.code; });
  ASSERT_NE(group, groups.end());
  EXPECT_EQ(group->worst.value.value(), largest);
  EXPECT_EQ(group->where(), "worst in high, and 2 other load cases");
  const std::string page = make_report(source, {.live = false}).html;
  for (const std::string& text : {slip.table(), page})
    EXPECT_THAT(text, AllOf(HasSubstr(group->text().substr(0, 70)), HasSubstr(group->where())));
}

/// Text between two others; empty if these are missing.
std::string between(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t begin = text.find(from);
  if (begin == text.npos) return {};
  return text.substr(begin, text.find(to, begin + from.size()) - begin);
}

/// Names of the records that the page cites.
std::set<std::string> cited_records(const std::string& html) {
  static const std::regex place("<code>docs/validation/([a-z_]+)\\.md</code>");
  std::set<std::string> names;
  for (std::sregex_iterator k(html.begin(), html.end(), place), end; k != end; ++k) names.insert((*k)[1]);
  return names;
}

TEST(Report, CitesTheRecordsOfTheModelsThatItUsed) {
  const auto cited = [](const char* lesson) {
    return cited_records(make_report(lesson_source(lesson), {.live = false}).html);
  };
  EXPECT_EQ(cited("07_contact_geometry.yaml"), (std::set<std::string>{"contact", "measures"}));  // Solves nothing.
  EXPECT_THAT(cited("13_three_models.yaml"), testing::IsSupersetOf({"bars", "refined", "influence"}));
  EXPECT_THAT(cited("24_misalignment.yaml"), testing::Contains("full_mechanism"));
  EXPECT_THAT(cited("30_duty_cycle.yaml"), testing::IsSupersetOf({"slip", "heat"}));
  EXPECT_THAT(cited("33_tolerances.yaml"), testing::Contains("motion"));
  EXPECT_THAT(cited("31_running_screw.yaml"), testing::IsSupersetOf({"life", "running"}));
  EXPECT_EQ(cited("32_press.yaml"), (std::set<std::string>{"size"}));
  for (const char* lesson : {"12_preload.yaml", "14_flight_spectrum.yaml", "18_design_measures.yaml"})
    for (const std::string& record : cited(lesson))
      EXPECT_TRUE(std::filesystem::exists(fmt::format(PRS_SOURCE_DIR "/docs/validation/{}.md", record))) << record;
}

TEST(Report, ADutyCycleIsToldApartFromSteadyStates) {
  const Report report = make_report(lesson_source("30_duty_cycle.yaml"), {.live = false});
  const auto& cycle = report.data["results"]["slip"]["heat_cycle"];
  const std::string power = report_number(cycle["energy_lost_J"].get<double>() / cycle["period_s"].get<double>(), "W");
  EXPECT_THAT(between(report.html, "data-tile=\"Power lost\"", "</dl>"),
              AllOf(HasSubstr(power + " <small>W"), HasSubstr("mean over the cycle")));
  EXPECT_THAT(between(report.html, "data-tile=\"efficiency\"", "data-tile=\"temperature"),
              AllOf(HasSubstr("over the cycle"), Not(HasSubstr("best"))));
  const std::string slip = between(report.html, "<section id=\"slip\"", "<details>");
  const std::size_t steady = slip.find("<h3>Steady: each load case running without pause</h3>"),
                    cyclic = slip.find("<h3>Over the duty cycle</h3>");
  ASSERT_NE(cyclic, std::string::npos);
  EXPECT_LT(steady, slip.find("Power lost</th>"));
  EXPECT_LT(slip.find("Temperature, rollers"), cyclic);
  EXPECT_LT(cyclic, slip.find("Peak, rollers"));
}

TEST(Report, StiffnessTermsThatDoNotAddUpFold) {
  const std::string page = make_report(lesson_source("18_design_measures.yaml"), {.live = false}).html;
  const std::string open = between(page, "<section id=\"measures\"", "<details>");
  EXPECT_THAT(open, Not(HasSubstr("stiffness_terms")));
  EXPECT_THAT(page, HasSubstr("<figcaption>Stiffness terms: contacts with equal thread loads"));
}

TEST(Report, HasWordsForTexts) {
  EXPECT_EQ(report_value("flank_edge", {}), "edge loading");
  EXPECT_EQ(report_value("static", {}), "at rest");
  EXPECT_EQ(report_value("lemor", {}), "Lemor&#39;s formula");
  EXPECT_EQ(report_value("iteration_limit", {}), "iteration limit");
}

TEST(Report, HasNumbersThatReadBack) {
  EXPECT_EQ(report_number(854.8137, "N/µm"), "854.8");
  EXPECT_EQ(report_number(1000.04, "N/µm"), "1000.0");
  EXPECT_EQ(report_number(425.27, "h"), "425");
  EXPECT_EQ(report_number(1234567.0, "h"), "1.23 × 10<sup>6</sup>");
  EXPECT_EQ(report_number(-0.0642634, "mm"), "\u22120.064263");
  EXPECT_EQ(report_number(123456.7, "N"), "123457");
  EXPECT_EQ(report_number(501520676.76, ""), "5.015 × 10<sup>8</sup>");
  EXPECT_EQ(report_number(2.5e-7, ""), "2.500 × 10<sup>\u22127</sup>");
}

TEST(Report, MayBeInInchesAndPounds) {
  const input::Source source = lesson_source("01_config_1_to_3.yaml");
  const TableUnits units(UnitSystem::us);
  std::string page = make_report(source, {.live = false}).html;
  page.erase(page.find("<script"));           // Documents are always SI.
  for (const char* tag : {"<wbr>", "<sub>"})  // In names of keys and in formulas.
    for (std::size_t at; (at = page.find(tag)) != std::string::npos;) page.erase(at, 5);
  EXPECT_THAT(page, HasSubstr("Pitch diameters: screw 0.82677 in"));
  EXPECT_THAT(page, HasSubstr("Lead 0.19685 in, 3 starts"));
  for (const char* si :
       {">N/µm<", ">kN<", ">N<", ">MPa<", ">mm<", ">µm<", "(kN)", "(N/µm)", "Stiffness, N/µm", " GPa "})
    EXPECT_EQ(page.find(si), std::string::npos) << si;
  for (const char* us : {">lbf/µin<", ">lbf<", ">ksi<", ">in<", "data-units=\"us\""}) EXPECT_THAT(page, HasSubstr(us));
}

TEST(Report, KeepsTheDateThatItIsGiven) {
  ::setenv("SOURCE_DATE_EPOCH", "86400", 1);
  const input::Source source = lesson_source("05_standard_screw.yaml");
  const Report first = make_report(source, {"prs report"});
  EXPECT_THAT(first.html, HasSubstr("1970-01-02"));
  EXPECT_EQ(first.html, make_report(source, {"prs report"}).html);
  ::setenv("SOURCE_DATE_EPOCH", "99999999999999999", 1);  // Beyond the range of a calendar.
  EXPECT_NO_THROW(make_report(source, {"prs report"}));
  ::unsetenv("SOURCE_DATE_EPOCH");
}

TEST(ReportCommand, WritesAFileAndNothingElse) {
  const test::TemporaryDirectory folder;
  const std::string lesson = "'" PRS_SOURCE_DIR "/configs/05_standard_screw.yaml'";
  const test::Outcome run = test::run_prs("report " + lesson + " --output page.html", folder.path());
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(test::content_of(folder.path() / "page.html").ends_with("</html>\n"));
  const auto files = std::filesystem::directory_iterator(folder.path());
  EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

TEST(ReportCommand, WritesAndMarksWhatDidNotConverge) {
  const test::TemporaryDirectory folder;
  const test::Outcome run = test::run_prs("report '" PRS_SOURCE_DIR
                                          "/configs/09_slip_and_dissipation.yaml' --output page.html "
                                          "--set 'carrier.nut_torque=150 N m' --set 'load_cases[0].axial_force=80 kN'",
                                          folder.path());
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.err, HasSubstr("prs: slip did not converge"));
  EXPECT_THAT(test::content_of(folder.path() / "page.html"), HasSubstr("Slip did not converge."));
}

TEST(ReportCommand, RefusesWhatIsNoFile) {
  const test::TemporaryDirectory folder;
  const std::string lesson = "'" PRS_SOURCE_DIR "/configs/05_standard_screw.yaml'";
  EXPECT_EQ(test::run_prs("report " + lesson, folder.path()).status, 2);
  EXPECT_EQ(test::run_prs("report " + lesson + " --output .", folder.path()).status, 2);
  EXPECT_EQ(test::run_prs("report " + lesson + " --set mechanism.rollers=x --output page.html", folder.path()).status,
            2);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(ReportCommand, ShowsTheStudyOfTheSameCase) {
  const test::TemporaryDirectory folder;
  const std::string lesson = "'" PRS_SOURCE_DIR "/configs/17_derivatives.yaml'";
  ASSERT_EQ(test::run_prs("study " + lesson + " --quiet --output results", folder.path()).status, 0);
  const auto page = [&](const std::string& more) {
    EXPECT_EQ(test::run_prs("report " + lesson + " --results results --output page.html" + more, folder.path()).status,
              0);
    return test::content_of(folder.path() / "page.html");
  };
  EXPECT_THAT(page(""), AllOf(HasSubstr("download=\"derivatives.csv\""), HasSubstr("data-figure=\"derivatives_01_"),
                              Not(HasSubstr("<img"))));
  EXPECT_THAT(page(" --set mechanism.rollers=8"), Not(HasSubstr("derivatives.csv\"")));
}

TEST(ReportCommand, FoldersOfResultsThatHaveNoneAreTold) {
  const test::TemporaryDirectory folder;
  std::filesystem::create_directory(folder.path() / "empty");
  const auto run = [&](const std::string& command) {
    return test::run_prs(
        command + " '" PRS_SOURCE_DIR "/configs/07_contact_geometry.yaml'" + " --output page.html --results empty",
        folder.path());
  };
  const test::Outcome none = run("report --static --results nowhere");
  EXPECT_EQ(none.status, 2);
  EXPECT_THAT(none.err, HasSubstr("--results: got nowhere, which is no folder; expected one that"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "page.html"));
  const test::Outcome empty = run("report --static");
  EXPECT_EQ(empty.status, 0);
  EXPECT_THAT(empty.err, HasSubstr("--results: empty has no study or optimization of this case"));
  EXPECT_EQ(test::run_prs("explore x.yaml --output ''", folder.path()).status, 2);
}

TEST(WorkbenchCommand, WritesThePageOfAnyCaseAndRefusesWrongOnes) {
  const test::TemporaryDirectory folder;
  const auto run = [&](const std::string& arguments) { return test::run_prs("workbench " + arguments, folder.path()); };
  const std::string lessons = PRS_SOURCE_DIR "/configs/";
  for (const char* const lesson : {"", "14_flight_spectrum.yaml", "32_press.yaml"}) {
    const std::string file = *lesson ? "'" + lessons + lesson + "'" : "";
    const test::Outcome written = run(file + " --output page.html");
    if (written.err.find("the engine of live pages is") != std::string::npos) GTEST_SKIP() << written.err;
    EXPECT_EQ(written.status, 0) << written.err;
    const std::string page = test::content_of(folder.path() / "page.html");
    EXPECT_LT(page.size(), 4'500'000u);
    EXPECT_THAT(page, HasSubstr("default-src 'none'"));
    std::filesystem::remove(folder.path() / "page.html");
  }
  EXPECT_EQ(run("").status, 2);
  EXPECT_EQ(run("--set mechanism.rollers=9 --output page.html").status, 2);
  EXPECT_EQ(run("'" + lessons + "05_standard_screw.yaml' --set mechanism.rollers=no --output page.html").status, 2);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "page.html"));
}

TEST(Svg, DrawsLargeMapsNoFinerThanAScreen) {
  const auto map_of = [](std::size_t nodes) {
    Figure figure{"map", "Map", {"x"}, {"y"}};
    figure.colours = ColourScale{"z", "", 0.0, 2.0};
    GridData& grid = figure.panels.emplace_back().map.grid;
    for (std::size_t k = 0; k < nodes; ++k) {
      grid.x.push_back(static_cast<double>(k) / static_cast<double>(nodes - 1));
      grid.y.push_back(grid.x.back());
    }
    for (const double x : grid.x)
      for (const double y : grid.y) grid.values.push_back(x + y);
    return svg(figure, "m");
  };
  const std::string fine = map_of(1200);
  EXPECT_THAT(fine, HasSubstr("href=\"data:image/png;base64,"));
  EXPECT_LT(fine.size(), 100'000u);
}

TEST(Svg, DrawsTheSameInUnitsOfTables) {
  constexpr double kAround = 14.0;  // Clipped marks may reach over the frame.
  Figure figure{.name = "a", .title = "a", .x = {"Force", "kN", 0.0, 8.0}, .y = {"y", "mm", 0.0, 4.0}};
  const std::size_t line = figure.add(line_of(Colour::blue));
  figure.panels.resize(1);
  figure.panels[0].series = {{line, {{{1.0, 1.0}, {7.0, 3.0}}}}};
  const auto share_of_line = [](const std::string& drawn) {
    const std::size_t last = drawn.find("class=\"s0\""), first = drawn.rfind('l', last);
    const std::size_t clip = drawn.find("<clipPath"), width = drawn.find("width=\"", clip);
    return std::stod(drawn.substr(first + 1)) / (std::stod(drawn.substr(width + 7)) - kAround);
  };
  const std::string si = svg(figure, "x");
  const TableUnits units(UnitSystem::us);
  const std::string us = svg(figure, "x");
  EXPECT_THAT(si, AllOf(HasSubstr("Force (kN)"), HasSubstr("y (mm)")));
  EXPECT_THAT(us, AllOf(HasSubstr("Force (lbf)"), HasSubstr("y (in)"), HasSubstr(">1500<")));
  // Share 7 - 1 in 8, in either unit.
  EXPECT_NEAR(share_of_line(us), 0.75, 1e-3);
  EXPECT_NEAR(share_of_line(si), 0.75, 1e-3);
}

TEST(Svg, DrawsEachKindOfPart) {
  Figure figure{"all", "Lines & <marks>"};
  figure.x = {"Force", "kN"};
  figure.y = {"Share", "%", 0.0, 10.0};
  Panel& panel = figure.panels.emplace_back();
  panel.series.push_back({figure.add("line", line_of(Colour::blue)), {{{0, 1}, {1, 2}, {2, 3}}}});
  panel.series.push_back({figure.add("marks", points_of(Colour::green, Mark::square)), {{{1, 4}}}});
  panel.series.push_back({figure.add("bars", area_of(Colour::grey)), {{{0, 0}, {1, 0}, {1, 5}}}});
  panel.references.push_back({figure.add(line_of(Colour::reference)), 5.0});
  panel.labels.push_back({"a < b", 0.5, 0.5, true});
  const std::string drawn = svg(figure, "f");
  EXPECT_EQ(malformed("<html>" + drawn + "</html>"), "");
  EXPECT_THAT(drawn, HasSubstr("aria-label=\"Lines &amp; &lt;marks&gt;\""));
  EXPECT_THAT(drawn, HasSubstr("a &lt; b"));
  EXPECT_THAT(drawn, HasSubstr("Force (kN)"));
  for (const char* part : {"class=\"s0\"", "class=\"f2\"", "class=\"f7\"", "class=\"s8\""})
    EXPECT_THAT(drawn, HasSubstr(part));
}

}  // namespace
}  // namespace prs
