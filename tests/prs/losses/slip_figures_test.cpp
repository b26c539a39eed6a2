#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "prs/losses/slip_figures.h"
#include "prs/output/files.h"
#include "support/drawn.h"
#include "support/sample_slip.h"
#include "support/shown.h"
#include "support/temporary_directory.h"

namespace prs {
namespace {

namespace fs = std::filesystem;
using test::equal_share_case;
using test::expect_drawn;
using test::failed_case;
using test::sample_pictures;
using test::solved_case;
using test::TemporaryDirectory;
using test::with_slip;
using test::without_equilibrium;

Result slip_sweeps() {
  Result result = test::sweeps({"config1"});
  for (LoadCaseResult& load_case : result.load_cases) load_case = with_slip(std::move(load_case));
  return result;
}

std::optional<Figure> slip_picture(const Result& result, const char* name) {
  return test::shown(slip_pictures(Case{}, result), name);
}

/// Figures without the patches, which need a case.
Figures of_powers(const Result& result) {
  Figures all;
  for (const Picture& picture : slip_pictures(Case{}, result))
    if (picture.drawn == Picture::Drawn::always && !picture.name.starts_with("slip_"))
      for (Figure& figure : picture.make({})) all.push_back(std::move(figure));
  return all;
}

bool has_style(const Figure& figure, const Panel& panel, const std::string& title) {
  for (const LegendEntry& entry : figure.legend)
    if (entry.title == title)
      return std::any_of(panel.series.begin(), panel.series.end(),
                         [&](const Series& line) { return line.style == entry.style; });
  return false;
}

Figures with_patches(const Result& result, const SlipPictures& pictures = sample_pictures()) {
  Figures all = of_powers(result);
  all.push_back(slip_patch_figure(result.load_cases.back(), pictures));
  all.push_back(slip_residue_figure(result.load_cases.back(), pictures));
  return all;
}

TEST(SlipFigures, ThreadPowersStandBesideTheLevelOfEqualShares) {
  const Result result = slip_sweeps();
  const auto figure = slip_picture(result, "thread_power");
  ASSERT_TRUE(figure);
  ASSERT_EQ(figure->panels.size(), 4);
  const Panel& panel = figure->panels[0];
  const SlipResult& full = *result.load_cases[8].slip;
  ASSERT_EQ(panel.references.size(), 1);
  EXPECT_DOUBLE_EQ(panel.references[0].at, full.equal_shares->thread_power.screw);
  EXPECT_DOUBLE_EQ(panel.series.at(0).parts[0][3][1], full.threads.screw.power[3]);
  EXPECT_EQ(figure->legend.back().title, "every thread with equal thread loads");
}

TEST(SlipFigures, ThreadPowersWithoutEqualSharesHaveNoLevel) {
  Result result;
  result.load_cases = {with_slip(solved_case("a", 45e3, Direction::tension))};
  result.load_cases[0].slip->equal_shares.reset();
  const auto figure = slip_picture(result, "thread_power");
  ASSERT_TRUE(figure);
  EXPECT_EQ(figure->legend.size(), 1);
  EXPECT_EQ(figure->panels[0].series.size(), 1);
}

TEST(SlipFigures, TemperaturesOfADutyStandOverItsTime) {
  Result result = slip_sweeps();
  EXPECT_FALSE(slip_picture(result, "heat_cycle"));
  HeatCycle& cycle = result.heat_cycle.emplace();
  cycle.status = HeatStatus::converged;
  cycle.period = 4.0;
  cycle.time = {0.0, 2.0, 4.0};
  cycle.temperature = {{300.0, 310.0, 300.0}, {300.0, 320.0, 300.0}, {300.0, 305.0, 300.0}};
  cycle.mean = {305.0, 310.0, 302.0};
  const std::optional<Figure> figure = slip_picture(result, "heat_cycle");
  ASSERT_TRUE(figure);
  EXPECT_EQ(figure->x.unit, "s");
  EXPECT_EQ(figure->x.to, 4.0);
  ASSERT_EQ(figure->panels.size(), 1U);
  ASSERT_EQ(figure->panels[0].series.size(), 3U);
  EXPECT_NEAR(figure->panels[0].series[1].parts[0][1][1], 320.0 - 273.15, 1e-12);
  ASSERT_EQ(figure->legend.size(), 3U);
  EXPECT_EQ(figure->legend[1].title, "rollers");
}

TEST(SlipFigures, CasesWithoutAnAnswerHaveNone) {
  Result result;
  result.load_cases = {without_equilibrium(solved_case("a", 45e3, Direction::tension)), failed_case("b"),
                       equal_share_case("c")};
  EXPECT_FALSE(slip_picture(result, "thread_power"));
  EXPECT_FALSE(slip_picture(result, "power_by_source"));
}

TEST(SlipFigures, ArrowsOfThePatchFollowTheVelocityAndDoNotOverlap) {
  const SlipPictures pictures = sample_pictures();
  const Figure figure = slip_patch_figure(with_slip(solved_case("a", 45e3, Direction::tension)), pictures);
  ASSERT_EQ(figure.panels.size(), 2);
  for (const Interface i : kInterfaces) {
    const PatchField& field = (*pictures.most_loaded_thread)[i];
    const Panel& panel = figure.panels[i == Interface::screw ? 0 : 1];
    EXPECT_EQ(std::ranges::count_if(panel.map.grid.values, [](double v) { return v == v; }),
              static_cast<std::ptrdiff_t>(field.friction_coefficient.size()));
    const auto& arrows = panel.series[1].parts;
    ASSERT_GT(arrows.size(), 60);
    EXPECT_LT(arrows.size(), 11 * 11);
    const double spacing = 2e3 * 2.0 * field.semi_minor / field.points;
    double longest = 0.0;
    for (const Polyline& arrow : arrows)
      longest = std::max(longest, std::hypot(arrow[1][0] - arrow[0][0], arrow[1][1] - arrow[0][1]));
    EXPECT_LE(longest, spacing * 1.0001);
    EXPECT_GT(longest, 0.8 * spacing);
  }
  // Pure spin, counterclockwise: upwards on the right.
  const auto& spin = figure.panels[1].series[1].parts;
  const auto right =
      std::max_element(spin.begin(), spin.end(), [](const auto& a, const auto& b) { return a[0][0] < b[0][0]; });
  EXPECT_GT((*right)[1][1], (*right)[0][1]);
}

TEST(SlipFigures, EvenFrictionHasAColourRangeFromZero) {
  SlipPictures pictures = sample_pictures();
  for (const Interface i : kInterfaces)
    for (double& value : (*pictures.most_loaded_thread)[i].friction_coefficient) value = 0.11;
  const Figure figure = slip_patch_figure(with_slip(equal_share_case("coulomb")), pictures);
  ASSERT_TRUE(figure.colours);
  EXPECT_EQ(figure.colours->from, 0.0);
  EXPECT_EQ(figure.colours->to, 0.11);
}

TEST(SlipFigures, ResidueCurvesAddUpToTheirSum) {
  const Figure figure = slip_residue_figure(with_slip(solved_case("a", 45e3, Direction::tension)), sample_pictures());
  ASSERT_EQ(figure.panels.size(), 2);
  for (const Panel& panel : figure.panels) {
    ASSERT_EQ(panel.series.size(), 5);
    EXPECT_EQ(panel.references.size(), 3);
    for (std::size_t k = 0; k < panel.series.back().parts[0].size(); ++k) {
      double sum = 0.0;
      for (std::size_t c = 0; c < 4; ++c) sum += panel.series[c].parts[0][k][1];
      EXPECT_NEAR(panel.series[4].parts[0][k][1], sum, 1e-9);
    }
  }
}

TEST(SlipFigures, AreasOfPowerStackUpToTheTotal) {
  const Result result = slip_sweeps();
  const Figures figures = of_powers(result);
  ASSERT_GE(figures.size(), 2);
  EXPECT_EQ(figures[0].name, "power_by_source");
  EXPECT_EQ(figures[1].name, "power_by_source_2");
  const Panel& power = figures[0].panels[0];
  EXPECT_TRUE(has_style(figures[0], power, "roller-carrier"));
  EXPECT_FALSE(has_style(figures[0], power, "carrier-nut"));
  const std::size_t top = power.series.size() - 2;
  const Polyline& area = power.series[top].parts[0];
  ASSERT_EQ(area.size(), 2 * 9);
  EXPECT_DOUBLE_EQ(area[9][0], 45.0);
  EXPECT_DOUBLE_EQ(area[9][1], result.load_cases[8].slip->power.total());
}

TEST(SlipFigures, SweepIsSortedAndBrokenWhereThereIsNoAnswer) {
  const SlipResult good = *with_slip(solved_case("a", 45e3, Direction::tension)).slip;
  SlipResult bad = good;
  bad.status = SlipStatus::no_equilibrium;
  const Figure figure = power_by_source_figure({5, 4, 3, 2, 1}, {"x"}, {good, good, bad, good, good}, {});
  EXPECT_EQ(figure.x.from, 1.0);
  EXPECT_EQ(figure.x.to, 5.0);
  EXPECT_EQ(figure.panels[1].series[0].parts.size(), 2);
}

TEST(SlipFigures, ReferencesStandInBothPanels) {
  const SlipResult slip = *with_slip(solved_case("a", 45e3, Direction::tension)).slip;
  PowerFigureOptions options;
  options.relative_to = slip.power.total();
  options.references = {{"reference", 20.0, slip.power.total(), 0.786}};
  options.comparison_title = "other model";
  options.comparison = {{10.0, 0.7}, {30.0, 0.8}};
  const Figure figure = power_by_source_figure({10, 20, 30}, {"Screw diameter", "mm"}, {slip, slip, slip}, options);
  for (const Panel& panel : figure.panels) EXPECT_TRUE(has_style(figure, panel, "reference"));
  EXPECT_TRUE(has_style(figure, figure.panels[1], "other model"));
  EXPECT_NEAR(figure.panels[0].series.back().parts[0][0][1], 100.0, 1e-9);
}

TEST(SlipPlots, EveryFigureIsDrawn) { expect_drawn(with_patches(slip_sweeps())); }

TEST(SlipFigures, NoThreadThatTouchesHasNoPatches) {
  SlipPictures pictures = sample_pictures();
  pictures.most_loaded_thread.reset();
  EXPECT_TRUE(slip_patch_figure(with_slip(equal_share_case("coulomb")), pictures).panels.empty());
}

TEST(SlipPlots, DegenerateValuesAreDrawn) {
  Result result;
  result.load_cases = {with_slip(equal_share_case("still"))};
  SlipPictures pictures = sample_pictures();
  for (const Interface i : kInterfaces) {
    PatchField& field = (*pictures.most_loaded_thread)[i];
    std::fill(field.sliding_major.begin(), field.sliding_major.end(), 0.0);
    std::fill(field.sliding_minor.begin(), field.sliding_minor.end(), 0.0);
    std::fill(field.friction_coefficient.begin(), field.friction_coefficient.end(), 0.0);
  }
  pictures.residue_near_root = {{0.373, 0.373}, {{}, {}}};
  expect_drawn(with_patches(result, pictures));
}

}  // namespace
}  // namespace prs
