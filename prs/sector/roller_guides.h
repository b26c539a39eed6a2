#pragma once

#include "prs/sector/sector.h"

namespace prs {

/// Forces of the guides of a bending roller against the forces at its threads.
///
/// Let phi_h be the shape of the free roller whose guides at end h move outwards by 1. By reciprocity the guides of
/// that end push the roller outwards with R_h = -sum f phi_h, f all other forces and moments on it; phi_near + phi_far
/// = 1, a rigid motion.
class RollerGuides {
 public:
  explicit RollerGuides(const Sector& sector);

  /// R_near and R_far under the normal loads of all threads and a push [N].
  std::array<double, 2> forces(const PerInterface<std::vector<double>>& normal_load, const RollerPush& push) const;

 private:
  /// phi at a thread: deflection, and rotation times the arm of an axial force.
  struct At {
    double across = 0.0, along = 0.0;
  };
  struct End {
    PerInterface<std::vector<At>> threads;
    double of_thread = 0.0, of_heads = 0.0;  ///< Integrals of phi over the lengths of threads and heads [m].
  };
  double sense_;
  PerInterface<double> cosine_, sine_;
  std::array<End, 2> ends_;
};

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
fe::FollowingLoad turned_loads(const SectorSolver& solver, double axial_force, const RollerPush& per_normal_load);

}  // namespace prs
