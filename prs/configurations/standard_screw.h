#pragma once

#include <optional>

#include "prs/model/case.h"

namespace prs {

/// What a maker's catalogue prints of a standard planetary roller screw. SI units.
struct StandardScrew {
  double screw_diameter = 0.0;  ///< Nominal, the pitch diameter d [m].
  double lead = 0.0;            ///< l [m]
  int starts = 5;               ///< n of screw and nut, at least 3; rollers have one.
  double nut_diameter = 0.0;    ///< Outer, of a plain cylinder [m].
  double nut_length = 0.0;      ///< L [m]
  /// r_B of the roller's flanks [m], which no catalogue prints; an arc about the roller's axis
  /// where absent.
  std::optional<double> roller_profile_radius = std::nullopt;
};

/// Part of the nut's length that carries threads.
inline constexpr double kThreadedShare = 0.68;

/// A complete mechanism of those numbers, with what catalogues keep to themselves by rule:
///
///     d_R = d/(n - 2),  d_N = d + 2 d_R,  2 c = d (n - 1)/(n - 2)     (1.52), no backlash
///     p = l/n,  0.68 L/p contacts of a roller, in the middle of the nut
///     as many rollers as fit with half a pitch between their crests
///     flanks of 45 deg, screw and nut straight, rollers convex; crests 0.15 p, roots 0.23 p
///     (groove.h) screw without bore; rollers whose ends, of 0.7 d_R, reach half way to the ends of
///     the nut steel of 210 GPa, 0.3, 7800 kg/m^3 (that of the catalogue in
///     validation/standard_screws)
///
/// The nut is held at its near end in tension, at its far one in compression. No load cases.
Case standard_screw_case(const StandardScrew& screw);

}  // namespace prs
