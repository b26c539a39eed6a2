#include "contact/contact_point.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/hertz.h"
#include "contact/mechanism_geometry.h"
#include "support/count.h"
#include "support/plain_contact.h"
#include "tests/contact/mechanisms.h"
#include "tests/contact/units.h"

namespace contact {
namespace {

using test::RandomMechanisms;

Eigen::Vector3d eigen(const Vector3<double>& v) { return {v.x, v.y, v.z}; }

/// Depth of a body's surface behind the tangent plane at the contact point, at the tangent vector `t` from it, found
/// from the surface equation alone: moves along the normal to the surface. `centre_x`: position of the thread's axis,
/// `n`: outward normal of the material.
double depth_behind_tangent_plane(const ThreadSurface& s, double centre_x, int gamma, const ContactPoint& p,
                                  const Eigen::Vector3d& n, const Eigen::Vector3d& t) {
  const Eigen::Vector2d at(p.position.x - centre_x, p.position.y);
  const double angle_0 = std::atan2(at.y(), at.x());
  const auto height = [&](const Eigen::Vector3d& q) {  // above the surface at the contact point
    const double x = at.x() + q.x(), y = at.y() + q.y();
    const double turn = std::remainder(std::atan2(y, x) - angle_0, 2 * std::numbers::pi);
    return gamma * (s.profile(std::hypot(x, y)).height - s.profile(at.norm()).height) + turn * s.reduced_lead;
  };
  double depth = 0.0;
  for (int i = 0; i < 30; ++i) {  // z of the moved point against the surface there
    const Eigen::Vector3d q = t - depth * n;
    depth += (q.z() - height(q)) * n.z();
  }
  return depth;
}

/// Normal curvature along the unit tangent `t`, by second difference.
double numerical_curvature(const ThreadSurface& s, double centre_x, int gamma, const ContactPoint& p,
                           const Eigen::Vector3d& n, const Eigen::Vector3d& t) {
  const double h = 2e-4 * p.radius_on_roller;
  return (depth_behind_tangent_plane(s, centre_x, gamma, p, n, h * t) +
          depth_behind_tangent_plane(s, centre_x, gamma, p, n, -h * t)) /
         (h * h);
}

struct Case {
  ThreadPair pair;
  RollerFace face;
};

std::vector<Case> cases_of(const MechanismGeometry& m) {
  return {{screw_pair(m), RollerFace::top},
          {screw_pair(m), RollerFace::bottom},
          {nut_pair(m), RollerFace::top},
          {nut_pair(m), RollerFace::bottom}};
}

TEST(InterfaceGeometry, PrincipalCurvaturesAreThoseOfTheSurfacesThemselves) {
  RandomMechanisms random(11);
  int checked = 0;
  for (int i = 0; i < 40; ++i) {
    for (const auto& [pair, face] : cases_of(random.next())) {
      const InterfaceGeometry g = interface_geometry(pair, face);
      if (!g.ok()) continue;
      ++checked;
      const int gamma = static_cast<int>(face);
      const bool external = pair.body.side > 0;
      const Eigen::Vector3d n = eigen(g.point.normal);
      // A nut's material lies on the other side of its air's surface.
      const int body_gamma = external ? -gamma : gamma;
      const double scale = std::abs(g.roller.second) + std::abs(g.body.second);
      for (const bool second : {false, true}) {
        const double quarter = second ? std::numbers::pi / 2 : 0.0;
        EXPECT_NEAR(numerical_curvature(pair.roller, pair.centre_distance, gamma, g.point, n,
                                        eigen(g.direction(g.roller.angle + quarter))),
                    second ? g.roller.second : g.roller.first, 1e-5 * scale);
        EXPECT_NEAR(
            numerical_curvature(pair.body, 0.0, body_gamma, g.point, -n, eigen(g.direction(g.body.angle + quarter))),
            second ? g.body.second : g.body.first, 1e-5 * scale);
      }
      EXPECT_NEAR(eigen(g.helix_tangent).dot(n), 0.0, 1e-14);
    }
  }
  EXPECT_GT(checked, 80);
}

TEST(InterfaceGeometry, RelativeCurvaturesAreTheClearanceHessianInTheTangentPlane) {
  // The gap along the normal is |n_z| times the axial clearance: a second way to the same tensor,
  // through the search for the contact point instead of the fundamental forms.
  RandomMechanisms random(12);
  int checked = 0;
  const int tries = ::test::count(200, 5000);
  double worst = 0.0;
  for (int i = 0; i < tries; ++i) {
    for (const auto& [pair, face] : cases_of(random.next())) {
      const InterfaceGeometry g = interface_geometry(pair, face);
      if (!g.ok()) continue;
      ++checked;
      const SymmetricTensor& h = g.point.clearance_hessian;
      const double nz = std::abs(g.point.normal.z);
      const auto along = [&](const Vector3<double>& u, const Vector3<double>& v) {
        return nz * (u.x * (h.xx * v.x + h.xy * v.y) + u.y * (h.xy * v.x + h.yy * v.y));
      };
      const double scale = g.relative.second;
      worst = std::max({worst, std::abs(along(g.major_axis, g.major_axis) - g.relative.first) / scale,
                        std::abs(along(g.minor_axis, g.minor_axis) - g.relative.second) / scale,
                        std::abs(along(g.major_axis, g.minor_axis)) / scale});
      EXPECT_GT(g.relative.first, 0.0);
    }
  }
  EXPECT_LT(worst, 1e-12);
  EXPECT_GT(checked, 100);
}

TEST(InterfaceGeometry, AxesAreARightHandedFrameWithTheNormal) {
  RandomMechanisms random(13);
  int checked = 0;
  for (int i = 0; i < 50; ++i) {
    for (const auto& [pair, face] : cases_of(random.next())) {
      const InterfaceGeometry g = interface_geometry(pair, face);
      if (!g.ok()) continue;
      ++checked;
      EXPECT_NEAR(g.point.normal.norm(), 1.0, 1e-15);
      EXPECT_NEAR((g.major_axis.cross(g.minor_axis) - g.point.normal).norm(), 0.0, 1e-14);
      EXPECT_LE(std::abs(g.roller.first), std::abs(g.roller.second));
      EXPECT_LE(std::abs(g.body.first), std::abs(g.body.second));
      EXPECT_LE(g.relative.first, g.relative.second);
      EXPECT_NEAR(g.curvature_sum(), g.body.first + g.body.second + g.roller.first + g.roller.second,
                  1e-12 * g.relative.second);
    }
  }
  EXPECT_GT(checked, 25);
}

TEST(InterfaceGeometry, OtherFacesHaveTheSameCurvatures) {
  RandomMechanisms random(14);
  int checked = 0;
  for (int i = 0; i < 50; ++i) {
    const MechanismGeometry m = random.next();
    for (const ThreadPair& pair : {screw_pair(m), nut_pair(m)}) {
      const InterfaceGeometry top = interface_geometry(pair, RollerFace::top);
      if (!top.ok()) continue;
      ++checked;
      const InterfaceGeometry bottom = interface_geometry(pair, RollerFace::bottom);
      const InterfaceGeometry turned = on_other_faces(top);
      EXPECT_NEAR(bottom.relative.first, turned.relative.first, 1e-11 * turned.relative.second);
      EXPECT_NEAR((bottom.helix_tangent - turned.helix_tangent).norm(), 0.0, 1e-13);
      EXPECT_NEAR(std::abs(bottom.major_axis.dot(turned.major_axis)), 1.0, 1e-9);
      EXPECT_NEAR((turned.major_axis.cross(turned.minor_axis) - turned.point.normal).norm(), 0.0, 1e-14);
      EXPECT_NEAR(bottom.first_directions_angle(), turned.first_directions_angle(), 1e-9);
    }
  }
  EXPECT_GT(checked, 25);
}

TEST(InterfaceGeometry, AbeviHertzConstants) {
  const MechanismContact c = mechanism_contact(test::abevi(), Configuration::i1_j2);
  ASSERT_TRUE(c.ok());
  const double modulus = contact_modulus({209 * GPa, 0.3}, {209 * GPa, 0.3});
  const auto hertz = [&](const InterfaceGeometry& g) {
    return hertz_constants(g.relative.first, g.relative.second, modulus).hertz_constant;
  };
  EXPECT_NEAR(hertz(c.screw) / static_cast<double>(plain::abevi_hertz_constant(true)), 1.0, 1e-12);
  EXPECT_NEAR(hertz(c.nut) / static_cast<double>(plain::abevi_hertz_constant(false)), 1.0, 1e-12);
}

TEST(InterfaceGeometry, SanduTableB2) {
  // The point of tables B.1 and B.2 is the roller's at I1 of example 1.
  const MechanismContact c = mechanism_contact(test::sandu_example_1(), Configuration::i1_j2);
  EXPECT_NEAR(c.screw.point.radius_on_roller, 5.0178 * mm, 6e-5 * mm);
  EXPECT_NEAR(c.screw.point.angle_on_roller, -172.7935 * deg, 6e-5 * deg);
  EXPECT_NEAR(c.screw.roller.first, 0.1289 * per_mm, 6e-5 * per_mm);
  EXPECT_NEAR(c.screw.roller.second, 0.1542 * per_mm, 6e-5 * per_mm);
}

TEST(InterfaceGeometry, YaoTable1Curvatures) {
  const MechanismContact c = mechanism_contact(test::yao(), Configuration::i1_j2);
  ASSERT_TRUE(c.ok());
  const double four_digits = 6e-5 * per_mm;
  EXPECT_NEAR(c.screw.body.first, -3.7845e-4 * per_mm, 2e-8 * per_mm);  // errata 1
  EXPECT_NEAR(c.screw.body.second, 0.0298 * per_mm, four_digits);
  EXPECT_NEAR(c.screw.roller.first, 0.0763 * per_mm, four_digits);
  EXPECT_NEAR(c.screw.roller.second, 0.1009 * per_mm, four_digits);
  EXPECT_NEAR(c.screw.curvature_sum(), 0.2067 * per_mm, four_digits);
  EXPECT_NEAR(c.nut.body.first, 8.5970e-5 * per_mm, 1e-9 * per_mm);
  EXPECT_NEAR(c.nut.body.second, -0.0178 * per_mm, four_digits);
  EXPECT_NEAR(c.nut.roller.first, 0.0762 * per_mm, four_digits);
  EXPECT_NEAR(c.nut.roller.second, 0.1010 * per_mm, four_digits);
  EXPECT_NEAR(c.nut.curvature_sum(), 0.1595 * per_mm, four_digits);
  EXPECT_NEAR(c.screw.first_directions_angle(), 39.8815 * deg, 6e-5 * deg);
  EXPECT_NEAR(c.nut.first_directions_angle(), 40.0207 * deg, 6e-5 * deg);
  EXPECT_NEAR(c.nut.point.radius_on_body, 40 * mm, 1e-14);
  EXPECT_NEAR(c.nut.point.radius_on_roller, 8 * mm, 1e-14);
}

TEST(InterfaceGeometry, YaoTable1ScrewPointIsNearThePrintedOneWhichDoesNotClose) {
  const ContactPoint p = mechanism_contact(test::yao(), Configuration::i1_j2).screw.point;
  EXPECT_NEAR(p.radius_on_body, 24.1710 * mm, 5e-4 * mm);
  EXPECT_NEAR(p.radius_on_roller, 8.0336 * mm, 1e-3 * mm);
  EXPECT_NEAR(p.angle_on_body, -3.6995 * deg, 0.02 * deg);
  // r_S sin = r_R sin and r_S cos + r_R cos = c at the printed radii and angles [mm].
  const double r_s = 24.1710, r_r = 8.0336, a_s = 3.6995 * deg, a_r = 11.2727 * deg;
  const double gap =
      std::hypot(r_s * std::sin(a_s) - r_r * std::sin(a_r), r_s * std::cos(a_s) + r_r * std::cos(a_r) - 32.0);
  EXPECT_GT(gap, 5e-4);
}

TEST(InterfaceGeometry, YaoTable1ContactWithTheRightEllipticParameter) {
  // Corrected values (errata 1), at the load of the paper, (27) and (28).
  const MechanismContact c = mechanism_contact(test::yao(), Configuration::i1_j2);
  const double modulus = contact_modulus({212 * GPa, 0.29}, {212 * GPa, 0.29});
  const double helix = std::atan(5 / (std::numbers::pi * 16));
  const double theta = std::atan(std::cos(helix));
  const double load = 300.0 / (std::cos(theta) * std::cos(helix));
  EXPECT_NEAR(load, 425.3123, 6e-5);
  struct Row {
    const InterfaceGeometry& g;
    double eccentricity, a, b, delta, printed_stress;
  };
  for (const Row& row :
       {Row{c.screw, 0.651, 0.345, 0.262, 9.14, 2255.8601}, Row{c.nut, 0.613, 0.368, 0.291, 8.40, 1897.4493}}) {
    const HertzConstants h = hertz_constants(row.g.relative.first, row.g.relative.second, modulus);
    const HertzContact contact = at_load(h, load);
    EXPECT_NEAR(std::sqrt(1 - h.ellipticity * h.ellipticity), row.eccentricity, 6e-4);
    EXPECT_NEAR(contact.semi_major, row.a * mm, 6e-4 * mm);
    EXPECT_NEAR(contact.semi_minor, row.b * mm, 6e-4 * mm);
    EXPECT_NEAR(contact.approach, row.delta * um, 6e-3 * um);
    EXPECT_NEAR(contact.peak_pressure / (row.printed_stress * MPa), 1.0, 4e-3);
  }
}

TEST(InterfaceGeometry, YaoTable2Optimum) {
  const MechanismContact c = mechanism_contact(test::yao(42.5388, 40.4725, 40.1249), Configuration::i1_j2);
  ASSERT_TRUE(c.ok());
  EXPECT_NEAR(c.screw.curvature_sum(), 0.1911 * per_mm, 6e-5 * per_mm);
  EXPECT_NEAR(c.nut.curvature_sum(), 0.1464 * per_mm, 6e-5 * per_mm);
  // Points to the closure error of the printed ones only (errata 3).
  EXPECT_NEAR(c.screw.point.radius_on_body, 23.8722 * mm, 0.02 * mm);
  EXPECT_NEAR(c.nut.point.radius_on_roller, 7.9434 * mm, 0.002 * mm);
}

TEST(InterfaceGeometry, EllipseBeyondTheFlankIsNamed) {
  MechanismGeometry m = test::abevi();
  const ThreadPair sharp = screw_pair(m);
  const InterfaceGeometry g = interface_geometry(sharp, RollerFace::top);
  EXPECT_TRUE(ellipse_beyond_flanks(sharp, g, 0.1 * mm, 0.1 * mm).empty());
  // A circle of radius rho reaches rho sqrt(1 - n_x^2) along x, the radial direction here.
  const FlankViolations v = ellipse_beyond_flanks(sharp, g, 0.8 * mm, 0.8 * mm);
  ASSERT_EQ(v.size(), 4u);
  const double reach = 0.8 * mm * std::sqrt(1.0 - std::pow(g.point.normal.x, 2));
  EXPECT_NEAR(v.begin()->by, reach - (10.5 * mm - sharp.body.smallest_radius), 1e-15);
  EXPECT_EQ(v.begin()->end, FlankEnd::root);
  EXPECT_EQ((v.begin() + 1)->end, FlankEnd::crest);
  EXPECT_TRUE((v.begin() + 2)->of_roller);
}

TEST(InterfaceGeometry, AnEllipseGrownToTheNearestEdgeTouchesThatEdgeAlone) {
  for (const MechanismGeometry& m : {test::abevi(), test::sandu_example_1(), test::yao()})
    for (const ThreadPair& pair : {screw_pair(m), nut_pair(m)}) {
      const InterfaceGeometry g = interface_geometry(pair, RollerFace::top);
      ASSERT_TRUE(g.ok());
      const double a = 0.2 * mm, b = 0.1 * mm;
      const FlankEdge edge = nearest_flank_edge(pair, g, a, b);
      const double short_of = edge.scale * (1.0 - 1e-9), beyond = edge.scale * (1.0 + 1e-9);
      EXPECT_TRUE(ellipse_beyond_flanks(pair, g, short_of * a, short_of * b).empty());
      const FlankViolations v = ellipse_beyond_flanks(pair, g, beyond * a, beyond * b);
      ASSERT_GE(v.size(), 1u);
      EXPECT_TRUE(std::any_of(v.begin(), v.end(), [&](const FlankViolation& violation) {
        return violation.of_roller == edge.of_roller && violation.end == edge.end;
      }));
    }
}

TEST(InterfaceGeometry, NoAdmissiblePointLeavesOnlyTheReason) {
  MechanismGeometry m = test::abevi();
  m.roller.profile_curvature = 0.0;
  const InterfaceGeometry g = interface_geometry(screw_pair(m), RollerFace::top);
  EXPECT_FALSE(g.ok());
  EXPECT_EQ(name(g.point.status), "straight_on_straight");
  EXPECT_EQ(g.relative.second, 0.0);
}

}  // namespace
}  // namespace contact
