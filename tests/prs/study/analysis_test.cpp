#include "prs/study/study_result.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "prs/study/designs.h"
#include "support/sanitized.h"

namespace prs {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

Study sampled(Plan plan, std::size_t samples, std::vector<std::string> responses = {"y"}) {
  Study study;
  study.plan = plan;
  study.samples = samples;
  study.responses = std::move(responses);
  for (const char* name : {"a", "b"}) {
    Factor factor;
    factor.path = factor.label = name;
    factor.distribution = {Distribution::Kind::uniform, 1.0, 3.0};
    factor.base = Level{"2", 2.0};
    study.factors.push_back(factor);
  }
  return study;
}

/// Converged designs from 0 on, each with one response.
RowBlock block(std::vector<double> responses, std::size_t first = 0) {
  return {first, responses.size(), std::move(responses), {}};
}

StudySummary summary(const Study& study, const RowBlock& rows) {
  StudyAnalysis analysis(study);
  analysis.add(rows);
  return analysis.summary();
}

TEST(StudyStatistics, FollowTheirClosedForms) {
  const ResponseStatistics s = summary(sampled(Plan::monte_carlo, 4), block({99.0, 2.0, 8.0, -4.0, 2.0})).statistics[0];
  EXPECT_EQ(s.count, 4U);
  EXPECT_DOUBLE_EQ(s.mean, 2.0);
  EXPECT_DOUBLE_EQ(*s.standard_deviation, std::sqrt(24.0));  // 72/3
  EXPECT_EQ(s.min, -4.0);
  EXPECT_EQ(s.min_design, 3U);
  EXPECT_EQ(s.max, 8.0);
  EXPECT_EQ(s.max_design, 2U);
  // -4 2 2 8: at 3 p from the first.
  EXPECT_THAT(s.quantiles, ElementsAre(testing::DoubleEq(-4.0 + 6 * 0.03), testing::DoubleEq(-4.0 + 6 * 0.15), 2.0,
                                       testing::DoubleEq(2.0 + 6 * 0.85), testing::DoubleEq(2.0 + 6 * 0.97)));
  EXPECT_EQ(s.histogram.from, -4.0);
  EXPECT_EQ(s.histogram.to, 8.0);
  EXPECT_THAT(s.histogram.counts, ElementsAre(1, 0, 2, 1));
}

TEST(StudyStatistics, SmallSpreadAboutALargeMeanKeepsItsDigits) {
  std::vector<double> values{0.0};
  for (int k = 0; k < 1000; ++k) values.push_back(1e9 + (k % 2 == 0 ? 0.25 : -0.25));
  const ResponseStatistics s = summary(sampled(Plan::sobol, 1000), block(values)).statistics[0];
  EXPECT_DOUBLE_EQ(s.mean, 1e9);
  EXPECT_NEAR(*s.standard_deviation, 0.25 * std::sqrt(1000.0 / 999), 1e-12);
}

TEST(StudyStatistics, LeaveOutFailedDesignsAndMissingNumbers) {
  const Study study = sampled(Plan::monte_carlo, 3, {"y", "z"});
  const RowBlock rows{0, 4, {0.0, 0.0, 1.0, 5.0, 7.0, 7.0, 3.0, kNoResponse}, {{2, {"refused", "no"}}}};
  const StudySummary s = summary(study, rows);
  EXPECT_EQ(s.statistics[0].count, 2U);
  EXPECT_EQ(s.statistics[0].mean, 2.0);
  EXPECT_EQ(s.statistics[1].count, 1U);
  EXPECT_EQ(s.statistics[1].mean, 5.0);
  EXPECT_FALSE(s.statistics[1].standard_deviation);
  EXPECT_THAT(s.statistics[1].histogram.counts, IsEmpty());
  EXPECT_EQ(s.statistics[1].quantiles[2], 5.0);
  EXPECT_EQ(s.surfaces->designs, 1U);
}

TEST(StudyStatistics, NothingWithoutDesigns) {
  const StudySummary s = summary(sampled(Plan::monte_carlo, 1), block({1.0}));
  EXPECT_EQ(s.statistics[0].count, 0U);
  EXPECT_EQ(s.statistics[0].values_kept, 0U);
  EXPECT_EQ(s.surfaces->reason, "0 designs with all responses do not determine 3 coefficients");
}

// A third of 200,000 values 0, 1, .. is kept. The share of kept values below a quantile scatters by sqrt(p (1 - p) /
// 65,536) <= 0.002.
TEST(StudyStatistics, QuantilesOfManyDesignsComeFromPartOfThem) {
  SKIP_UNDER_SANITIZERS();
  constexpr std::size_t kDesigns = 200'000;
  std::vector<double> values(kDesigns);
  std::iota(values.begin(), values.end(), 0.0);
  const ResponseStatistics s = summary(sampled(Plan::monte_carlo, kDesigns - 1), block(values)).statistics[0];
  EXPECT_EQ(s.count, kDesigns - 1);
  EXPECT_EQ(s.values_kept, kMostValuesKept);
  for (std::size_t k = 0; k < kProbabilities.size(); ++k) {
    const double p = kProbabilities[k];
    EXPECT_NEAR(s.quantiles[k] / kDesigns, p, 4 * std::sqrt(p * (1 - p) / 65'536)) << p;
  }
  EXPECT_EQ(std::accumulate(s.histogram.counts.begin(), s.histogram.counts.end(), std::size_t{0}), kMostValuesKept);
}

/// About one design in a hundred, without a pattern.
bool fails(std::size_t k) { return k > 0 && std::mt19937_64(k)() % 97 == 5; }

std::size_t failures(std::size_t first, std::size_t count) {
  std::size_t found = 0;
  for (std::size_t k = first; k < first + count; ++k) found += fails(k) ? 1 : 0;
  return found;
}

/// Results of all designs of a study, some of which fail.
RowBlock answers(const Study& study, std::size_t first, std::size_t count) {
  RowBlock rows{first, count, {}, {}};
  for (std::size_t k = first; k < first + count; ++k) {
    const std::vector<Draw> x = draws(study, k);
    const double a = k == 0 ? 2.0 : x[0].number, b = k == 0 ? 2.0 : x[1].number;
    if (fails(k)) rows.failures.push_back({k - first, {"failed", "a reason"}});
    rows.responses.push_back(fails(k) ? kNoResponse : 1.0 + 3.0 * a - b);
    rows.responses.push_back(fails(k) ? kNoResponse : a * std::exp(b));
  }
  return rows;
}

StudySummary in_blocks_of(const Study& study, std::size_t size) {
  StudyAnalysis analysis(study);
  const std::size_t designs = design_count(study);
  for (std::size_t first = 0; first < designs; first += size)
    analysis.add(answers(study, first, std::min(size, designs - first)));
  return analysis.summary();
}

void expect_same(const StudySummary& a, const StudySummary& b) {
  ASSERT_EQ(a.statistics.size(), b.statistics.size());
  for (std::size_t j = 0; j < a.statistics.size(); ++j) {
    const ResponseStatistics &s = a.statistics[j], &t = b.statistics[j];
    EXPECT_EQ(s.mean, t.mean);
    EXPECT_EQ(s.standard_deviation, t.standard_deviation);
    EXPECT_EQ(s.min_design, t.min_design);
    EXPECT_EQ(s.max_design, t.max_design);
    EXPECT_EQ(s.quantiles, t.quantiles);
    EXPECT_EQ(s.histogram.counts, t.histogram.counts);
    const LinearFit &f = *a.surfaces->fits[j], &g = *b.surfaces->fits[j];
    EXPECT_EQ(f.intercept, g.intercept);
    EXPECT_EQ(f.r_squared, g.r_squared);
    for (std::size_t i = 0; i < f.effects.size(); ++i) {
      EXPECT_EQ(f.effects[i].coefficient, g.effects[i].coefficient);
      EXPECT_EQ(f.effects[i].standard_error, g.effects[i].standard_error);
    }
  }
  ASSERT_EQ(a.indices.size(), b.indices.size());
  for (std::size_t j = 0; j < a.indices.size(); ++j)
    for (std::size_t i = 0; i < a.indices[j].factors.size(); ++i) {
      const FactorIndices &f = a.indices[j].factors[i], &g = b.indices[j].factors[i];
      EXPECT_EQ(f.first.value, g.first.value);
      EXPECT_EQ(f.total.value, g.total.value);
      EXPECT_EQ(f.total.half_width, g.total.half_width);
    }
}

TEST(StudyAnalysis, DoesNotDependOnHowTheRowsAreCut) {
  for (const Plan plan : {Plan::latin_hypercube, Plan::sobol_indices}) {
    const Study study = sampled(plan, 1000, {"y", "z"});
    const StudySummary whole = in_blocks_of(study, design_count(study));
    for (const std::size_t size : {1U, 7U, 128U, 999U}) expect_same(in_blocks_of(study, size), whole);
  }
}

TEST(StudyAnalysis, TakesInputsThatAreDrawnAlready) {
  Study study = sampled(Plan::latin_hypercube, 300, {"y", "z"});
  study.factors[0].companions.emplace_back().path = "with a";
  const std::size_t designs = design_count(study);
  std::vector<double> inputs;
  for (std::size_t k = 0; k < designs; ++k) {
    const std::vector<Draw> drawn = draws(study, k);
    for (const double number : {drawn[0].number, -1.0, drawn[1].number}) inputs.push_back(number);
  }
  StudyAnalysis analysis(study);
  analysis.add(answers(study, 0, designs), inputs);
  expect_same(analysis.summary(), in_blocks_of(study, designs));
}

// y = 1 + 3 a - b over [1, 3]: 5 + 3 x_a - x_b on the factors' axes, whichever designs fail.
TEST(StudyAnalysis, FindsTheLinearResponseOfAStudy) {
  for (const Plan plan : {Plan::latin_hypercube, Plan::sobol, Plan::monte_carlo}) {
    const Study study = sampled(plan, 500, {"y", "z"});
    const StudySummary s = in_blocks_of(study, 64);
    EXPECT_EQ(s.surfaces->designs, 500U - failures(1, 500));
    const LinearFit& fit = *s.surfaces->fits[0];
    EXPECT_NEAR(fit.intercept, 5.0, 1e-13);
    ASSERT_THAT(fit.effects, SizeIs(2));
    EXPECT_EQ(fit.effects[0].factor, 0U);
    EXPECT_NEAR(fit.effects[0].coefficient, 3.0, 1e-13);
    EXPECT_NEAR(fit.effects[1].coefficient, -1.0, 1e-13);
    EXPECT_NEAR(fit.r_squared, 1.0, 1e-13);
    EXPECT_LT(s.surfaces->fits[1]->r_squared, 0.97);
    EXPECT_THAT(s.indices, IsEmpty());
  }
}

// First and total indices of a sum are its parts of the variance, 9/10 and 1/10. A failed design invalidates its sample
// of four.
TEST(StudyAnalysis, IndicesOfVarianceComeFromWholeSamples) {
  const Study study = sampled(Plan::sobol_indices, 4096, {"y", "z"});
  const StudySummary s = in_blocks_of(study, 1000);
  ASSERT_THAT(s.indices, SizeIs(2));
  const ResponseIndices& y = s.indices[0];
  EXPECT_EQ(y.samples + y.left_out, 4096U);
  std::size_t left_out = 0;
  for (std::size_t j = 0; j < 4096; ++j) left_out += failures(1 + 4 * j, 4) > 0 ? 1 : 0;
  EXPECT_GT(left_out, 100U);
  EXPECT_EQ(y.left_out, left_out);
  EXPECT_NEAR(y.factors[0].first.value, 0.9, *y.factors[0].first.half_width);
  EXPECT_NEAR(y.factors[0].total.value, 0.9, *y.factors[0].total.half_width);
  EXPECT_NEAR(y.factors[1].first.value, 0.1, *y.factors[1].first.half_width);
  EXPECT_NEAR(y.factors[1].total.value, 0.1, *y.factors[1].total.half_width);
  // Statistics count the two independent designs of each sample only.
  EXPECT_LE(s.statistics[0].count, 2 * 4096U);
  EXPECT_NEAR(s.statistics[0].mean, 5.0, 0.01);
}

TEST(StudyAnalysis, PlansThatListTheirDesignsHaveStatisticsOnly) {
  Study study = sampled(Plan::grid, 0);
  for (Factor& factor : study.factors) {
    factor.levels = {{"1", 1.0}, {"3", 3.0}};
    factor.distribution = {};
  }
  const StudySummary s = summary(study, block({0.0, 1.0, 2.0, 3.0, 6.0}));
  EXPECT_EQ(s.statistics[0].mean, 3.0);
  EXPECT_FALSE(s.surfaces);
  EXPECT_THAT(s.indices, IsEmpty());
}

TEST(StudyAnalysis, SaysThatTooManyFactorsHaveNoSurface) {
  Study study = sampled(Plan::monte_carlo, 2);
  study.factors.assign(kMostFactorsOfSurface + 1, study.factors[0]);
  const StudySummary s = summary(study, block({1.0, 2.0, 3.0}));
  EXPECT_EQ(s.statistics[0].count, 2U);
  EXPECT_EQ(s.surfaces->reason, "it takes at most 100 factors, the study has 101");
}

TEST(StudyResult, CountsAllDesignsAndKeepsTheFirst) {
  StudyResult result;
  result.study = sampled(Plan::monte_carlo, 30'000);
  RowBlock rows{0, 3, {1.0, kNoResponse, 3.0}, {{1, {"refused", "no room"}}}};
  add(result, rows);
  add(result, {3, 2, {4.0, kNoResponse}, {{1, {"iteration_limit", "late"}}}});
  EXPECT_EQ(result.designs, 5U);
  EXPECT_EQ(result.refused, 1U);
  EXPECT_EQ(result.failed, 1U);
  ASSERT_THAT(result.rows, SizeIs(5));
  EXPECT_THAT(result.base().design.settings, IsEmpty());
  EXPECT_THAT(result.rows[2].design.settings, SizeIs(2));
  EXPECT_EQ(result.rows[1].status.reason, "no room");
  EXPECT_EQ(result.rows[1].responses[0], std::nullopt);
  EXPECT_EQ(result.rows[3].responses[0], 4.0);
  EXPECT_TRUE(result.rows[3].status.converged());
  add(result, block(std::vector<double>(25'000, 1.0), 5));
  EXPECT_EQ(result.designs, 25'005U);
  EXPECT_THAT(result.rows, SizeIs(kMostRowsShown));
}

}  // namespace
}  // namespace prs
