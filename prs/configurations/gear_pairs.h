#pragma once

#include <vector>

#include "prs/model/mechanism.h"

namespace prs {

/// Spur gears that keep the rollers in step, by numbers and module: pinions at the ends of the
/// rollers, in ring gears on the nut (standard) or on gears of the screw (inverted). 20 deg basic
/// rack of full depth.
struct GearPair {
  int roller_teeth = 0;                 ///< z_R, a multiple k n_R of the roller's starts.
  int body_teeth = 0;                   ///< z_N or z_S, k n_S: the ratio of the leads exactly.
  double module = 0.0;                  ///< m [m]
  int series = 1;                       ///< 1 is to be preferred to 2.
  double working_pressure_angle = 0.0;  ///< alpha_w at the centre distance of the threads [rad].
  /// x_N - x_R (standard) or x_S + x_R (inverted), in modules, that brings reference gears to that
  /// centre distance; how it is shared is left to the designer.
  double profile_shift = 0.0;
  int most_rollers = 0;  ///< Whose threads and pinions clear each other.
};

/// Gears that fit a centre distance c [m] (Sandu 2018, (2.1) with the operating pitch radii
/// c Gamma/(1 -+ Gamma)). With the reference centre distance a = m (z_body -+ z_R)/2:
///
///     cos(alpha_w) = (a/c) cos(20 deg),
///     profile shift = (z_body -+ z_R)(inv alpha_w - inv 20 deg)/(2 tan 20 deg).
///
/// Modules of ISO 54, below 1 mm of DIN 780-1, from 0.2 to 10 mm. Pinions of 12 to 40 teeth (below
/// 18, x_R >= 1 - z_R sin(20 deg)^2/2 keeps them from undercut); profile shifts up to 1, half a
/// module for either gear. `gap` [m] is kept free between the tips of neighbours, m above the
/// operating pitch circle; `rollers` is what the threads leave room for. Strength is not looked at,
/// nor whether the teeth are higher than the threads.
///
/// The pairs that hold most rollers come first, then those of series 1, then those of least shift,
/// to a tenth of the module, and of fewest teeth.
std::vector<GearPair> gear_pairs(Mechanism::Type type, Mechanism::Starts starts,
                                 double centre_distance, int rollers, double gap);

}  // namespace prs
