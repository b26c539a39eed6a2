#include "contact/curvature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace contact {
namespace {

using std::numbers::pi;

TEST(SymmetricTensor, TurningKeepsTraceAndDeterminant) {
  const SymmetricTensor t{3.0, -1.2, 0.7};
  for (double angle = -3.0; angle < 3.0; angle += 0.37) {
    const SymmetricTensor u = in_turned_axes(t, angle);
    EXPECT_NEAR(u.trace(), t.trace(), 1e-14);
    EXPECT_NEAR(u.determinant(), t.determinant(), 1e-14);
    const SymmetricTensor back = in_turned_axes(u, -angle);
    EXPECT_NEAR(back.xx, t.xx, 1e-14);
    EXPECT_NEAR(back.xy, t.xy, 1e-14);
  }
  const SymmetricTensor quarter = in_turned_axes(t, 0.5 * pi);
  EXPECT_NEAR(quarter.xx, t.yy, 1e-15);
  EXPECT_NEAR(quarter.xy, -t.xy, 1e-15);
}

TEST(SymmetricTensor, PrincipalDirectionsDiagonaliseIt) {
  for (const SymmetricTensor& t : {SymmetricTensor{3, -1.2, 0.7}, SymmetricTensor{-3, 2, -5}, SymmetricTensor{1, 0, -4},
                                   SymmetricTensor{0, 1, 0}, SymmetricTensor{2, 0, 2}, SymmetricTensor{0, 0, 0}}) {
    for (const PrincipalValues& p : {principal_ascending(t), principal_by_magnitude(t)}) {
      const SymmetricTensor d = in_turned_axes(t, p.angle);
      EXPECT_NEAR(d.xx, p.first, 1e-14);
      EXPECT_NEAR(d.yy, p.second, 1e-14);
      EXPECT_NEAR(d.xy, 0.0, 1e-14);
      EXPECT_GT(p.angle, -0.5 * pi - 1e-15);
      EXPECT_LE(p.angle, 0.5 * pi + 1e-15);
    }
    EXPECT_LE(principal_ascending(t).first, principal_ascending(t).second);
    EXPECT_LE(std::abs(principal_by_magnitude(t).first), std::abs(principal_by_magnitude(t).second));
  }
}

TEST(SymmetricTensor, SmallEigenvalueKeepsItsDigits) {
  const double small = 1e-9;
  const SymmetricTensor t{1.0, 1e-5, small + 1e-10};  // determinant = small exactly
  EXPECT_NEAR(principal_ascending(t).first / small, 1.0, 1e-6);
  const double second = principal_ascending(t).second;
  EXPECT_NEAR(principal_ascending(t).first * second / small, 1.0, 1e-12);
}

TEST(CurvatureTensor, TorusHasItsTwoRadii) {
  // Outer equator of a torus (R + r cos v, r sin v), parameters (u, v) skewed: u = u', v = v' + s
  // u'.
  const double big = 5.0, r = 2.0, s = 0.8, radius = big + r;
  const FundamentalForms f{
      .E = radius * radius + s * s * r * r, .F = s * r * r, .G = r * r, .L = radius + s * s * r, .M = s * r, .N = r};
  const PrincipalValues p = principal_ascending(curvature_tensor(f));
  EXPECT_NEAR(p.first, 1.0 / radius, 1e-15);
  EXPECT_NEAR(p.second, 1.0 / r, 1e-15);
  // The u-line leaves the equator by atan(s r/radius) towards +v; the equator is the direction of
  // the first curvature.
  EXPECT_NEAR(p.angle, -std::atan2(s * r, radius), 1e-15);
}

}  // namespace
}  // namespace contact
