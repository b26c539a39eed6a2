#pragma once

#include <optional>

namespace prs {

/// What the design measures need besides the mechanism, its structure and its loads. SI units.
struct MeasureOptions {
  /// How the two ends of the loaded length of the screw are held.
  enum class Ends {
    fixed_free,
    supported_supported,
    fixed_supported,
    fixed_fixed,
  };
  struct Shaft {
    double length = 0.0;  ///< Greatest distance between the supports of the screw [m].
    Ends ends = Ends::supported_supported;
  };

  std::optional<double> loaded_width;  ///< Thread width that one contact loads, for Yamamoto [m].
  std::optional<double> friction_coefficient;  ///< For the estimate of efficiency.
  std::optional<double> yield_strength;        ///< [Pa]
  std::optional<Shaft> shaft;
};

}  // namespace prs
