#include "prs/study/study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace prs {
namespace {

using ::testing::ElementsAre;

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
  EXPECT_THAT(seen,
              ElementsAre("load_cases[0].axial_force=35 kN", "load_cases[0].axial_force=5 kN",
                          "mechanism.rollers=10", "mechanism.rollers=8", "mechanism.rollers=9"));
}

TEST(Study, LevelEqualToTheFileIsTheBaseCase) {
  const Study study = two_factors();
  std::vector<bool> base;
  for (std::size_t k = 1; k < design_count(study); ++k)
    base.push_back(is_base(study, design(study, k)));
  EXPECT_THAT(base, ElementsAre(false, true, false, false, true));
}

}  // namespace
}  // namespace prs
