#pragma once

#include <limits>
#include <numbers>

#include "simd/lanes.h"

namespace contact {

using simd::any, simd::select, simd::sqrt;

/// The complete elliptic integrals that an elliptic Hertz contact needs, for one axis ratio
/// k = b/a, that is for the *parameter* m = 1 - k^2 (not the modulus e = sqrt(m)). With
/// w(t)^2 = 1 - m sin(t)^2 and all integrals from 0 to pi/2:
///
///     K = int 1/w,  B = int cos^2/w,  D = int sin^2/w,  C = int sin^2 cos^2/w^3,
///     E = int w = B + k^2 D,  K = B + D,  C = (D - B)/m.
template <class Real>
struct EllipticIntegralsOf {
  Real first{};   ///< K
  Real second{};  ///< E
  Real b{};       ///< B = (E - k^2 K)/m
  Real d{};       ///< D = (K - E)/m
  Real c{};       ///< C = (D - B)/m
};
using EllipticIntegrals = EllipticIntegralsOf<double>;

/// All integrals at once by the arithmetic-geometric mean, for 0 < axis_ratio <= 1. The sums are
/// carried divided by m, so nothing cancels near the circle (m = 0); towards the line (k -> 0) B
/// loses only the factor K/B, which grows like ln(4/k). Relative errors are a few 1e-16 K/B.
template <class Real>
EllipticIntegralsOf<Real> complete_elliptic_integrals(const Real& axis_ratio) {
  const Real k = axis_ratio;
  const Real m = (1.0 - k) * (1.0 + k);

  // a, g: arithmetic and geometric mean; c2 = ((a - g)/2)^2 of the step before.
  Real a = 0.5 * (1.0 + k);
  Real g = sqrt(k);
  Real c2 = 0.25 * (1.0 - k) * (1.0 - k);
  Real term = 0.25 / ((1.0 + k) * (1.0 + k));  // 2^(n-1) c_n^2/m^2
  Real sum = term;                             // (E/K of the circle's limit - E/K)/m^2, see D
  const auto apart = [&] { return c2 > std::numeric_limits<double>::epsilon() * a * a; };
  // What has converged stays as it is, whatever its neighbours in a batch do.
  for (auto active = apart(); any(active); active = active && apart()) {
    const auto next = [&](Real& x, const Real& value) { x = select(active, value, x); };
    const Real mean = 0.5 * (a + g);
    next(g, sqrt(Real(a * g)));
    next(a, mean);
    const Real shrink = c2 / (16.0 * a * a);
    next(c2, c2 * shrink);
    next(term, term * (2.0 * shrink));
    next(sum, sum + term);
  }
  const Real first = std::numbers::pi / (a + g);
  const Real d = first * (0.5 + m * sum);
  const Real b = first * (0.5 - m * sum);
  return {first, b + k * k * d, b, d, 2.0 * first * sum};
}

}  // namespace contact
