#pragma once

#include <optional>

#include "contact/hertz.h"
#include "prs/model/part.h"

namespace prs {

/// Linear elastic, isotropic. SI units.
struct Material {
  double youngs_modulus = 0.0;    ///< E [Pa]
  double poisson_ratio = 0.0;     ///< nu
  std::optional<double> density;  ///< [kg/m^3]; of weight, centrifugal force, flash.
  /// [1/K]; needed where temperatures are given.
  std::optional<double> thermal_expansion = std::nullopt;
  std::optional<double> conductivity = std::nullopt;   ///< [W/(m K)]; for flash temperatures.
  std::optional<double> specific_heat = std::nullopt;  ///< [J/(kg K)]; the same.

  operator contact::Elasticity() const { return {youngs_modulus, poisson_ratio}; }
};

using Materials = PerPart<Material>;

/// Contact pressure beyond which the static capacity of through-hardened steel is exceeded: a
/// permanent deformation of 1e-4 of the element's diameter at 4.0 GPa (ISO 76:2006, roller
/// bearings).
inline constexpr double kStaticPressureLimit = 4.0e9;

}  // namespace prs
