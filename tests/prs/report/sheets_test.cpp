#include <gmock/gmock.h>

#include "prs/page/page.h"
#include "prs/report/report.h"
#include "prs/report/tables.h"
#include "tests/support/made_up_live_parts.h"
#include "tests/support/temporary_directory.h"

namespace prs {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kLesson = PRS_SOURCE_DIR "/configs/05_standard_screw.yaml";

input::Source with_block(const std::string& block) {
  input::Source source = input::load_source(kLesson, {});
  source.text += "\n" + block;
  return source;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(TitleBlock, SaysWhatTheFileSaysOfTheReport) {
  const std::string page =
      make_report(with_block("report: {title: Press 40 kN, customer: \"</style><b>A & B\", number: "
                             "C-12, revision: B, author: Jane}"),
                  {.live = false})
          .html;
  EXPECT_THAT(page, AllOf(HasSubstr("<h1>Press 40 kN</h1>"), HasSubstr("<title>Press 40 kN · "),
                          HasSubstr("<dd>&lt;/style&gt;&lt;b&gt;A &amp; B</dd>"), HasSubstr("<dd>Jane</dd>"),
                          Not(HasSubstr("<b>"))));
  EXPECT_THAT(page, HasSubstr("@bottom-left{content:\"Press 40 kN · No\\2e  C\\2d 12 · rev"));
  EXPECT_THAT(page, Not(HasSubstr("<code>report.")));  // Not an input of the calculation.
  EXPECT_THAT(make_report(input::load_source(kLesson, {}), {.live = false}).html,
              HasSubstr("<h1>05_standard_screw</h1>"));
}

TEST(TitleBlock, TakesKnownKeysAlone) {
  EXPECT_THROW(make_report(with_block("report: {titel: x}"), {.live = false}), input::InputError);
}

TEST(TitleBlock, TextsCannotLeaveTheStyleOfTheSheets) {
  const std::string page =
      make_report(with_block("report: {title: '</style><script>x</script>\"}\\'}"), {.live = false}).html;
  EXPECT_EQ(count_of(page, "</style>"), 1u);
  EXPECT_THAT(page, Not(HasSubstr("<script>x")));
}

TEST(Sheets, GoFromTheAnswerToTheNumbers) {
  std::vector<std::string> ids;
  for (const ReportSection& section : report_parts(input::load_source(kLesson, {}), {}).sections)
    ids.push_back(section.id);
  EXPECT_THAT(ids, ElementsAre("summary", "verdict", "warnings", "mechanism", "inputs", "loads", "pressures",
                               "stiffness", "life", "slip", "preload", "measures", "response", "fit", "references",
                               "models", "contacts", "studies", "data", "provenance", "glossary"));
}

TEST(Summary, IsOneSheetToSign) {
  const std::string page = make_report(with_block("limits: {static_safety: 2}\nreport: {title: Press, author: Jane}"),
                                       {.live = false, .summary = true})
                               .html;
  EXPECT_THAT(page, AllOf(HasSubstr("class=\"page is-summary\""), HasSubstr("<h3>Requirement</h3>"),
                          HasSubstr("Static safety at least 2"), HasSubstr("data-figure=\"section\""),
                          HasSubstr("<th scope=\"row\">Prepared</th><td>Jane</td>"), HasSubstr(">Approved<"),
                          Not(HasSubstr("id=\"loads\""))));
  EXPECT_EQ(count_of(page, "<div class=\"value\">"), 5u);
  EXPECT_THAT(make_report(with_block(""), {.live = false}).html, HasSubstr("<section id=\"summary\""));
}

TEST(Summary, IsOfACase) {
  EXPECT_THROW(
      make_report(input::load_source(PRS_SOURCE_DIR "/configs/32_press.yaml", {}), {.live = false, .summary = true}),
      input::InputError);
}

TEST(Glossary, HasEachWordThatTheNumbersLeadTo) {
  for (const char* lesson : {"05_standard_screw.yaml", "24_misalignment.yaml", "30_duty_cycle.yaml", "32_press.yaml"}) {
    const std::string page =
        make_report(input::load_source(std::string(PRS_SOURCE_DIR "/configs/") + lesson, {}), {.live = false}).html;
    const std::string link = "href=\"#term-";
    std::size_t links = 0;
    for (std::size_t at = page.find(link); at != page.npos; at = page.find(link, at + 1), ++links) {
      const std::size_t begin = at + link.size() - 5;
      const std::string id = page.substr(begin, page.find('"', begin) - begin);
      EXPECT_THAT(page, HasSubstr("<dt id=\"" + id + "\">")) << lesson;
    }
    EXPECT_GT(links, 20u) << lesson;
  }
}

TEST(Prose, HasTheSignsOfPrint) {
  EXPECT_EQ(prose_html("2 um at 80 degC, 7850 kg/m^3, 30 mm^2/s, 10^-4, N/mm^1.5; run `prs check --set x='2 um'`"),
            "2 µm at 80 °C, 7850 kg/m³, 30 mm²/s, 10<sup>-4</sup>, N/mm<sup>1.5</sup>; run <code>prs check --set "
            "x=&#39;2 um&#39;</code>");
  EXPECT_EQ(prose_html("aluminum <b> column"), "aluminum &lt;b&gt; column");
  EXPECT_EQ(breakable_html("load_cases[0].name"), "load_<wbr>cases<wbr>[0].<wbr>name");
}

/// Units as a keyboard has them, and backquotes, stand nowhere but in code.
TEST(Sheets, AreSetAsPrint) {
  for (const char* lesson : {"30_duty_cycle.yaml", "37_bench.yaml"}) {
    std::string page =
        make_report(input::load_source(std::string(PRS_SOURCE_DIR "/configs/") + lesson, {}), {.live = false}).html;
    page = page.substr(page.find("<body>"), page.find("<script type") - page.find("<body>"));
    for (const auto& [from, to] :
         {std::pair{"<code>", "</"}, {"<span class=\"mono\">", "</"}, {" title=\"", "\">"}, {"href=\"data:", "\">"}})
      for (std::size_t at = page.find(from); at != page.npos; at = page.find(from, at))
        page.erase(at, page.find(to, at) - at);
    for (const char* letters : {"`", " um<", " um,", "degC", "kg/m^3"})
      EXPECT_THAT(page, Not(HasSubstr(letters))) << lesson;
  }
}

TEST(Sheets, SayWhetherLoadsAreThoseAtRestOrRunning) {
  const std::string page =
      make_report(input::load_source(PRS_SOURCE_DIR "/configs/31_running_screw.yaml", {}), {.live = false}).html;
  for (const char* picture : {"load_distribution", "peak_pressure", "ellipses", "section"}) {
    const std::size_t at = page.find(std::string("data-figure=\"") + picture);
    ASSERT_NE(at, page.npos) << picture;
    EXPECT_THAT(page.substr(at, page.find("</figcaption>", at) - at), HasSubstr("at rest")) << picture;
  }
  EXPECT_THAT(page, HasSubstr("those of thread loads running"));
}

TEST(Sheets, FoldWhatOnlySomeAskFor) {
  const std::string page = make_report(input::load_source(kLesson, {}), {.live = false}).html;
  const std::size_t fold = page.find("<details><summary>Every number of the load cases");
  ASSERT_NE(fold, page.npos);
  EXPECT_LT(fold, page.find("Hertz constant"));
  EXPECT_LT(page.find("Axial stiffness"), fold);
  EXPECT_NE(page.find("details:not([open])", page.find("@media print")), page.npos);
  EXPECT_EQ(folded_html("Nothing", ""), "");
}

TEST(Sheets, HaveNoKeysForWords) {
  const std::string page =
      make_report(input::load_source(PRS_SOURCE_DIR "/configs/27_missing_roller.yaml", {}), {.live = false}).html;
  for (const char* key : {">Semi major<", ">Dofs<", ">Source<", ">Power loss input output<", ">l10<", ">Rated<", ">At<",
                          ">Stiffness SI<"})
    EXPECT_THAT(page, Not(HasSubstr(key)));
}

TEST(Sheets, NamesOfLoadCasesDoNotTurnTheWriting) {
  input::Source source = input::load_source(kLesson, {});
  source.overrides = {"load_cases[0].name=\u202Eevil"};
  EXPECT_EQ(report_parts(source, {}).threads["cases"][0], "\uFFFDevil");
  const test::TemporaryDirectory parts;
  test::write_live_parts(parts.path());
  EXPECT_THAT(make_report(source, {.live_parts = parts.path()}).html,
              AllOf(Not(HasSubstr("\u202E")), HasSubstr("\\u202e")));
}

TEST(ReportUnits, AreOfOneKind) {
  EXPECT_EQ(report_unit("axial_force_N", "N", 19000.0).text, "kN");
  EXPECT_EQ(report_unit("normal_load_N", "N", 85.0).text, "N");
  EXPECT_EQ(report_unit("peak_pressure_MPa", "MPa").text, "GPa");
  EXPECT_DOUBLE_EQ(report_unit("peak_pressure_MPa", "MPa").factor, 1e-3);
}

TEST(PageSvg, HasTheSignsOfPrint) {
  Figure figure{"travel", "Travel"};
  figure.x = {"Row", "", 0.0, 1.0};
  figure.y = {"Travel", "um", 0.0, 1.0};
  figure.panels.emplace_back().series = {{figure.add("a", line_of(Colour::blue)), {{{0.0, 0.0}, {1.0, 1.0}}}}};
  EXPECT_THAT(svg(figure, "f"), HasSubstr("Travel (µm)"));
}

TEST(PageSvg, HasAnImageForEachPanel) {
  Figure figure{"two", "Two panels"};
  figure.columns = 2;
  figure.x = {"Thread", "", 0.0, 2.0};
  figure.y = {"Peak pressure", "GPa", 0.0, 4.0};
  const std::size_t line = figure.add("a < b", line_of(Colour::blue));
  for (const char* title : {"left", "right"}) {
    Panel& panel = figure.panels.emplace_back();
    panel.title = title;
    panel.series = {{line, {{{0.0, 0.0}, {2.0, 2.0}}}}};
  }
  const std::string drawn = svg(figure, "f");
  EXPECT_EQ(count_of(drawn, "class=\"half\" role=\"img\""), 2u);
  EXPECT_EQ(count_of(drawn, "Peak pressure (GPa)"), 2u);  // Each is separate on a phone.
  EXPECT_EQ(count_of(drawn, "clipPath id=\"f-1-0\""), 1u);
  EXPECT_EQ(count_of(drawn, "clipPath id=\"f-0-0\""), 1u);
  EXPECT_THAT(drawn, HasSubstr("<ul class=\"legend\">"));
  EXPECT_THAT(drawn, HasSubstr("a &lt; b</li>"));
}

}  // namespace
}  // namespace prs
