#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "prs/model/materials.h"

namespace prs {

/// What stands in series with the mechanism between the drive and the load: shaft, its axial
/// bearings, housing. What is left out is rigid.
struct AxisParts {
  /// The shaft from the loaded section of the screw to its bearings; the one for buckling and
  /// critical speed has a length of its own.
  struct Shaft {
    double length = 0.0;  ///< L to the one axial bearing, or between two of them [m].
    /// x from the nearer of two axial bearings; absent with one of them [m].
    std::optional<double> from_bearing;
    std::optional<double> torsion_length;  ///< L_t to where rotation is held; default L [m].
  };
  std::optional<Shaft> shaft;
  std::optional<double> support_bearing;  ///< All bearings of the shaft together [N/m].
  std::optional<double> housing;          ///< [N/m]
};

/// A round shaft and the lead of its thread.
struct ShaftSection {
  Material material;
  double diameter = 0.0;  ///< d, pitch diameter of the screw [m].
  double bore = 0.0;      ///< b [m]
  double lead = 0.0;      ///< l [m]
};

/// Axial stiffness of an axis, by what gives way.
struct SystemStiffness {
  struct Contribution {
    std::string_view name;   ///< mechanism, shaft, wind_up, support_bearing, housing.
    double stiffness = 0.0;  ///< [N/m]
    double share = 0.0;      ///< Of the total compliance; all sum to 1.
  };
  double total = 0.0;  ///< [N/m]
  std::vector<Contribution> contributions;
};

/// In series, 1/k = sum 1/k_i, with
///
///     shaft    L/(E A) to one bearing, x (L - x)/(L E A) between two,
///     wind_up  (l/(2 pi))^2 L_t/(G J),   G = E/(2 (1 + nu)),
///     A = pi/4 (d^2 - b^2),   J = pi/32 (d^4 - b^4).
///
/// `mechanism`: the secant stiffness of the screw at rest [N/m].
SystemStiffness system_stiffness(double mechanism, const AxisParts& parts,
                                 const ShaftSection& section);

}  // namespace prs
