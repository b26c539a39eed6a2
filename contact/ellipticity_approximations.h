#pragma once

#include <cmath>
#include <numbers>

#include "simd/lanes.h"

namespace contact {

using simd::exp, simd::log10;

// Published fits of the ellipticity ratio a/b >= 1 to the ratio q = kappa_2/kappa_1 >= 1 of the
// relative curvatures (Sandu 2018, table 1.5), for comparison with `ellipticity`, which is exact;
// Antoine's is also where that one starts. Errors of a/b at q = 1.5, 10, 1000 are given with each.

/// a/b = 1.03 q^0.64 (Hamrock & Dowson): +1.9 %, -0.1 %, +26 %; +3 % at the circle.
inline double hamrock_dowson_ellipticity(double q) { return 1.03 * std::pow(q, 0.64); }

/// a/b = q^(2/pi) (Hamrock & Brewe), Sandu's choice: -1.2 %, -3.7 %, +20 %.
inline double hamrock_brewe_ellipticity(double q) { return std::pow(q, 2.0 / std::numbers::pi); }

/// a/b = q^(2/3) (Johnson), the tangent at the circle: +0.02 %, +3.2 %, +47 %.
inline double johnson_ellipticity(double q) { return std::pow(q, 2.0 / 3.0); }

/// a/b = q^gamma(q) with a rational function gamma of X = log10(q) (Antoine et al.; Sandu 2018,
/// (1.75), (1.76)): within 6e-6 for q <= 1e6.
template <class Real>
Real antoine_ellipticity(const Real& q) {
  const Real x = log10(q);
  const Real y = x * x;
  const Real numerator =
      1.0 + y * (0.40227436 + y * (3.7491752e-2 + y * (7.4855761e-4 + y * 2.1667028e-6)));
  const Real denominator =
      1.0 + y * (0.42678878 + y * (4.2605401e-2 + y * (9.0786922e-4 + y * 2.7868927e-6)));
  return exp(Real(2.0 / 3.0 * numerator / denominator * x * std::numbers::ln10));
}

}  // namespace contact
