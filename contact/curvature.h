#pragma once

#include <cmath>
#include <numbers>
#include <utility>

namespace contact {

/// Symmetric 2 x 2 tensor in an orthonormal frame of a tangent plane. As a curvature tensor
/// [1/m]: the surface of a body near a point, as depth below the tangent plane at (x, y), is
/// (xx x^2 + 2 xy x y + yy y^2)/2, so convex material is positive.
struct SymmetricTensor {
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;

  double trace() const { return xx + yy; }
  double determinant() const {
    // Kahan's difference of products: accurate also when the two products nearly agree.
    const double product = xy * xy;
    return std::fma(xx, yy, -product) + std::fma(-xy, xy, product);
  }
};

inline SymmetricTensor operator+(const SymmetricTensor& a, const SymmetricTensor& b) {
  return {a.xx + b.xx, a.xy + b.xy, a.yy + b.yy};
}
inline SymmetricTensor operator*(double factor, const SymmetricTensor& t) {
  return {factor * t.xx, factor * t.xy, factor * t.yy};
}

/// The same tensor when the second axis is reversed: the tangent plane seen from its other side.
inline SymmetricTensor mirrored(const SymmetricTensor& t) { return {t.xx, -t.xy, t.yy}; }

/// The same tensor in axes turned by `angle` [rad] from the old ones, first towards second axis.
inline SymmetricTensor in_turned_axes(const SymmetricTensor& t, double angle) {
  const double mean = 0.5 * (t.xx + t.yy);
  const double difference = 0.5 * (t.xx - t.yy);
  const double cosine = std::cos(2.0 * angle), sine = std::sin(2.0 * angle);
  const double d = difference * cosine + t.xy * sine;
  return {mean + d, t.xy * cosine - difference * sine, mean - d};
}

/// Eigenvalues of a symmetric tensor and the direction of the first, as an angle from the first
/// axis [rad] in (-pi/2, pi/2]; the second direction stands a quarter turn further.
struct PrincipalValues {
  double first = 0.0;
  double second = 0.0;
  double angle = 0.0;
};

/// first <= second. Closed form; a small eigenvalue next to a large one keeps its digits (product
/// of the eigenvalues = determinant). An isotropic tensor has angle 0.
inline PrincipalValues principal_ascending(const SymmetricTensor& t) {
  const double mean = 0.5 * t.trace();
  const double difference = 0.5 * (t.xx - t.yy);
  const double radius = std::hypot(difference, t.xy);
  if (radius == 0.0) return {mean, mean, 0.0};
  const double larger = mean + std::copysign(radius, mean);  // in absolute value
  const double smaller = t.determinant() / larger;
  double angle = 0.5 * std::atan2(t.xy, difference) + 0.5 * std::numbers::pi;
  if (angle > 0.5 * std::numbers::pi) angle -= std::numbers::pi;
  return larger > smaller ? PrincipalValues{smaller, larger, angle}
                          : PrincipalValues{larger, smaller, angle};
}

/// |first| <= |second|, the papers' order for one body (Sandu 2018, (B.8)).
inline PrincipalValues principal_by_magnitude(const SymmetricTensor& t) {
  PrincipalValues p = principal_ascending(t);
  if (std::abs(p.first) > std::abs(p.second)) {
    std::swap(p.first, p.second);
    p.angle += p.angle > 0.0 ? -0.5 * std::numbers::pi : 0.5 * std::numbers::pi;
  }
  return p;
}

/// First (E, F, G) and second (L, M, N) fundamental form of a surface in parameters u, v; the sign
/// of the second decides the sign of the curvature.
struct FundamentalForms {
  double E = 0.0, F = 0.0, G = 0.0;
  double L = 0.0, M = 0.0, N = 0.0;
};

/// Curvature tensor of the surface in the orthonormal frame whose first axis lies along the u-lines
/// and whose second axis is on the side of growing v: the shape operator I^-1 II (Sandu 2018,
/// (B.4); Yao 2023, (22) corrected) in that frame, where it is symmetric.
inline SymmetricTensor curvature_tensor(const FundamentalForms& f) {
  const double shear = f.F / f.E;           // the v-line = second axis + shear * u-line
  const double width2 = f.G - shear * f.F;  // squared length of its part along the second axis
  return {f.L / f.E, (f.M - shear * f.L) / std::sqrt(f.E * width2),
          (f.N - 2.0 * shear * f.M + shear * shear * f.L) / width2};
}

}  // namespace contact
