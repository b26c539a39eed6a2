#include "prs/model/groove.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prs {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

TEST(DefaultGroove, HasAMakersCrestAndARootWithAFlat) {
  const Groove g = default_groove(false, 2e-3, 10e-3, 45.0 * kDegree, 45.0 * kDegree);
  EXPECT_DOUBLE_EQ(g.addendum, 0.30e-3);
  EXPECT_DOUBLE_EQ(g.dedendum, 0.46e-3);
  EXPECT_NEAR(g.position(FlankSide::forward, -g.dedendum), 0.96e-3, 1e-12);  // of 1 mm
}

TEST(DefaultGroove, IsLowerThanWhereTheFlanksMeet) {
  for (double angle = 20.0; angle <= 75.0; angle += 5.0) {
    const double pitch = 2e-3, psi = angle * kDegree;
    const Groove g = default_groove(false, pitch, 10e-3, 20.0 * kDegree, psi);
    EXPECT_LT(g.position(FlankSide::forward, -g.dedendum), 0.5 * pitch);
    EXPECT_GT(g.position(FlankSide::forward, g.addendum), 0.0);
    EXPECT_LE(g.dedendum, default_root_depth(pitch, psi));
  }
}

TEST(DefaultRootDepth, IsAQuarterOfAPitchOrWhereTheFlanksMeet) {
  EXPECT_DOUBLE_EQ(default_root_depth(2e-3, 30.0 * kDegree), 0.5e-3);
  EXPECT_NEAR(default_root_depth(2e-3, 45.0 * kDegree), 0.5e-3, 1e-18);
  EXPECT_DOUBLE_EQ(default_root_depth(2e-3, 60.0 * kDegree), 0.5e-3 / std::sqrt(3.0));
}

}  // namespace
}  // namespace prs
