#pragma once

#include <span>

#include "prs/model/load_case.h"
#include "prs/model/materials.h"
#include "prs/model/mechanism.h"
#include "prs/model/structure.h"

namespace prs {

/// What lies between two neighbouring threads: axial compliances [m/N] of screw and nut under the
/// loads of one roller, which shares their sections with the others (p N_r/(E A)).
struct ThreadGap {
  double screw = 0.0;
  /// Nut, on the side of the thrust section that faces the loaded end of the screw [m/N].
  double nut_before_thrust = 0.0;
  double nut_behind_thrust = 0.0;
};

/// The gaps between the threads of the sector model's bars: screw from bore to pitch diameter, nut
/// from pitch diameter to its outer diameter or that of its flanges.
std::vector<ThreadGap> thread_gaps(const Mechanism& mechanism, const Structure& structure,
                                   const Materials& materials, double thrust, double position);

/// Axial loads F_k [N] of the threads of one roller, thread 1 first, of sum F, after Yang (Jung
/// 2017, (4.1) and (8.20), both misprinted). Each tooth of the roller is a ball between screw and
/// nut: it passes on what it takes, so that both interfaces have the same loads, and nothing goes
/// along the roller. The axial approaches w_k = h F_k^(2/3) of both contacts together, h the sum of
/// `axial_hertz_coefficient`, then differ by what screw and nut stretch between two threads. With
/// S_k = sum F_j over j >= k, which the screw carries in front of thread k, and P_k = F - S_(k+1),
/// which the nut carries in front of the thrust section, in the direction of the load
///
///     w_k - w_(k+1) = S_(k+1) (c_S + c_N behind) - P_k c_N before.
///
/// With the thrust section at the loaded end ("same side") this is
/// h (F_(i-1)^(2/3) - F_i^(2/3)) = p N_r (1/(E A_S) + 1/(E A_N)) sum_(j >= i) F_j; at the other end
/// ("opposite side") the nut's term is -sum_(j < i) F_j. It is the sector model without bending in
/// the limit of a roller whose core has no axial stiffness; with a rigid core the interfaces would
/// not know of each other. The real roller lies between. Friction, teeth, deviations and Poisson's
/// ratio are left out; a thread without approach is open.
///
/// All w_k follow from w_n, with which their sum of loads grows: one root, bracketed, found to
/// rounding. Empty where rounding lets the sum miss F by more than 1e-9 F: loads that differ by
/// many orders between the ends.
std::vector<double> yang_distribution(double roller_force, double coefficient,
                                      std::span<const ThreadGap> gaps);

}  // namespace prs
