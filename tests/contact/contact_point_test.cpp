#include "contact/contact_point.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "contact/mechanism_geometry.h"
#include "support/allocations.h"
#include "support/count.h"
#include "tests/contact/mechanisms.h"
#include "tests/contact/units.h"

namespace contact {
namespace {

using std::numbers::pi;
using test::RandomMechanisms;

int gamma_of(RollerFace face) { return static_cast<int>(face); }

/// Outward unit normal of a described volume, Sandu 2018, (1.27).
Eigen::Vector3d normal_by_1_27(const ThreadSurface& s, double radius, double angle, int gamma) {
  const double f = s.profile(radius).slope, t = gamma * s.reduced_lead / radius;
  const double cosine = std::cos(angle), sine = std::sin(angle);
  return Eigen::Vector3d(f * cosine - t * sine, f * sine + t * cosine, -gamma).normalized();
}

/// Surface height z, Sandu 2018, (1.22).
double height_by_1_22(const ThreadSurface& s, double radius, double angle, int gamma) {
  return gamma * s.profile(radius).height + angle * s.reduced_lead;
}

/// Sandu 2018, (A.9) and (A.10) with the factor in front of (A.9) left out.
Eigen::Vector2d residual_of_a9_a10(const ThreadPair& pair, double body_radius, double roller_radius) {
  const double f1 = pair.body.profile(body_radius).slope;
  const double f2 = pair.roller.profile(roller_radius).slope;
  const double l1 = pair.body.reduced_lead, l2 = pair.roller.reduced_lead;
  const double c = pair.centre_distance;
  const double bracket = f1 * f1 + std::pow(l1 / body_radius, 2);
  // gamma_1 gamma_2 = -1 for two external threads, +1 for a nut's air.
  const double arm = (body_radius * f1 + pair.body.side * roller_radius * f2) / c;
  return {arm * arm + std::pow((l1 - l2) / c, 2) - bracket, bracket - f2 * f2 - std::pow(l2 / roller_radius, 2)};
}

/// Newton on (A.9), (A.10) in the two radii with the full Jacobian.
Eigen::Vector2d solve_a9_a10(const ThreadPair& pair, Eigen::Vector2d radii) {
  for (int i = 0; i < 60; ++i) {
    const double r1 = radii.x(), r2 = radii.y(), c = pair.centre_distance;
    const ProfilePoint f1 = pair.body.profile(r1), f2 = pair.roller.profile(r2);
    const double l1 = pair.body.reduced_lead, l2 = pair.roller.reduced_lead, s = pair.body.side;
    const double arm = 2.0 * (r1 * f1.slope + s * r2 * f2.slope) / (c * c);
    const double bracket = 2.0 * (f1.slope * f1.slope_rate - l1 * l1 / (r1 * r1 * r1));
    Eigen::Matrix2d jacobian;
    jacobian << arm * (f1.slope + r1 * f1.slope_rate) - bracket, arm * s * (f2.slope + r2 * f2.slope_rate), bracket,
        -2.0 * (f2.slope * f2.slope_rate - l2 * l2 / (r2 * r2 * r2));
    radii -= jacobian.inverse() * residual_of_a9_a10(pair, r1, r2);
  }
  return radii;
}

struct NamedPair {
  ThreadPair pair;
  RollerFace face;
};

std::vector<NamedPair> pairs_of(const MechanismGeometry& m) {
  return {{screw_pair(m), RollerFace::top},
          {screw_pair(m), RollerFace::bottom},
          {nut_pair(m), RollerFace::bottom},
          {nut_pair(m), RollerFace::top}};
}

/// Checks the contact points of `wanted` mechanisms with contacts at both interfaces for closure, equal normals and
/// Sandu's equations.
void expect_closure_and_equal_normals(RandomMechanisms random, int wanted) {
  int found = 0;
  double worst_gap = 0.0, worst_normal = 0.0, worst_equation = 0.0;
  for (int tries = 0; found < wanted && tries < 100 * wanted; ++tries) {
    const MechanismGeometry m = random.next();
    if (!mechanism_contact(m, Configuration::i1_j2).ok()) continue;
    ++found;
    for (const auto& [pair, face] : pairs_of(m)) {
      const ContactPoint p = find_contact_point(pair, face);
      ASSERT_TRUE(p.ok());
      const double rb = p.radius_on_body, rr = p.radius_on_roller;
      const double tb = p.angle_on_body, tr = p.angle_on_roller;
      worst_gap = std::max({worst_gap, std::abs(rb * std::cos(tb) - rr * std::cos(tr) - pair.centre_distance),
                            std::abs(rb * std::sin(tb) - rr * std::sin(tr))});
      const bool external = pair.body.side > 0;
      const int gamma = gamma_of(face);
      const Eigen::Vector3d on_roller = normal_by_1_27(pair.roller, rr, tr, gamma);
      const Eigen::Vector3d on_body = external ? Eigen::Vector3d(-normal_by_1_27(pair.body, rb, tb, -gamma))
                                               : normal_by_1_27(pair.body, rb, tb, gamma);
      worst_normal = std::max({worst_normal, (on_roller - on_body).norm(),
                               (on_roller - Eigen::Vector3d(p.normal.x, p.normal.y, p.normal.z)).norm()});
      worst_equation = std::max(worst_equation, residual_of_a9_a10(pair, rb, rr).norm());
    }
  }
  EXPECT_EQ(found, wanted);
  EXPECT_LT(worst_gap, 1e-13);
  EXPECT_LT(worst_normal, 1e-12);
  EXPECT_LT(worst_equation, 1e-12);
}

TEST(ContactPoint, ClosesAndHasEqualNormalsOnRandomMechanisms) {
  expect_closure_and_equal_normals(RandomMechanisms(1), ::test::count(500, 10000));
}

TEST(ContactPoint, ClosesAndHasEqualNormalsWithStraightAndConcaveRollers) {
  expect_closure_and_equal_normals(RandomMechanisms(6, RandomMechanisms::Rollers::straight_or_concave),
                                   ::test::count(200, 2000));
}

TEST(ContactPoint, TakesAtMostEightStepsOnRandomMechanisms) {
  const int tries = ::test::samples(4000, 200000);
  RandomMechanisms random(2);
  int found = 0, slow = 0;
  double steps = 0.0;
  for (int i = 0; i < tries; ++i) {
    const MechanismGeometry m = random.next();
    for (const auto& [pair, face] :
         {NamedPair{screw_pair(m), RollerFace::top}, NamedPair{nut_pair(m), RollerFace::bottom}}) {
      const ContactPoint p = find_contact_point(pair, face);
      if (!p.ok()) continue;
      ++found;
      steps += p.iterations;
      slow += p.iterations > 8;
    }
  }
  EXPECT_GT(found, tries);
  EXPECT_LE(slow, 0.001 * found);
  EXPECT_LT(steps / found, 5.0);
}

/// Axial clearance of a pair at a point of the plane, from the surface heights alone; infinite off
/// the flanks.
double clearance(const ThreadPair& pair, RollerFace face, double x, double y) {
  const double c = pair.centre_distance, side = pair.body.side;
  const double r = std::hypot(x, y), roller_r = std::hypot(x - c, y);
  if (r < pair.body.smallest_radius || r > pair.body.largest_radius || roller_r < pair.roller.smallest_radius ||
      roller_r > pair.roller.largest_radius) {
    return std::numeric_limits<double>::infinity();
  }
  const double turn = std::atan2(y, x);
  const double roller_turn = side > 0 ? std::atan2(-y, c - x) : std::atan2(y, x - c);
  return pair.roller.profile(roller_r).height + side * pair.body.profile(r).height -
         gamma_of(face) * (pair.body.reduced_lead * turn - pair.roller.reduced_lead * roller_turn);
}

/// Minimum of the clearance inside both flanks by values only: the best point of a grid, then a pattern search. None if
/// that ends on the border.
std::optional<Eigen::Vector2d> minimum_by_direct_search(const ThreadPair& pair, RollerFace face) {
  const double inner = pair.body.smallest_radius, outer = pair.body.largest_radius;
  Eigen::Vector2d best(0, 0);
  double lowest = std::numeric_limits<double>::infinity();
  const auto try_point = [&](const Eigen::Vector2d& p) {
    const double value = clearance(pair, face, p.x(), p.y());
    if (!(value < lowest)) return false;
    lowest = value;
    best = p;
    return true;
  };
  constexpr int n = 40;
  for (int i = 0; i < n; ++i) {
    for (int j = -n; j <= n; ++j) {
      const double r = inner + (outer - inner) * (i + 0.5) / n, t = 0.6 * j / n;
      try_point({r * std::cos(t), r * std::sin(t)});
    }
  }
  if (!std::isfinite(lowest)) return std::nullopt;
  for (double step = (outer - inner) / n; step > 1e-7 * outer;) {
    bool moved = false;
    for (int k = 0; k < 16; ++k) {
      const Eigen::Vector2d direction(std::cos(k * pi / 8), std::sin(k * pi / 8));
      moved = try_point(best + step * direction) || moved;
    }
    if (!moved) step *= 0.5;
  }
  for (int k = 0; k < 16; ++k) {
    const double margin = 1e-5 * outer;
    if (!std::isfinite(clearance(pair, face, best.x() + margin * std::cos(k * pi / 8),
                                 best.y() + margin * std::sin(k * pi / 8)))) {
      return std::nullopt;
    }
  }
  return best;
}

TEST(ContactPoint, IsFoundWhereverADirectSearchFindsAMinimum) {
  const int tries = ::test::samples(100, 3000);
  RandomMechanisms random(3);
  int seen = 0;
  for (int i = 0; i < tries; ++i) {
    const MechanismGeometry m = random.next();
    for (const auto& [pair, face] :
         {NamedPair{screw_pair(m), RollerFace::top}, NamedPair{nut_pair(m), RollerFace::bottom}}) {
      const auto lowest = minimum_by_direct_search(pair, face);
      if (!lowest) continue;
      ++seen;
      const ContactPoint p = find_contact_point(pair, face);
      ASSERT_TRUE(p.ok()) << i;
      // No point on the flanks lies lower, and the search, good to sqrt(eps), ends at the same place.
      EXPECT_LE(clearance(pair, face, p.position.x, p.position.y),
                clearance(pair, face, lowest->x(), lowest->y()) + 1e-15)
          << i;
      EXPECT_LT(std::hypot(p.position.x - lowest->x(), p.position.y - lowest->y()), 1e-4 * p.radius_on_body) << i;
    }
  }
  EXPECT_GT(seen, tries);
}

TEST(ContactPoint, AgreesWithNewtonOnSandusEquations) {
  const MechanismGeometry ex1 = test::sandu_example_1(), inverted = test::abevi();
  for (const ThreadPair& pair : {screw_pair(ex1), nut_pair(inverted)}) {
    const ContactPoint p = find_contact_point(pair, RollerFace::top);
    const Eigen::Vector2d radii = solve_a9_a10(pair, {pair.body.pitch_radius, pair.roller.pitch_radius});
    EXPECT_NEAR(p.radius_on_body, radii.x(), 1e-13 * mm);
    EXPECT_NEAR(p.radius_on_roller, radii.y(), 1e-13 * mm);
  }
}

TEST(ContactPoint, OfTheSeveralRootsOfSandusEquationsOnlyTheAdmissibleOneIsReported) {
  // A coarse inverted screw: near the roller's core the helix alone is as steep as the flank.
  MechanismGeometry m{MechanismType::inverted, test::thread(20, 12, 6),
                      test::thread(20, -12, 6, std::sin(45 * deg) / 20), test::nut_thread(60, 12, 6), 40 * mm};
  const ThreadPair pair = nut_pair(m);
  const Eigen::Vector2d other = solve_a9_a10(pair, {40 * mm, 1.9 * mm});
  ASSERT_LT(residual_of_a9_a10(pair, other.x(), other.y()).norm(), 1e-12);
  EXPECT_LT(other.y(), pair.roller.smallest_radius);

  const ContactPoint p = find_contact_point(pair, RollerFace::bottom);
  ASSERT_TRUE(p.ok());
  EXPECT_GT(p.radius_on_roller, pair.roller.smallest_radius);
  EXPECT_GT(p.clearance_hessian.determinant(), 0.0);
  EXPECT_GT(p.clearance_hessian.trace(), 0.0);
}

TEST(ContactPoint, SanduExample1) {
  // Table 1.6; theta_IS and theta_IR are printed with the signs of I2J1 (errata 1).
  const MechanismGeometry m = test::sandu_example_1();
  const ContactPoint screw = find_contact_point(screw_pair(m), RollerFace::top);
  ASSERT_TRUE(screw.ok());
  EXPECT_NEAR(screw.radius_on_body, 15.0351 * mm, 6e-5 * mm);
  EXPECT_NEAR(screw.radius_on_roller, 5.0177 * mm, 6e-5 * mm);
  EXPECT_NEAR(screw.angle_on_body, -2.3994 * deg, 6e-5 * deg);
  EXPECT_NEAR(screw.angle_on_roller, -172.7935 * deg, 6e-5 * deg);
  EXPECT_NEAR(screw.backlash, -0.1071 * mm, 6e-5 * mm);
  const ContactPoint nut = find_contact_point(nut_pair(m), RollerFace::bottom);
  ASSERT_TRUE(nut.ok());
  EXPECT_NEAR(nut.radius_on_body, 25 * mm, 1e-15);
  EXPECT_NEAR(nut.radius_on_roller, 5 * mm, 1e-15);
  EXPECT_NEAR(nut.angle_on_body, 0.0, 1e-14);
  EXPECT_NEAR(nut.backlash, 0.0, 1e-17);
}

TEST(ContactPoint, SanduExample3) {
  const MechanismGeometry m = test::sandu_example_3();
  const ContactPoint screw = find_contact_point(screw_pair(m), RollerFace::top);
  ASSERT_TRUE(screw.ok());
  EXPECT_NEAR(screw.radius_on_body, 9.7586 * mm, 6e-5 * mm);
  EXPECT_NEAR(screw.radius_on_roller, 3.2543 * mm, 6e-5 * mm);
  EXPECT_NEAR(screw.angle_on_body, -1.4717 * deg, 6e-5 * deg);
  EXPECT_NEAR(screw.angle_on_roller, -175.5829 * deg, 6e-5 * deg);
  EXPECT_NEAR(screw.backlash, -0.0656 * mm, 6e-5 * mm);
  const ContactPoint nut = find_contact_point(nut_pair(m), RollerFace::bottom);
  EXPECT_NEAR(nut.radius_on_body, 16.25 * mm, 1e-14);
  EXPECT_NEAR(nut.backlash, 0.0, 1e-17);
}

TEST(ContactPoint, NormalPointsFromTheRollerInI1J2) {
  const MechanismGeometry m = test::abevi();
  const ContactPoint screw = find_contact_point(screw_pair(m), RollerFace::top);
  EXPECT_LT(screw.normal.x, 0.0);  // towards the screw
  EXPECT_GT(screw.normal.z, 0.0);  // out of the top face
  const ContactPoint nut = find_contact_point(nut_pair(m), RollerFace::bottom);
  EXPECT_GT(nut.normal.x, 0.0);
  EXPECT_LT(nut.normal.z, 0.0);
  EXPECT_NEAR(screw.normal_angle(), 45.1636 * deg, 6e-5 * deg);
  EXPECT_NEAR(nut.normal_angle(), 45.0592 * deg, 6e-5 * deg);
  EXPECT_NEAR(nut.backlash, -0.064 * mm, 5e-4 * mm);
}

TEST(ContactPoint, OtherFacesAreAHalfTurnAboutX) {
  RandomMechanisms random(4);
  int checked = 0;
  for (int i = 0; i < 100; ++i) {
    const MechanismGeometry m = random.next();
    for (const ThreadPair& pair : {screw_pair(m), nut_pair(m)}) {
      const ContactPoint top = find_contact_point(pair, RollerFace::top);
      if (!top.ok()) continue;
      ++checked;
      const ContactPoint bottom = find_contact_point(pair, RollerFace::bottom);
      const ContactPoint turned = on_other_faces(top);
      EXPECT_NEAR(bottom.radius_on_body, turned.radius_on_body, 1e-16);
      EXPECT_NEAR(bottom.angle_on_body, turned.angle_on_body, 1e-13);
      EXPECT_NEAR(bottom.angle_on_roller, turned.angle_on_roller, 1e-13);
      EXPECT_NEAR((bottom.normal - turned.normal).norm(), 0.0, 1e-13);
      EXPECT_NEAR(bottom.backlash, turned.backlash, 1e-16);
      EXPECT_NEAR(bottom.clearance_hessian.xy, turned.clearance_hessian.xy, 1e-9 * turned.clearance_hessian.trace());
    }
  }
  EXPECT_GT(checked, 50);
}

TEST(ContactPoint, LeftHandedMechanismIsTheMirrorImage) {
  MechanismGeometry right = test::sandu_example_1(), left = right;
  for (Thread* t : {&left.screw, &left.roller, &left.nut}) t->lead = -t->lead;
  const ContactPoint a = find_contact_point(screw_pair(right), RollerFace::top);
  const ContactPoint b = find_contact_point(screw_pair(left), RollerFace::top);
  EXPECT_NEAR(b.radius_on_body, a.radius_on_body, 1e-16);
  EXPECT_NEAR(b.angle_on_body, -a.angle_on_body, 1e-14);
  // Branch near -pi on both hands (errata 14).
  EXPECT_NEAR(a.angle_on_roller + pi, 7.2065 * deg, 6e-5 * deg);
  EXPECT_NEAR(b.angle_on_roller + pi, -7.2065 * deg, 6e-5 * deg);
  EXPECT_NEAR(b.backlash, a.backlash, 1e-16);
}

TEST(ContactPoint, BacklashIsEquation140) {
  // D_zS = 2 (z_I1S - z_I1R) - l_R - p and D_zN = 2 (z_J2R - z_J2N).
  RandomMechanisms random(5);
  int checked = 0;
  for (int i = 0; i < 100; ++i) {
    const MechanismGeometry m = random.next();
    const ThreadPair screw = screw_pair(m), nut = nut_pair(m);
    if (const ContactPoint p = find_contact_point(screw, RollerFace::top); p.ok()) {
      ++checked;
      const double z_s = height_by_1_22(screw.body, p.radius_on_body, p.angle_on_body, 1);
      const double z_r = height_by_1_22(screw.roller, p.radius_on_roller, p.angle_on_roller, -1);
      EXPECT_NEAR(p.backlash, 2 * (z_s - z_r) - m.roller.lead - m.roller.pitch, 1e-16);
    }
    if (const ContactPoint p = find_contact_point(nut, RollerFace::bottom); p.ok()) {
      ++checked;
      const double z_n = height_by_1_22(nut.body, p.radius_on_body, p.angle_on_body, 1);
      const double z_r = height_by_1_22(nut.roller, p.radius_on_roller, p.angle_on_roller, 1);
      EXPECT_NEAR(p.backlash, 2 * (z_r - z_n), 1e-16);
    }
  }
  EXPECT_GT(checked, 50);
}

TEST(ContactPoint, ThinnerThreadsHaveMoreBacklash) {
  MechanismGeometry m = test::abevi();
  const double screw = find_contact_point(screw_pair(m), RollerFace::top).backlash;
  const double nut = find_contact_point(nut_pair(m), RollerFace::bottom).backlash;
  m.screw.thickness = 0.5 * m.screw.pitch - 0.03 * mm;
  m.nut.thickness = 0.5 * m.nut.pitch - 0.04 * mm;
  m.roller.thickness = 0.5 * m.roller.pitch - 0.01 * mm;
  EXPECT_NEAR(find_contact_point(screw_pair(m), RollerFace::top).backlash, screw + 0.04 * mm, 1e-17);
  EXPECT_NEAR(find_contact_point(nut_pair(m), RollerFace::bottom).backlash, nut + 0.05 * mm, 1e-17);
}

/// The radii of Abevi's screw leave no play, up to the rounding of their sums.
TEST(ContactPoint, BacklashWithinTheRoundingOfTheRadiiIsNone) {
  MechanismGeometry m = test::abevi();
  EXPECT_EQ(find_contact_point(screw_pair(m), RollerFace::top).backlash, 0.0);
  m.centre_distance += 1e-15;
  EXPECT_NEAR(find_contact_point(screw_pair(m), RollerFace::top).backlash, 2e-15, 1e-16);
}

TEST(ContactPoint, StraightOnStraightIsRefused) {
  MechanismGeometry m = test::abevi();
  m.roller.profile_curvature = 0.0;
  EXPECT_EQ(find_contact_point(screw_pair(m), RollerFace::top).status, ContactPointStatus::straight_on_straight);
}

TEST(ContactPoint, AxesTooFarApartAreOutOfReach) {
  MechanismGeometry m = test::abevi();
  m.centre_distance = 15 * mm;
  EXPECT_EQ(find_contact_point(screw_pair(m), RollerFace::top).status, ContactPointStatus::out_of_reach);
  m.centre_distance = 13 * mm;
  EXPECT_EQ(find_contact_point(nut_pair(m), RollerFace::bottom).status, ContactPointStatus::out_of_reach);
}

TEST(ContactPoint, TruncatedFlankIsNamedWithItsExcess) {
  MechanismGeometry m = test::sandu_example_1();  // touches at 15.0351 and 5.0178 mm
  m.screw.addendum = 0.03 * mm;
  m.roller.addendum = 0.01 * mm;
  const ContactPoint p = find_contact_point(screw_pair(m), RollerFace::top);
  EXPECT_EQ(p.status, ContactPointStatus::outside_flank);
  const FlankViolations beyond = point_beyond_flanks(screw_pair(m), p);
  ASSERT_EQ(beyond.size(), 2u);
  const FlankViolation &body = *beyond.begin(), &roller = *(beyond.begin() + 1);
  EXPECT_FALSE(body.of_roller);
  EXPECT_EQ(body.end, FlankEnd::crest);
  EXPECT_NEAR(body.by, 0.0051 * mm, 6e-5 * mm);
  EXPECT_TRUE(roller.of_roller);
  EXPECT_EQ(roller.end, FlankEnd::crest);
  EXPECT_NEAR(roller.by, 0.0078 * mm, 6e-5 * mm);

  MechanismGeometry inverted = test::abevi();  // touches the nut 0.0385 mm inside its pitch radius
  inverted.nut.addendum = 0.02 * mm;
  const ContactPoint q = find_contact_point(nut_pair(inverted), RollerFace::bottom);
  EXPECT_EQ(q.status, ContactPointStatus::outside_flank);
  const FlankViolations at_nut = point_beyond_flanks(nut_pair(inverted), q);
  ASSERT_EQ(at_nut.size(), 1u);
  EXPECT_FALSE(at_nut.begin()->of_roller);
  EXPECT_EQ(at_nut.begin()->end, FlankEnd::crest);
  EXPECT_NEAR(at_nut.begin()->by, 0.0185 * mm, 6e-5 * mm);
}

TEST(ContactPoint, ConcaveOnConcaveHasNone) {
  MechanismGeometry m = test::sandu_example_1();
  m.screw.profile_curvature = m.roller.profile_curvature = -0.05 * per_mm;
  const ContactPoint p = find_contact_point(screw_pair(m), RollerFace::top);
  EXPECT_FALSE(p.ok());
  EXPECT_NE(p.status, ContactPointStatus::not_computed);
}

TEST(ContactPoint, NonsenseEndsWithAStatus) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int part = 0; part < 5; ++part) {
    MechanismGeometry m = test::sandu_example_1();
    if (part == 0) m.screw.pitch_radius = nan;
    if (part == 1) m.roller.profile_curvature = nan;
    if (part == 2) m.centre_distance = nan;
    if (part == 3) m.roller.pitch = 0.0;
    if (part == 4) m.roller.profile_curvature = 1e9;
    EXPECT_FALSE(find_contact_point(screw_pair(m), RollerFace::top).ok()) << part;
  }
}

TEST(ContactPoint, AllocatesNothing) {
  const MechanismGeometry m = test::abevi();
  const std::size_t before = ::test::allocations();
  const MechanismContact contact = mechanism_contact(m, Configuration::i1_j2);
  const std::size_t after = ::test::allocations();
  EXPECT_TRUE(contact.ok());
  EXPECT_EQ(after, before);
}

}  // namespace
}  // namespace contact
