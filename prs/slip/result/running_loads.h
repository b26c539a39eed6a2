#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "prs/model/part.h"

namespace prs {

/// How the search for loads and friction that belong together ended.
enum class RunningStatus {
  converged,
  iteration_limit,
  slip_no_equilibrium,  ///< No slip ratio balances the moment on a roller.
  jammed,               ///< Friction takes more of a contact's axial force than its normal gives.
  no_equilibrium,       ///< The loads with that friction have no equilibrium.
  mechanism,
};

constexpr std::string_view name(RunningStatus status) {
  constexpr std::string_view kNames[] = {"converged", "iteration_limit", "slip_no_equilibrium",
                                         "jammed",    "no_equilibrium",  "mechanism"};
  return kNames[static_cast<std::size_t>(status)];
}

/// T of each thread on the roller: x along the axis from the loaded end of the screw, y outwards,
/// tangential along the orbit [N]. Threads as in `InterfaceLoads`.
struct FrictionForces {
  int threads_per_roller = 0;
  std::vector<double> axial, radial, tangential;
};

/// What a load case has where its loads are those of the running screw, with friction. SI units.
struct RunningLoads {
  RunningStatus status = RunningStatus::iteration_limit;
  int rounds = 0;       ///< Evaluations of slip.
  double change = 0.0;  ///< Change of a thread's load in the last round, over the largest load.
  /// R_near and R_far, forces of the guides on the roller, > 0 outwards; of each roller present
  /// [N]. None where rollers stay straight.
  std::vector<std::array<double, 2>> guide_force;

  /// The same load case at rest.
  struct AtRest {
    PerInterface<double> largest_normal_load;  ///< [N]
    double axial_displacement = 0.0;           ///< [m]
  };
  AtRest at_rest;

  bool converged() const { return status == RunningStatus::converged; }
};

}  // namespace prs
