#pragma once

#include "prs/sector/load_distribution.h"
#include "prs/sector/roller_push.h"

namespace prs {

/// The push as loads of a sector:
///
///     f = sum_screw -(X_i' T_x,i + Y_i' T_y,i) + sum_nut (X_i' T_x,i + Y_i' T_y,i) + f_c
///
/// X and Y the rows of the displacements delta_x and delta_y of screw against roller and of roller
/// against nut at a contact: with w = s cos(psi) delta_x + sin(psi) delta_y its approach. f_c: half
/// of the centrifugal force of each length of the roller at both its ends.
std::vector<fe::NodalLoad> push_loads(const Sector& sector, const RollerPush& push);

/// Loads of a running sector whose friction keeps its proportion to the normal loads.
/// `per_normal_load`: T over N of each thread, and the centrifugal force.
fe::FollowingLoad turned_loads(const SectorSolver& solver, double axial_force,
                               const RollerPush& per_normal_load);

}  // namespace prs
