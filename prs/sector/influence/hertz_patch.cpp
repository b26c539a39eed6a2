#include "prs/sector/influence/hertz_patch.h"

#include <algorithm>
#include <boost/math/special_functions/bessel.hpp>

#include "contact/hertz_formulas.h"

namespace prs {
namespace {

using std::numbers::pi;

/// Beyond this q the squared spectrum is replaced by its mean, 9/(2 q^4).
constexpr double kLargestSpectralRadius = 60.0;

/// (3 j_1(q)/q)^2, 1 at q = 0.
double squared_spectrum(double q) {
  if (q < 1e-2) return 1.0 - q * q / 5.0;
  const double f = 3.0 * (std::sin(q) - q * std::cos(q)) / (q * q * q);
  return f * f;
}

/// Simpson's rule over [a, b].
template <class Function>
double integral(double a, double b, int intervals, Function f) {
  const double h = (b - a) / (2 * intervals);
  double sum = f(a) + f(b);
  for (int i = 1; i < 2 * intervals; ++i) sum += (i % 2 ? 4.0 : 2.0) * f(a + i * h);
  return sum * h / 3.0;
}

}  // namespace

double pressure_amplitude(const HertzPatch& patch, int harmonic, double s, double r) {
  const double height = 1.0 - std::pow(s / patch.along_profile, 2);
  if (height <= 0.0) return 0.0;
  const double half_width = patch.along_circumference * std::sqrt(height);
  const double peak = 1.5 / (pi * patch.along_profile * patch.along_circumference);
  const double x = harmonic * half_width / r;
  const double share = x < 1e-4 ? 0.5 : boost::math::cyl_bessel_j(1, x) / x;
  const double factor = harmonic == 0 ? 0.5 : 1.0;
  return factor * peak * half_width * half_width / (patch.along_circumference * r) * share;
}

double half_space_compliance(const HertzPatch& patch, const Material& material) {
  const auto [minor, major] = std::minmax(patch.along_profile, patch.along_circumference);
  const double k = contact::complete_elliptic_integrals(minor / major).first;
  return 1.2 * k * contact::compliance(material) / (pi * major);
}

double half_space_spectrum(const HertzPatch& patch, const Material& material, double wave_number) {
  const double k = std::abs(wave_number);
  const double start = patch.along_circumference * k;
  // l = k sinh(t) takes dl/sqrt(k^2 + l^2) to dt.
  const double last = std::asinh(kLargestSpectralRadius / (patch.along_profile * k));
  const auto f = [&](double t) {
    return squared_spectrum(std::hypot(start, patch.along_profile * k * std::sinh(t)));
  };
  return contact::compliance(material) / (pi * pi) * integral(0.0, last, 1000, f);
}

double half_space_remainder(const HertzPatch& patch, const Material& material, double wave_number) {
  const double start = patch.along_circumference * std::abs(wave_number);
  // In polar coordinates a_t k = q cos(phi), a_s l = q sin(phi), of which |cos(phi)| > start/q.
  const auto over_angle = [&](double q) {
    return integral(0.0, std::acos(std::min(1.0, start / q)), 10, [&](double phi) {
      return 1.0 / std::hypot(patch.along_profile * std::cos(phi),
                              patch.along_circumference * std::sin(phi));
    });
  };
  const double last = std::max(kLargestSpectralRadius, 4.0 * start);
  const auto f = [&](double q) { return squared_spectrum(q) * over_angle(q); };
  const double body = integral(std::max(start, 1e-9), last, 3000, f);
  const double rest = 1.5 / (last * last * last) * over_angle(last);
  return 2.0 * contact::compliance(material) / (pi * pi) * (body + rest);
}

}  // namespace prs
