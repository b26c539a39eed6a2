#include "prs/threads/kinematics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "prs/slip/slip_model.h"
#include "prs/threads/contacts.h"
#include "tests/support/count.h"
#include "tests/support/slips.h"

namespace prs {
namespace {

KinematicGeometry geometry_of(const Case& c) {
  const Contacts contacts = find_contacts(c.mechanism, c.materials);
  KinematicGeometry g;
  g.type = c.mechanism.type;
  g.lead = c.mechanism.lead;
  g.gear_ratio = static_cast<double>(c.mechanism.starts.roller) / c.mechanism.starts.screw;
  g.centre_distance = contacts.threads.centre_distance;
  for (const Interface i : kInterfaces) g.points[i] = contacts.interfaces[i].geometry.point.position;
  return g;
}

/// The screw of a standard mechanism turns and its nut does not; for an inverted one it is the other way round.
TEST(Frame, OnePartTurnsAndTheOtherIsHeld) {
  const double speed = -40.0, nut = 0.0, carrier = 0.3 * speed;  // Speeds against the nut.
  using enum contact::MechanismType;
  EXPECT_EQ(turning_speed(standard, speed), speed);
  EXPECT_EQ(against_frame(true, nut, speed), 0.0);
  EXPECT_EQ(against_frame(true, carrier, speed), carrier);
  EXPECT_EQ(turning_speed(inverted, speed), -speed);
  EXPECT_EQ(against_frame(false, speed, speed), 0.0);
  EXPECT_EQ(against_frame(false, carrier, speed), carrier - speed);
}

TEST(Kinematics, SpeedsObeyGearsAndLead) {
  for (const Case& c : {test::sandu_reference(), test::inverted(test::sandu_reference())}) {
    const KinematicGeometry g = geometry_of(c);
    const double speed = 40.0, slip = 0.37;
    const Kinematics k = kinematics(g, speed, slip);
    EXPECT_DOUBLE_EQ(k.screw_to_carrier - k.nut_to_carrier, speed);  // omega_s/n
    EXPECT_DOUBLE_EQ(-k.nut_to_carrier / speed, slip);               // (2.2)
    const bool standard = g.type == Mechanism::Type::standard;       // (2.1)
    EXPECT_DOUBLE_EQ(standard ? k.nut_to_carrier / k.roller_to_carrier : -k.screw_to_carrier / k.roller_to_carrier,
                     g.gear_ratio);
    EXPECT_DOUBLE_EQ(k.nut_advance - k.screw_advance, -g.lead / (2 * std::numbers::pi) * speed);
  }
}

TEST(Kinematics, RollersDoNotTurnAtPureSliding) {
  for (const Case& c : {test::sandu_reference(), test::inverted(test::sandu_reference())}) {
    const KinematicGeometry g = geometry_of(c);
    EXPECT_EQ(kinematics(g, 40.0, slip_range(g).pure_sliding).roller_to_carrier, 0.0);
  }
}

/// (2.12): valid for every slip ratio, also for different pitches, as the rollers then migrate.
TEST(Kinematics, ContactsNeitherPartNorPenetrate) {
  std::mt19937_64 random(7);
  for (int n = test::count(100, 2000); n > 0; --n) {
    Case c = test::random_slip(random);
    const double pitch = axial_pitch(c.mechanism);
    c.mechanism = find_contacts(c.mechanism, c.materials).mechanism;
    c.mechanism.geometry = Mechanism::Geometry::simulation;
    if (n % 2 == 0) c.mechanism.pitch = {1.0003 * pitch, 0.9998 * pitch, 0.9995 * pitch};
    const Contacts contacts = find_contacts(c.mechanism, c.materials);
    const KinematicGeometry g = kinematic_geometry(contacts, 1.0);
    for (const double slip : {0.1, 0.37, 0.8})
      for (const Interface i : kInterfaces) {
        const ContactMotion m = contact_motion(g, kinematics(g, 1.0, slip), i);
        const double normal = m.sliding.dot(contacts.interfaces[i].geometry.point.normal);
        EXPECT_LT(std::abs(normal), 1e-12 * g.centre_distance);
      }
  }
}

/// Rollers with grooves stay on both threads however they orbit and spin, the travel is the lead, and without slip at
/// the pitch radii the carrier turns with d_S/(2 (d_S + d_R)) of the screw.
TEST(Kinematics, GroovedRollersStayOnBothThreads) {
  for (const double hand : {1.0, -1.0}) {
    Case c = test::recirculating();
    c.mechanism.lead *= hand;
    const Contacts contacts = find_contacts(c.mechanism, c.materials);
    const KinematicGeometry g = kinematic_geometry(contacts, 1.0);
    for (const double slip : {0.1, 0.25, 0.8})
      for (const double spin : {-0.3, 0.0, 0.4}) {
        const Kinematics k = kinematics(g, 1.0, slip, spin);
        for (const Interface i : kInterfaces)
          EXPECT_LT(std::abs(contact_motion(g, k, i).sliding.dot(contacts.interfaces[i].geometry.point.normal)),
                    1e-12 * g.centre_distance);
        EXPECT_EQ(travel_per_turn(g, slip), c.mechanism.lead);
        EXPECT_NEAR(k.roller_advance - k.nut_advance, c.mechanism.lead * slip / (2 * std::numbers::pi), 1e-15);
      }
    const double screw = *c.mechanism.pitch_diameter.screw, roller = *c.mechanism.pitch_diameter.roller;
    EXPECT_NEAR(ideal_slip_ratio(g), 0.5 * screw / (screw + roller), 1e-15);
    EXPECT_FALSE(slip_estimates(g).jones);
  }
}

/// (2.16), (2.17) as printed.
TEST(Kinematics, IdealSlipRatioIsThatOfThePaper) {
  std::mt19937_64 random(8);
  for (int n = test::count(100, 2000); n > 0; --n) {
    const Case c = test::random_slip(random);
    const KinematicGeometry g = geometry_of(c);
    plain::Case p;
    p.standard = g.type == Mechanism::Type::standard;
    p.gear_ratio = g.gear_ratio;
    p.centre_distance = g.centre_distance;
    p.screw.x = g.points.screw.x, p.screw.y = g.points.screw.y;
    p.nut.x = g.points.nut.x, p.nut.y = g.points.nut.y;
    EXPECT_NEAR(ideal_slip_ratio(g), static_cast<double>(plain::ideal_slip_ratio(p)), 1e-13);
  }
}

TEST(Kinematics, IdealSlipRatioSlidesLeast) {
  for (const Case& c : {test::sandu_reference(), test::inverted(test::sandu_reference())}) {
    const KinematicGeometry g = geometry_of(c);
    const auto sliding = [&](double slip) {
      return contact_motion(g, kinematics(g, 1.0, slip), sliding_interface(g.type)).sliding.norm();
    };
    const double ideal = ideal_slip_ratio(g);
    EXPECT_LT(sliding(ideal), sliding(ideal + 1e-4));
    EXPECT_LT(sliding(ideal), sliding(ideal - 1e-4));
  }
}

/// If both contacts are the pitch points of the gears, all three formulas agree.
TEST(Kinematics, EstimatesAgreeForContactsAtThePitchPoints) {
  for (const double gamma : {0.15, 0.2, 1.0 / 3.0}) {
    KinematicGeometry g;
    g.lead = 10e-3;
    g.gear_ratio = gamma;
    g.centre_distance = 20e-3;
    const double roller = g.centre_distance * gamma / (1 - gamma);
    g.points.screw = {g.centre_distance - roller, 0.0};
    g.points.nut = {g.centre_distance + roller, 0.0};
    EXPECT_NEAR(slip_estimates(g).simple, ideal_slip_ratio(g), 1e-14);
    EXPECT_NEAR(*slip_estimates(g).jones, ideal_slip_ratio(g), 1e-14);

    g.type = Mechanism::Type::inverted;
    const double inverted_roller = g.centre_distance * gamma / (1 + gamma);
    g.points.screw = {g.centre_distance - inverted_roller, 0.0};
    g.points.nut = {g.centre_distance + inverted_roller, 0.0};
    EXPECT_NEAR(slip_estimates(g).simple, ideal_slip_ratio(g), 1e-14);
    EXPECT_FALSE(slip_estimates(g).jones);
  }
}

TEST(Kinematics, OptimalityRunsFromPureSlidingToIdeal) {
  for (const SlipRange range : {SlipRange{0.0, 0.374}, SlipRange{1.0, 0.416}}) {
    EXPECT_EQ(optimality(range, range.pure_sliding), 0.0);
    EXPECT_EQ(optimality(range, range.ideal), 1.0);
  }
}

}  // namespace
}  // namespace prs
