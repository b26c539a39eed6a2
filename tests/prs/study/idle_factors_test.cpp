#include "prs/study/designs.h"
#include "prs/study/sensitivity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

namespace prs {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A study whose factors have these numbers of levels, or are drawn between 1 and 3 where it is 0.
Study factor_study(Plan plan, const std::vector<std::size_t>& levels, std::size_t samples = 0) {
  Study study;
  study.plan = plan;
  study.samples = samples;
  study.responses = {"y", "z"};
  for (const std::size_t count : levels) {
    Factor factor;
    factor.path = factor.label = "f" + std::to_string(study.factors.size());
    factor.base = Level{"0", 0.0};
    for (std::size_t k = 0; k < count; ++k)
      factor.levels.push_back({std::to_string(k + 1), static_cast<double>(k + 1)});
    if (count == 0) factor.distribution = {Distribution::Kind::uniform, 1.0, 3.0};
    study.factors.push_back(factor);
  }
  return study;
}

std::vector<double> values_of(const std::vector<Draw>& draws) {
  std::vector<double> values;
  for (const Draw& draw : draws)
    values.push_back(draw.kind == Draw::Kind::level    ? static_cast<double>(draw.level + 1)
                     : draw.kind == Draw::Kind::number ? draw.number
                                                       : 0.0);
  return values;
}

/// Both responses of a design from the values of its factors.
using Respond = std::function<std::vector<double>(const std::vector<double>& x)>;

std::vector<std::size_t> idle_of(const Study& study, const Respond& respond) {
  FollowedFactors followed(study);
  for (std::size_t k = 0; k < design_count(study); ++k) followed.add(respond(values_of(draws(study, k))), k);
  return followed.idle();
}

const Respond kFirstAndLast = [](const std::vector<double>& x) { return std::vector{x.front() * x.back(), 7.0}; };

TEST(IdleFactors, OfListedPlansAreThoseThatNoResponseFollows) {
  // With one at a time from 0, a product of two factors does not change.
  const Respond sum = [](const std::vector<double>& x) { return std::vector{x[0] - x[2], 7.0}; };
  EXPECT_THAT(idle_of(factor_study(Plan::one_at_a_time, {2, 3, 4}), sum), ElementsAre(1));
  EXPECT_THAT(idle_of(factor_study(Plan::one_at_a_time, {2, 3, 4}), kFirstAndLast), ElementsAre(0, 1, 2));
  EXPECT_THAT(idle_of(factor_study(Plan::grid, {2, 3, 4}), kFirstAndLast), ElementsAre(1));
  EXPECT_THAT(idle_of(factor_study(Plan::sobol_indices, {0, 0, 0}, 8), kFirstAndLast), ElementsAre(1));
}

TEST(IdleFactors, OneDesignOfAGridIsEnoughToFollow) {
  const Study study = factor_study(Plan::grid, {5, 6, 7});
  for (const std::size_t odd : {std::size_t{1}, std::size_t{100}, design_count(study) - 1}) {
    FollowedFactors followed(study);
    for (std::size_t k = 0; k < design_count(study); ++k)
      followed.add(std::vector{1.0, k == odd ? 1.0 + 1e-16 * 4 : 1.0}, k);
    EXPECT_THAT(followed.idle(), IsEmpty()) << odd;
  }
  EXPECT_THAT(idle_of(study, [](const auto&) { return std::vector{1.0, kNoResponse}; }), ElementsAre(0, 1, 2));
}

TEST(IdleFactors, AFactorThatDoesNotVaryIsNone) {
  Study study = factor_study(Plan::one_at_a_time, {1, 2});
  study.factors[0].base = study.factors[0].levels[0];
  EXPECT_THAT(idle_of(study, [](const auto&) { return std::vector{1.0, 2.0}; }), ElementsAre(1));
  study.plan = Plan::grid;
  EXPECT_THAT(idle_of(study, [](const auto&) { return std::vector{1.0, 2.0}; }), ElementsAre(1));
}

TEST(IdleFactors, DesignsWithoutNumbersTellNothingAndOneOfThemFollows) {
  const Study study = factor_study(Plan::one_at_a_time, {3, 2});
  const std::vector<double> none(2, kNoResponse);
  EXPECT_THAT(idle_of(study, [&](const auto&) { return none; }), IsEmpty());
  const Respond fails = [&](const std::vector<double>& x) { return x[0] == 3.0 ? none : std::vector{1.0, 1.0}; };
  EXPECT_THAT(idle_of(study, fails), ElementsAre(1));
}

std::vector<std::size_t> idle_drawn(const Study& study, const Respond& respond, std::size_t* designs = nullptr) {
  return idle_drawn_factors(study, nullptr, [&](const std::vector<std::vector<Draw>>& drawn) {
    RowBlock block{0, drawn.size(), {}, {}};
    for (const std::vector<Draw>& draw : drawn)
      for (const double y : respond(values_of(draw))) block.responses.push_back(y);
    if (designs) *designs = drawn.size();
    return block;
  });
}

TEST(IdleFactors, OfDrawnPlansAreFoundByPairsOfDesigns) {
  for (const Plan plan : {Plan::latin_hypercube, Plan::sobol, Plan::monte_carlo}) {
    const Study study = factor_study(plan, {0, 2, 0, 1}, 50);
    std::size_t designs = 0;
    // With all others as in the file, at 0, the product would not change.
    const Respond product = [](const std::vector<double>& x) { return std::vector{x[0] * x[2], 1.0}; };
    EXPECT_THAT(idle_drawn(study, product, &designs), ElementsAre(1));
    EXPECT_EQ(designs, 12u);                          // Four designs for each factor that varies.
    EXPECT_THAT(idle_of(study, product), IsEmpty());  // The plan's own designs do not show it.
  }
}

}  // namespace
}  // namespace prs
