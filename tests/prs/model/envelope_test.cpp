#include "prs/study/study_result.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "prs/study/designs.h"

namespace prs {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A continuous factor in mm.
Factor factor(std::string path, const std::vector<double>& numbers) {
  Factor f;
  f.path = f.label = std::move(path);
  f.unit = "mm";
  f.continuous = true;
  for (const double number : numbers) f.levels.push_back({fmt::format("{} mm", number), number});
  return f;
}

std::vector<double> steps(double from, double to, int count) {
  std::vector<double> all;
  for (int k = 0; k < count; ++k) all.push_back(from + (to - from) * k / (count - 1));
  return all;
}

using Formula = std::function<std::vector<double>(double x, double y)>;

/// A study over x and y, and its rows by a formula in place of a solver.
struct Grid {
  Study study;
  RowBlock rows;

  Grid(Factor x, Factor y, std::vector<std::string> responses, const Formula& formula) {
    study.plan = Plan::grid;
    study.factors = {std::move(x), std::move(y)};
    study.responses = std::move(responses);
    study.envelope.emplace();
    rows.rows = design_count(study);
    for (std::size_t k = 0; k < rows.rows; ++k) {
      const std::vector<Draw> drawn = draws(study, k);
      const auto at = [&](std::size_t f) { return k == 0 ? 0.0 : *study.factors[f].levels[drawn[f].level].number; };
      for (const double value : formula(at(0), at(1))) rows.responses.push_back(value);
    }
  }

  GridMaps maps() const {
    GridMapCollector collector(study);
    collector.add(rows);
    return *collector.maps();
  }
  EnvelopeResult envelope() const { return evaluate_envelope(study, maps()); }
};

Grid linear() {
  return {factor("x", {3.0, 1.0, 2.0, 4.0}), factor("y", steps(10.0, 20.0, 6)), {"a", "b"}, [](double x, double y) {
            return std::vector{2.0 * x + y, x * y};
          }};
}

TEST(GridMaps, NodesAscendWhateverTheOrderOfTheLevels) {
  const GridMaps maps = linear().maps();
  EXPECT_THAT(maps.axes[0].numbers, ElementsAre(1.0, 2.0, 3.0, 4.0));
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 6; ++j)
      EXPECT_EQ(maps.responses[1][maps.node(i, j)], maps.axes[0].numbers[i] * maps.axes[1].numbers[j]);
  EXPECT_EQ(maps.design(maps.node(0, 0)), 7U);  // x = 1 is the second level of six designs each.
}

TEST(GridMaps, BilinearFunctionIsReproducedEverywhere) {
  const GridMaps maps = linear().maps();
  for (const double u : {0.0, 0.3, 1.0, 2.75, 3.0})
    for (const double v : {0.0, 0.5, 4.2, 5.0}) {
      const double x = maps.axes[0].number(u), y = maps.axes[1].number(v);
      EXPECT_NEAR(map_value(maps, maps.responses[1], {u, v}), x * y, 1e-12);
      EXPECT_NEAR(*maps.axes[0].place(x), u, 1e-12);
      EXPECT_NEAR(*maps.axes[1].place(y), v, 1e-12);
    }
  EXPECT_FALSE(maps.axes[0].place(0.999));
  EXPECT_FALSE(maps.axes[0].place(4.001));
}

TEST(GridMaps, LogarithmicAxisIsGeometricBetweenNodes) {
  Factor x = factor("x", {1.0, 10.0, 100.0});
  x.logarithmic = true;
  const Grid grid(x, factor("y", {0.0, 1.0}), {"a"},
                  [](double at, double) { return std::vector{std::log10(std::max(at, 1.0))}; });
  const GridMaps maps = grid.maps();
  EXPECT_NEAR(maps.axes[0].number(0.5), std::sqrt(10.0), 1e-14);
  EXPECT_NEAR(*maps.axes[0].place(std::sqrt(1000.0)), 1.5, 1e-14);
  EXPECT_NEAR(map_value(maps, maps.responses[0], {1.25, 0.5}), 1.25, 1e-14);
}

TEST(GridMaps, CompanionsAreInterpolatedWithTheirFactor) {
  Grid grid = linear();
  grid.study.factors[1].companions = {factor("roller", steps(4.0, 9.0, 6))};
  const GridMaps maps = grid.maps();
  const std::vector<Level> inputs = inputs_at(grid.study, maps, {1.5, 2.25});
  ASSERT_EQ(inputs.size(), 3U);
  EXPECT_EQ(inputs[0].text, "2.5 mm");
  EXPECT_NEAR(*inputs[1].number, 14.5, 1e-12);
  EXPECT_NEAR(*inputs[2].number, 6.25, 1e-12);
  EXPECT_TRUE(maps.axes[1].continuous);
  grid.study.factors[1].companions[0].continuous = false;
  EXPECT_FALSE(grid.maps().axes[1].continuous);
}

TEST(GridMaps, NeedTwoFactorsWithDifferentNumbers) {
  Study study = linear().study;
  EXPECT_TRUE(map_axes(study));
  study.factors[0].levels[1] = study.factors[0].levels[0];
  EXPECT_FALSE(map_axes(study));
  study = linear().study;
  study.factors[0].levels[1].number.reset();
  EXPECT_FALSE(map_axes(study));
  study = linear().study;
  study.plan = Plan::one_at_a_time;
  EXPECT_FALSE(map_axes(study));
}

// Jung 2017, table 8.1: parameters "normalized by their root mean square values", which gives the
// printed scale, all of its digits, for the nut's outer diameters.
TEST(Envelope, RootMeanSquareGivesTheScaleOfJung) {
  Grid grid(factor("D_n", {40.0, 46.67, 53.34, 60.01, 66.68, 73.35, 80.02, 86.69, 93.36, 100.03}),
            factor("p", {3.0, 5.0}), {"D_n"}, [](double d, double) { return std::vector{d}; });
  grid.study.envelope->measures = {{"D_n", 1.0}};
  const GridMaps maps = grid.maps();
  const GridMap map = normalised(maps, grid.envelope().measures[0]);
  constexpr double kPrinted[] = {0.55104921,  0.642936666, 0.734824122, 0.826711577, 0.918599033,
                                 1.010486489, 1.102373945, 1.1942614,   1.286148856, 1.378036312};
  for (std::size_t i = 0; i < 10; ++i) EXPECT_NEAR(map[maps.node(i, 1)], kPrinted[i], 5.1e-10) << i;
}

TEST(Envelope, ProductHasWeightsAsExponentsAndSumAsFactors) {
  Grid grid = linear();
  grid.study.envelope->measures = {{"a", 3.0}, {"b", -0.5}};
  const GridMaps maps = grid.maps();
  double squares_a = 0.0, squares_b = 0.0, largest = 0.0;
  for (std::size_t k = 0; k < maps.nodes(); ++k) {
    squares_a += maps.responses[0][k] * maps.responses[0][k];
    squares_b += maps.responses[1][k] * maps.responses[1][k];
    largest = std::max(largest, maps.responses[1][k]);
  }
  const double n = static_cast<double>(maps.nodes());
  const double rms_a = std::sqrt(squares_a / n), rms_b = std::sqrt(squares_b / n);
  const EnvelopeResult product = grid.envelope();
  EXPECT_NEAR(product.measures[0].rms / rms_a, 1.0, 1e-14);
  for (std::size_t k = 0; k < maps.nodes(); ++k) {
    const double a = maps.responses[0][k] / rms_a, b = maps.responses[1][k] / rms_b;
    EXPECT_NEAR(product.values[k] / (a * a * a / std::sqrt(b)), 1.0, 1e-13);
  }
  grid.study.envelope->combine = Envelope::Combine::sum;
  grid.study.envelope->normalise = Envelope::Normalise::max;
  const EnvelopeResult sum = grid.envelope();
  for (std::size_t k = 0; k < maps.nodes(); ++k)
    EXPECT_NEAR(sum.values[k], 3.0 * maps.responses[0][k] / 28.0 - 0.5 * maps.responses[1][k] / largest, 1e-13);
}

// Errata of Jung, item 7: as factors of a product the weights only rescale it.
TEST(Envelope, WeightsMoveTheBestDesignOfAProduct) {
  const auto best_x = [](double weight) {
    Grid grid(factor("x", steps(1.0, 5.0, 401)), factor("y", {1.0, 2.0}), {"a", "b"}, [](double x, double) {
      return std::vector{x, 6.0 - x};
    });
    grid.study.envelope->measures = {{"a", weight}, {"b", 1.0}};
    const EnvelopeResult result = grid.envelope();
    const GridMaps maps = grid.maps();
    return maps.axes[0].numbers[*result.best / maps.axes[1].nodes()];
  };
  // x^w (6 - x) is largest at 6 w/(w + 1).
  EXPECT_NEAR(best_x(1.0), 3.0, 0.01);
  EXPECT_NEAR(best_x(2.0), 4.0, 0.01);
  EXPECT_NEAR(best_x(0.5), 2.0, 0.01);
}

TEST(Envelope, UnitsDoNotMatterToANormalisedProduct) {
  Grid newtons(factor("x", steps(1.0, 3.0, 5)), factor("y", steps(2.0, 4.0, 5)), {"a", "b"}, [](double x, double y) {
    return std::vector{x * x + y, y / x};
  });
  Grid kilonewtons = newtons;
  for (std::size_t k = 0; k < kilonewtons.rows.responses.size(); k += 2) kilonewtons.rows.responses[k] *= 1e-3;
  newtons.study.envelope->measures = kilonewtons.study.envelope->measures = {{"a", 2.0}, {"b", -1.0}};
  const EnvelopeResult a = newtons.envelope(), b = kilonewtons.envelope();
  for (std::size_t k = 0; k < a.values.size(); ++k) EXPECT_NEAR(a.values[k] / b.values[k], 1.0, 1e-13);
}

TEST(Envelope, GivenPointHasTheValuesThere) {
  Grid grid = linear();
  grid.study.envelope->measures = {{"b", 1.0}};
  grid.study.envelope->normalise = Envelope::Normalise::none;
  grid.study.envelope->points = {{"A", {{1.5, 11.0}}, {}}, {"B", {{3.0, 14.0}}, {}}, {"C", {}, {}}};
  const EnvelopeResult result = grid.envelope();
  ASSERT_EQ(result.points.size(), 3U);
  EXPECT_NEAR(result.points[0].envelope, 16.5, 1e-12);
  EXPECT_NEAR(result.points[0].responses[0], 14.0, 1e-12);
  EXPECT_FALSE(result.points[0].design);
  EXPECT_EQ(*result.points[1].design, 3U);  // x = 3 is the first level.
  EXPECT_EQ(result.points[1].inputs[1].text, "14 mm");
  EXPECT_EQ(result.points[2].envelope, 80.0);  // The best: x = 4, y = 20.
  EXPECT_EQ(result.points[2].inputs[0].text, "4 mm");
}

TEST(Envelope, OneTargetIsMetWhereTheEnvelopeIsBest) {
  Grid grid = linear();
  grid.study.envelope->measures = {{"b", 1.0}};
  grid.study.envelope->points = {{"B", {}, {{"a", 20.0}}}, {"low", {}, {{"a", 11.0}}}};
  const EnvelopeResult result = grid.envelope();
  const EnvelopePoint& point = result.points[0];
  // On 2 x + y = 20 the product x y grows with x until 5: at the grid's x = 4, y = 12.
  EXPECT_NEAR(point.responses[0], 20.0, 1e-12);
  EXPECT_NEAR(*point.inputs[0].number, 4.0, 1e-12);
  EXPECT_NEAR(*point.inputs[1].number, 12.0, 1e-12);
  EXPECT_THAT(result.points[1].reason, HasSubstr("a lies between 12 and 28 in the grid, 11 is"));
  EXPECT_THAT(result.points[1].inputs, IsEmpty());
}

TEST(Envelope, TwoTargetsAreReadBackIntoBothFactors) {
  Grid grid = linear();
  grid.study.envelope->measures = {{"b", 1.0}};
  for (const auto& [x, y] : {std::pair{1.3, 17.1}, {3.9, 10.2}, {2.5, 15.0}, {1.0, 20.0}}) {
    grid.study.envelope->points = {{"B", {}, {{"a", 2.0 * x + y}, {"b", x * y}}}};
    const EnvelopePoint point = grid.envelope().points.at(0);
    ASSERT_EQ(point.reason, "");
    EXPECT_NEAR(point.responses[0], 2.0 * x + y, 1e-9);
    EXPECT_NEAR(point.responses[1], x * y, 1e-9);
    EXPECT_NEAR(*point.inputs[0].number, x, 1e-9);
    EXPECT_NEAR(*point.inputs[1].number, y, 1e-9);
  }
  grid.study.envelope->points = {{"B", {}, {{"a", 13.0}, {"b", 70.0}}}};
  EXPECT_EQ(grid.envelope().points[0].reason, "no place of the grid has both values");
}

// Second order: the error of a smooth map falls with the square of the step.
TEST(Envelope, ReadBackConvergesToTheInverseOfASmoothMap) {
  const auto error = [](int nodes) {
    Grid grid(factor("x", steps(1.0, 2.0, nodes)), factor("y", steps(1.0, 2.0, nodes)), {"a", "b"},
              [](double x, double y) {
                return x == 0.0 ? std::vector{0.0, 0.0} : std::vector{x * x * std::sqrt(y), std::exp(x) / y};
              });
    grid.study.envelope->measures = {{"a", 1.0}};
    grid.study.envelope->points = {{"B", {}, {{"a", 1.43 * 1.43 * std::sqrt(1.67)}, {"b", std::exp(1.43) / 1.67}}}};
    const EnvelopePoint point = grid.envelope().points.at(0);
    return std::hypot(*point.inputs[0].number - 1.43, *point.inputs[1].number - 1.67);
  };
  EXPECT_LT(error(11), 3e-3);
  EXPECT_LT(error(161), error(11) / 100.0);
  EXPECT_LT(error(161), 2e-5);
}

TEST(Envelope, BetweenWholeNumbersThereIsNothing) {
  Grid grid = linear();
  grid.study.factors[0].continuous = false;
  grid.study.envelope->measures = {{"b", 1.0}};
  grid.study.envelope->points = {{"B", {}, {{"a", 19.0}}}};
  EnvelopePoint point = grid.envelope().points.at(0);
  EXPECT_NEAR(point.responses[0], 19.0, 1e-12);
  EXPECT_EQ(std::floor(point.place[0]), point.place[0]);
  EXPECT_NEAR(*point.inputs[1].number, 11.0, 1e-12);  // With x = 4.

  grid.study.factors[1].continuous = false;
  point = grid.envelope().points.at(0);
  ASSERT_TRUE(point.design);
  EXPECT_NEAR(point.responses[0], 19.0, 1.0 + 1e-12);  // 18 or 20, the better of the two.
  EXPECT_EQ(point.inputs[0].text, "4 mm");
  EXPECT_EQ(point.inputs[1].text, "12 mm");
}

TEST(Envelope, DesignsWithoutANumberAreLeftOut) {
  Grid grid(factor("x", {1.0, 2.0, 3.0}), factor("y", {1.0, 2.0, 3.0}), {"a"},
            [](double x, double y) { return std::vector{x == 2.0 && y == 2.0 ? kNoResponse : x - 2.0}; });
  grid.study.envelope->measures = {{"a", 0.5}};
  grid.study.envelope->points = {{"B", {}, {{"a", 0.5}}}};
  const EnvelopeResult result = grid.envelope();
  EXPECT_EQ(result.measures[0].without, 1U);
  EXPECT_NEAR(result.measures[0].rms, std::sqrt(6.0 / 8.0), 1e-15);
  EXPECT_EQ(result.without, 4U);  // Roots of -1, and the missing one.
  EXPECT_NEAR(*result.points[0].inputs[0].number, 2.5, 1e-12);
  EXPECT_NE(*result.points[0].inputs[1].number, 2.0);
  grid.rows.responses.assign(grid.rows.responses.size(), kNoResponse);
  grid.study.envelope->points.push_back({"best", {}, {}});
  EXPECT_THAT(grid.envelope().points[0].reason, HasSubstr("no design has a number for a"));
  EXPECT_EQ(grid.envelope().points[1].reason, "no design has an envelope");
}

TEST(Envelope, CutsOfTheRowsDoNotMatter) {
  Grid grid = linear();
  grid.study.envelope->measures = {{"a", 1.0}, {"b", -1.0}};
  StudyAnalysis whole(grid.study), parts(grid.study);
  whole.add(grid.rows);
  for (std::size_t k = 0; k < grid.rows.rows; k += 4) {
    const std::size_t count = std::min<std::size_t>(4, grid.rows.rows - k);
    const auto first = grid.rows.responses.begin() + static_cast<std::ptrdiff_t>(2 * k);
    parts.add({k, count, {first, first + static_cast<std::ptrdiff_t>(2 * count)}, {}});
  }
  EXPECT_EQ(whole.summary().envelope->values, parts.summary().envelope->values);
  EXPECT_EQ(whole.summary().envelope->values, grid.envelope().values);
}

}  // namespace
}  // namespace prs
