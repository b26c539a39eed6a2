#pragma once

#include <algorithm>
#include <functional>

#include "fe/newton.h"
#include "prs/loads/result.h"
#include "prs/sector/sector_model.h"
#include "prs/slip/slip_model.h"

namespace prs {

/// Response of the bodies to a push.
struct BodyAnswer {
  fe::NewtonStatus status = fe::NewtonStatus::iteration_limit;
  PerInterface<std::vector<double>> normal_load;   ///< Loads as in `InterfaceLoads` [N].
  std::vector<std::array<double, 2>> guide_force;  ///< See `RunningLoads`.
};

/// Bodies between which a running screw is in equilibrium. Each push is on one of the present rollers.
struct RunningBodies {
  /// The answer to friction as given forces.
  std::function<BodyAnswer(const std::vector<RollerPush>&)> go_on;
  /// The answer to friction in these proportions to the normal loads; none where it must be followed step by step.
  std::function<std::optional<BodyAnswer>(const std::vector<RollerPush>&)> follow = {};
};

/// Indices of the rollers among all threads; under preload rows are the flank that the load names and the other one.
struct RunningRollers {
  std::vector<std::size_t> present{0};
  std::size_t threads = 0;
  enum class Rows { rollers, flanks, nuts } rows = Rows::rollers;

  bool of_flanks() const { return rows != Rows::rollers; }
};

/// Slip of each nut and the push on each present roller of a running screw in equilibrium.
struct RunningEquilibrium {
  std::vector<SlipEquilibrium> slip;
  std::vector<RollerPush> push;
};

/// Slip ratio and spin of the rollers of each nut, where they are known.
using SpinOfNuts = std::array<std::optional<RollerSpin>, 2>;

/// Finds the loads and the friction of a running screw that bring forth each other, from the state at rest, which
/// `loaded` and `at_rest` have. The loads of `loaded` become those of the running screw, and its `running` says how the
/// search ended. `near`: the last slip ratio and spin of each nut that were found.
RunningEquilibrium running_equilibrium(const Conditions& c, const Contacts& contacts, const SlipModels& models,
                                       RunningRollers rollers, BodyAnswer at_rest, const RunningBodies& bodies,
                                       LoadCaseResult& loaded, SpinOfNuts& near);

/// How a search ends whose bodies end with this status.
RunningStatus running_status(fe::NewtonStatus status);

/// Largest load over that at rest; none for an interface without load.
std::optional<double> over_static(const InterfaceLoads& running, double largest_at_rest);

/// A component of friction and its axis.
struct FrictionComponent {
  std::vector<double> FrictionForces::*force;
  double contact::Vector3<double>::*axis;
};
inline constexpr FrictionComponent kFrictionComponents[] = {{&FrictionForces::radial, &contact::Vector3<double>::x},
                                                            {&FrictionForces::tangential, &contact::Vector3<double>::y},
                                                            {&FrictionForces::axial, &contact::Vector3<double>::z}};

inline double largest(const std::vector<double>& values) { return std::ranges::max(values); }

/// The push of no friction.
inline RollerPush no_push(std::size_t threads) {
  const std::vector<double> none(threads, 0.0);
  return {{none, none}, {none, none}};
}

}  // namespace prs
