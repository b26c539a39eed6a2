#pragma once

#include <cmath>
#include <numbers>

#include "prs/model/materials.h"
#include "prs/sector/sector_numbers.h"

namespace prs {

/// pi d^2/4 [m^2]
inline double disc_area(double diameter) { return std::numbers::pi / 4.0 * diameter * diameter; }

/// Between two diameters [m^2].
inline double ring_area(double outer, double inner) { return disc_area(outer) - disc_area(inner); }

/// A full round section: I = pi d^4/64, kappa = 6 (1 + nu)/(7 + 6 nu) (Cowper 1966).
inline RollerSection<double> disc_rigidity(const Material& material, double diameter, bool shear) {
  const double modulus = material.youngs_modulus, nu = material.poisson_ratio;
  const double area = disc_area(diameter);
  RollerSection<double> r{modulus * area,
                          modulus * (std::numbers::pi / 64.0 * std::pow(diameter, 4)), 0.0};
  if (shear) r.shear = 6.0 * (1.0 + nu) / (7.0 + 6.0 * nu) * (modulus / (2.0 * (1.0 + nu))) * area;
  return r;
}

}  // namespace prs
