#pragma once

#include "prs/mechanism/full_distribution.h"
#include "prs/sector/influence/flexibility_around.h"
#include "prs/sector/influence/influence_solver.h"

namespace prs {

/// The bodies of the full mechanism by their flexibilities, for one direction of the load and one position; all rollers
/// have the same.
struct FullBodies {
  FlexibilityAround screw, nut;    ///< Flexibilities with the sections of `screw_stations` and `nut_stations`.
  Eigen::MatrixXd roller;          ///< Flexibility at the contacts at the screw, then at those at the nut.
  std::optional<ThrustFace> face;  ///< Face of a nut that can lift off its shoulder, in mode 0.
};

/// Places at which a ring guides the rollers: the middles of their ends, or the outer nodes [m].
std::array<double, 2> guide_places(const FullModel& model);

/// Places on the screw whose displacements are needed, from the loaded section on [m]: rings that it carries, bearings,
/// a side force and a moment `at` a place of their own.
std::vector<double> screw_stations(const FullModel& model);
/// Rings on the nut, x [m].
std::vector<double> nut_stations(const FullModel& model);

/// Flexibilities by finite elements. Throws CaseError if a body cannot be meshed.
FullBodies full_bodies(const Conditions& c, const Contacts& contacts, const PerInterface<ContactLaw>& laws,
                       const FullModel& model, MatrixCache& cache = shared_matrix_cache());

/// Moment on the seat of a nut at which one side of its shoulder, a ring from r_i to r_o under linear pressure, lifts
/// off: F (r_o^2 + r_i^2)/(4 r_o) [N m].
double lifting_moment(const Structure::Nut& nut, const SupportForce& seat);

/// Contacts of all rollers on elastic bodies,
///
///     w = R U - C N + w_0,   N = k_0 <w - g>^1.5,   R' N = f,
///
/// U the motions of the screw's loaded section and of each roller along its axis. C holds the flexibilities of screw
/// and nut between all rollers, each roller's own, and those of housing springs and rings: a ring moves a roller as a
/// rigid line through both rings, its forces on the body that carries it are those of the line's equilibrium. w_0 is
/// due to a displaced seat of the nut, rollers out of place, and bending of the screw by loads behind the loaded
/// section. Reactions of bearings are unknowns next to U.
FullDistribution solve(const FullModel& model, const FullBodies& bodies, Detail detail = Detail::complete);

}  // namespace prs
