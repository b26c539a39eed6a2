#include "prs/figures/contours.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

namespace prs {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

GridData grid_of(int nodes, double from, double to,
                 const std::function<double(double, double)>& f) {
  GridData grid;
  for (int k = 0; k < nodes; ++k) grid.x.push_back(from + (to - from) * k / (nodes - 1));
  grid.y = grid.x;
  for (const double x : grid.x)
    for (const double y : grid.y) grid.values.push_back(f(x, y));
  return grid;
}

/// Counter-clockwise > 0.
double area(const Polyline& line) {
  double sum = 0.0;
  for (std::size_t k = 1; k < line.size(); ++k)
    sum += 0.5 * (line[k - 1][0] * line[k][1] - line[k][0] * line[k - 1][1]);
  return sum;
}

/// Whether a point lies inside of a closed line (even-odd).
bool holds(const Polyline& line, double x, double y) {
  bool inside = false;
  for (std::size_t k = 1; k < line.size(); ++k) {
    const auto [x1, y1] = line[k - 1];
    const auto [x2, y2] = line[k];
    if ((y1 > y) != (y2 > y) && x < x1 + (x2 - x1) * (y - y1) / (y2 - y1)) inside = !inside;
  }
  return inside;
}

TEST(Contours, LineOfAPlaneIsStraightWithLargerValuesToItsLeft) {
  const GridData plane = grid_of(6, 0.0, 5.0, [](double x, double y) { return x + 2.0 * y; });
  const std::vector<Polyline> lines = contour_lines(plane, 6.3);
  ASSERT_THAT(lines, SizeIs(1));
  for (const auto& [x, y] : lines[0]) EXPECT_NEAR(x + 2.0 * y, 6.3, 1e-12);
  EXPECT_GT(lines[0].front()[0], -1e-12);
  const auto& [x1, y1] = lines[0].front();
  const auto& [x2, y2] = lines[0].back();
  EXPECT_GT((x2 - x1) * 2.0 - (y2 - y1) * 1.0, 0.0);
  EXPECT_THAT(contour_lines(plane, 15.1), IsEmpty());
  EXPECT_THAT(contour_lines(plane, -0.1), IsEmpty());
}

TEST(Contours, CircleClosesAndItsErrorFallsWithTheSquareOfTheStep) {
  const auto error = [](int nodes) {
    const GridData bowl =
        grid_of(nodes, -1.0, 1.0, [](double x, double y) { return -std::hypot(x, y); });
    const std::vector<Polyline> lines = contour_lines(bowl, -0.7);
    EXPECT_THAT(lines, SizeIs(1));
    EXPECT_EQ(lines[0].front(), lines[0].back());
    return std::abs(area(lines[0]) / (std::numbers::pi * 0.49) - 1.0);
  };
  EXPECT_LT(error(21), 0.01);
  EXPECT_LT(error(201), error(21) / 50.0);
}

TEST(Contours, SaddleHasTwoLinesThatDoNotCross) {
  const GridData saddle =
      grid_of(2, 0.0, 1.0, [](double x, double y) { return x == y ? 1.0 : 0.0; });
  EXPECT_THAT(contour_lines(saddle, 0.4), SizeIs(2));
  EXPECT_THAT(contour_lines(saddle, 0.6), SizeIs(2));
  for (const Polyline& line : contour_lines(saddle, 0.4))  // The middle, 0.5, is above.
    EXPECT_NEAR(std::abs(line[0][0] - line[0][1]) + std::abs(line[1][0] - line[1][1]), 1.2, 1e-12);
}

TEST(Contours, CellsWithoutANumberAreLeftOut) {
  GridData plane = grid_of(5, 0.0, 4.0, [](double x, double) { return x; });
  plane.values[2 * 5 + 2] = kNone;
  double length = 0.0;
  for (const Polyline& line : contour_lines(plane, 2.5))
    length += std::abs(line.back()[1] - line.front()[1]);
  EXPECT_NEAR(length, 2.0, 1e-12);  // Of four cells two have no corner missing.
}

TEST(Contours, RoundLevelsHoldAllValues) {
  for (const auto& [least, largest] :
       {std::pair{0.0, 1.0}, {2286.0, 2581.0}, {-3.2e-7, 4.1e-7}, {1.0, 1.0001}, {-5.0, -5.0}}) {
    GridData grid{{0.0, 1.0}, {0.0, 1.0}, {least, largest, kNone, least}};
    const std::vector<double> levels = round_levels(grid, 12);
    ASSERT_GE(levels.size(), 2U);
    EXPECT_LE(levels.size(), 13U);
    EXPECT_LE(levels.front(), least);
    EXPECT_GE(levels.back(), largest);
    EXPECT_TRUE(std::ranges::is_sorted(levels));
  }
  EXPECT_THAT(round_levels({{0.0, 1.0}, {0.0, 1.0}, {2286.0, 2581.0, 2300.0, 2400.0}}, 12),
              ElementsAre(2250.0, 2300.0, 2350.0, 2400.0, 2450.0, 2500.0, 2550.0, 2600.0));
  EXPECT_THAT(round_levels({{0.0, 1.0}, {0.0, 1.0}, {kNone, kNone, kNone, kNone}}, 12), IsEmpty());
}

// The last area over a place is what is seen there.
TEST(Contours, AreasLeaveEachPlaceTheBandOfItsValue) {
  const auto waves = [](double x, double y) {
    return std::sin(3.0 * x) * std::cos(2.0 * y) + 0.2 * x;
  };
  GridData grid = grid_of(81, -2.0, 2.0, waves);
  const auto missing = [](double x, double y) { return std::hypot(x - 0.5, y + 0.3) < 0.4; };
  for (std::size_t i = 0; i < 81; ++i)
    for (std::size_t j = 0; j < 81; ++j)
      if (missing(grid.x[i], grid.y[j])) grid.values[i * 81 + j] = kNone;
  const std::vector<double> levels = round_levels(grid, 12);
  const std::vector<ContourBand> bands = contour_bands(grid, levels);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-1.99, 1.99);
  int judged = 0, without = 0;
  for (int k = 0; k < 2000; ++k) {
    const double x = place(random), y = place(random);
    std::size_t seen = levels.size();
    for (const ContourBand& band : bands)
      if (holds(band.outline, x, y)) seen = band.band;
    if (std::hypot(x - 0.5, y + 0.3) < 0.3) {
      EXPECT_EQ(seen, levels.size());
      ++without;
    } else if (std::hypot(x - 0.5, y + 0.3) > 0.5) {
      const double value = waves(x, y);
      const auto above = std::ranges::upper_bound(levels, value);
      // The grid is 0.05 wide, so that values are known to about 5e-3.
      if (std::ranges::any_of(levels, [&](double l) { return std::abs(l - value) < 6e-3; }))
        continue;
      EXPECT_EQ(seen, static_cast<std::size_t>(above - levels.begin()) - 1) << x << ' ' << y;
      ++judged;
    }
  }
  EXPECT_GT(judged, 1000);
  EXPECT_GT(without, 10);
}

TEST(Contours, ThinnedGridKeepsItsEnds) {
  const GridData grid = grid_of(200, 0.0, 1.0, [](double x, double y) { return x - y; });
  const GridData some = thinned(grid, 41);
  EXPECT_THAT(some.x, SizeIs(41));
  EXPECT_EQ(some.x.front(), 0.0);
  EXPECT_EQ(some.x.back(), 1.0);
  EXPECT_EQ(some.at(40, 0), 1.0);
  EXPECT_EQ(thinned(grid, 500).values, grid.values);
}

}  // namespace
}  // namespace prs
