#pragma once

#include <optional>

#include "modules/drive/curves.h"

namespace prs {

/// Friction of threads as a constant, a share of the load and one of the speed: |T_f|/|r| = no_load + per_load |F| +
/// per_speed |n r|, none of them below 0.
struct FrictionFit {
  double no_load = 0.0, per_load = 0.0, per_speed = 0.0;
  double largest_error = 0.0, rms_error = 0.0;  ///< [N]
  /// Mean efficiencies at the largest speed; absent if they are not > 0.
  std::optional<double> screw_drives = {}, load_drives = {};
};

/// Fit over ten steps of force in both senses and of speed, both senses of rotation.
FrictionFit fit_friction(const PrsCurves& curves, double largest_force, double largest_speed);

}  // namespace prs
