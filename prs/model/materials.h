#pragma once

#include <optional>

#include "prs/model/part.h"

namespace prs {

/// Linear elastic, isotropic. SI units.
struct Material {
  double youngs_modulus = 0.0;    ///< E [Pa]
  double poisson_ratio = 0.0;     ///< nu
  std::optional<double> density;  ///< [kg/m^3]; needed for weight and centrifugal force only.
  /// [1/K]; needed where temperatures are given.
  std::optional<double> thermal_expansion = std::nullopt;
};

using Materials = PerPart<Material>;

}  // namespace prs
