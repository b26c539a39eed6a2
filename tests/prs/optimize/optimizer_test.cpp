#include "prs/optimize/optimizer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "known_problems.h"
#include "prs/components/components.h"
#include "tests/support/temporary_directory.h"

namespace prs {
namespace {

/// Distance of the front's designs from a known curve, at most and on average.
struct Distance {
  double largest = 0.0;
  double mean = 0.0;
};

template <class Excess>
Distance distance(const Search& search, Excess excess) {
  Distance distance;
  for (const std::size_t k : search.front) {
    const double d = excess(search.designs[k].responses);
    EXPECT_GT(d, -1e-9) << "below the true front";
    distance.largest = std::max(distance.largest, d);
    distance.mean += d / static_cast<double>(search.front.size());
  }
  return distance;
}

std::vector<double> of_front(const Search& search, std::size_t response) {
  std::vector<double> values;
  for (const std::size_t k : search.front) values.push_back(search.designs[k].responses[response]);
  return values;
}

double zdt1_excess(const std::vector<double>& y) { return y[1] - (1.0 - std::sqrt(y[0])); }

TEST(Optimizer, EveryAlgorithmFindsAKnownFront) {
  for (const Algorithm algorithm : {Algorithm::nsga2, Algorithm::nspso, Algorithm::moead}) {
    test::Problem problem = test::zdt1(5);
    problem.optimization.algorithm = algorithm;
    problem.optimization.population = 60;
    problem.optimization.generations = 150;
    const OptimizationResult result = problem.run();
    EXPECT_EQ(result.search.designs.size(), 9000) << name(algorithm);
    EXPECT_EQ(problem.asked, 9001) << name(algorithm);
    EXPECT_LT(distance(result.search, zdt1_excess).mean, 0.01) << name(algorithm);
    const std::vector<double> f = of_front(result.search, 0);
    ASSERT_GT(f.size(), 20) << name(algorithm);
    EXPECT_LT(f.front(), 0.02) << name(algorithm);
    EXPECT_GT(f.back(), 0.9) << name(algorithm);
    EXPECT_TRUE(std::ranges::is_sorted(f));
  }
}

TEST(Optimizer, SingleObjectivesReachTheirOptimum) {
  for (const Algorithm algorithm : {Algorithm::sade, Algorithm::pso, Algorithm::cmaes}) {
    test::Problem problem = test::zdt1(3);
    problem.optimization.study.responses = {"f"};
    problem.optimization.objectives = {{0, true}};
    problem.optimization.algorithm = algorithm;
    problem.optimization.generations = 100;
    // 7 - |x - c|^2 with c in the cube.
    problem.answer = [](const std::vector<double>& x) {
      const double d[] = {x[0] - 0.25, x[1] - 0.5, x[2] - 0.8};
      return std::vector{7.0 - d[0] * d[0] - d[1] * d[1] - d[2] * d[2]};
    };
    const OptimizationResult result = problem.run();
    ASSERT_TRUE(result.compromise) << name(algorithm);
    EXPECT_EQ(result.search.front.size(), 1) << name(algorithm);
    EXPECT_NEAR(result.chosen()->responses[0], 7.0, 1e-4) << name(algorithm);
    EXPECT_EQ(result.search.designs.size(), 4000) << name(algorithm);
  }
}

TEST(Optimizer, ConstrainedFrontOfBinhAndKorn) {
  test::Problem problem = test::binh_korn();
  problem.optimization.generations = 100;
  const OptimizationResult result = problem.run();
  const auto excess = [](const std::vector<double>& y) {
    // On the front x = t, y = min(t, 3).
    double t = std::sqrt(y[0] / 8.0);
    if (t > 3.0) t = std::sqrt(y[0] / 4.0 - 9.0);
    const double u = std::min(t, 3.0);
    return y[1] - ((t - 5.0) * (t - 5.0) + (u - 5.0) * (u - 5.0));
  };
  const Distance d = distance(result.search, excess);
  EXPECT_LT(d.mean, 0.1);  // Range: 46.
  EXPECT_LT(of_front(result.search, 0).front(), 0.5);
  EXPECT_NEAR(of_front(result.search, 0).back(), 136.0, 1.5);
  for (const std::size_t k : result.search.front) {
    EXPECT_LE(result.search.designs[k].responses[2], 25.0);
    EXPECT_GE(result.search.designs[k].responses[3], 7.7);
  }
}

TEST(Optimizer, ConstrainedFrontOfSrinivasAndDeb) {
  test::Problem problem = test::srinivas();
  problem.optimization.population = 100;
  problem.optimization.generations = 100;
  const OptimizationResult result = problem.run();
  // Within the constraints x = -2.5: there f = 22.25 + (y - 1)^2, and f + g = -0.25, its smallest value. The front ends
  // at the disc.
  const double end = std::sqrt(225.0 - 6.25);
  std::size_t on_line = 0;
  for (const std::size_t k : result.search.front) {
    const std::vector<double>& y = result.search.designs[k].responses;
    EXPECT_LE(y[2], 225.0);
    EXPECT_LE(y[3], -10.0);
    EXPECT_GE(y[0] + y[1], -0.25 - 1e-9);
    if (y[0] < 24.5 || y[0] > 22.25 + (end - 1.0) * (end - 1.0)) continue;
    ++on_line;
    EXPECT_LT(y[0] + y[1], 0.5);
  }
  EXPECT_GT(on_line, 50);
}

/// Numbers that distinguish two results.
std::vector<std::vector<double>> answers(const OptimizationResult& result) {
  std::vector<std::vector<double>> all;
  for (const Search* search : {&result.search, result.check ? &*result.check : nullptr})
    if (search)
      for (const EvaluatedDesign& design : search->designs) all.push_back(design.responses);
  return all;
}

/// Searches whose next points do not depend on the answers within a generation.
TEST(Optimizer, AsksForAGenerationAtOnce) {
  for (const Algorithm algorithm : {Algorithm::sade, Algorithm::cmaes, Algorithm::pso}) {
    test::Problem problem = test::zdt1(3);
    problem.optimization.study.responses = {"f"};
    problem.optimization.objectives = {{0, false}};
    problem.optimization.algorithm = algorithm;
    problem.optimization.population = 12;
    problem.optimization.generations = 20;
    problem.answer = [](const std::vector<double>& x) { return std::vector{x[0] + x[1] * x[2]}; };
    Journal journal = Journal::temporary(problem.header());
    const EvaluateDesigns one_by_one = problem.evaluate();
    std::vector<std::size_t> sizes;
    const EvaluateDesigns counted = [&](const std::vector<std::vector<Draw>>& designs) {
      sizes.push_back(designs.size());
      return one_by_one(designs);
    };
    ASSERT_TRUE(optimize(problem.optimization, counted, journal, {}));
    ASSERT_EQ(sizes.size(), 21) << name(algorithm);
    EXPECT_EQ(sizes[0], 1);
    EXPECT_EQ(std::ranges::count(sizes, 12U), 20) << name(algorithm);
  }
}

/// Both searches start from different designs and end at different ones; the better one counts.
TEST(Optimizer, DeliversTheBetterOfBothSearches) {
  test::Problem problem = test::zdt1(4);
  problem.optimization.study.responses = {"f"};
  problem.optimization.objectives = {{0, false}};
  problem.optimization.population = 8;
  problem.optimization.generations = 12;
  problem.answer = [](const std::vector<double>& x) {
    double sum = 0.0;
    for (const double xi : x) sum += (xi - 0.3) * (xi - 0.3) + 0.1 * std::cos(20.0 * xi);
    return std::vector{sum};
  };
  std::size_t of_check = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    problem.optimization.seed = seed;
    problem.optimization.algorithm = Algorithm::sade;
    problem.optimization.check = Algorithm::cmaes;
    const OptimizationResult result = problem.run();
    ASSERT_TRUE(result.compromise);
    const double best = result.search.designs[result.search.front.at(0)].responses[0];
    const double other = result.check->designs[result.check->front.at(0)].responses[0];
    EXPECT_EQ(result.chosen()->responses[0], std::min(best, other));
    EXPECT_EQ(&result.search_of(*result.compromise), best <= other ? &result.search : &*result.check);
    of_check += other < best;
  }
  EXPECT_GT(of_check, 0);
  EXPECT_LT(of_check, 8);
}

TEST(Optimizer, SeedDecides) {
  test::Problem problem = test::binh_korn();
  problem.optimization.generations = 10;
  const auto first = answers(problem.run());
  EXPECT_EQ(answers(problem.run()), first);
  problem.optimization.seed = 2;
  EXPECT_NE(answers(problem.run()), first);
}

TEST(Optimizer, InterruptedAnywhereItEndsTheSameAndComputesNothingTwice) {
  for (const Algorithm check : {Algorithm::moead, Algorithm::nspso}) {
    test::Problem problem = test::binh_korn();
    problem.optimization.population = 12;
    problem.optimization.generations = 6;
    problem.optimization.check = check;
    const auto whole = answers(problem.run());
    const std::size_t designs = design_count(problem.optimization);
    ASSERT_EQ(problem.asked, designs);

    const test::TemporaryDirectory temporary;
    const auto path = temporary.path() / "optimize.journal";
    problem.asked = 0;
    std::optional<OptimizationResult> result;
    int runs = 0;
    while (!result) {
      Journal journal = Journal::append_to(path, problem.header());
      const std::size_t before = problem.asked;
      result = optimize(problem.optimization, problem.evaluate(), journal,
                        {[&] { return problem.asked - before >= 7; }, {}});
      ASSERT_LT(++runs, 100);
    }
    EXPECT_GT(runs, 8);
    EXPECT_EQ(problem.asked, designs);
    EXPECT_EQ(answers(*result), whole);
  }
}

TEST(Optimizer, GoesOnFromTheMiddleOfAGeneration) {
  test::Problem problem = test::binh_korn();
  problem.optimization.population = 12;
  problem.optimization.generations = 4;
  Journal whole = Journal::temporary(problem.header());
  const auto expected = answers(*optimize(problem.optimization, problem.evaluate(), whole, {}));

  // A journal with records of different sizes, up to the fifth design of the third generation.
  Journal part = Journal::temporary(problem.header());
  std::vector<double> rows;
  for (const Journal::Record& record : whole.records()) {
    const RowBlock block = whole.block(record);
    rows.insert(rows.end(), block.responses.begin(), block.responses.end());
  }
  const std::size_t width = 4, kept = 1 + 12 + 12 + 5;
  for (std::size_t first = 0; first < kept; first += 5) {
    const auto from = rows.begin() + static_cast<std::ptrdiff_t>(first * width);
    part.append(encode({first, 5, {from, from + 20}, {}}));
  }
  problem.asked = 0;
  EXPECT_EQ(answers(*optimize(problem.optimization, problem.evaluate(), part, {})), expected);
  EXPECT_EQ(problem.asked, 1 + 48 - kept);
}

TEST(Optimizer, DesignsWithoutAnswerAreTheWorst) {
  test::Problem problem = test::zdt1(2);
  const auto answer = problem.answer;
  // Half of the range has no result, one more response is missing in a quarter.
  problem.answer = [answer](const std::vector<double>& x) {
    if (x[0] > 0.5) return std::vector<double>{};
    std::vector<double> y = answer(x);
    if (x[0] > 0.25) y[1] = kNoResponse;
    return y;
  };
  const OptimizationResult result = problem.run();
  std::size_t without = 0;
  for (const EvaluatedDesign& design : result.search.designs) {
    const double x = problem.values(design.draws)[0];
    EXPECT_EQ(design.is_feasible(), x <= 0.25);
    EXPECT_EQ(design.status.reason.empty(), x <= 0.25);
    without += x > 0.25;
  }
  EXPECT_GT(without, 10);
  EXPECT_GT(of_front(result.search, 0).back(), 0.24);
}

TEST(Optimizer, WithoutAFeasibleDesignTheNearestIsShown) {
  test::Problem problem = test::binh_korn();
  problem.optimization.constraints.push_back({"never", 0, Constraint::Sense::at_most, {Limit::Kind::number, -1.0, 0}});
  problem.optimization.check = Algorithm::nspso;
  const OptimizationResult result = problem.run();
  EXPECT_FALSE(result.compromise);
  EXPECT_TRUE(result.search.front.empty());
  ASSERT_TRUE(result.nearest);
  // The search reduces the violation: f towards 0.
  EXPECT_LT(result.chosen()->responses[0], 0.1);
  EXPECT_TRUE(result.comparison->best.empty());
}

TEST(Optimizer, FirstDesignIsTheFilesOwnWhereTheVariablesHaveIt) {
  test::Problem problem = test::binh_korn();
  problem.optimization.generations = 1;
  problem.optimization.study.factors[0].base = Level{"2.5", 2.5};
  problem.optimization.study.factors[1].base = Level{"1", 1.0};
  EXPECT_EQ(problem.run().search.designs[0].responses, problem.answer({2.5, 1.0}));
  problem.optimization.study.factors[1].base = Level{"7", 7.0};  // Out of range.
  const OptimizationResult result = problem.run();
  EXPECT_NE(result.search.designs[0].responses, problem.answer({2.5, 7.0}));
  EXPECT_EQ(result.initial.responses, problem.answer({2.5, 7.0}));
}

TEST(Optimizer, WholeNumbersAndWordsAreSearchedByTheirIndex) {
  test::Problem problem = test::zdt1(2);
  Factor& count = problem.optimization.study.factors[1];
  count.distribution = {};
  for (int k = 3; k <= 12; ++k) count.levels.push_back({std::to_string(k), 1.0 * k});
  problem.answer = [](const std::vector<double>& x) {
    return std::vector{x[0] + (x[1] - 9.0) * (x[1] - 9.0), 1.0 - x[0]};
  };
  const OptimizationResult result = problem.run();
  for (const std::size_t k : result.search.front) EXPECT_EQ(problem.values(result.search.designs[k].draws)[1], 9.0);
  std::vector<std::size_t> met(10);
  for (const EvaluatedDesign& design : result.search.designs) ++met.at(design.draws[1].level);
  EXPECT_THAT(met, testing::Each(testing::Gt(0)));
}

TEST(DrawAt, RoundsToAMillionthOfTheRangeAndStaysInside) {
  const Factor angle = test::variable("a", 40.0, 50.0);
  EXPECT_EQ(draw_at(angle, 0.123456789).number, 41.23457);
  EXPECT_EQ(draw_at(angle, 0.0).number, 40.0);
  EXPECT_EQ(draw_at(angle, 1.0).number, 50.0);
  const Factor narrow = test::variable("b", 1.00000049, 1.0000061);
  for (const double x : {0.0, 0.3, 1.0}) {
    EXPECT_GE(draw_at(narrow, x).number, 1.00000049);
    EXPECT_LE(draw_at(narrow, x).number, 1.0000061);
  }
  const Factor large = test::variable("c", -3e9, 5e9);
  EXPECT_EQ(draw_at(large, 0.51234567891).number, 1098765000.0 + 0.0);
}

}  // namespace
}  // namespace prs
