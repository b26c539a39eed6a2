#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "prs/record/pictures.h"
#include "prs/run/commands.h"
#include "prs/study/study_pictures.h"
#include "support/drawn.h"
#include "support/program.h"
#include "support/shown.h"
#include "support/temporary_directory.h"
#include "tests/support/sample_study.h"

namespace prs {
namespace {

using test::expect_drawn;

Figures of_lesson(const char* file, Command command, std::vector<std::string> overrides = {}) {
  const auto source = input::load_source(std::string(PRS_SOURCE_DIR "/configs/") + file, std::move(overrides));
  const Delivery delivery = run(analysis_of(command), source);
  return figures(delivery.pictures());
}

/// All pictures of each lesson, run as its file first says.
TEST(LessonPlots, TextsStandApart) {
  static const std::regex line(R"(#\s+(prs \w+ configs/(\S+)\.yaml))");
  std::size_t lessons = 0;
  for (const auto& entry : std::filesystem::directory_iterator(PRS_SOURCE_DIR "/configs")) {
    if (entry.path().extension() != ".yaml") continue;
    const std::string text = test::content_of(entry.path());
    std::smatch found;
    ASSERT_TRUE(std::regex_search(text, found, line)) << entry.path();
    SCOPED_TRACE(found[1]);
    const test::TemporaryDirectory folder;
    const std::string command = found[1].str().substr(4);
    const test::Outcome outcome = test::run_prs(command + " --quiet --output '" + folder.path().string() + "'");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    ASSERT_TRUE(std::filesystem::exists(folder.path() / "plots"));
    for (const auto& picture : std::filesystem::directory_iterator(folder.path() / "plots")) {
      SCOPED_TRACE(picture.path().filename());
      expect_drawn(test::content_of(picture.path()));
    }
    ++lessons;
  }
  EXPECT_GE(lessons, 37u);
}

std::optional<Figure> one_of(const Figures& figures, std::string_view name) {
  const auto found = std::ranges::find(figures, name, &Figure::name);
  return found == figures.end() ? std::nullopt : std::optional(*found);
}

TEST(LessonPlots, MixedFrictionHasStribecksCurve) {
  const std::optional<Figure> shown = one_of(of_lesson("29_stribeck.yaml", Command::slip), "stribeck");
  ASSERT_TRUE(shown);
  ASSERT_EQ(shown->panels.size(), 4u);  // friction, efficiency, power, film
  EXPECT_TRUE(shown->x.logarithmic);
  for (const Panel& panel : shown->panels) {
    EXPECT_NEAR(panel.references.back().at, 200.0, 1e-9);  // the speed of the case
    EXPECT_EQ(panel.series.front().parts.front().size(), 41u);
  }
  expect_drawn(*shown);
  EXPECT_FALSE(one_of(of_lesson("09_slip_and_dissipation.yaml", Command::slip), "stribeck"));
}

TEST(LessonPlots, SlipOfAllRollersHasMaps) {
  const Figures shown =
      of_lesson("27_missing_roller.yaml", Command::slip, {"friction={coulomb: 0.1}", "operation={speed: 100 rpm}"});
  EXPECT_FALSE(one_of(shown, "thread_power"));
  const std::optional<Figure> power = one_of(shown, "roller_power");
  ASSERT_TRUE(power);
  ASSERT_EQ(power->panels.size(), 2u);
  const GridData& grid = power->panels[1].map.grid;
  EXPECT_EQ(grid.x.size(), 20u);
  EXPECT_EQ(grid.y.size(), 11u);
  EXPECT_TRUE(std::isnan(grid.at(3, 0)));  // the missing one
  EXPECT_EQ(power->panels[1].labels.at(0).text, "missing");
  EXPECT_GT(grid.at(3, 1), grid.at(3, 5));
  expect_drawn(Figures{*power, *one_of(shown, "roller_friction")});
}

TEST(LessonPlots, ATurnOfTheCarrierEndsWhereItBegan) {
  const std::optional<Figure> turn = one_of(of_lesson("27_missing_roller.yaml", Command::solve), "carrier_turn");
  ASSERT_TRUE(turn);
  for (const Series& series : turn->panels.at(0).series) {
    const Polyline& line = series.parts.at(0);
    EXPECT_DOUBLE_EQ(line.back()[0], line.front()[0] + 360.0);
    EXPECT_EQ(line.back()[1], line.front()[1]);
  }
  EXPECT_DOUBLE_EQ(turn->x.to - turn->x.from, 360.0);
}

TEST(LessonPlots, LoadCasesHaveOneScale) {
  const auto source = input::load_source(PRS_SOURCE_DIR "/configs/24_misalignment.yaml", {});
  const Delivery delivery = run(analysis_of(Command::solve), source);
  const Pictures pictures = delivery.pictures();
  for (const char* name : {"roller_loads", "end_view"}) {
    const Figure first = figure(pictures, name, {.load_case = 0}), second = figure(pictures, name, {.load_case = 1});
    EXPECT_NE(first.title, second.title);
    EXPECT_EQ(first.colours->from, second.colours->from) << name;
    EXPECT_EQ(first.colours->to, second.colours->to) << name;
    EXPECT_EQ(first.colours->unit, second.colours->unit) << name;
  }
  EXPECT_EQ(figure(pictures, "roller_shares", {.load_case = 0}).x.to,
            figure(pictures, "roller_shares", {.load_case = 1}).x.to);
}

TEST(LessonPlots, LoadCasesHaveColoursOfTheirOwn) {
  std::set<Colour> colours;
  for (std::size_t k = 0; k < 7; ++k) colours.insert(case_colour(k));
  EXPECT_EQ(colours.size(), 7u);
  EXPECT_FALSE(colours.contains(Colour::grey));
}

TEST(LessonPlots, TheSectionHasSizesSupportsAndTheLoad) {
  const auto source = input::load_source(PRS_SOURCE_DIR "/configs/05_standard_screw.yaml", {});
  const auto drawn = [&](const char* direction) {
    input::Source turned = source;
    turned.overrides = {std::string("load_cases[0].direction=") + direction};
    const Delivery delivery = run(analysis_of(Command::solve), turned);
    return figure(delivery.pictures(), "section", {.load_case = 0});
  };
  const auto arrow_of = [](const Figure& section) {  // Arrow from its tail to its tip.
    for (const Series& series : section.panels[0].series)
      if (const Style& s = section.styles[series.style]; s.shape == Shape::area && s.colour == Colour::bad)
        return Polyline{series.parts.at(0).at(0), series.parts.at(0).at(3)};
    return Polyline{{0.0, 0.0}, {0.0, 0.0}};
  };
  const Figure pulled = drawn("tension"), pushed = drawn("compression");
  EXPECT_LT(arrow_of(pulled)[1][0], arrow_of(pulled)[0][0]);  // Pointing out of the nut.
  EXPECT_GT(arrow_of(pushed)[1][0], arrow_of(pushed)[0][0]);
  std::string texts, legend;
  for (const Label& label : pulled.panels[0].labels) texts += label.text + "; ";
  for (const LegendEntry& entry : pulled.legend) legend += entry.title + "; ";
  for (const char* text : {"kN; tension", "screw, pitch Ø", "10 rollers; pitch Ø10", "nut Ø"})
    EXPECT_THAT(texts, testing::HasSubstr(text));
  EXPECT_THAT(legend, testing::HasSubstr("section where the nut is held"));
}

/// Top of the mark of the section that holds the nut [mm].
double top_of_mark(const Figure& section) {
  for (const LegendEntry& entry : section.legend)
    for (const Series& series : section.panels[0].series)
      if (entry.title.starts_with("section where") && series.style == entry.style) return series.parts.at(0).at(1)[1];
  return 0.0;
}

TEST(LessonPlots, TheMarkOfAHeldSectionReachesTheLargerDiameterAtAFlange) {
  const auto source = input::load_source(PRS_SOURCE_DIR "/configs/05_standard_screw.yaml", {});
  const Delivery delivery = run(analysis_of(Command::solve), source);
  const Pictures pictures = delivery.pictures();
  for (const std::size_t load_case : {0U, 1U})  // Held at 40 mm and at 60 mm: a flange's two ends.
    EXPECT_GT(top_of_mark(figure(pictures, "section", {.load_case = load_case})), 49.0);
}

TEST(LessonPlots, PreloadHasItsStiffness) {
  const Figures shown = of_lesson("12_preload.yaml", Command::preload);
  ASSERT_EQ(shown.front().panels.size(), 3);
  EXPECT_EQ(shown.front().panels[1].y->unit, "N/µm");
  expect_drawn(shown);
}

TEST(LessonPlots, PicturesOfSeveralLoadCasesAreNumbered) {
  const std::vector<std::string> names = test::names(of_lesson("09_slip_and_dissipation.yaml", Command::slip));
  for (const char* kind : {"slip_patches", "slip_residue"})
    for (const char* number : {"_1", "_2", "_3"}) EXPECT_THAT(names, testing::Contains(std::string(kind) + number));
}

TEST(LessonPlots, TextsOfStudiesStandApart) {
  const StudyResult sampled = sample::sampled(Plan::latin_hypercube);
  expect_drawn(figures(study_pictures(sampled)));
  const StudyResult counting = sample::counting();
  expect_drawn(figures(study_pictures(counting)));
  std::vector<double> many;
  for (int k = 0; k < 12; ++k) many.push_back(1.0 + 0.5 * k);
  Study study;
  study.plan = Plan::grid;
  study.factors = {sample::counted("x", many), sample::counted("y", many)};
  study.responses = {"y"};
  for (Factor& factor : study.factors) factor.continuous = true;
  study.envelope = Envelope{.measures = {{"y", 2.0}}, .points = {{"A", {{1.25, 3.0}}, {}}}};
  const StudyResult maps = sample::run(study, [](const std::vector<double>& x) { return std::vector{x[0] * x[1]}; });
  expect_drawn(figures(study_pictures(maps)));
}

}  // namespace
}  // namespace prs
