#include "prs/sector/refined/local_compliance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prs {
namespace {

using std::numbers::pi;

double squared(double x) { return x * x; }

/// (R^2 + r^2)/(R^2 - r^2) of Lame's solution.
double lame_ratio(double outer, double inner) {
  return (squared(outer) + squared(inner)) / (squared(outer) - squared(inner));
}

/// Radial pressure times its radius per normal load, projected back on the normal, over E [m/N].
double pressure_factor(const Material& material, int rollers, double pitch, double normal_angle) {
  return rollers * squared(std::sin(normal_angle)) / (2.0 * pi * pitch * material.youngs_modulus);
}

}  // namespace

LineReach rows_around(double radius, int rows) { return {radius / rows, radius / rows}; }

LineReach opposite_rows(double radius) {
  using std::numbers::e;
  return {2.0 * radius / e, 2.0 * radius / (e * e)};
}

double concentration_compliance(const LineReach& reach, const Material& material, double pitch,
                                double normal_angle) {
  const double e = material.youngs_modulus, nu = material.poisson_ratio;
  const double shear_modulus = e / (2.0 * (1.0 + nu));
  const auto row = [&](double length) {
    return std::log(0.5 * length / pitch) + std::numbers::egamma;
  };
  return squared(std::sin(normal_angle)) * 2.0 * (1.0 - nu * nu) / (pi * e * pitch) *
             row(reach.normal) +
         squared(std::cos(normal_angle)) / (pi * shear_modulus * pitch) * row(reach.tangential);
}

double cylinder_compliance(double radius, double bore_radius, const Material& material, int rollers,
                           double pitch, double normal_angle) {
  return pressure_factor(material, rollers, pitch, normal_angle) *
         (lame_ratio(radius, bore_radius) - material.poisson_ratio);
}

double wall_compliance(double inner_radius, double outer_radius, const Material& material,
                       int rollers, double pitch, double normal_angle) {
  return pressure_factor(material, rollers, pitch, normal_angle) *
         (lame_ratio(outer_radius, inner_radius) + material.poisson_ratio -
          1.0 / std::log(outer_radius / inner_radius));
}

std::vector<double> band_shares(int contacts, double pitch, double radius, double bore_radius,
                                double nu) {
  const double solid = std::pow(24.0 * (1.0 + nu), 0.25) / radius;
  const double mean_radius = 0.5 * (radius + bore_radius);
  const double tube =
      std::pow(3.0 * (1.0 - nu * nu), 0.25) / std::sqrt(mean_radius * (radius - bore_radius));
  const double b = std::max(solid, tube);
  const auto taken = [&](double x) { return 0.5 * std::exp(-b * x) * std::cos(b * x); };
  std::vector<double> shares;
  for (int k = 0; k < contacts; ++k)
    shares.push_back(1.0 - taken((k + 0.5) * pitch) - taken((contacts - k - 0.5) * pitch));
  return shares;
}

double poisson_offset(double sense, double radius, double bore_radius, const Material& material,
                      int rollers, double normal_angle) {
  const double area = pi * (squared(radius) - squared(bore_radius)) / rollers;
  return -sense * material.poisson_ratio * std::tan(normal_angle) * radius /
         (material.youngs_modulus * area);
}

}  // namespace prs
