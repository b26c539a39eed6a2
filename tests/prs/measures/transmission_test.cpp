#include "prs/measures/measures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include "prs/measures/measures_analysis.h"
#include "prs/slip/slip.h"
#include "prs/slip/slip_at_speed.h"
#include "tests/support/slips.h"

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
  EXPECT_NEAR(*back_driving_efficiency(lead, diameter, friction), std::tan(slope - angle) / std::tan(slope),
              2.0 * friction * std::tan(slope));
}

TEST(Efficiency, BackDrivingIsTwoLessTheReciprocal) {
  const double eta = efficiency(-5e-3, 21e-3, 0.01);
  EXPECT_NEAR(*back_driving_efficiency(-5e-3, 21e-3, 0.01), 2.0 - 1.0 / eta, 1e-15);
}

double friction_of(double efficiency, double lead, double diameter) {
  return (1.0 / efficiency - 1.0) * lead / (pi * diameter);
}

/// A maker's standard screws (series SRS-C, 24 sizes): the pairs of efficiencies in its catalogue.
TEST(Efficiency, BackDrivingEstimateMissesAMakersValuesByUpToSevenHundredths) {
  double lowest = 0.0, highest = 0.0;
  for (const auto& [forward, backward] :
       {std::pair{0.89, 0.87}, {0.83, 0.82}, {0.80, 0.79}, {0.79, 0.79}, {0.77, 0.77}}) {
    const double lead = 10e-3, diameter = 30e-3;
    const double miss = *back_driving_efficiency(lead, diameter, friction_of(forward, lead, diameter)) - backward;
    lowest = std::min(lowest, miss);
    highest = std::max(highest, miss);
  }
  EXPECT_NEAR(lowest, -0.07, 0.005);
  EXPECT_NEAR(highest, 0.01, 0.005);
}

TEST(Efficiency, BackDrivingEstimateLiesBelowThatOfContacts) {
  Case c = test::sandu_reference();
  const double lead = c.mechanism.lead, diameter = *c.mechanism.pitch_diameter.screw;
  const double forward = *analyze_slip(c).load_cases[0].slip->efficiency;
  const double backward = *analyze_slip(test::turned_back(c)).load_cases[0].slip->efficiency;
  const MeasuresResult measures = analyze_measures(c);
  EXPECT_DOUBLE_EQ(*measures.load_measures[0]->back_driving_efficiency, backward);
  Case heated = c;
  heated.lubricant->viscosity.reset();  // it would follow from the parts' temperatures
  const Result& loaded = measures.analysis;
  EXPECT_FALSE(back_driving_efficiency(heated, loaded.contacts, loaded.load_cases[0]));
  c.friction.reset();
  EXPECT_FALSE(analyze_measures(c).load_measures[0]->back_driving_efficiency);
  const double miss = *back_driving_efficiency(lead, diameter, friction_of(forward, lead, diameter)) - backward;
  EXPECT_LT(miss, -0.03);
  EXPECT_GT(miss, -0.07);
}

/// The note is beside the number, in tables and in `--explain`.
TEST(Efficiency, BackDrivingSaysHowFarItIsOff) {
  const Quantity<Measures>& q = quantity<Measures>("back_driving_efficiency");
  EXPECT_NE(q.title.find("0.07"), std::string_view::npos);
  EXPECT_NE(q.validity.find("0.07"), std::string_view::npos);
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
  EXPECT_NEAR(roller_inertia(9, 0.02, 3e-7, 14e-3, {1.0, 1.0}), 9 * (3e-7 + 0.02 * 14e-3 * 14e-3), 1e-18);
}

TEST(Inertia, OfTravelHasTheKineticEnergyOfTheMass) {
  const double speed = 40.0, lead = 5e-3, mass = 2.0;
  const double velocity = speed * lead / (2.0 * pi);
  EXPECT_NEAR(travel_inertia(mass, lead) * speed * speed, mass * velocity * velocity, 1e-16);
}

}  // namespace
}  // namespace prs
