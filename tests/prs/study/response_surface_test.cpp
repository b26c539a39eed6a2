#include "prs/study/sensitivity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace prs {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// A number in [-1, 1).
double draw(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-52 - 1.0; }

TEST(LinearRegression, FindsALinearFunctionToRounding) {
  std::mt19937_64 random(1);
  LinearRegression regression(3, 2);
  for (int k = 0; k < 1000; ++k) {
    const std::array x{draw(random), draw(random), draw(random)};
    const std::array y{2.0 + 3.0 * x[0] - 0.5 * x[1] + 1e-3 * x[2], 1e6 + 1e-3 * x[1]};
    regression.add(x, y);
  }
  const auto fits = regression.fits();
  ASSERT_TRUE(fits[0] && fits[1]);
  EXPECT_NEAR(fits[0]->intercept, 2.0, 1e-14);
  for (const auto& [column, value] : {std::pair{0, 3.0}, {1, -0.5}, {2, 1e-3}})
    EXPECT_NEAR(fits[0]->effects[static_cast<std::size_t>(column)].coefficient, value, 1e-14);
  EXPECT_NEAR(fits[0]->r_squared, 1.0, 1e-14);
  EXPECT_NEAR(*fits[0]->adjusted_r_squared, 1.0, 1e-14);
  EXPECT_LT(*fits[0]->effects[0].standard_error, 1e-14);
  // A response of 1e6 is rounded to 1e-10.
  EXPECT_NEAR(fits[1]->effects[1].coefficient, 1e-3, 1e-10);
  EXPECT_NEAR(fits[1]->intercept, 1e6, 1e-9);
}

/// y = 10 + 3 x_1 - x_2 + x_1 x_2 / 2 over the corners of a square, each taken `times` times: the interaction is the
/// residual of the fit, 1/4 per row of a total of 41/4.
class Corners : public testing::TestWithParam<int> {};

TEST_P(Corners, FollowTheClosedForm) {
  const int times = GetParam();
  LinearRegression regression(2, 1);
  for (int k = 0; k < times; ++k)
    for (const double a : {-1.0, 1.0})
      for (const double b : {-1.0, 1.0}) {
        const std::array x{a, b};
        const std::array y{10.0 + 3.0 * a - b + 0.5 * a * b};
        regression.add(x, y);
      }
  const double rows = 4.0 * times;
  const LinearFit fit = *regression.fits()[0];
  EXPECT_NEAR(fit.intercept, 10.0, 1e-13);
  EXPECT_NEAR(fit.effects[0].coefficient, 3.0, 1e-13);
  EXPECT_NEAR(fit.effects[1].coefficient, -1.0, 1e-13);
  EXPECT_NEAR(fit.effects[0].contribution_percent, 75.0, 1e-12);
  EXPECT_NEAR(fit.effects[1].contribution_percent, 25.0, 1e-12);
  EXPECT_NEAR(fit.r_squared, 40.0 / 41.0, 1e-14);
  EXPECT_NEAR(*fit.adjusted_r_squared, 1.0 - (0.25 * rows / (rows - 3)) / (10.25 * rows / (rows - 1)), 1e-13);
  for (const FactorEffect& effect : fit.effects)
    EXPECT_NEAR(*effect.standard_error, std::sqrt(0.25 / (rows - 3)), 1e-13);
}

// Numbers around the 128 rows that are processed at once.
INSTANTIATE_TEST_SUITE_P(Rows, Corners, testing::Values(1, 31, 32, 33, 64, 1000));

TEST(LinearRegression, FitWithoutRowsLeftOverHasNoErrors) {
  LinearRegression regression(1, 1);
  for (const double x : {0.0, 1.0}) {
    const std::array row{x}, y{2.0 - x};
    regression.add(row, y);
  }
  const LinearFit fit = *regression.fits()[0];
  EXPECT_NEAR(fit.effects[0].coefficient, -1.0, 1e-15);
  EXPECT_FALSE(fit.effects[0].standard_error);
  EXPECT_FALSE(fit.adjusted_r_squared);
}

TEST(LinearRegression, ResponseWhoseSquaresOverflowHasNoFit) {
  LinearRegression regression(1, 2);
  for (const double x : {0.0, 0.5, 1.0}) {
    const std::array row{x};
    const std::array y{1e300 * x, x};
    regression.add(row, y);
  }
  const auto fits = regression.fits();
  EXPECT_FALSE(fits[0]);
  EXPECT_TRUE(fits[1]);
}

TEST(LinearRegression, ResponseThatDoesNotVaryHasNoFit) {
  std::mt19937_64 random(2);
  LinearRegression regression(1, 3);
  for (int k = 0; k < 300; ++k) {
    const std::array x{draw(random)};
    const std::array y{0.1, x[0], 1.0 + 1e-16 * static_cast<double>(k % 3)};
    regression.add(x, y);
  }
  const auto fits = regression.fits();
  EXPECT_FALSE(fits[0]);
  EXPECT_TRUE(fits[1]);
  EXPECT_FALSE(fits[2]);
}

TEST(LinearRegression, TellsAColumnThatFollowsOthers) {
  std::mt19937_64 random(3);
  LinearRegression sound(2, 1), twice(2, 1), constant(2, 1);
  for (int k = 0; k < 300; ++k) {
    const double a = draw(random), b = draw(random);
    const std::array y{a};
    sound.add(std::array{a, b}, y);
    twice.add(std::array{a, 0.5 - 2.0 * a}, y);
    constant.add(std::array{0.25, b}, y);
  }
  EXPECT_FALSE(sound.dependent_column());
  EXPECT_EQ(twice.dependent_column(), 1U);
  EXPECT_EQ(constant.dependent_column(), 0U);
}

Factor factor(std::string path, Distribution distribution, std::vector<Level> levels = {}) {
  Factor f;
  f.path = f.label = std::move(path);
  f.distribution = distribution;
  f.levels = std::move(levels);
  return f;
}

Study mixed_study(Plan plan) {
  using enum Distribution::Kind;
  Study study;
  study.plan = plan;
  study.factors = {factor("uniform", {uniform, 29.0, 31.0}),
                   factor("word", {}, {{"jacod", {}}, {"other", {}}}),
                   factor("decades", {log_uniform, 1.0, 100.0}),
                   factor("normal", {normal, 5.0, 0.5}),
                   factor("levels", {}, {{"7", 7.0}, {"5", 5.0}, {"13", 13.0}}),
                   factor("fixed", {uniform, 3.0, 3.0})};
  return study;
}

TEST(NormalisedFactors, RunOverTheirRanges) {
  const auto factors = normalised_factors(mixed_study(Plan::latin_hypercube));
  ASSERT_THAT(factors, SizeIs(4));
  EXPECT_EQ(factors[0].factor, 0U);
  EXPECT_DOUBLE_EQ(factors[0](29.0), -1.0);
  EXPECT_DOUBLE_EQ(factors[0](31.0), 1.0);
  EXPECT_EQ(factors[1].factor, 2U);
  EXPECT_NEAR(factors[1](1.0), -1.0, 1e-15);
  EXPECT_NEAR(factors[1](10.0), 0.0, 1e-15);
  EXPECT_NEAR(factors[1](100.0), 1.0, 1e-15);
  EXPECT_EQ(factors[2].factor, 3U);
  EXPECT_DOUBLE_EQ(factors[2](5.5), 1.0);
  EXPECT_EQ(factors[3].factor, 4U);
  EXPECT_DOUBLE_EQ(factors[3](5.0), -1.0);
  EXPECT_DOUBLE_EQ(factors[3](13.0), 1.0);
}

TEST(NormalisedFactors, AreForSampledPlansOnly) {
  for (const Plan plan : {Plan::one_at_a_time, Plan::grid, Plan::derivatives})
    EXPECT_THAT(normalised_factors(mixed_study(plan)), IsEmpty());
}

TEST(ResponseSurfaces, RankTheStudysFactors) {
  const Study study = mixed_study(Plan::monte_carlo);
  const auto factors = normalised_factors(study);
  std::mt19937_64 random(4);
  LinearRegression regression(factors.size(), 1);
  for (int k = 0; k < 200; ++k) {
    const std::array x{draw(random), draw(random), draw(random), draw(random)};
    regression.add(x, std::array{x[0] - 6.0 * x[1] + 3.0 * x[3]});
  }
  const ResponseSurfaces surfaces = response_surfaces(regression, factors, study);
  EXPECT_EQ(surfaces.designs, 200U);
  const std::vector<FactorEffect>& effects = surfaces.fits[0]->effects;
  EXPECT_EQ(effects[0].factor, 2U);
  EXPECT_NEAR(effects[0].contribution_percent, 60.0, 1e-10);
  EXPECT_NEAR(effects[0].coefficient, -6.0, 1e-13);
  EXPECT_EQ(effects[1].factor, 4U);
  EXPECT_EQ(effects[2].factor, 0U);
  EXPECT_EQ(effects[3].factor, 3U);
}

TEST(ResponseSurfaces, SayWhyThereIsNone) {
  const Study study = mixed_study(Plan::sobol);
  const auto factors = normalised_factors(study);
  LinearRegression regression(factors.size(), 1);
  std::mt19937_64 random(5);
  for (int k = 0; k < 4; ++k) {
    const double a = draw(random);
    regression.add(std::array{a, draw(random), draw(random), -a}, std::array{a});
  }
  EXPECT_EQ(response_surfaces(regression, factors, study).reason,
            "4 designs with all responses do not determine 5 coefficients");
  for (int k = 0; k < 20; ++k) {
    const double a = draw(random);
    regression.add(std::array{a, draw(random), draw(random), -a}, std::array{a});
  }
  const ResponseSurfaces surfaces = response_surfaces(regression, factors, study);
  EXPECT_THAT(surfaces.reason, HasSubstr("levels does not vary independently"));
  EXPECT_THAT(surfaces.fits, IsEmpty());
}

}  // namespace
}  // namespace prs
