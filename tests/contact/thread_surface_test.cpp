#include "contact/thread_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "contact/hertz.h"
#include "support/plain_contact.h"
#include "tests/contact/units.h"

namespace contact {
namespace {

using std::numbers::pi;

Thread external(double radius, double lead, double pitch, double profile_curvature = 0.0) {
  return {.pitch_radius = radius,
          .lead = lead,
          .pitch = pitch,
          .flank_angle = 45 * deg,
          .profile_curvature = profile_curvature};
}

Thread nut(double radius, double lead, double pitch, double profile_curvature = 0.0) {
  Thread t = external(radius, lead, pitch, profile_curvature);
  t.internal = true;
  return t;
}

// Sandu 2018, table 1.6, example 1 (mm).
const Thread kScrew = external(15 * mm, 10 * mm, 2 * mm);
const Thread kRoller = external(5 * mm, 2 * mm, 2 * mm, std::sin(45 * deg) / (5 * mm));
const Thread kNut = nut(25 * mm, 10 * mm, 2 * mm);

TEST(ThreadSurface, ProfileRisesAQuarterPitchToThePitchRadius) {
  for (const Thread& t : {kScrew, kRoller, kNut, external(5 * mm, -2 * mm, 2 * mm, -1.0 / (9 * mm))}) {
    const ThreadSurface s(t);
    EXPECT_NEAR(s.profile(t.pitch_radius).height, 0.25 * t.pitch, 1e-18);
    EXPECT_NEAR(s.profile(s.smallest_radius).height, 0.0, 1e-17);
    EXPECT_NEAR(s.profile(s.largest_radius).height, 0.5 * t.pitch, 1e-17);
  }
}

TEST(ThreadSurface, ArcHasItsRadiusAndFlankAngleInItsPlane) {
  // Distance from the centre x_C = r_T - r_B sin(alpha), z'_C = K + r_B cos(alpha) (convex); the
  // radius need not be r_T/sin(alpha) (errata to (1.7)).
  for (const ProfilePlane plane : {ProfilePlane::normal, ProfilePlane::axial}) {
    Thread t = external(5 * mm, 2 * mm, 2 * mm, 1.0 / (6 * mm));
    t.plane = plane;
    const ThreadSurface s(t);
    const double cos_beta = plane == ProfilePlane::normal ? std::cos(s.helix_angle()) : 1.0;
    const double x_c = (5 - 6 * std::sin(45 * deg)) * mm;
    const double z_c = 0.5 * mm * cos_beta + 6 * mm * std::cos(45 * deg);
    for (double r = 4.6 * mm; r < 5.4 * mm; r += 0.1 * mm) {
      const double z = s.profile(r).height * cos_beta;
      EXPECT_NEAR(std::hypot(r - x_c, z - z_c), 6 * mm, 1e-17);
    }
    EXPECT_NEAR(s.profile(5 * mm).slope * cos_beta, 1.0, 1e-15);
  }
}

TEST(ThreadSurface, SlopesAreDerivativesOfTheHeight) {
  for (const double curvature : {0.0, 0.1414 * per_mm, -0.1 * per_mm}) {
    const ThreadSurface s(external(5 * mm, 2 * mm, 2 * mm, curvature));
    const double r = 5.2 * mm, h = 1e-4 * mm;
    EXPECT_NEAR((s.profile(r + h).height - s.profile(r - h).height) / (2 * h), s.profile(r).slope, 1e-8);
    EXPECT_NEAR((s.profile(r + h).slope - s.profile(r - h).slope) / (2 * h), s.profile(r).slope_rate, 1e-4);
  }
}

TEST(ThreadSurface, SharpLimitsAreThosePrinted) {
  // Sandu 2018, table 1.6, examples 1 to 3 [mm], rounded to 1e-4.
  const double tolerance = 0.6e-4 * mm;
  const auto expect = [&](const Thread& t, double smallest, double largest) {
    EXPECT_NEAR(sharp_limits(t).smallest, smallest * mm, tolerance);
    EXPECT_NEAR(sharp_limits(t).largest, largest * mm, tolerance);
  };
  expect(kScrew, 14.5028, 15.4972);
  expect(kRoller, 4.4453, 5.4535);
  expect(kNut, 24.5010, 25.4990);
  expect(external(15 * mm, 10 * mm, 5 * mm), 13.7570, 16.2430);
  expect(external(7.5 * mm, -5 * mm, 5 * mm, 0.0471 * per_mm), 6.1443, 8.6477);
  expect(nut(30.1265 * mm, 10 * mm, 5 * mm), 28.8783, 31.3748);
  const auto example_3 = [](Thread t) {
    t.flank_angle = 68.21 * deg;
    return t;
  };
  expect(example_3(external(9.75 * mm, 10 * mm, 2 * mm)), 9.5527, 9.9473);
  expect(example_3(external(3.25 * mm, 2 * mm, 2 * mm, 0.2857 * per_mm)), 3.0036, 3.4070);
  expect(example_3(nut(16.25 * mm, 10 * mm, 2 * mm)), 16.0511, 16.4489);
}

TEST(ThreadSurface, AxialPlaneLimitsUseAQuarterOfTheAxialPitch) {
  Thread t = external(15 * mm, 10 * mm, 2 * mm);
  t.plane = ProfilePlane::axial;
  EXPECT_NEAR(sharp_limits(t).smallest, 14.5 * mm, 1e-17);
  EXPECT_NEAR(sharp_limits(t).largest, 15.5 * mm, 1e-17);
}

TEST(ThreadSurface, TruncationPointsOutwardsForAScrewAndInwardsForANut) {
  Thread screw = kScrew, internal = kNut;
  screw.addendum = internal.addendum = 0.2 * mm;
  screw.dedendum = internal.dedendum = 0.3 * mm;
  EXPECT_NEAR(flank_limits(screw).largest, 15.2 * mm, 1e-17);
  EXPECT_NEAR(flank_limits(screw).smallest, 14.7 * mm, 1e-17);
  EXPECT_NEAR(flank_limits(internal).smallest, 24.8 * mm, 1e-17);
  EXPECT_NEAR(flank_limits(internal).largest, 25.3 * mm, 1e-17);
}

TEST(ThreadSurface, StronglyCurvedArcEndsWhereItTurnsRadialOrAxial) {
  // A convex arc of 0.8 mm around a 45 degree flank with K = 0.5 mm reaches neither root nor crest.
  const ThreadSurface s(external(5 * mm, 0.0, 2 * mm, 1.0 / (0.8 * mm)));
  EXPECT_NEAR(s.sin_local_flank(s.smallest_radius), 0.0, 1e-12);
  EXPECT_LE(s.sin_local_flank(s.largest_radius), 1.0);
  EXPECT_NEAR(s.profile(s.largest_radius * (1 - 1e-12)).height, 1.0 * mm, 1e-8);
}

TEST(ThreadSurface, ThicknessOpensAnExternalGrooveAndFillsANuts) {
  Thread screw = kScrew, internal = kNut;
  screw.thickness = internal.thickness = 0.8 * mm;
  EXPECT_NEAR(ThreadSurface(screw).half_groove, 0.6 * mm, 1e-18);
  EXPECT_NEAR(ThreadSurface(internal).half_groove, 0.4 * mm, 1e-18);
}

TEST(ThreadCurvature, HelicoidHasItsClosedFormGaussianAndMeanCurvature) {
  // For z = f(r) + L theta, W^2 = 1 + f'^2 + L^2/r^2:
  //   K = (r^3 f' f'' - L^2)/(r^4 W^4),
  //   2 H W^3 = f'' (1 + L^2/r^2) + f' (1 + f'^2 + 2 L^2/r^2)/r.
  for (const Thread& t : {kScrew, kRoller, external(5 * mm, -2 * mm, 2 * mm, -1.0 / (9 * mm))}) {
    const ThreadSurface s(t);
    const double r = 1.02 * t.pitch_radius, l = s.reduced_lead;
    const ProfilePoint f = s.profile(r);
    const double w2 = 1.0 + f.slope * f.slope + l * l / (r * r);
    const double gaussian = (r * r * r * f.slope * f.slope_rate - l * l) / (r * r * r * r * w2 * w2);
    const double mean =
        (f.slope_rate * (1.0 + l * l / (r * r)) + f.slope * (1.0 + f.slope * f.slope + 2.0 * l * l / (r * r)) / r) /
        (2.0 * w2 * std::sqrt(w2));
    const SymmetricTensor tensor = curvature_tensor(s, r);
    EXPECT_NEAR(tensor.determinant() / gaussian, 1.0, 1e-13);
    EXPECT_NEAR(0.5 * tensor.trace() / mean, 1.0, 1e-13);
  }
}

TEST(ThreadCurvature, MinimalHelicoidHasNoMeanCurvature) {
  // A flank perpendicular to the axis is the classical helicoid: H = 0, K = -L^2/(r^2 + L^2)^2.
  Thread t = external(5 * mm, 20 * mm, 2 * mm);
  t.flank_angle = 1e-12;
  const ThreadSurface s(t);
  const SymmetricTensor tensor = curvature_tensor(s, 5 * mm);
  const double l = s.reduced_lead, r = 5 * mm;
  EXPECT_NEAR(tensor.trace(), 0.0, 1e-8);
  EXPECT_NEAR(tensor.determinant() * std::pow(r * r + l * l, 2) / (-l * l), 1.0, 1e-12);
}

TEST(ThreadCurvature, RingsOfAnAxialProfileAreSurfacesOfRevolution) {
  // Zero lead: curvature of the meridian arc, and Meusnier across it.
  Thread t = external(5 * mm, 0.0, 2 * mm, 1.0 / (6 * mm));
  const ThreadSurface s(t);
  const double r = 5.1 * mm;
  const SymmetricTensor tensor = curvature_tensor(s, r);
  EXPECT_NEAR(tensor.yy, 1.0 / (6 * mm), 1e-10);
  EXPECT_NEAR(tensor.xx, s.sin_local_flank(r) / r, 1e-10);
  EXPECT_NEAR(tensor.xy, 0.0, 1e-12);
}

TEST(ThreadCurvature, RollerOfTableB2) {
  // Sandu 2018, table B.2: 0.1289 and 0.1542 /mm at r = 5.0178 mm.
  const PrincipalValues p = principal_by_magnitude(curvature_tensor(ThreadSurface(kRoller), 5.0178 * mm));
  EXPECT_NEAR(p.first, 0.1289 * per_mm, 0.6e-4 * per_mm);
  EXPECT_NEAR(p.second, 0.1542 * per_mm, 0.6e-4 * per_mm);
}

TEST(ThreadCurvature, NutMaterialIsTheOppositeOfItsAir) {
  const ThreadSurface air_like(external(25 * mm, 10 * mm, 2 * mm));
  const SymmetricTensor air = curvature_tensor(air_like, 25 * mm);
  const SymmetricTensor material = curvature_tensor(ThreadSurface(kNut), 25 * mm);
  EXPECT_EQ(material.xx, -air.xx);
  EXPECT_EQ(material.xy, -air.xy);
  EXPECT_EQ(material.yy, -air.yy);
}

}  // namespace
}  // namespace contact
