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
  no_equilibrium,       ///< Of the loads with that friction.
  mechanism,
};

std::string_view name(RunningStatus status);

/// What a load case has where its loads are those of the running screw, with friction. Threads as
/// in `InterfaceLoads`. SI units.
struct RunningLoads {
  RunningStatus status = RunningStatus::iteration_limit;
  int rounds = 0;       ///< Evaluations of slip.
  double change = 0.0;  ///< Of a thread's load in the last round, over the largest load.

  /// T of each thread on the roller: x along the axis from the loaded end of the screw, y outwards,
  /// tangential along the orbit [N].
  struct Friction {
    std::vector<double> axial, radial, tangential;
  };
  PerInterface<Friction> friction;
  /// R_near and R_far, forces of the guides on the roller, > 0 outwards; of each roller present
  /// [N]. None where rollers stay straight.
  std::vector<std::array<double, 2>> guide_force;

  // The same load case at rest.
  PerInterface<double> largest_static_load;  ///< [N]
  double static_displacement = 0.0;          ///< Axial [m].

  bool converged() const { return status == RunningStatus::converged; }
};

}  // namespace prs
