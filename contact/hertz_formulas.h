#pragma once

#include <limits>
#include <numbers>

#include "contact/curvature.h"
#include "contact/elliptic_integrals.h"
#include "contact/ellipticity_approximations.h"
#include "contact/hertz.h"

/// Hertz's constants: one set of formulas for numbers and for batches, one design per lane.
namespace contact {

using simd::any, simd::cbrt, simd::exp, simd::log, simd::max, simd::min;

/// Numbers of `HertzConstants`.
template <class Real>
struct HertzNumbers {
  Real status{};  ///< `HertzStatus` as a number.
  Real ellipticity{};
  Real hertz_constant{};
  Real cbrt_constant{};  ///< k_0^(1/3) [N^(1/3)/m^(1/2)]
  Real semi_major_per_cbrt_load{};
  Real semi_minor_per_cbrt_load{};
};

template <class Real>
Real ellipticity_of(const Real& curvature_ratio) {
  // Newton on ln((b/a)^2 D/B) = ln(ratio) over ln(b/a): nearly a straight line, slope between 1.5
  // (circle) and 2 (line). The residual is the logarithm of a number near 1, so its rounding does
  // not grow with the ratio. A second order step needs no check once the first is below 1e-8.
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
HertzNumbers<Real> hertz_numbers(const PrincipalOf<Real>& relative, const Real& contact_modulus) {
  using enum HertzStatus;
  const auto code = [](HertzStatus status) { return Real(static_cast<double>(status)); };
  constexpr double pi = std::numbers::pi;
  const Real kappa_1 = min(relative.first, relative.second);
  const Real kappa_2 = max(relative.first, relative.second);
  const auto finite = (relative.first - relative.first) + (relative.second - relative.second) +
                          (contact_modulus - contact_modulus) ==
                      0.0;
  HertzNumbers<Real> h;
  h.status = select(contact_modulus > 0.0, code(ok), code(no_stiffness));
  h.status = select(kappa_1 == 0.0, code(no_point_contact), h.status);
  h.status = select(kappa_1 < 0.0, code(conforming_surface), h.status);
  h.status = select(finite, h.status, code(not_finite));
  const auto sound = h.status == code(ok);
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

/// Semi-axes and pressure under a load, of which the cube root is known; zero where it is open.
template <class Real>
EllipseNumbers<Real> ellipse_numbers(const Real& semi_major_per_cbrt_load,
                                     const Real& semi_minor_per_cbrt_load, const Real& normal_load,
                                     const Real& cbrt_load) {
  const auto loaded = normal_load > 0.0;
  const Real a = semi_major_per_cbrt_load * cbrt_load, b = semi_minor_per_cbrt_load * cbrt_load;
  const auto where_loaded = [&](const Real& value) { return select(loaded, value, Real(0.0)); };
  return {where_loaded(a), where_loaded(b),
          where_loaded(1.5 * normal_load / (std::numbers::pi * a * b))};
}

}  // namespace contact
