#pragma once

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "contact/hertz_formulas.h"
#include "prs/sector/influence/grooved_body.h"

namespace test {

/// Part of `half_space_compliance` per wave number k around the axis [m^2/N]: the compliance is the
/// integral of h(k) over all k, positive and negative. With the spectrum 3 j_1(q)/q of the patch,
/// q^2 = (a_t k)^2 + (a_s l)^2, and 2 (1 - nu^2)/(E |k|) of the half-space:
///
///     h(k) = (1 - nu^2)/(2 pi^2 E) int (3 j_1(q)/q)^2/sqrt(k^2 + l^2) dl.
///
/// A series of harmonics of period N in theta on a circle of radius r has N/r h(n/r) in its terms.
inline double half_space_spectrum(const prs::HertzPatch& patch, const prs::Material& material, double wave_number) {
  // l = k sinh(t) turns dl/sqrt(k^2 + l^2) into dt.
  const double k = std::abs(wave_number), a_t = patch.along_circumference, a_s = patch.along_profile;
  const auto squared = [&](double t) {
    const double q = std::hypot(a_t * k, a_s * k * std::sinh(t));
    const double f = q < 1e-3 ? 1.0 : 3.0 * (std::sin(q) - q * std::cos(q)) / (q * q * q);
    return f * f;
  };
  const double last = std::asinh(60.0 / (a_s * k));  // the integrand has fallen to 1e-7 there
  const double integral = boost::math::quadrature::gauss_kronrod<double, 61>::integrate(squared, 0.0, last, 15, 1e-9);
  return contact::compliance(material) / (std::numbers::pi * std::numbers::pi) * integral;
}

}  // namespace test
