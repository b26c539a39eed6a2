#include "prs/life/load_history.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "support/count.h"

namespace prs {
namespace {

using Counts = std::map<double, double>;

Counts counts_of(const std::vector<Cycle>& cycles) {
  Counts counts;
  for (const Cycle& c : cycles) counts[c.range()] += c.count;
  return counts;
}

struct Plain {
  double from, to, count;
  bool operator==(const Plain&) const = default;
};

std::vector<Plain> plain(const std::vector<Cycle>& cycles) {
  std::vector<Plain> all;
  for (const Cycle& c : cycles) all.push_back({c.start.value, c.end.value, c.count});
  return all;
}

/// The standard's history of peaks and valleys, figure 6: A to I.
const std::vector<double> kStandardHistory = {-2, 1, -3, 5, -1, 3, -4, 4, -2};

TEST(Rainflow, CountsTheExampleOfTheStandard) {
  const std::vector<Cycle> cycles = rainflow(kStandardHistory);
  EXPECT_EQ(counts_of(cycles), (Counts{{3, 0.5}, {4, 1.5}, {6, 0.5}, {8, 1.0}, {9, 0.5}}));
  // Events A-B, B-C, E-F, C-D, D-G, then what is left: G-H, H-I.
  EXPECT_EQ(plain(cycles),
            (std::vector<Plain>{
                {-2, 1, 0.5}, {1, -3, 0.5}, {-1, 3, 1.0}, {-3, 5, 0.5}, {5, -4, 0.5}, {-4, 4, 0.5}, {4, -2, 0.5}}));
  EXPECT_EQ(cycles[2].mean(), 1.0);
  EXPECT_EQ(cycles[2].start.index, 4u);
  EXPECT_EQ(cycles[2].end.index, 5u);
}

TEST(Rainflow, ASineIsItsPeriods) {
  std::vector<double> history;
  for (int k = 0; k <= 1000; ++k) history.push_back(std::round(100 * std::cos(k * M_PI / 20)));
  const std::vector<Cycle> cycles = rainflow(history);
  EXPECT_EQ(counts_of(cycles), (Counts{{200.0, 25.0}}));
}

TEST(Rainflow, NothingCyclesWhereNothingTurns) {
  EXPECT_TRUE(rainflow(std::vector<double>{}).empty());
  EXPECT_TRUE(rainflow(std::vector<double>{3.0}).empty());
  EXPECT_TRUE(rainflow(std::vector<double>(100, 3.0)).empty());
  EXPECT_EQ(plain(rainflow(std::vector<double>{1, 2, 2, 5})), (std::vector<Plain>{{1, 5, 0.5}}));
}

/// Algorithm of 5.4.4, literally, on a list of peaks and valleys that is searched from its start every time.
Counts counted_word_by_word(std::vector<double> points) {
  Counts counts;
  std::size_t read = 0;   // Points read so far, of those not discarded.
  std::size_t start = 0;  // S, always the first remaining point.
  const auto range = [&](std::size_t k) { return std::abs(points[k] - points[k - 1]); };
  for (;;) {
    if (read == points.size()) break;  // (1) out of data
    ++read;
    while (read >= 3) {  // (2)
      const double x = range(read - 1), y = range(read - 2);
      if (x < y) break;  // (3)
      const auto first = points.begin() + static_cast<std::ptrdiff_t>(read) - 3;
      if (read - 3 == start) {  // (5)
        counts[y] += 0.5;
        points.erase(first);
        read -= 1;
      } else {  // (4)
        counts[y] += 1.0;
        points.erase(first, first + 2);
        read -= 2;
      }
    }
  }
  for (std::size_t k = 1; k < points.size(); ++k) counts[range(k)] += 0.5;  // (6)
  return counts;
}

/// Peaks and valleys by comparison with both neighbours; plateaus joined first.
std::vector<double> peaks_and_valleys(std::vector<double> history) {
  history.erase(std::unique(history.begin(), history.end()), history.end());
  std::vector<double> points;
  for (std::size_t k = 0; k < history.size(); ++k) {
    const bool inside = k > 0 && k + 1 < history.size();
    if (!inside || (history[k] - history[k - 1]) * (history[k + 1] - history[k]) < 0.0) points.push_back(history[k]);
  }
  return points;
}

/// Whole numbers, so that ranges are exact and equal ones occur.
std::vector<double> random_history(std::mt19937& random, int length, int spread) {
  std::uniform_int_distribution<int> value(-spread, spread);
  std::vector<double> history;
  for (int k = 0; k < length; ++k) history.push_back(value(random));
  return history;
}

TEST(Rainflow, IsTheStandardWordByWord) {
  std::mt19937 random(1);
  for (int k = 0; k < test::samples(2000, 100'000); ++k) {
    const std::vector<double> history = random_history(random, 1 + k % 60, 1 + static_cast<int>(random() % 30));
    EXPECT_EQ(counts_of(rainflow(history)), counted_word_by_word(peaks_and_valleys(history)));
  }
}

/// Rychlik (1987): for a history that starts and ends at its largest value, each other peak M forms a cycle with the
/// higher of the two lowest values between it and the next higher one on either side.
Counts counted_peak_by_peak(const std::vector<double>& points) {
  Counts counts;
  for (std::size_t k = 1; k + 1 < points.size(); ++k) {
    if (points[k] < points[k - 1]) continue;
    double left = points[k], right = points[k];
    for (std::size_t i = k; i-- > 0 && points[i] <= points[k];) left = std::min(left, points[i]);
    for (std::size_t i = k + 1; i < points.size() && points[i] < points[k]; ++i) right = std::min(right, points[i]);
    counts[points[k] - std::max(left, right)] += 1.0;
  }
  return counts;
}

TEST(Rainflow, OfAClosedHistoryIsThatOfRychlik) {
  std::mt19937 random(2);
  for (int k = 0; k < test::samples(500, 20'000); ++k) {
    std::vector<double> history = random_history(random, 3 + k % 100, 1000);
    history.insert(history.begin(), 2000.0);
    history.push_back(2000.0);
    const std::vector<double> points = peaks_and_valleys(history);
    Counts expected = counted_peak_by_peak(points);
    // Two halves: from the largest value to the smallest, and back.
    expected[2000.0 - *std::ranges::min_element(points)] += 1.0;
    EXPECT_EQ(counts_of(rainflow(history)), expected);
  }
}

TEST(Rainflow, RangesAddUpToTheWayOfTheHistory) {
  std::mt19937 random(3);
  for (int k = 0; k < 200; ++k) {
    const std::vector<double> history = random_history(random, 2 + k, 500);
    double way = 0.0, counted = 0.0;
    for (std::size_t i = 1; i < history.size(); ++i) way += std::abs(history[i] - history[i - 1]);
    for (const Cycle& c : rainflow(history)) counted += 2.0 * c.count * c.range();
    EXPECT_EQ(counted, way);
  }
}

TEST(Rainflow, DoesNotSeeSamplesBetweenTurningPoints) {
  std::mt19937 random(4);
  const std::vector<double> history = random_history(random, 300, 50);
  std::vector<double> fine;
  for (std::size_t i = 1; i < history.size(); ++i)
    for (int part = 0; part < 4; ++part) fine.push_back(history[i - 1] + 0.25 * part * (history[i] - history[i - 1]));
  fine.push_back(history.back());
  EXPECT_EQ(counts_of(rainflow(fine)), counts_of(rainflow(history)));
}

std::vector<double> values(const std::vector<HistoryPoint>& points) {
  std::vector<double> v;
  for (const HistoryPoint& p : points) v.push_back(p.value);
  return v;
}

std::vector<HistoryPoint> turning_points(const std::vector<double>& history, double hysteresis) {
  std::vector<HistoryPoint> points;
  TurningPoints turning(hysteresis);
  const auto keep = [&](const HistoryPoint& p) { points.push_back(p); };
  for (const double v : history) turning.push(v, keep);
  turning.finish(keep);
  return points;
}

TEST(TurningPoints, StandAtTheFirstSampleOfAPlateau) {
  const auto points = turning_points({0, 0, 3, 3, 1, 1, 2}, 0.0);
  EXPECT_THAT(values(points), testing::ElementsAre(0, 3, 1, 2));
  EXPECT_EQ(points[0].index, 0u);
  EXPECT_EQ(points[1].index, 2u);
  EXPECT_EQ(points[2].index, 4u);
  EXPECT_EQ(points[3].index, 6u);
}

TEST(TurningPoints, PassOverSwingsWithinTheHysteresis) {
  EXPECT_THAT(values(turning_points({0, 10, 9, 11, 4, 5, 0, 8}, 1.0)), testing::ElementsAre(0, 11, 0, 8));
  // At the start too: -0.9 and 1.1 are two apart, 0 is within.
  EXPECT_THAT(values(turning_points({0, 0.9, -0.9, 1.1, -5}, 1.9)), testing::ElementsAre(-0.9, 1.1, -5));
  EXPECT_TRUE(turning_points({0, 1, 0, 1, 0}, 1.0).empty());
}

TEST(TurningPoints, KeepEveryRangeBeyondTheHysteresis) {
  std::mt19937 random(5);
  for (int k = 0; k < 300; ++k) {
    const std::vector<double> history = random_history(random, 80, 40);
    Counts all = counts_of(rainflow(history)), gated = counts_of(rainflow(history, 5.0));
    EXPECT_GT(gated.empty() ? 6.0 : gated.begin()->first, 5.0);
    // The ends of a history may move by the hysteresis; its full cycles do not.
    EXPECT_LE(std::abs(all.rbegin()->first - gated.rbegin()->first), 0.0);
  }
}

TEST(CycleMatrix, HoldsEveryCycleInItsBin) {
  std::mt19937 random(6);
  const std::vector<Cycle> cycles = rainflow(random_history(random, 5000, 300));
  const CycleMatrix m = cycle_matrix(cycles, 16);
  double sum = 0.0;
  for (const double c : m.count) sum += c;
  EXPECT_EQ(sum, count(cycles));
  std::vector<double> expected(16 * 16, 0.0);
  for (const Cycle& c : cycles)
    for (int i = 0; i < 16; ++i)
      for (int k = 0; k < 16; ++k) {
        const double range = i * m.range_width(), mean = m.mean_from + k * m.mean_width();
        const bool in_range = c.range() >= range && (c.range() < range + m.range_width() || i == 15);
        const bool in_mean = c.mean() >= mean && (c.mean() < mean + m.mean_width() || k == 15);
        if (in_range && in_mean) expected[static_cast<std::size_t>(16 * i + k)] += c.count;
      }
  double moved = 0.0;  // Cycles that rounding moves across the edge of a bin.
  for (std::size_t k = 0; k < expected.size(); ++k) moved += std::abs(expected[k] - m.count[k]);
  EXPECT_LE(moved, 4.0);
}

TEST(EquivalentRange, IsTheRangeOfConstantAmplitude) {
  const std::vector<Cycle> same(7, Cycle{{-1.0, 0}, {3.0, 1}, 1.0});
  EXPECT_NEAR(equivalent_range(same, 5.0), 4.0, 1e-15);
  // One cycle of 2 and one of 1, slope 3: ((8 + 1)/2)^(1/3).
  const std::vector<Cycle> two = {{{0.0, 0}, {2.0, 1}, 1.0}, {{1.0, 2}, {0.0, 3}, 1.0}};
  EXPECT_NEAR(equivalent_range(two, 3.0), std::cbrt(4.5), 1e-15);
  EXPECT_EQ(equivalent_range({}, 3.0), 0.0);
}

}  // namespace
}  // namespace prs
