#include "contact/hertz.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "contact/elliptic_integrals.h"
#include "contact/ellipticity_approximations.h"

namespace contact {

double contact_modulus(const Elasticity& body_1, const Elasticity& body_2) {
  const auto compliance = [](const Elasticity& e) {
    return (1.0 - e.poisson_ratio * e.poisson_ratio) / e.youngs_modulus;
  };
  return 1.0 / (compliance(body_1) + compliance(body_2));
}

std::string_view name(HertzStatus status) {
  constexpr std::string_view kNames[] = {
      "ok", "not_computed", "not_finite", "no_point_contact", "conforming_surface", "no_stiffness"};
  return kNames[static_cast<std::size_t>(status)];
}

double ellipticity(double curvature_ratio) {
  // Newton on ln((b/a)^2 D/B) = ln(ratio) over ln(b/a): nearly a straight line, slope between 1.5
  // (circle) and 2 (line). The residual is the logarithm of a number near 1, so its rounding does
  // not grow with the ratio. A second order step needs no check once the first is below 1e-8.
  double k = std::min(1.0, 1.0 / antoine_ellipticity(1.0 / curvature_ratio));
  for (int i = 0; i < 20; ++i) {
    const EllipticIntegrals e = complete_elliptic_integrals(k);
    const double residual = std::log(k * k * e.d / (e.b * curvature_ratio));
    const double slope = 1.0 + e.c / e.d + k * k * e.c / e.b;
    const double step = residual / slope;
    k = std::min(1.0, k * std::exp(-step));
    if (std::abs(step) < 1e-8) break;
  }
  return k;
}

HertzConstants hertz_constants(double kappa_1, double kappa_2, double contact_modulus) {
  if (kappa_1 > kappa_2) std::swap(kappa_1, kappa_2);
  HertzConstants h;
  if (!std::isfinite(kappa_1) || !std::isfinite(kappa_2) || !std::isfinite(contact_modulus)) {
    h.status = HertzStatus::not_finite;
  } else if (kappa_1 < 0.0) {
    h.status = HertzStatus::conforming_surface;
  } else if (kappa_1 == 0.0) {
    h.status = HertzStatus::no_point_contact;
  } else if (contact_modulus <= 0.0) {
    h.status = HertzStatus::no_stiffness;
  } else {
    constexpr double pi = std::numbers::pi;
    const double k = ellipticity(kappa_1 / kappa_2);
    const EllipticIntegrals e = complete_elliptic_integrals(k);
    h.ellipticity = k;
    h.semi_minor_per_cbrt_load = std::cbrt(3.0 * k * e.b / (pi * kappa_2 * contact_modulus));
    h.semi_major_per_cbrt_load = h.semi_minor_per_cbrt_load / k;
    const double stiffness =
        2.0 * pi * h.semi_major_per_cbrt_load * contact_modulus / (3.0 * e.first);
    h.hertz_constant = stiffness * std::sqrt(stiffness);
    h.status = HertzStatus::ok;
  }
  return h;
}

double HertzContact::pressure(double along_major, double along_minor) const {
  if (normal_load <= 0.0) return 0.0;
  const double x = along_major / semi_major;
  const double y = along_minor / semi_minor;
  return peak_pressure * std::sqrt(std::max(0.0, 1.0 - x * x - y * y));
}

HertzContact at_load(const HertzConstants& constants, double normal_load) {
  HertzContact contact;
  if (normal_load <= 0.0) return contact;
  const double cbrt_load = std::cbrt(normal_load);
  const double cbrt_approach = std::cbrt(normal_load / constants.hertz_constant);
  contact.normal_load = normal_load;
  contact.approach = cbrt_approach * cbrt_approach;
  contact.semi_major = constants.semi_major_per_cbrt_load * cbrt_load;
  contact.semi_minor = constants.semi_minor_per_cbrt_load * cbrt_load;
  contact.peak_pressure =
      1.5 * normal_load / (std::numbers::pi * contact.semi_major * contact.semi_minor);
  return contact;
}

}  // namespace contact
