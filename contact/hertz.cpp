#include "contact/hertz.h"

#include <algorithm>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/tools/minima.hpp>

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

HertzContact at_load(const HertzConstants& constants, double normal_load) {
  HertzContact contact;
  if (normal_load <= 0.0) return contact;
  const double cbrt_approach = std::cbrt(normal_load / constants.hertz_constant);
  const EllipseNumbers<double> ellipse = ellipse_numbers(
      constants.semi_major_per_cbrt_load, constants.semi_minor_per_cbrt_load, normal_load, std::cbrt(normal_load));
  contact.normal_load = normal_load;
  contact.approach = cbrt_approach * cbrt_approach;
  contact.semi_major = ellipse.semi_major;
  contact.semi_minor = ellipse.semi_minor;
  contact.peak_pressure = ellipse.peak_pressure;
  return contact;
}

double AxisStress::largest_shear() const {
  const auto [smallest, largest] = std::minmax({along_major, along_minor, along_normal});
  return 0.5 * (largest - smallest);
}

AxisStress stress_on_axis(double semi_major, double semi_minor, double depth, double poisson_ratio) {
  const double a2 = semi_major * semi_major, b2 = semi_minor * semi_minor, z2 = depth * depth;
  const double a_outer = std::sqrt(a2 + z2), b_outer = std::sqrt(b2 + z2);
  const double ab = semi_major * semi_minor;

  // Carlson's R_D(x, y, s) = 3/2 int_0^inf dt/((t + s) sqrt((t + x)(t + y)(t + s))), t = w - z^2.
  using boost::math::ellint_rd;
  const double z_ia = 2.0 / 3.0 * depth * ellint_rd(z2, b2 + z2, a2 + z2);
  const double z_ib = 2.0 / 3.0 * depth * ellint_rd(z2, a2 + z2, b2 + z2);
  const double z_iz = 2.0 / (a_outer * b_outer) - z_ia - z_ib;

  const double nu = poisson_ratio;
  const double sum = a_outer + b_outer;
  return {
      ab * ((1.0 - nu) * z_ia - nu * z_iz - (1.0 - 2.0 * nu) / (a_outer * sum)),
      ab * ((1.0 - nu) * z_ib - nu * z_iz - (1.0 - 2.0 * nu) / (b_outer * sum)),
      -ab / (a_outer * b_outer),
  };
}

double AxisStress::von_mises() const {
  const double x = along_major - along_minor, y = along_minor - along_normal, z = along_normal - along_major;
  return std::sqrt(0.5 * (x * x + y * y + z * z));
}

namespace {

/// Largest value over p_0 of a stress on the normal, and its depth over b.
template <class Stress>
std::pair<double, double> largest_on_axis(double ellipticity, double poisson_ratio, Stress stress) {
  const auto at = [&](double depth) { return stress(stress_on_axis(1.0 / ellipticity, 1.0, depth, poisson_ratio)); };
  // The curve is smooth except for a kink where the largest stress changes direction, and may have a second maximum
  // near the surface: samples everywhere, then a refinement of the best place.
  constexpr int kSamples = 12;
  constexpr double kSpacing = 1.2 / kSamples;  // of z/b
  std::pair<double, double> best{at(0.0), 0.0};
  for (int i = 1; i <= kSamples; ++i) {
    const double depth = i * kSpacing;
    if (const double there = at(depth); there > best.first) best = {there, depth};
  }
  const auto [depth, minus_stress] =
      boost::math::tools::brent_find_minima([&](double z) { return -at(z); }, std::max(0.0, best.second - kSpacing),
                                            best.second + kSpacing, std::numeric_limits<double>::digits / 2);
  return -minus_stress > best.first ? std::pair(-minus_stress, depth) : best;
}

}  // namespace

SubsurfaceShear largest_subsurface_shear(double ellipticity, double poisson_ratio) {
  const auto [stress, depth] =
      largest_on_axis(ellipticity, poisson_ratio, [](const AxisStress& s) { return s.largest_shear(); });
  return {stress, depth};
}

SubsurfaceVonMises largest_subsurface_von_mises(double ellipticity, double poisson_ratio) {
  const auto [stress, depth] =
      largest_on_axis(ellipticity, poisson_ratio, [](const AxisStress& s) { return s.von_mises(); });
  return {stress, depth};
}

}  // namespace contact
