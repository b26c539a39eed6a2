#include "prs/study/designs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <random>
#include <set>
#include <vector>

#include "tests/support/count.h"

namespace prs {
namespace {

using Number = std::function<double(std::uint64_t k)>;

std::vector<double> numbers(std::size_t n, const Number& number) {
  std::vector<double> all(n);
  for (std::size_t k = 0; k < n; ++k) all[k] = number(k);
  return all;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  const double mean_a = std::reduce(a.begin(), a.end()) / n;
  const double mean_b = std::reduce(b.begin(), b.end()) / n;
  double ab = 0.0, aa = 0.0, bb = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    ab += (a[k] - mean_a) * (b[k] - mean_b);
    aa += (a[k] - mean_a) * (a[k] - mean_a);
    bb += (b[k] - mean_b) * (b[k] - mean_b);
  }
  return ab / std::sqrt(aa * bb);
}

/// Kolmogorov-Smirnov distance from a distribution, times the root of the number.
double kolmogorov_smirnov(std::vector<double> sample, const std::function<double(double)>& cdf) {
  std::ranges::sort(sample);
  const auto n = static_cast<double>(sample.size());
  double distance = 0.0;
  for (std::size_t k = 0; k < sample.size(); ++k) {
    const double f = cdf(sample[k]);
    distance = std::max({distance, f - static_cast<double>(k) / n, static_cast<double>(k + 1) / n - f});
  }
  return distance * std::sqrt(n);
}
constexpr double kOneInAThousand = 1.95;  ///< Value exceeded with that probability.

double uniform_cdf(double x) { return x; }
double normal_cdf(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

TEST(Permuted, IsAPermutationForEverySizeAndKey) {
  for (const std::uint64_t n : {1, 2, 3, 7, 8, 9, 1000, 1024, 1025, 4096})
    for (const std::uint64_t key : {0ULL, 1ULL, 0xFFFFFFFFFFFFFFFFULL}) {
      std::vector<bool> hit(n);
      for (std::uint64_t k = 0; k < n; ++k) {
        const std::uint64_t image = permuted(key, k, n);
        ASSERT_LT(image, n);
        EXPECT_FALSE(hit[image]) << n << " " << key;
        hit[image] = true;
      }
    }
}

TEST(Permuted, AllPermutationsAreAsLikely) {
  constexpr int kKeys = 240'000;
  std::array<int, 24> seen{};
  std::mt19937_64 keys(1);
  for (int i = 0; i < kKeys; ++i) {
    const std::uint64_t key = keys();
    std::array<std::uint64_t, 4> order{};
    for (std::uint64_t k = 0; k < 4; ++k) order[k] = permuted(key, k, 4);
    std::size_t rank = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto smaller = std::count_if(order.begin() + static_cast<std::ptrdiff_t>(k), order.end(),
                                         [&](auto o) { return o < order[k]; });
      rank = rank * (4 - k) + static_cast<std::size_t>(smaller);
    }
    ++seen[rank];
  }
  double chi_squared = 0.0;
  for (const int count : seen) chi_squared += std::pow(count - kKeys / 24, 2) / (kKeys / 24);
  EXPECT_LT(chi_squared, 49.7);  // 23 degrees of freedom, one in a thousand.
}

TEST(LatinHypercube, HitsEachStratumOnce) {
  for (const std::uint64_t n : {1, 2, 7, 1000, 4096})
    for (std::size_t dimension = 0; dimension < 5; ++dimension) {
      std::set<int> strata;
      for (std::uint64_t k = 0; k < n; ++k) {
        const double x = latin_hypercube_number(11, dimension, k, n);
        ASSERT_GT(x, 0.0);
        ASSERT_LT(x, 1.0);
        strata.insert(static_cast<int>(x * static_cast<double>(n)));
      }
      EXPECT_EQ(strata.size(), n) << "dimension " << dimension;
    }
}

TEST(LatinHypercube, DimensionsAndSeedsAreUncorrelated) {
  constexpr std::size_t kSamples = 4096;
  std::vector<std::vector<double>> columns;
  for (const std::uint64_t seed : {1, 2, 3})
    for (std::size_t dimension = 0; dimension < 4; ++dimension)
      columns.push_back(
          numbers(kSamples, [&](std::uint64_t k) { return latin_hypercube_number(seed, dimension, k, kSamples); }));
  for (std::size_t i = 0; i < columns.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_LT(std::abs(correlation(columns[i], columns[j])), 4.0 / std::sqrt(kSamples));
  for (const std::vector<double>& column : columns) {
    const std::vector<double> head(column.begin(), column.end() - 1);
    const std::vector<double> tail(column.begin() + 1, column.end());
    EXPECT_LT(std::abs(correlation(head, tail)), 4.0 / std::sqrt(kSamples));
  }
}

TEST(LatinHypercube, LiesAnywhereInItsStratum) {
  const std::vector<double> within = numbers(20'000, [](std::uint64_t k) {
    const double x = 20'000 * latin_hypercube_number(5, 0, k, 20'000);
    return x - std::floor(x);
  });
  EXPECT_LT(kolmogorov_smirnov(within, uniform_cdf), kOneInAThousand);
}

TEST(MonteCarlo, IsUniformAndIndependent) {
  std::vector<std::vector<double>> columns;
  for (const std::uint64_t seed : {0, 1})
    for (std::size_t dimension = 0; dimension < 4; ++dimension)
      columns.push_back(numbers(20'000, [&](std::uint64_t k) { return monte_carlo_number(seed, dimension, k); }));
  for (std::size_t i = 0; i < columns.size(); ++i) {
    EXPECT_LT(kolmogorov_smirnov(columns[i], uniform_cdf), kOneInAThousand);
    const std::vector<double> head(columns[i].begin(), columns[i].end() - 1);
    const std::vector<double> tail(columns[i].begin() + 1, columns[i].end());
    EXPECT_LT(std::abs(correlation(head, tail)), 4.0 / std::sqrt(2e4));
    for (std::size_t j = 0; j < i; ++j) EXPECT_LT(std::abs(correlation(columns[i], columns[j])), 4.0 / std::sqrt(2e4));
  }
}

// Bratley & Fox 1988 with the direction numbers of Joe & Kuo 2008, whose program prints these.
TEST(Sobol, StartsWithThePublishedPoints) {
  const double points[10][3] = {{0, 0, 0},
                                {0.5, 0.5, 0.5},
                                {0.75, 0.25, 0.25},
                                {0.25, 0.75, 0.75},
                                {0.375, 0.375, 0.625},
                                {0.875, 0.875, 0.125},
                                {0.625, 0.125, 0.875},
                                {0.125, 0.625, 0.375},
                                {0.1875, 0.3125, 0.9375},
                                {0.6875, 0.8125, 0.4375}};
  for (std::uint64_t k = 0; k < 10; ++k)
    for (std::size_t d = 0; d < 3; ++d) EXPECT_EQ(static_cast<double>(sobol_fraction(d, k)) * 0x1p-64, points[k][d]);
}

TEST(Sobol, IsBoostsSequenceFarOut) {
  boost::random::sobol engine(kMostSobolDimensions);
  for (const std::uint64_t k : {3UL, 123'456UL, 999'999'999UL, kMostSobolSamples - 1}) {
    engine.seed(k - 1);  // Boost leaves out the point 0.
    for (std::size_t d = 0; d < kMostSobolDimensions; ++d)
      ASSERT_EQ(sobol_fraction(d, k), engine()) << "point " << k << ", dimension " << d;
  }
}

TEST(Sobol, ShiftKeepsTheNet) {
  for (const std::uint64_t seed : {1, 2, 3})
    for (const std::uint64_t block : {0, 1, 5}) {
      std::set<std::pair<int, int>> boxes;
      for (std::uint64_t k = 0; k < 256; ++k)
        boxes.insert({static_cast<int>(16 * sobol_number(seed, 0, 256 * block + k)),
                      static_cast<int>(16 * sobol_number(seed, 1, 256 * block + k))});
      EXPECT_EQ(boxes.size(), 256U);  // One point in each.
    }
}

TEST(Sobol, ShiftedPointIsUniform) {
  for (const std::size_t dimension : {0, 1, 17}) {
    const std::vector<double> over_seeds =
        numbers(20'000, [&](std::uint64_t seed) { return sobol_number(seed, dimension, 12); });
    EXPECT_LT(kolmogorov_smirnov(over_seeds, uniform_cdf), kOneInAThousand);
  }
}

/// Root mean square error over seeds of the mean of a product of 1 + (x - 1/2), which is 1.
double integration_error(double (*number)(std::uint64_t, std::size_t, std::uint64_t), std::uint64_t samples) {
  constexpr std::uint64_t kSeeds = 16;
  double squares = 0.0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    double sum = 0.0;
    for (std::uint64_t k = 0; k < samples; ++k) {
      double f = 1.0;
      for (std::size_t d = 0; d < 5; ++d) f *= 0.5 + number(seed, d, k);
      sum += f;
    }
    squares += std::pow(sum / static_cast<double>(samples) - 1.0, 2);
  }
  return std::sqrt(squares / kSeeds);
}

// Error over the root of the number for Monte Carlo, over almost the number itself for a smooth integrand.
TEST(Sobol, IntegratesFasterThanMonteCarlo) {
  const double far = integration_error(sobol_number, 8192);
  EXPECT_GT(integration_error(sobol_number, 128), 32.0 * far);
  EXPECT_LT(integration_error(monte_carlo_number, 128), 16.0 * integration_error(monte_carlo_number, 8192));
  EXPECT_GT(integration_error(monte_carlo_number, 8192), 20.0 * far);
}

// Abramowitz & Stegun, table 26.5; tails from their definition.
TEST(NormalQuantile, InvertsTheDistribution) {
  EXPECT_EQ(normal_quantile(0.5), 0.0);
  EXPECT_NEAR(normal_quantile(0.975), 1.95996398454005, 1e-14);
  EXPECT_NEAR(normal_quantile(0.99), 2.32634787404084, 1e-14);
  for (const double u : {1e-300, 1e-12, 1e-3, 0.2, 0.499}) EXPECT_NEAR(normal_cdf(normal_quantile(u)) / u, 1.0, 1e-12);
  EXPECT_NEAR(normal_quantile(0.9), -normal_quantile(0.1), 1e-15);
}

TEST(NormalQuantile, OfIndependentNumbersIsNormal) {
  const auto n = static_cast<std::size_t>(test::count(20'000, 2'000'000));
  const std::vector<double> x =
      numbers(n, [](std::uint64_t k) { return normal_quantile(monte_carlo_number(3, 1, k)); });
  const auto count = static_cast<double>(n);
  const double mean = std::reduce(x.begin(), x.end()) / count;
  const double square = std::transform_reduce(x.begin(), x.end(), x.begin(), 0.0) / count;
  EXPECT_LT(std::abs(mean), 3.3 / std::sqrt(count));
  EXPECT_LT(std::abs(square - 1.0), 3.3 * std::sqrt(2.0 / count));
  EXPECT_LT(kolmogorov_smirnov(x, normal_cdf), kOneInAThousand);
}

}  // namespace
}  // namespace prs
