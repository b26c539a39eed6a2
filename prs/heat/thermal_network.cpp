#include "prs/heat/thermal_network.h"

#include <Eigen/Cholesky>

namespace prs {

OfParts of_parts(const PerPart<double>& v) { return {v.screw, v.roller, v.nut}; }
PerPart<double> per_part(const OfParts& v) { return {v[0], v[1], v[2]}; }

OfParts ThermalNetwork::steady(const OfParts& heat) const {
  return (conductance.ldlt().solve(heat).array() + ambient).matrix();
}

ThermalNetwork thermal_network(const Heat& heat) {
  const Heat::Conductance& c = heat.conductance;
  ThermalNetwork n;
  n.ambient = heat.ambient;
  n.conductance << c.screw_ambient + c.screw_rollers, -c.screw_rollers, 0.0,  //
      -c.screw_rollers, c.rollers_ambient + c.screw_rollers + c.rollers_nut, -c.rollers_nut, 0.0,
      -c.rollers_nut, c.nut_ambient + c.rollers_nut;
  return n;
}

OfParts heat_of(const PowerBySource& p) {
  return {0.5 * p.screw + p.carrier_screw, 0.5 * (p.screw + p.nut) + p.carrier_roller,
          0.5 * p.nut + p.carrier_nut};
}

PerInterface<double> oil_temperatures(const OfParts& t) {
  return {0.5 * (t[0] + t[1]), 0.5 * (t[1] + t[2])};
}

Eigen::Matrix<double, 2, 3> oil_by_parts() {
  Eigen::Matrix<double, 2, 3> m;
  m << 0.5, 0.5, 0.0, 0.0, 0.5, 0.5;
  return m;
}

}  // namespace prs
