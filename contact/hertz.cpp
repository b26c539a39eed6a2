#include "contact/hertz.h"

#include <algorithm>

#include "contact/hertz_formulas.h"

namespace contact {

double compliance(const Elasticity& body) {
  return (1.0 - body.poisson_ratio * body.poisson_ratio) / body.youngs_modulus;
}

double contact_modulus(const Elasticity& body_1, const Elasticity& body_2) {
  return 1.0 / (compliance(body_1) + compliance(body_2));
}

std::string_view name(HertzStatus status) {
  constexpr std::string_view kNames[] = {
      "ok", "not_computed", "not_finite", "no_point_contact", "conforming_surface", "no_stiffness"};
  return kNames[static_cast<std::size_t>(status)];
}

double ellipticity(double curvature_ratio) { return ellipticity_of(curvature_ratio); }

HertzConstants hertz_constants(double kappa_1, double kappa_2, double contact_modulus) {
  return hertz_constants(PrincipalValues{kappa_1, kappa_2, 0.0}, contact_modulus);
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
  const double cbrt_approach = std::cbrt(normal_load / constants.hertz_constant);
  const EllipseNumbers<double> ellipse =
      ellipse_numbers(constants.semi_major_per_cbrt_load, constants.semi_minor_per_cbrt_load,
                      normal_load, std::cbrt(normal_load));
  contact.normal_load = normal_load;
  contact.approach = cbrt_approach * cbrt_approach;
  contact.semi_major = ellipse.semi_major;
  contact.semi_minor = ellipse.semi_minor;
  contact.peak_pressure = ellipse.peak_pressure;
  return contact;
}

}  // namespace contact
