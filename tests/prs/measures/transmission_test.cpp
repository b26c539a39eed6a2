#include "prs/measures/transmission.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace prs {
namespace {

using Type = Mechanism::Type;
using std::numbers::pi;

struct Radii {
  double screw, roller, nut;
  double centre_distance() const { return screw + roller; }
};

/// Matched radii and their gear ratio: standard r_R/r_N, inverted r_R/r_S.
struct Matched {
  Type type;
  Radii radii;
  double gear_ratio;
};
const Matched kMatched[] = {{Type::standard, {15.0, 5.0, 25.0}, 5.0 / 25.0},
                            {Type::standard, {9.0, 4.5, 18.0}, 4.5 / 18.0},
                            {Type::inverted, {10.5, 3.5, 17.5}, 3.5 / 10.5},
                            {Type::inverted, {20.0, 4.0, 28.0}, 4.0 / 20.0}};

TEST(PlanetaryRatios, RollersRollOnScrewAndNut) {
  for (const auto& [type, r, gear_ratio] : kMatched) {
    const PlanetaryRatios ratios = planetary_ratios(type, gear_ratio);
    const double axis = ratios.carrier * r.centre_distance();
    EXPECT_NEAR(axis + ratios.roller * r.roller, 0.0, 1e-14);
    EXPECT_NEAR(axis - ratios.roller * r.roller, r.screw, 1e-13);
    EXPECT_NEAR(ratios.roller, -r.screw / (2.0 * r.roller), 1e-14);
    EXPECT_NEAR(ratios.carrier, r.screw / (2.0 * r.centre_distance()), 1e-15);
  }
}

TEST(PlanetaryRatios, OfAnInvertedMechanismAreSeenFromItsScrew) {
  for (const auto& [type, r, gear_ratio] : kMatched) {
    const PlanetaryRatios nut_at_rest = planetary_ratios(type, gear_ratio);
    const PlanetaryRatios ratios = ratios_to_frame(type, nut_at_rest);
    if (type == Type::standard) {
      EXPECT_EQ(ratios.roller, nut_at_rest.roller);
      EXPECT_EQ(ratios.carrier, nut_at_rest.carrier);
      continue;
    }
    const double axis = ratios.carrier * r.centre_distance();
    EXPECT_NEAR(axis - ratios.roller * r.roller, 0.0, 1e-13);
    EXPECT_NEAR(axis + ratios.roller * r.roller, r.nut, 1e-13);
  }
}

TEST(Efficiency, IsThatOfAThreadWithSmallFriction) {
  const double lead = 5e-3, diameter = 21e-3, friction = 1e-4;
  const double slope = std::atan(lead / (pi * diameter)), angle = std::atan(friction);
  EXPECT_NEAR(efficiency(lead, diameter, friction), std::tan(slope) / std::tan(slope + angle),
              friction * std::tan(slope));
  EXPECT_NEAR(*back_driving_efficiency(lead, diameter, friction),
              std::tan(slope - angle) / std::tan(slope), 2.0 * friction * std::tan(slope));
}

TEST(Efficiency, BackDrivingIsTwoLessTheReciprocal) {
  const double eta = efficiency(-5e-3, 21e-3, 0.01);
  EXPECT_NEAR(*back_driving_efficiency(-5e-3, 21e-3, 0.01), 2.0 - 1.0 / eta, 1e-15);
}

TEST(Efficiency, IsHalfWhereTheScrewStartsToLock) {
  const double lead = 5e-3, diameter = 21e-3, limit = lead / (pi * diameter);
  EXPECT_NEAR(efficiency(lead, diameter, limit), 0.5, 1e-15);
  EXPECT_FALSE(back_driving_efficiency(lead, diameter, 1.0000001 * limit));
  EXPECT_TRUE(back_driving_efficiency(lead, diameter, 0.9999999 * limit));
}

TEST(DriveTorque, DoesTheWorkOfTheLoadAndItsLosses) {
  const double eta = 0.8, force = 12e3, lead = -5e-3;
  EXPECT_NEAR(drive_torque(force, lead, eta) * 2.0 * pi * eta, force * 5e-3, 1e-10);
  EXPECT_NEAR(velocity_ratio(lead) * 2.0 * pi, 5e-3, 1e-17);
}

TEST(Inertia, OfRollersThatTurnWithTheirCarrierIsSteiners) {
  EXPECT_NEAR(roller_inertia(9, 0.02, 3e-7, 14e-3, {1.0, 1.0}), 9 * (3e-7 + 0.02 * 14e-3 * 14e-3),
              1e-18);
}

TEST(Inertia, OfTravelHasTheKineticEnergyOfTheMass) {
  const double speed = 40.0, lead = 5e-3, mass = 2.0;
  const double velocity = speed * lead / (2.0 * pi);
  EXPECT_NEAR(travel_inertia(mass, lead) * speed * speed, mass * velocity * velocity, 1e-16);
}

}  // namespace
}  // namespace prs
