#pragma once

#include <cmath>
#include <limits>
#include <numbers>

namespace contact {

/// The complete elliptic integrals that an elliptic Hertz contact needs, for one axis ratio
/// k = b/a, that is for the *parameter* m = 1 - k^2 (not the modulus e = sqrt(m)). With
/// w(t)^2 = 1 - m sin(t)^2 and all integrals from 0 to pi/2:
///
///     K = int 1/w,  B = int cos^2/w,  D = int sin^2/w,  C = int sin^2 cos^2/w^3,
///     E = int w = B + k^2 D,  K = B + D,  C = (D - B)/m.
struct EllipticIntegrals {
  double first = 0.0;   ///< K
  double second = 0.0;  ///< E
  double b = 0.0;       ///< B = (E - k^2 K)/m
  double d = 0.0;       ///< D = (K - E)/m
  double c = 0.0;       ///< C = (D - B)/m
};

/// All integrals at once by the arithmetic-geometric mean, for 0 < axis_ratio <= 1. The sums are
/// carried divided by m, so nothing cancels near the circle (m = 0); towards the line (k -> 0) B
/// loses only the factor K/B, which grows like ln(4/k). Relative errors are a few 1e-16 K/B.
inline EllipticIntegrals complete_elliptic_integrals(double axis_ratio) {
  const double k = axis_ratio;
  const double m = (1.0 - k) * (1.0 + k);

  // a, g: arithmetic and geometric mean; c2 = ((a - g)/2)^2 of the step before.
  double a = 0.5 * (1.0 + k);
  double g = std::sqrt(k);
  double c2 = 0.25 * (1.0 - k) * (1.0 - k);
  double term = 0.25 / ((1.0 + k) * (1.0 + k));  // 2^(n-1) c_n^2/m^2
  double sum = term;                             // (E/K of the circle's limit - E/K)/m^2, see D
  while (c2 > std::numeric_limits<double>::epsilon() * a * a) {
    const double mean = 0.5 * (a + g);
    g = std::sqrt(a * g);
    a = mean;
    const double shrink = c2 / (16.0 * a * a);
    c2 *= shrink;
    term *= 2.0 * shrink;
    sum += term;
  }
  const double first = std::numbers::pi / (a + g);
  const double d = first * (0.5 + m * sum);
  const double b = first * (0.5 - m * sum);
  return {first, b + k * k * d, b, d, 2.0 * first * sum};
}

}  // namespace contact
