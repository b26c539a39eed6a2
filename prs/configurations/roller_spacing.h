#pragma once

#include <vector>

#include "prs/model/mechanism.h"

namespace prs {

/// Rollers at equal spacing, 360 deg/N from one to the next.
///
/// *Which numbers mesh.* In pitches, a thread of n starts and hand h (+1 right, -1 left) has at the
/// angle phi and the height z the phase n phi/(2 pi) - h z/p. A roller at the place phi_i, turned
/// by psi_i, faces the screw with phi_i + pi and the nut with phi_i. Its crests meet the grooves of
/// a body B where, z eliminated,
///
///     n_R (phi_i - psi_i)/(2 pi) - h_R h n_B phi_i/(2 pi) = const_B   (mod 1),   B = screw, nut.
///
/// Both conditions are one and the same at every place if (n_N - n_S)/N is whole, and as the leads
/// are equal (Sandu 2018, (2.14)) n_N = n_S: every number of rollers meshes both threads. What is
/// left is the turn psi_i. Gears with z_body/z_roller = n_S/n_R, ring gear (standard) or on the
/// screw (inverted), ask for
///
///     z_R (phi_i - psi_i)/(2 pi) -+ z_body phi_i/(2 pi) = const       (mod 1),
///
/// the same turn. The condition of planetary gears with sun and ring, (z_ring + z_sun)/N whole,
/// does not arise, since each roller has one gear mesh only. It is assumed that on every roller
/// teeth and threads stand in the same relation, and at both ends.

/// Fewer do not centre the screw.
inline constexpr int kFewestRollers = 3;

/// Free space between the outermost radii of neighbouring rollers, overlap < 0 [m]:
/// 2 c sin(pi/N) - 2 r (Sandu 2018, (1.45)).
double neighbour_gap(double centre_distance, double outer_radius, int rollers);

/// Largest number of rollers of this outer radius whose neighbours are `gap` apart, (1.47) with
/// r + gap/2; at most 1000, and 1 where even two would not fit.
int most_rollers(double centre_distance, double outer_radius, double gap);

/// Turn of a roller in the planet carrier against its neighbour [rad], in the sense in which the
/// places are counted: psi - phi of the conditions above, from 0 to 2 pi/n_R, with which the
/// rollers' threads repeat. Standard -(n_S/n_R) 2 pi/N, inverted +(n_S/n_R) 2 pi/N.
double indexing_angle(Mechanism::Type type, Mechanism::Starts starts, int rollers);

/// Whether every roller goes in alike, turned the same way as seen from its place: n_S/N whole.
/// Other numbers need marks, or rollers that find their turn by rolling in from one place.
bool go_in_alike(Mechanism::Starts starts, int rollers);

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
