#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "fe/power_law_spring.h"

namespace prs {

/// A guide ring with a clearance at one end node of a roller: the force k <|v| - c> against the
/// radial displacement v.
struct RingGuide {
  double stiffness = 0.0;  ///< k [N/m]
  double clearance = 0.0;  ///< c [m]

  /// Force on the roller, > 0 outwards [N].
  double force(double v) const { return std::copysign(stiffness * std::max(std::abs(v) - clearance, 0.0), -v); }
  /// -d force/dv; at the touching point the stiffness beyond it [N/m].
  double tangent(double v) const { return std::abs(v) >= clearance ? stiffness : 0.0; }
  /// The stop on one side, which only pushes; its approach is v or -v.
  fe::PowerLawSpring stop() const { return {std::numeric_limits<double>::infinity(), clearance, 1.0 / stiffness}; }
};

/// The guides of a roller: outer and inner node of its first end, inner and outer node of its last.
struct GuideLoads {
  std::array<double, 4> displacement{};  ///< Displacement v against the ring, > 0 outwards [m].
  std::array<double, 4> force{};         ///< Force on the roller, > 0 outwards [N].

  /// R_near and R_far [N].
  std::array<double, 2> of_ends() const { return {force[0] + force[1], force[2] + force[3]}; }
};

/// One array of the guides of all rollers, roller after roller.
inline std::vector<double> roller_after_roller(std::span<const GuideLoads> guides,
                                               std::array<double, 4> GuideLoads::*values) {
  std::vector<double> all;
  for (const GuideLoads& g : guides) all.insert(all.end(), (g.*values).begin(), (g.*values).end());
  return all;
}

}  // namespace prs
