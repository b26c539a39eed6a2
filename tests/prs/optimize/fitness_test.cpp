#include "prs/optimize/optimizer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "known_problems.h"
#include "prs/components/components.h"

namespace prs {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

EvaluatedDesign with(std::vector<double> responses) { return {{}, std::move(responses), {}, 0.0}; }

bool dominates(const std::vector<double>& a, const std::vector<double>& b) {
  bool better = false;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k] > b[k]) return false;
    better = better || a[k] < b[k];
  }
  return better;
}

TEST(Fitness, DominatesAsDebDefinesIt) {
  Optimization optimization = test::two_objectives({});
  optimization.objectives[1].maximize = true;
  optimization.study.responses.push_back("c");
  optimization.constraints = {{"c", 2, Constraint::Sense::at_least, {Limit::Kind::number, 0.0, 0}}};
  EvaluatedDesign initial = with({-2e-3, 5e6, 1.0});
  const Fitness fitness(optimization, initial);
  // Objectives of all sizes, far beyond those of the file's own design, and of both signs.
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-12.0, 12.0), sign(-1.0, 1.0);
  const auto number = [&] { return std::copysign(std::pow(10.0, exponent(random)), sign(random)); };
  std::vector<EvaluatedDesign> designs;
  for (int k = 0; k < 150; ++k) designs.push_back(with({number(), number(), sign(random)}));
  for (EvaluatedDesign& design : designs) fitness.assess(design);
  const auto reference = [&](const EvaluatedDesign& a, const EvaluatedDesign& b) {
    if (a.is_feasible() != b.is_feasible()) return a.is_feasible();
    if (!a.is_feasible()) return a.violation < b.violation;
    return dominates(costs(optimization, a), costs(optimization, b));
  };
  std::size_t dominated = 0;
  for (const EvaluatedDesign& a : designs)
    for (const EvaluatedDesign& b : designs) {
      EXPECT_EQ(dominates(fitness(a), fitness(b)), reference(a, b));
      dominated += reference(a, b);
    }
  EXPECT_GT(dominated, 1000);
}

TEST(Fitness, ViolationsAreRelative) {
  Optimization optimization = test::two_objectives({});
  const EvaluatedDesign initial = with({200.0, 4.0});
  const auto violation = [&](Constraint::Sense sense, Limit limit, std::vector<double> responses) {
    optimization.constraints = {{"c", 0, sense, limit}};
    EvaluatedDesign design = with(std::move(responses));
    Fitness(optimization, initial).assess(design);
    return design.violation;
  };
  using enum Constraint::Sense;
  using Kind = Limit::Kind;
  EXPECT_EQ(violation(at_least, {Kind::number, 100.0, 0}, {90.0, 0.0}), 10.0 / 200.0);
  EXPECT_EQ(violation(at_least, {Kind::number, 400.0, 0}, {90.0, 0.0}), 310.0 / 400.0);
  EXPECT_EQ(violation(at_least, {Kind::number, 100.0, 0}, {100.0, 0.0}), 0.0);
  EXPECT_EQ(violation(at_most, {Kind::initial, 1.5, 0}, {330.0, 0.0}), 30.0 / 300.0);
  EXPECT_EQ(violation(at_most, {Kind::initial, 1.5, 0}, {300.0, 0.0}), 0.0);
  EXPECT_EQ(violation(at_most, {Kind::response, 0.0, 1}, {3.0, 2.0}), 1.0 / 3.0);
  EXPECT_EQ(violation(at_least, {Kind::response, 0.0, 1}, {3.0, 2.0}), 0.0);
}

TEST(NonDominated, AgreesWithTheDefinition) {
  std::mt19937 random(2);
  std::uniform_int_distribution<int> coordinate(0, 12);
  for (std::size_t dimensions = 1; dimensions <= 4; ++dimensions) {
    Points points;
    for (int k = 0; k < 200; ++k) {
      std::vector<double>& point = points.emplace_back();
      for (std::size_t i = 0; i < dimensions; ++i) point.push_back(coordinate(random));
    }
    std::vector<std::size_t> expected;
    for (std::size_t k = 0; k < points.size(); ++k) {
      bool counts = true;
      for (std::size_t j = 0; j < points.size(); ++j)
        counts = counts && !dominates(points[j], points[k]) && !(j < k && points[j] == points[k]);
      if (counts) expected.push_back(k);
    }
    EXPECT_THAT(non_dominated(points), testing::UnorderedElementsAreArray(expected)) << dimensions;
  }
  EXPECT_THAT(non_dominated({}), IsEmpty());
}

TEST(Hypervolume, OfBoxesIsTheirUnion) {
  EXPECT_EQ(modules::loaded<SearchModule>().hypervolume({}, {1.0, 1.0}), 0.0);
  EXPECT_DOUBLE_EQ(modules::loaded<SearchModule>().hypervolume({{0.2}, {0.4}}, {1.0}), 0.8);
  EXPECT_DOUBLE_EQ(modules::loaded<SearchModule>().hypervolume({{0.0, 0.5}, {0.5, 0.0}}, {1.0, 1.0}), 0.75);
  EXPECT_DOUBLE_EQ(modules::loaded<SearchModule>().hypervolume({{0.0, 0.5, 0.5}, {0.5, 0.0, 0.0}}, {1.0, 1.0, 1.0}),
                   0.25 + 0.5 - 0.125);
}

/// A front of three designs with u = (0, 1), (0.2, 0.35) and (1, 0).
Search three_designs() {
  Search search;
  search.designs = {with({10.0, 7.0}), with({12.0, 5.7}), with({20.0, 5.0}), with({30.0, 9.0})};
  search.front = {0, 1, 2};
  return search;
}

TEST(CompromiseOf, ChoosesByEachRule) {
  OptimizationResult result{test::two_objectives({}), {}, three_designs(), {}, {}};
  result.front = result.search.front;
  const auto chosen = [&](Compromise compromise) {
    result.optimization.compromise = std::move(compromise);
    return compromise_of(result);
  };
  EXPECT_EQ(chosen({Compromise::By::ideal, {}, 0}), 1);
  EXPECT_EQ(chosen({Compromise::By::knee, {}, 0}), 1);
  EXPECT_EQ(chosen({Compromise::By::weights, {1.0, 0.1}, 0}), 0);
  EXPECT_EQ(chosen({Compromise::By::weights, {0.1, 1.0}, 0}), 2);
  EXPECT_EQ(chosen({Compromise::By::best, {}, 1}), 2);
  result.front.clear();
  EXPECT_FALSE(compromise_of(result));
}

TEST(JointFront, HasWhatNeitherSearchDominates) {
  OptimizationResult result{test::two_objectives({}), {}, three_designs(), {}, {}};
  EXPECT_EQ(joint_front(result), (std::vector<std::size_t>{0, 1, 2}));
  // The second design beats one of the search, the third is one of them, the fourth is on no front.
  result.check =
      Search{Algorithm::moead, {with({99.0, 99.0}), with({11.0, 5.7}), with({20.0, 5.0}), with({1.0, 1.0})}, {1, 2}};
  EXPECT_EQ(joint_front(result), (std::vector<std::size_t>{0, 5, 2}));
  EXPECT_EQ(result.design(5).responses, (std::vector{11.0, 5.7}));
  EXPECT_EQ(result.search_of(5).algorithm, Algorithm::moead);
}

TEST(CompareFronts, MeasuresBothInOneBox) {
  const Optimization optimization = test::two_objectives({});
  Search half = three_designs();
  half.front = {0, 2};
  const FrontComparison c = compare_fronts(optimization, with({15.0, 6.0}), three_designs(), half);
  // Boxes up to 1.1: ends of 0.1 x 1.1 each less their overlap, larger with the middle.
  const double ends = 2 * 0.11 - 0.01, middle = 0.8 * 0.65;
  EXPECT_NEAR(c.check_hypervolume, ends / 1.21, 1e-12);
  EXPECT_NEAR(c.hypervolume, (ends + middle) / 1.21, 1e-12);
  EXPECT_THAT(c.best, ElementsAre(10.0, 5.0));
  EXPECT_THAT(c.check_best, ElementsAre(10.0, 5.0));
  // The file's own design beyond the fronts widens the box to twice the extent in each objective.
  const FrontComparison wide = compare_fronts(optimization, with({30.0, 9.0}), three_designs(), half);
  EXPECT_NEAR(wide.hypervolume - wide.check_hypervolume, middle / 4.0 / 1.21, 1e-12);
}

}  // namespace
}  // namespace prs
