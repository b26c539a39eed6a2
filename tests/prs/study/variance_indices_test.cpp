#include "prs/study/sensitivity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace prs {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

using Function = std::function<double(const std::vector<double>&)>;

/// Indices of a function of d factors that are uniform in [0, 1), by independent draws.
ResponseIndices indices(const Function& f, std::size_t d, std::size_t samples, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  VarianceIndices estimator(d, samples);
  std::vector<double> a(d), b(d), values(d + 2);
  for (std::size_t j = 0; j < samples; ++j) {
    for (std::vector<double>* point : {&a, &b})
      for (double& x : *point) x = static_cast<double>(random() >> 11) * 0x1p-53;
    values[0] = f(a);
    values[1] = f(b);
    for (std::size_t i = 0; i < d; ++i) {
      std::swap(a[i], b[i]);
      values[i + 2] = f(a);
      std::swap(a[i], b[i]);
    }
    estimator.add(values);
  }
  return estimator.result();
}

const FactorIndices& of(const ResponseIndices& result, std::size_t factor) {
  return *std::ranges::find(result.factors, factor, &FactorIndices::factor);
}

/// Number of `repeats` intervals that hold the truth, for first indices and then for total ones.
struct Coverage {
  std::vector<int> first, total;
};

Coverage coverage(const Function& f, const std::vector<double>& first, const std::vector<double>& total, int repeats,
                  std::size_t samples) {
  Coverage c{std::vector<int>(first.size()), std::vector<int>(first.size())};
  for (int k = 0; k < repeats; ++k) {
    const ResponseIndices result = indices(f, first.size(), samples, 1000U + static_cast<unsigned>(k));
    for (std::size_t i = 0; i < first.size(); ++i) {
      const auto& [factor, s, t] = of(result, i);
      c.first[i] += std::abs(s.value - first[i]) <= *s.half_width;
      c.total[i] += std::abs(t.value - total[i]) <= *t.half_width;
    }
  }
  return c;
}

constexpr double kPi = std::numbers::pi;

/// Ishigami & Homma 1990 with a = 7, b = 0.1.
double ishigami(const std::vector<double>& u) {
  const double x = kPi * (2 * u[0] - 1), y = kPi * (2 * u[1] - 1), z = kPi * (2 * u[2] - 1);
  return std::sin(x) + 7.0 * std::pow(std::sin(y), 2) + 0.1 * std::pow(z, 4) * std::sin(x);
}

struct Ishigami {
  double v1 = 0.5 * std::pow(1 + 0.1 * std::pow(kPi, 4) / 5, 2);
  double v2 = 49.0 / 8;
  double v13 = 0.01 * std::pow(kPi, 8) * 8 / 225;
  double v = v1 + v2 + v13;
  std::vector<double> first{v1 / v, v2 / v, 0.0};
  std::vector<double> total{(v1 + v13) / v, v2 / v, v13 / v};
};

TEST(VarianceIndices, OfIshigamisFunction) {
  const Ishigami truth;
  EXPECT_NEAR(truth.first[0], 0.3139, 5e-5);  // Published value.
  EXPECT_NEAR(truth.first[1], 0.4424, 5e-5);
  EXPECT_NEAR(truth.total[0], 0.5576, 5e-5);
  EXPECT_NEAR(truth.total[2], 0.2437, 5e-5);
  const ResponseIndices result = indices(ishigami, 3, 1 << 15, 7);
  EXPECT_EQ(result.samples, 1U << 15);
  EXPECT_NEAR(result.variance, truth.v, 0.02 * truth.v);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [factor, s, t] = of(result, i);
    EXPECT_NEAR(s.value, truth.first[i], 1.5 * *s.half_width) << i;
    EXPECT_NEAR(t.value, truth.total[i], 1.5 * *t.half_width) << i;
    EXPECT_LT(*s.half_width, 0.03);
    EXPECT_LT(*t.half_width, 0.02);
  }
  EXPECT_EQ(result.factors[0].factor, 0U);
  EXPECT_EQ(result.factors[1].factor, 1U);
  EXPECT_EQ(result.factors[2].factor, 2U);
}

// Probability that fewer than 178 of 200 intervals at 95 % hold the truth: one in 10,000.
TEST(VarianceIndices, IntervalsHoldTheTruthAsOftenAsTheySay) {
  const Ishigami truth;
  const Coverage c = coverage(ishigami, truth.first, truth.total, 200, 1024);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_GE(c.first[i], 178) << i;
    EXPECT_GE(c.total[i], 178) << i;
  }
  EXPECT_LT(c.first[0] + c.first[1] + c.total[0] + c.total[1], 800);  // Some intervals do not hold it.
}

/// Sobol's g-function, a product of (|4 u - 2| + a) / (1 + a).
TEST(VarianceIndices, OfSobolsProduct) {
  const std::vector<double> a{0.0, 1.0, 4.5, 9.0, 99.0};
  const auto g = [&](const std::vector<double>& u) {
    double product = 1.0;
    for (std::size_t i = 0; i < a.size(); ++i) product *= (std::abs(4 * u[i] - 2) + a[i]) / (1 + a[i]);
    return product;
  };
  double all = 1.0;
  for (const double x : a) all *= 1 + 1 / (3 * (1 + x) * (1 + x));
  const ResponseIndices result = indices(g, a.size(), 1 << 14, 11);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double part = 1 / (3 * (1 + a[i]) * (1 + a[i]));
    const auto& [factor, s, t] = of(result, i);
    EXPECT_NEAR(s.value, part / (all - 1), 1.5 * *s.half_width) << i;
    EXPECT_NEAR(t.value, part * all / (1 + part) / (all - 1), 1.5 * *t.half_width) << i;
  }
}

// A response that hardly varies about a large value loses no digits, and a sum has no interactions.
TEST(VarianceIndices, OfASumAboutALargeValue) {
  const auto sum = [](const std::vector<double>& u) { return 1e6 + u[0] + 2.0 * u[1]; };
  const ResponseIndices result = indices(sum, 2, 4096, 3);
  for (const auto& [i, share] : {std::pair{0U, 0.2}, {1U, 0.8}}) {
    EXPECT_NEAR(of(result, i).first.value, share, 0.03);
    EXPECT_NEAR(of(result, i).total.value, share, 0.03);
  }
  EXPECT_NEAR(result.variance, 5.0 / 12, 0.01);
}

TEST(VarianceIndices, SampleWithAFailedDesignIsLeftOutAndCounted) {
  const auto f = [](double x) { return std::vector{x, 1.0 - x, 0.5 * x, x * x}; };
  const std::vector<double> xs{0.1, 0.7, 0.4, 0.9, 0.3};
  VarianceIndices with(2, 6), without(2, 5);
  for (const double x : xs) {
    without.add(f(x));
    with.add(f(x));
    if (x == 0.4) with.add(std::vector{0.0, 1.0, std::numeric_limits<double>::quiet_NaN(), 0.0});
  }
  EXPECT_EQ(with.result().samples, 5U);
  EXPECT_EQ(with.result().left_out, 1U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(of(with.result(), i).first.value, of(without.result(), i).first.value);
    EXPECT_EQ(of(with.result(), i).total.value, of(without.result(), i).total.value);
  }
}

TEST(VarianceIndices, NothingToShareWhereNothingVaries) {
  VarianceIndices constant(1, 3), one(1, 1);
  const VarianceIndices none(1, 3);
  for (int k = 0; k < 3; ++k) constant.add(std::vector{0.1, 0.1, 0.1});
  EXPECT_THAT(constant.result().factors, IsEmpty());
  EXPECT_THAT(none.result().factors, IsEmpty());
  one.add(std::vector{1.0, 2.0, 2.0});
  ASSERT_THAT(one.result().factors, SizeIs(1));
  EXPECT_FALSE(one.result().factors[0].total.half_width);
  EXPECT_DOUBLE_EQ(one.result().factors[0].total.value, 2.0);  // 1/2 over the variance 1/4.
}

}  // namespace
}  // namespace prs
