#include "prs/measures/stiffness.h"

#include <gtest/gtest.h>

#include <cmath>

namespace prs {
namespace {

using System = MeasureOptions::System;

SystemStiffness stiffness(const System& system) {
  return system_stiffness(700e6, system, {25e-3, 0.0}, {210e9, 0.3, {}}, 5e-3);
}

System shaft(std::optional<double> from_bearing = {}) {
  System system;
  system.shaft = {0.3, from_bearing ? System::Axial::both_ends : System::Axial::one_end, from_bearing, {}};
  return system;
}

TEST(SystemStiffness, SharesOfTheComplianceSumToOne) {
  System system = shaft(0.15);
  system.support_bearing = 600e6;
  system.housing = 1500e6;
  const SystemStiffness s = stiffness(system);
  const auto& [mechanism, stretch, wind_up, bearing, housing] = s.contributions;
  double shares = 0.0, compliance = 0.0;
  for (const auto& part : {mechanism, stretch, wind_up, bearing, housing})
    shares += part->share, compliance += 1.0 / part->stiffness;
  EXPECT_NEAR(shares, 1.0, 1e-14);
  EXPECT_NEAR(s.total * compliance, 1.0, 1e-14);
}

TEST(SystemStiffness, WindUpOfAFullShaftIsAShareOfItsStretch) {
  const SystemStiffness::Contributions c = stiffness(shaft()).contributions;
  const double ratio = 16.0 * 1.3 * std::pow(5e-3 / (2.0 * std::acos(-1.0) * 25e-3), 2);
  EXPECT_NEAR(c.shaft->stiffness / c.wind_up->stiffness, ratio, 1e-14);
}

TEST(SystemStiffness, MiddleOfTwoBearingsIsFourTimesAsStiff) {
  const auto stretch = [](const System& system) { return stiffness(system).contributions.shaft->stiffness; };
  EXPECT_NEAR(stretch(shaft(0.15)) / stretch(shaft()), 4.0, 1e-14);
}

TEST(SystemStiffness, PartsThatAreLeftOutAreRigid) {
  const SystemStiffness s = stiffness({});
  EXPECT_EQ(s.total, 700e6);
  EXPECT_FALSE(s.contributions.shaft || s.contributions.wind_up || s.contributions.support_bearing ||
               s.contributions.housing);
}

}  // namespace
}  // namespace prs
