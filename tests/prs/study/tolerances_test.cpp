#include <gtest/gtest.h>

#include <cmath>

#include "prs/study/designs.h"
#include "prs/study/study_result.h"

namespace prs {
namespace {

Factor length(std::string path, double base, double deviation) {
  Factor f;
  f.label = f.path = std::move(path);
  f.unit = "um";
  f.base = Level{"", base};
  f.distribution = {Distribution::Kind::normal, base, deviation};
  return f;
}

/// A number, a list of three that is one factor, and one that is kept.
Study tolerances(Plan plan, std::size_t samples) {
  Study study;
  study.plan = plan;
  study.samples = samples;
  study.factors = {length("a", 1.0, 2.0), length("list[0]", 0.0, 1.0), length("list[1]", 0.0, 1.0),
                   length("list[2]", 0.0, 1.0), length("kept", 0.0, 1.0)};
  study.factors[2].with_previous = study.factors[3].with_previous = true;
  study.factors[4].kept = true;
  study.responses = {"response"};
  return study;
}

TEST(Tolerances, HalveTheDeviationOfOneFactorAndLeaveTheOthers) {
  const Study study = tolerances(Plan::tolerances, 4);
  ASSERT_EQ(design_count(study), 1u + 4u * 3u);
  for (std::size_t sample = 0; sample < 4; ++sample) {
    const std::vector<Draw> drawn = draws(study, 1 + 3 * sample);
    for (std::size_t halved = 1; halved < 3; ++halved) {
      const std::vector<Draw> half = draws(study, 1 + 3 * sample + halved);
      for (std::size_t i = 0; i < drawn.size(); ++i) {
        const bool is_halved = halved == 1 ? i == 0 : i > 0 && i < 4;
        const double base = *study.factors[i].base->number;
        EXPECT_DOUBLE_EQ(half[i].number - base, (is_halved ? 0.5 : 1.0) * (drawn[i].number - base));
      }
    }
  }
}

/// Answers of a + 2 (list[0] + list[1] + list[2]).
StudySummary answered(const Study& study) {
  StudyAnalysis analysis(study);
  RowBlock block{0, design_count(study), {}, {}};
  for (std::size_t k = 0; k < block.rows; ++k) {
    std::vector<double> x;
    for (const Draw& d : draws(study, k)) x.push_back(d.number);
    block.responses.push_back(x[0] + 2.0 * (x[1] + x[2] + x[3]));
  }
  analysis.add(block);
  return analysis.summary();
}

TEST(Tolerances, GainWhatTheVariancesSay) {
  const std::vector<ToleranceGain> gains = answered(tolerances(Plan::tolerances, 40'000)).tolerances.at(0);
  ASSERT_EQ(gains.size(), 2u);
  EXPECT_EQ(gains[0].factor, 1u);  // A variance of 12 beside one of 4, about 1.
  const double all = 1.0 + 1.6448536 * 4.0;
  EXPECT_NEAR(gains[0].quantile, all, 0.1);
  EXPECT_NEAR(gains[0].gain(), 1.0 - (1.0 + 1.6448536 * std::sqrt(7.0)) / all, 0.01);
  EXPECT_NEAR(gains[1].gain(), 1.0 - (1.0 + 1.6448536 * std::sqrt(13.0)) / all, 0.01);
}

TEST(Tolerances, AListTogetherIsOneFactorOfTheVariance) {
  const Study study = tolerances(Plan::sobol_indices, 4'096);
  ASSERT_EQ(design_count(study), 1u + 4'096u * 5u);
  const ResponseIndices indices = answered(study).indices.at(0);
  ASSERT_EQ(indices.factors.size(), 3u);
  for (const FactorIndices& f : indices.factors)
    EXPECT_NEAR(f.first.value, f.factor == 0 ? 0.25 : f.factor == 1 ? 0.75 : 0.0, 0.03);
  EXPECT_EQ(path_of_block(study, 1), "list");
  EXPECT_EQ(path_of_block(study, 0), "a");
}

}  // namespace
}  // namespace prs
