#pragma once

#include <limits>

namespace fe {

/// Rounding of a force by that of the displacements from which it follows, and of an energy that is a difference of
/// works, each as a share: bounds by experience, a few operations and a few dozen of them.
inline constexpr double kForceRounding = 4.0 * std::numeric_limits<double>::epsilon();
inline constexpr double kEnergyRounding = 64.0 * std::numeric_limits<double>::epsilon();

/// Factor from a shift of a singular tangent to the next one.
inline constexpr double kShiftGrowth = 100.0;

}  // namespace fe
