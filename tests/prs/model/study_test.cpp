#include "prs/study/designs.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "prs/input/units.h"

namespace prs {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

Study two_factors() {
  Study study;
  Factor rollers;
  rollers.path = "mechanism.rollers";
  rollers.levels = {{"8", 8.0}, {"9", 9.0}, {"10", 10.0}};
  rollers.base = Level{"9", 9.0};
  Factor force;
  force.path = "load_cases[0].axial_force";
  force.unit = "kN";
  force.levels = {{"5 kN", 5.0}, {"35 kN", 35.0}};
  force.base = Level{"35000 N", 35.0};
  study.factors = {rollers, force};
  return study;
}

TEST(Study, BaseCaseComesFirst) {
  const Study study = two_factors();
  EXPECT_TRUE(design(study, 0).settings.empty());
  EXPECT_TRUE(is_base(study, design(study, 0)));
  EXPECT_TRUE(overrides(study, design(study, 0)).empty());
}

TEST(Study, EachDesignVariesOneFactorAndAllLevelsAppearOnce) {
  const Study study = two_factors();
  ASSERT_EQ(design_count(study), 6U);
  std::multiset<std::string> seen;
  for (std::size_t k = 1; k < design_count(study); ++k) {
    ASSERT_EQ(design(study, k).settings.size(), 1U);
    seen.insert(overrides(study, design(study, k)).at(0));
  }
  EXPECT_THAT(seen, ElementsAre("load_cases[0].axial_force=35 kN", "load_cases[0].axial_force=5 kN",
                                "mechanism.rollers=10", "mechanism.rollers=8", "mechanism.rollers=9"));
}

TEST(Study, CompanionsGoWithTheLevelOfTheirFactor) {
  Study study = two_factors();
  Factor lead;
  lead.path = "mechanism.lead";
  lead.unit = "mm";
  lead.levels = {{"4 mm", 4.0}, {"5 mm", 5.0}, {"6 mm", 6.0}};
  lead.base = Level{"5 mm", 5.0};
  study.factors[0].companions = {lead};
  study.plan = Plan::grid;
  ASSERT_EQ(design_count(study), 7U);
  EXPECT_THAT(overrides(study, draws(study, 5)),
              ElementsAre("mechanism.rollers=10", "mechanism.lead=6 mm", "load_cases[0].axial_force=5 kN"));
  EXPECT_TRUE(is_base(study, design(study, 4)));
  study.factors[0].companions[0].base = Level{"4 mm", 4.0};
  EXPECT_FALSE(is_base(study, design(study, 4)));
  const std::vector<DrawnInput> inputs = drawn_inputs(study);
  ASSERT_EQ(inputs.size(), 3U);
  EXPECT_EQ(inputs[1].input->path, "mechanism.lead");
  EXPECT_EQ(inputs[1].factor, 0U);
  EXPECT_EQ(inputs[2].factor, 1U);
}

TEST(Study, GridHasEveryCombinationTheLastFactorFastest) {
  Study study = two_factors();
  study.plan = Plan::grid;
  ASSERT_EQ(design_count(study), 7U);
  std::vector<std::string> all;
  for (std::size_t k = 1; k < 7; ++k)
    all.push_back(fmt::format("{}", fmt::join(overrides(study, design(study, k)), " ")));
  EXPECT_THAT(all, ElementsAre("mechanism.rollers=8 load_cases[0].axial_force=5 kN",
                               "mechanism.rollers=8 load_cases[0].axial_force=35 kN",
                               "mechanism.rollers=9 load_cases[0].axial_force=5 kN",
                               "mechanism.rollers=9 load_cases[0].axial_force=35 kN",
                               "mechanism.rollers=10 load_cases[0].axial_force=5 kN",
                               "mechanism.rollers=10 load_cases[0].axial_force=35 kN"));
}

TEST(Study, DerivativesNeedTheBaseCaseOnly) {
  Study study = two_factors();
  study.plan = Plan::derivatives;
  EXPECT_EQ(design_count(study), 1U);
}

/// Each kind of distribution once.
Study sampled_distributions(Plan plan, std::size_t samples) {
  using enum Distribution::Kind;
  Study study = two_factors();
  study.plan = plan;
  study.samples = samples;
  study.seed = 42;
  const auto add = [&](const char* path, const char* unit, Distribution distribution) {
    Factor factor;
    factor.path = path;
    factor.unit = unit;
    factor.distribution = distribution;
    study.factors.push_back(factor);
  };
  add("mechanism.lead", "mm", {uniform, 4.0, 6.0});
  add("lubricant.viscosity", "mPa s", {log_uniform, 10.0, 1000.0});
  add("deviations.crowning", "um", {normal, 5.0, 2.0});
  add("friction.coulomb", "", {uniform, -0.25, 0.25});
  return study;
}

constexpr Plan kSampled[] = {Plan::latin_hypercube, Plan::sobol, Plan::monte_carlo, Plan::sobol_indices};

std::vector<double> column(const Study& study, std::size_t factor) {
  std::vector<double> values;
  for (std::size_t k = 1; k < design_count(study); ++k) values.push_back(draws(study, k)[factor].number);
  std::ranges::sort(values);
  return values;
}

TEST(Study, SampledPlansHaveTheirSamplesAndTheBaseCase) {
  EXPECT_EQ(design_count(sampled_distributions(Plan::latin_hypercube, 100)), 101U);
  EXPECT_EQ(design_count(sampled_distributions(Plan::sobol, 100)), 101U);
  EXPECT_EQ(design_count(sampled_distributions(Plan::monte_carlo, 100)), 101U);
  EXPECT_EQ(design_count(sampled_distributions(Plan::sobol_indices, 100)),
            801U);  // Two more than factors.
  for (const Plan plan : kSampled) {
    EXPECT_TRUE(is_sampled(plan));
    EXPECT_TRUE(design(sampled_distributions(plan, 100), 0).settings.empty());
  }
}

TEST(Study, DrawIsAPureFunctionOfSeedAndIndex) {
  for (const Plan plan : kSampled) {
    Study study = sampled_distributions(plan, 50);
    std::vector<std::vector<std::string>> forwards;
    for (std::size_t k = 0; k < 50; ++k) forwards.push_back(overrides(study, design(study, k)));
    for (std::size_t k = 50; k-- > 0;) EXPECT_EQ(overrides(study, design(study, k)), forwards[k]);
    study.seed = 43;
    for (std::size_t k = 1; k < 50; ++k) EXPECT_NE(overrides(study, design(study, k)), forwards[k]);
  }
}

// Formulas of designs.h in exact integers of another language.
TEST(Study, SameSeedDrawsTheSameOnEveryPlatform) {
  const auto first = [](Plan plan) {
    const Study study = sampled_distributions(plan, 8);
    return overrides(study, design(study, 1))[2];
  };
  EXPECT_EQ(first(Plan::latin_hypercube), "mechanism.lead=5.70727626021835 mm");
  EXPECT_EQ(first(Plan::sobol), "mechanism.lead=4.985978371589385 mm");
  EXPECT_EQ(first(Plan::monte_carlo), "mechanism.lead=4.095781670013567 mm");
}

TEST(Study, TextReadsBackAsTheSameNumber) {
  for (const Plan plan : kSampled) {
    const Study study = sampled_distributions(plan, 200);
    for (std::size_t k = 1; k < design_count(study); ++k) {
      const std::vector<Draw> drawn = draws(study, k);
      const Design with_texts = design(study, k);
      ASSERT_EQ(with_texts.settings.size(), drawn.size());
      for (std::size_t i = 2; i < drawn.size(); ++i) {
        const auto split = input::split_unit(with_texts.settings[i].level.text);
        ASSERT_TRUE(split);
        EXPECT_EQ(split->number, drawn[i].number);
        EXPECT_EQ(split->unit, study.factors[i].unit);
        EXPECT_EQ(with_texts.settings[i].level.number, drawn[i].number);
      }
    }
  }
}

TEST(Study, LatinHypercubeHasOneSampleInEachStratumOfEachDistribution) {
  constexpr std::size_t kSamples = 1000;
  const Study study = sampled_distributions(Plan::latin_hypercube, kSamples);
  const std::vector<double> lead = column(study, 2), viscosity = column(study, 3), crowning = column(study, 4);
  for (std::size_t k = 0; k < kSamples; ++k) {
    const auto stratum = static_cast<int>(k);
    EXPECT_EQ(static_cast<int>((lead[k] - 4.0) * 500.0), stratum);
    EXPECT_EQ(static_cast<int>(std::log10(viscosity[k] / 10.0) * 500.0), stratum);
    EXPECT_EQ(static_cast<int>(500.0 * std::erfc((5.0 - crowning[k]) / std::sqrt(8.0))), stratum);
  }
}

TEST(Study, LevelsAreAsLikely) {
  const Study study = sampled_distributions(Plan::latin_hypercube, 600);
  std::map<std::size_t, int> rollers, force;
  for (std::size_t k = 1; k <= 600; ++k) {
    ++rollers[draws(study, k)[0].level];
    ++force[draws(study, k)[1].level];
  }
  EXPECT_THAT(rollers, ElementsAre(Pair(0, 200), Pair(1, 200), Pair(2, 200)));
  EXPECT_THAT(force, ElementsAre(Pair(0, 300), Pair(1, 300)));
}

// Saltelli et al. 2010: A, B, and A with one column of B.
TEST(Study, IndicesOfVarianceMixTheColumnsOfTwoMatrices) {
  const Study study = sampled_distributions(Plan::sobol_indices, 16);
  const std::size_t factors = study.factors.size();
  const auto value = [](const Draw& d) { return std::pair(d.level, d.number); };
  for (std::size_t sample = 0; sample < 16; ++sample) {
    const std::size_t first = 1 + sample * (factors + 2);
    const std::vector<Draw> a = draws(study, first), b = draws(study, first + 1);
    for (std::size_t i = 2; i < factors; ++i) EXPECT_NE(a[i].number, b[i].number);
    for (std::size_t mixed = 0; mixed < factors; ++mixed) {
      const std::vector<Draw> ab = draws(study, first + 2 + mixed);
      for (std::size_t i = 0; i < factors; ++i) EXPECT_EQ(value(ab[i]), value(i == mixed ? b[i] : a[i]));
    }
  }
}

TEST(Study, LevelEqualToTheFileIsTheBaseCase) {
  const Study study = two_factors();
  std::vector<bool> base;
  for (std::size_t k = 1; k < design_count(study); ++k) base.push_back(is_base(study, design(study, k)));
  EXPECT_THAT(base, ElementsAre(false, true, false, false, true));
}

}  // namespace
}  // namespace prs
