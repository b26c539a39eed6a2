#pragma once

#include <numbers>

#include "prs/model/materials.h"
#include "prs/sector/sector_numbers.h"

namespace prs {

/// pi d^2/4 [m^2]
inline double disc_area(double diameter) { return std::numbers::pi / 4.0 * diameter * diameter; }

/// Between two diameters [m^2].
inline double ring_area(double outer, double inner) { return disc_area(outer) - disc_area(inner); }

/// A ring-shaped section, m the inner over the outer diameter (Cowper 1966):
///
///     I = pi (d_o^4 - d_i^4)/64,   q = (1 + m^2)^2,
///     kappa = 6 (1 + nu) q/((7 + 6 nu) q + (20 + 12 nu) m^2)
inline RollerSection<double> ring_rigidity(const Material& material, double outer, double inner,
                                           bool shear) {
  const double modulus = material.youngs_modulus, nu = material.poisson_ratio;
  const double area = ring_area(outer, inner);
  RollerSection<double> r{
      modulus * area,
      modulus * (std::numbers::pi / 64.0 * (std::pow(outer, 4) - std::pow(inner, 4))), 0.0};
  if (!shear) return r;
  const double m2 = std::pow(inner / outer, 2), q = (1.0 + m2) * (1.0 + m2);
  const double kappa = 6.0 * (1.0 + nu) * q / ((7.0 + 6.0 * nu) * q + (20.0 + 12.0 * nu) * m2);
  r.shear = kappa * (modulus / (2.0 * (1.0 + nu))) * area;
  return r;
}

/// A full round section.
inline RollerSection<double> disc_rigidity(const Material& material, double diameter, bool shear) {
  return ring_rigidity(material, diameter, 0.0, shear);
}

}  // namespace prs
