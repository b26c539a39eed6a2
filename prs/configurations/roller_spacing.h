#pragma once

#include "prs/model/mechanism.h"

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
namespace prs {

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

}  // namespace prs
