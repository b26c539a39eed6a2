#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "prs/model/part.h"

namespace prs {

/// Outcome of the search for consistent loads and friction.
enum class RunningStatus {
  converged,
  iteration_limit,
  slip_no_equilibrium,  ///< No slip ratio balances the moment on a roller.
  jammed,               ///< Friction exceeds the part of a contact's axial force that its normal gives.
  no_equilibrium,       ///< The loads with friction have no equilibrium.
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

/// Data of a load case whose loads are those of the running screw, with friction. SI units.
struct RunningLoads {
  RunningStatus status = RunningStatus::iteration_limit;
  int rounds = 0;       ///< Number of evaluations of slip.
  double change = 0.0;  ///< Change of a thread's load in the last round, over the largest load.
  /// R_near and R_far, forces of the guides on the roller, > 0 outwards, for each present roller [N]. None if rollers
  /// stay straight.
  std::vector<std::array<double, 2>> guide_force;

  /// Same load case at rest.
  struct AtRest {
    PerInterface<double> largest_normal_load;  ///< [N]
    double axial_displacement = 0.0;           ///< [m]
  };
  AtRest at_rest;

  bool converged() const { return status == RunningStatus::converged; }
};

}  // namespace prs
