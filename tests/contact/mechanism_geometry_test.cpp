#include "contact/mechanism_geometry.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/count.h"
#include "tests/contact/mechanisms.h"
#include "tests/contact/units.h"

namespace contact {
namespace {

MechanismGeometry draft(MechanismType type, double target_radius_mm, double pitch_mm, int screw_starts,
                        int roller_starts, double roller_curvature_per_mm, double flank_deg = 45) {
  const double lead = screw_starts * pitch_mm;
  const double roller = roller_lead(type, lead, pitch_mm, roller_starts);
  return {type, test::thread(target_radius_mm, lead, pitch_mm, 0, flank_deg),
          test::thread(0, roller, pitch_mm, roller_curvature_per_mm, flank_deg),
          test::nut_thread(0, lead, pitch_mm, 0, flank_deg), 0};
}

TEST(MechanismDesign, SanduExample2) {
  // Table 1.6: inverted, 1/r_BR = 0.0471 /mm exactly (errata 3), no backlash.
  const DesignResult d = design_by_backlash(draft(MechanismType::inverted, 15, 5, 2, 1, 0.0471), 2, 1, {});
  ASSERT_TRUE(d.ok()) << name(d.status);
  const double length = 6e-5 * mm, angle = 6e-5 * deg;
  EXPECT_NEAR(d.mechanism.centre_distance, 22.5 * mm, length);
  EXPECT_NEAR(d.mechanism.roller.pitch_radius, 7.5 * mm, 1e-15);
  EXPECT_NEAR(d.mechanism.nut.pitch_radius, 30.1265 * mm, length);
  EXPECT_NEAR(ThreadSurface(d.mechanism.screw).helix_angle(), 6.0566 * deg, angle);
  EXPECT_NEAR(ThreadSurface(d.mechanism.roller).helix_angle(), -6.0566 * deg, angle);
  EXPECT_NEAR(ThreadSurface(d.mechanism.nut).helix_angle(), 3.0241 * deg, angle);
  const ContactPoint &screw = d.contact.screw.point, &nut = d.contact.nut.point;
  EXPECT_NEAR(screw.radius_on_body, 15 * mm, length);
  EXPECT_NEAR(screw.radius_on_roller, 7.5 * mm, length);
  EXPECT_NEAR(screw.angle_on_body, 0.0, angle);
  EXPECT_NEAR(screw.angle_on_roller, -180 * deg, angle);
  EXPECT_NEAR(nut.radius_on_roller, 7.4360 * mm, length);
  EXPECT_NEAR(nut.radius_on_body, 29.8095 * mm, length);
  EXPECT_NEAR(nut.angle_on_roller, 12.1996 * deg, angle);
  EXPECT_NEAR(nut.angle_on_body, 3.0217 * deg, angle);
  // Table 1.7, printed to 1e-3 mm.
  EXPECT_NEAR(nut.position.x, 29.768 * mm, 6e-4 * mm);
  EXPECT_NEAR(nut.position.y, 1.571 * mm, 6e-4 * mm);
  EXPECT_NEAR(2 * d.mechanism.nut.pitch_radius, 60.25 * mm, 6e-3 * mm);
}

TEST(MechanismDesign, SanduTable32RectifiesTheScrew) {
  // Errata 4: target 15 mm, r_BR = 6 mm, no backlash.
  const DesignResult d = design_by_backlash(draft(MechanismType::standard, 15, 2, 5, 1, 1.0 / 6.0), 5, 1, {});
  ASSERT_TRUE(d.ok());
  EXPECT_NEAR(d.mechanism.screw.pitch_radius, 14.9467 * mm, 6e-5 * mm);
  EXPECT_NEAR(d.mechanism.centre_distance, 20.0 * mm, 6e-5 * mm);
  EXPECT_NEAR(d.mechanism.roller.pitch_radius, 5 * mm, 1e-15);
  EXPECT_NEAR(d.mechanism.nut.pitch_radius, 25 * mm, 1e-15);
}

TEST(MechanismDesign, BacklashIsMetToATrillionthOfAMetre) {
  test::RandomMechanisms random(21);
  const int wanted = ::test::count(200, 5000);
  int designed = 0, failed = 0;
  double worst = 0.0;
  while (designed < wanted) {
    const MechanismType type = random.integer(0, 1) == 1 ? MechanismType::standard : MechanismType::inverted;
    const int roller_starts = random.integer(1, 2);
    const int starts = type == MechanismType::standard ? random.integer(2 * roller_starts + 1, 2 * roller_starts + 5)
                                                       : random.integer(1, 6);
    const double radius = random.uniform(5, 40);
    const double roller = matched_pitch_radii(type, radius, starts, roller_starts).roller;
    MechanismGeometry m = draft(type, radius, random.uniform(0.1, 0.4) * std::min(radius, roller), starts,
                                roller_starts, std::sin(45 * deg) / roller);
    if (random.integer(0, 1) == 1) {
      for (Thread* t : {&m.screw, &m.roller, &m.nut}) {
        t->lead = -t->lead;
        t->plane = ProfilePlane::axial;
      }
    }
    const Backlash wanted_backlash{random.uniform(-0.02, 0.05) * m.screw.pitch,
                                   random.uniform(-0.02, 0.05) * m.screw.pitch};
    const DesignResult d = design_by_backlash(m, starts, roller_starts, wanted_backlash);
    if (!d.ok()) {
      ++failed;
      EXPECT_NE(d.status, DesignStatus::not_converged);
      ASSERT_LT(failed, wanted);
      continue;
    }
    ++designed;
    // Solves again from the designed dimensions alone.
    const MechanismContact again = mechanism_contact(d.mechanism, Configuration::i2_j1);
    worst = std::max({worst, std::abs(again.screw.point.backlash - wanted_backlash.screw),
                      std::abs(again.nut.point.backlash - wanted_backlash.nut)});
    EXPECT_LE(d.iterations, 14);
  }
  EXPECT_LT(worst, 1e-12);
  EXPECT_LT(failed, wanted / 5);
}

TEST(MechanismDesign, PitchesThatRoundingTellsApartAreOne) {
  MechanismGeometry m = draft(MechanismType::inverted, 15, 2, 3, 1, std::sin(45 * deg) / 5);
  m.nut.pitch = std::nextafter(m.roller.pitch, 1.0);
  m.screw.pitch = std::nextafter(m.roller.pitch, 0.0);
  EXPECT_TRUE(same_pitch(m.screw, m.nut));
  EXPECT_NE(design_by_backlash(m, 3, 1, {}).status, DesignStatus::pitches_differ);
  m.nut.pitch = m.roller.pitch * (1.0 + 2.0 * kSamePitch);
  EXPECT_FALSE(same_pitch(m.nut, m.roller));
}

TEST(MechanismDesign, ImpossibleDraftsAreNamed) {
  const Backlash none;
  EXPECT_EQ(design_by_backlash(draft(MechanismType::standard, 15, 2, 2, 1, 0.1), 2, 1, none).status,
            DesignStatus::too_few_screw_starts);
  MechanismGeometry m = draft(MechanismType::inverted, 15, 2, 3, 1, 0.1);
  m.nut.pitch *= 1.01;
  EXPECT_EQ(design_by_backlash(m, 3, 1, none).status, DesignStatus::pitches_differ);
  m = draft(MechanismType::inverted, 15, 2, 3, 1, 0.0);
  const DesignResult straight = design_by_backlash(m, 3, 1, none);
  EXPECT_EQ(straight.status, DesignStatus::no_screw_contact);
  EXPECT_EQ(straight.contact.screw.point.status, ContactPointStatus::straight_on_straight);
  m = draft(MechanismType::inverted, 15, 5, 3, 1, std::sin(45 * deg) / 5);
  m.nut.addendum = 0.01 * mm;  // the nut touches on the crest's side of its pitch radius
  const DesignResult truncated = design_by_backlash(m, 3, 1, none);
  EXPECT_EQ(truncated.status, DesignStatus::no_nut_contact);
  EXPECT_EQ(truncated.contact.nut.point.status, ContactPointStatus::outside_flank);
}

TEST(MechanismGeometry, MatchedRadiiMatchTheHelixAngles) {
  const PitchRadii standard = matched_pitch_radii(MechanismType::standard, 15.0, 5, 1);
  EXPECT_DOUBLE_EQ(standard.roller, 5.0);
  EXPECT_DOUBLE_EQ(standard.nut, 25.0);  // r_N = r_R n_N/n_R (1.52)
  const PitchRadii inverted = matched_pitch_radii(MechanismType::inverted, 15.0, 2, 1);
  EXPECT_DOUBLE_EQ(inverted.roller, 7.5);
  EXPECT_DOUBLE_EQ(inverted.nut, 30.0);
}

TEST(MechanismGeometry, RollerLeadFollowsTheHandOfTheScrew) {
  EXPECT_DOUBLE_EQ(roller_lead(MechanismType::standard, 10, 2, 1), 2.0);
  EXPECT_DOUBLE_EQ(roller_lead(MechanismType::standard, -10, 2, 2), -4.0);
  EXPECT_DOUBLE_EQ(roller_lead(MechanismType::inverted, 10, 5, 1), -5.0);
  EXPECT_DOUBLE_EQ(roller_lead(MechanismType::inverted, -10, 5, 1), 5.0);
}

TEST(MechanismGeometry, KinematicConsistencyFindsEachFault) {
  const KinematicConsistency good = kinematic_consistency(test::abevi());
  EXPECT_EQ(good.lead_difference, 0.0);
  EXPECT_NEAR(good.gear_ratio, good.gear_ratio_by_leads, 1e-15);
  MechanismGeometry bad = test::sandu_example_1();
  bad.nut.lead *= 1.001;
  bad.nut.pitch_radius = 25.1 * mm;
  const KinematicConsistency found = kinematic_consistency(bad);
  EXPECT_NEAR(found.lead_difference, 0.01 * mm, 1e-15);
  EXPECT_NEAR(found.gear_ratio, 5 / 25.1, 1e-15);
  EXPECT_NEAR(found.gear_ratio_by_leads, 0.2, 1e-15);
}

TEST(MechanismGeometry, LargestRollerCountJustFits) {
  EXPECT_EQ(largest_roller_count(test::abevi()), 11);  // the published screw has 11
  MechanismGeometry m = test::sandu_example_1();
  m.roller.addendum = 20 * mm * std::sin(3.14159265358979324 / 10) - 5 * mm;
  EXPECT_EQ(largest_roller_count(m), 10);
  m.roller.addendum = *m.roller.addendum + 1e-6 * mm;
  EXPECT_EQ(largest_roller_count(m), 9);
  m.roller.addendum = 100 * mm;
  EXPECT_EQ(largest_roller_count(m), 1);
}

TEST(MechanismGeometry, OriginsBringTheContactPointsTogether) {
  // z of one body's contact point + height of its origin = z of the roller's contact point, modulo
  // the pitch, for both configurations: (1.41) to (1.44).
  test::RandomMechanisms random(22);
  int checked = 0;
  for (int i = 0; i < 100; ++i) {
    const MechanismGeometry m = random.next();
    for (const Configuration configuration : {Configuration::i1_j2, Configuration::i2_j1}) {
      const MechanismContact c = mechanism_contact(m, configuration);
      if (!c.ok()) continue;
      ++checked;
      const AxialPositions origin = axial_positions(m, c, configuration);
      const auto z = [](const ThreadSurface& s, double radius, double angle, int gamma) {
        return gamma * s.profile(radius).height + angle * s.reduced_lead;
      };
      const int at_screw = static_cast<int>(roller_face_at_screw(configuration));
      const int at_nut = static_cast<int>(roller_face_at_nut(configuration));
      const ContactPoint &p = c.screw.point, &q = c.nut.point;
      const ThreadPair screw = screw_pair(m), nut = nut_pair(m);
      const double roller_i = z(screw.roller, p.radius_on_roller, p.angle_on_roller, at_screw);
      const double screw_i = z(screw.body, p.radius_on_body, p.angle_on_body, -at_screw);
      const double roller_j = z(nut.roller, q.radius_on_roller, q.angle_on_roller, at_nut);
      const double nut_j = z(nut.body, q.radius_on_body, q.angle_on_body, at_nut);
      // I2 lies on the thread next to I1's: the roller's angle is a turn further.
      const double gap_i = origin.screw + screw_i - roller_i;
      EXPECT_NEAR(std::remainder(gap_i, m.screw.pitch), 0.0, 1e-15);
      EXPECT_NEAR(origin.nut + nut_j - roller_j, 0.0, 1e-16);
    }
  }
  EXPECT_GT(checked, 30);
}

/// Rollers whose helix vanishes touch as rollers with grooves, to the first order of their lead.
TEST(MechanismGeometry, AVanishingHelixTendsToGrooves) {
  MechanismGeometry m{MechanismType::recirculating, test::thread(10, 2, 2), test::thread(8, 0, 2, 0.1),
                      test::nut_thread(26, 2, 2), 18 * mm};
  EXPECT_EQ(roller_lead(m.type, 2.0, 2.0, 0), 0.0);
  const MechanismContact grooves = mechanism_contact(m, Configuration::i1_j2);
  ASSERT_TRUE(grooves.ok());
  for (const double share : {1e-2, 1e-4, 1e-6})
    for (const double hand : {1.0, -1.0}) {
      m.roller.lead = hand * share * m.roller.pitch;
      const MechanismContact c = mechanism_contact(m, Configuration::i1_j2);
      for (const auto interface : {&MechanismContact::screw, &MechanismContact::nut}) {
        const InterfaceGeometry &a = c.*interface, &b = grooves.*interface;
        EXPECT_NEAR(a.point.radius_on_body, b.point.radius_on_body, share * mm);
        EXPECT_NEAR(a.point.normal_angle(), b.point.normal_angle(), share);
        EXPECT_NEAR(a.relative.first, b.relative.first, share * b.relative.second);
        EXPECT_NEAR(a.relative.second, b.relative.second, share * b.relative.second);
      }
    }
}

/// Rollers with grooves keep the radius of the draft, and the others follow for the backlash.
TEST(MechanismGeometry, GroovedRollersAreDesignedForTheirBacklash) {
  MechanismGeometry draft{MechanismType::recirculating, test::thread(10, 2, 2), test::thread(8, 0, 2, 0.1),
                          test::nut_thread(0, 2, 2), 0.0};
  const DesignResult d = design_by_backlash(draft, 1, 0, {0.01 * mm, 0.02 * mm});
  ASSERT_TRUE(d.ok()) << name(d.status);
  EXPECT_EQ(d.mechanism.roller.pitch_radius, draft.roller.pitch_radius);
  EXPECT_NEAR(d.mechanism.nut.pitch_radius, 26 * mm, 1e-15);
  EXPECT_NEAR(d.contact.screw.point.backlash, 0.01 * mm, 1e-14);
  EXPECT_NEAR(d.contact.nut.point.backlash, 0.02 * mm, 1e-14);
}

TEST(MechanismGeometry, YaosClearanceIsHalfTheBacklashOfThreadsWithTheirThickness) {
  // Yao 2023, (55), with the thread thicknesses of table A1 and positive where (56) requires it.
  MechanismGeometry m = test::yao();
  m.screw.thickness = m.nut.thickness = 2 * mm;
  m.roller.thickness = 2.4 * mm;
  const MechanismContact c = mechanism_contact(m, Configuration::i1_j2);
  const ContactPoint& p = c.screw.point;
  const ThreadPair pair = screw_pair(m);
  // Deflection angles both counted from the line of centres, each towards its part's own thread.
  const double clearance = pair.body.profile(p.radius_on_body).height + p.angle_on_body * pair.body.reduced_lead +
                           pair.roller.profile(p.radius_on_roller).height -
                           (p.angle_on_roller + std::numbers::pi) * pair.roller.reduced_lead - m.roller.pitch / 2;
  EXPECT_NEAR(clearance, p.backlash / 2, 1e-17);
  EXPECT_GT(clearance, 0.0);
  EXPECT_NEAR(c.nut.point.backlash, (5 - 2 - 2.4) * mm, 1e-16);
}

}  // namespace
}  // namespace contact
