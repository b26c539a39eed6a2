#pragma once

#include <limits>

#include "contact/curvature.h"
#include "contact/hertz.h"

/// Hertz's constants: one set of formulas for numbers and for batches, one design per lane.
namespace contact {

using simd::any, simd::cbrt, simd::exp, simd::log, simd::log10, simd::max, simd::min;

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
  Real sum = term;                             // (1 - m/2 - E/K)/m^2
  const auto apart = [&] { return c2 > std::numeric_limits<double>::epsilon() * a * a; };
  // Converged lanes stay unchanged, whatever their neighbours in a batch do.
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
  const Real numerator = 1.0 + y * (0.40227436 + y * (3.7491752e-2 + y * (7.4855761e-4 + y * 2.1667028e-6)));
  const Real denominator = 1.0 + y * (0.42678878 + y * (4.2605401e-2 + y * (9.0786922e-4 + y * 2.7868927e-6)));
  return exp(Real(2.0 / 3.0 * numerator / denominator * x * std::numbers::ln10));
}

template <class Real>
Real ellipticity_of(const Real& curvature_ratio) {
  // Newton on ln((b/a)^2 D/B) = ln(ratio) over ln(b/a): nearly a straight line, slope between 1.5
  // (circle) and 2 (line). The residual is the logarithm of a number near 1, so its rounding does
  // not grow with the ratio. The error after a step is about its square: one below 1e-8 is the last.
  Real k = min(Real(1.0), Real(1.0 / antoine_ellipticity(Real(1.0 / curvature_ratio))));
  auto active = curvature_ratio > 0.0;
  for (int i = 0; i < 20 && any(active); ++i) {
    const EllipticIntegralsOf<Real> e = complete_elliptic_integrals(k);
    const Real residual = log(Real(k * k * e.d / (e.b * curvature_ratio)));
    const Real slope = 1.0 + e.c / e.d + k * k * e.c / e.b;
    const Real step = residual / slope;
    k = select(active, min(Real(1.0), Real(k * exp(Real(-step)))), k);
    active = active && !(abs(step) < 1e-8);
  }
  return k;
}

template <class Real>
HertzConstantsOf<Real> hertz_constants(const PrincipalOf<Real>& relative, const Real& contact_modulus) {
  using Status = simd::EnumOf<HertzStatus, Real>;
  using enum HertzStatus;
  constexpr double pi = std::numbers::pi;
  const Real kappa_1 = min(relative.first, relative.second);
  const Real kappa_2 = max(relative.first, relative.second);
  const auto finite =
      (relative.first - relative.first) + (relative.second - relative.second) + (contact_modulus - contact_modulus) ==
      0.0;
  HertzConstantsOf<Real> h;
  h.status = select(contact_modulus > 0.0, Status(ok), Status(no_stiffness));
  h.status = select(kappa_1 == 0.0, Status(no_point_contact), h.status);
  h.status = select(kappa_1 < 0.0, Status(conforming_surface), h.status);
  h.status = select(finite, h.status, Status(not_finite));
  const auto sound = h.ok();
  if (!any(sound)) return h;

  const Real k = ellipticity_of(Real(select(sound, Real(kappa_1 / kappa_2), Real(1.0))));
  const EllipticIntegralsOf<Real> e = complete_elliptic_integrals(k);
  const Real semi_minor = cbrt(Real(3.0 * k * e.b / (pi * kappa_2 * contact_modulus)));
  const Real semi_major = semi_minor / k;
  const Real stiffness = 2.0 * pi * semi_major * contact_modulus / (3.0 * e.first);
  const auto where_sound = [&](const Real& value) { return select(sound, value, Real(0.0)); };
  h.ellipticity = where_sound(k);
  const Real cbrt_constant = sqrt(stiffness);
  h.hertz_constant = where_sound(stiffness * cbrt_constant);
  h.cbrt_constant = where_sound(cbrt_constant);
  h.semi_major_per_cbrt_load = where_sound(semi_major);
  h.semi_minor_per_cbrt_load = where_sound(semi_minor);
  return h;
}

/// Numbers of `HertzContact` that do not need the Hertz constant.
template <class Real>
struct EllipseNumbers {
  Real semi_major{}, semi_minor{}, peak_pressure{};
};

/// Semi-axes and pressure under a load with known cube root; zero if the contact is open.
template <class Real>
EllipseNumbers<Real> ellipse_numbers(const Real& semi_major_per_cbrt_load, const Real& semi_minor_per_cbrt_load,
                                     const Real& normal_load, const Real& cbrt_load) {
  const auto loaded = normal_load > 0.0;
  const Real a = semi_major_per_cbrt_load * cbrt_load, b = semi_minor_per_cbrt_load * cbrt_load;
  const auto where_loaded = [&](const Real& value) { return select(loaded, value, Real(0.0)); };
  return {where_loaded(a), where_loaded(b), where_loaded(1.5 * normal_load / (std::numbers::pi * a * b))};
}

}  // namespace contact
