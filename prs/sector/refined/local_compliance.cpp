#include "prs/sector/refined/local_compliance.h"

#include <cmath>
#include <numbers>

#include "prs/sector/refined/compliance_formulas.h"

namespace prs {
namespace {

ElasticNumbers<double> elastic(const Material& m) { return {m.youngs_modulus, m.poisson_ratio}; }

LineReach reach(const LineReachOf<double>& r) { return {r.normal, r.tangential}; }

}  // namespace

LineReach rows_around(double radius, int rows) {
  return reach(reach_around(radius, static_cast<double>(rows)));
}

LineReach opposite_rows(double radius) { return reach(reach_of_opposite(radius)); }

double concentration_compliance(const LineReach& r, const Material& material, double pitch,
                                double normal_angle) {
  return concentration({r.normal, r.tangential}, elastic(material), pitch, std::sin(normal_angle),
                       std::cos(normal_angle));
}

double cylinder_compliance(double radius, double bore_radius, const Material& material, int rollers,
                           double pitch, double normal_angle) {
  return of_cylinder(radius, bore_radius, elastic(material), static_cast<double>(rollers), pitch,
                     std::sin(normal_angle));
}

double wall_compliance(double inner_radius, double outer_radius, const Material& material,
                       int rollers, double pitch, double normal_angle) {
  return of_wall(inner_radius, outer_radius, elastic(material), static_cast<double>(rollers), pitch,
                 std::sin(normal_angle));
}

std::vector<double> band_shares(int contacts, double pitch, double radius, double bore_radius,
                                double nu) {
  const double decay = band_decay(radius, bore_radius, nu);
  std::vector<double> shares;
  for (int k = 0; k < contacts; ++k)
    shares.push_back(1.0 - taken_by_end(decay, (k + 0.5) * pitch) -
                     taken_by_end(decay, (contacts - k - 0.5) * pitch));
  return shares;
}

double poisson_offset(double sense, double radius, double bore_radius, const Material& material,
                      int rollers, double normal_angle) {
  const double area = std::numbers::pi * (radius * radius - bore_radius * bore_radius) / rollers;
  return -sense * material.poisson_ratio * std::tan(normal_angle) * radius /
         (material.youngs_modulus * area);
}

}  // namespace prs
