#pragma once

#include <numbers>

#include "simd/lanes.h"

namespace contact {

using simd::abs, simd::atan2, simd::copysign, simd::fma, simd::hypot, simd::select, simd::sincos, simd::sqrt;

/// Symmetric 2 x 2 tensor in an orthonormal frame of a tangent plane. As a curvature tensor
/// [1/m]: the surface of a body near a point, as depth below the tangent plane at (x, y), is
/// (xx x^2 + 2 xy x y + yy y^2)/2, so convex material is positive.
template <class Real>
struct TensorOf {
  Real xx{};
  Real xy{};
  Real yy{};

  Real trace() const { return xx + yy; }
  Real determinant() const {
    // Kahan's difference of products: accurate also when the two products nearly agree.
    const Real product = xy * xy;
    return fma(xx, yy, -product) + fma(-xy, xy, product);
  }
};
using SymmetricTensor = TensorOf<double>;

template <class Real>
TensorOf<Real> operator+(const TensorOf<Real>& a, const TensorOf<Real>& b) {
  return {a.xx + b.xx, a.xy + b.xy, a.yy + b.yy};
}
template <class Real>
TensorOf<Real> operator*(const std::type_identity_t<Real>& factor, const TensorOf<Real>& t) {
  return {factor * t.xx, factor * t.xy, factor * t.yy};
}

/// The tensor with the second axis reversed: the tangent plane seen from its other side.
template <class Real>
TensorOf<Real> mirrored(const TensorOf<Real>& t) {
  return {t.xx, -t.xy, t.yy};
}

/// The tensor in axes turned by `angle` [rad], first towards second axis.
template <class Real>
TensorOf<Real> in_turned_axes(const TensorOf<Real>& t, const std::type_identity_t<Real>& angle) {
  const Real mean = 0.5 * (t.xx + t.yy);
  const Real difference = 0.5 * (t.xx - t.yy);
  const auto [sine, cosine] = sincos(Real(2.0 * angle));
  const Real d = difference * cosine + t.xy * sine;
  return {mean + d, t.xy * cosine - difference * sine, mean - d};
}

/// Eigenvalues of a symmetric tensor and the direction of the first, as an angle from the first axis [rad] in (-pi/2,
/// pi/2]; the second direction is a quarter turn further.
template <class Real>
struct PrincipalOf {
  Real first{};
  Real second{};
  Real angle{};
};
using PrincipalValues = PrincipalOf<double>;

/// Eigenvalues with first <= second. Closed form; a small eigenvalue next to a large one keeps its digits (product of
/// the eigenvalues = determinant). An isotropic tensor has angle 0.
template <class Real>
PrincipalOf<Real> principal_ascending(const TensorOf<Real>& t) {
  const Real mean = 0.5 * t.trace();
  const Real difference = 0.5 * (t.xx - t.yy);
  const Real radius = hypot(difference, t.xy);
  const auto isotropic = radius == 0.0;
  const Real larger = mean + copysign(radius, mean);  // the larger in absolute value
  const Real smaller = select(isotropic, mean, t.determinant() / larger);
  const Real turned = 0.5 * atan2(t.xy, difference) + 0.5 * std::numbers::pi;
  const Real angle = select(turned > 0.5 * std::numbers::pi, turned - std::numbers::pi, turned);
  const auto ascending = larger > smaller;
  return {select(ascending, smaller, larger), select(ascending, larger, smaller), select(isotropic, Real(0.0), angle)};
}

/// Eigenvalues with |first| <= |second|, the papers' order for one body (Sandu 2018, (B.8)).
template <class Real>
PrincipalOf<Real> principal_by_magnitude(const TensorOf<Real>& t) {
  const PrincipalOf<Real> p = principal_ascending(t);
  const auto swapped = abs(p.first) > abs(p.second);
  const Real quarter = select(p.angle > 0.0, Real(-0.5 * std::numbers::pi), Real(0.5 * std::numbers::pi));
  return {select(swapped, p.second, p.first), select(swapped, p.first, p.second),
          select(swapped, p.angle + quarter, p.angle)};
}

/// First (E, F, G) and second (L, M, N) fundamental form of a surface in parameters u, v; the sign
/// of the second decides the sign of the curvature.
template <class Real>
struct FormsOf {
  Real E{}, F{}, G{};
  Real L{}, M{}, N{};
};
using FundamentalForms = FormsOf<double>;

/// Curvature tensor of the surface in the orthonormal frame whose first axis lies along the u-lines
/// and whose second axis is on the side of growing v: the shape operator I^-1 II (Sandu 2018,
/// (B.4); Yao 2023, (22) corrected) in that frame, where it is symmetric.
template <class Real>
TensorOf<Real> curvature_tensor(const FormsOf<Real>& f) {
  const Real shear = f.F / f.E;           // the v-line = second axis + shear * u-line
  const Real width2 = f.G - shear * f.F;  // squared length of its part along the second axis
  return {f.L / f.E, (f.M - shear * f.L) / sqrt(f.E * width2),
          (f.N - 2.0 * shear * f.M + shear * shear * f.L) / width2};
}

}  // namespace contact
