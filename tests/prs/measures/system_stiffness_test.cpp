#include "prs/measures/system_stiffness.h"

#include <gtest/gtest.h>

#include <cmath>

namespace prs {
namespace {

const ShaftSection kShaft{{210e9, 0.3, {}}, 25e-3, 0.0, 5e-3};

TEST(SystemStiffness, SharesOfTheComplianceSumToOne) {
  const SystemStiffness s =
      system_stiffness(700e6, {AxisParts::Shaft{0.3, 0.15, {}}, 600e6, 1500e6}, kShaft);
  ASSERT_EQ(s.contributions.size(), 5u);
  double shares = 0.0, compliance = 0.0;
  for (const auto& c : s.contributions) shares += c.share, compliance += 1.0 / c.stiffness;
  EXPECT_NEAR(shares, 1.0, 1e-14);
  EXPECT_NEAR(s.total * compliance, 1.0, 1e-14);
}

TEST(SystemStiffness, WindUpOfAFullShaftIsAShareOfItsStretch) {
  const SystemStiffness s = system_stiffness(700e6, {AxisParts::Shaft{0.3, {}, {}}, {}, {}}, kShaft);
  const double stretch = s.contributions[1].stiffness, wind_up = s.contributions[2].stiffness;
  const double ratio = 16.0 * 1.3 * std::pow(5e-3 / (2.0 * std::acos(-1.0) * 25e-3), 2);
  EXPECT_NEAR(stretch / wind_up, ratio, 1e-14);
}

TEST(SystemStiffness, MiddleOfTwoBearingsIsFourTimesAsStiff) {
  const auto shaft = [](std::optional<double> x) {
    return system_stiffness(700e6, {AxisParts::Shaft{0.3, x, {}}, {}, {}}, kShaft)
        .contributions[1]
        .stiffness;
  };
  EXPECT_NEAR(shaft(0.15) / shaft({}), 4.0, 1e-14);
}

TEST(SystemStiffness, PartsThatAreLeftOutAreRigid) {
  const SystemStiffness s = system_stiffness(700e6, {}, kShaft);
  EXPECT_EQ(s.total, 700e6);
  EXPECT_EQ(s.contributions.size(), 1u);
}

}  // namespace
}  // namespace prs
