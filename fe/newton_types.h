#pragma once

#include <limits>
#include <string_view>
#include <vector>

#include "fe/lanes.h"
#include "simd/inlined.h"

namespace fe {

struct NewtonOptions {
  /// Largest residual over `force_scale` (moments over `length_scale` as well) that counts as
  /// equilibrium. Rounding allows about 1e-14 on a roller-screw sector.
  double residual_tolerance = 1e-12;
  /// Residual up to which a state that does not improve any further is equilibrium too, if stiffnesses are so far apart
  /// that rounding of the state alone exceeds `residual_tolerance`.
  double rounding_tolerance = 1e-11;
  /// Largest energy that the last step may have gained, relative to the energy of the state.
  double energy_tolerance = 1e-8;
  /// A state this close to equilibrium takes one step with the last factorization, at a third of
  /// the cost: its error shrinks as much as the last step changed the tangent, about 1e-3.
  double reuse_factorization_below = 1e-8;
  /// Largest change, relative to the largest force of a spring, that one more step may still bring to a spring's force.
  /// Estimated as the last step's change times the share of the residual that it left.
  double force_tolerance = 1e-10;
  int max_iterations = 500;
  /// Largest number of halvings before the search is given up.
  int max_halvings = 100;
  /// Armijo's share of the energy decrease predicted by the slope.
  double sufficient_decrease = 1e-4;
  /// The tangent is singular where too few springs are closed. Then, and only then, the step is
  /// taken with K + shift diag(K_linear), the shift growing from the first to the last value. The
  /// residual never contains the shift, so no regularisation is left in a converged state.
  double first_shift = 1e-10;
  double last_shift = 1.0;
  /// Smallest tangent of a spring in the matrix of a step, if too few springs are closed. The residual never contains
  /// it [N/m].
  double least_tangent = 0.0;
  /// Approach of a spring beyond which there is no equilibrium [m].
  double largest_approach = std::numeric_limits<double>::infinity();
  double force_scale = 1.0;   ///< [N]
  double length_scale = 1.0;  ///< [m]

  /// Linear solves allowed for a model with `springs` springs: one more for every 20 beyond 200,
  /// since in a thread of thousands of contacts only a few open in each step.
  int iteration_limit(int springs) const { return max_iterations + (springs > 200 ? (springs - 200) / 20 : 0); }

  // Stopping criteria for numbers and batches of them, inlined since kernels compile them for several instruction sets.
  // Residuals are relative to the force scale; `change` is the last step's change of a spring's force, relative to the
  // largest.

  /// Whether a step with the predicted decrease d'r hardly changes the energy any more.
  template <class Real>
  PRS_INLINED Lanes<Real> settled(const Real& slope, const Real& energy) const {
    return slope <= energy_tolerance * abs(energy);
  }
  template <class Real>
  PRS_INLINED Lanes<Real> small(const Real& residual) const {
    return residual <= residual_tolerance;
  }
  /// Whether one more step would hardly change a force.
  template <class Real>
  PRS_INLINED Lanes<Real> exact(const Real& change, const Real& residual, const Real& before) const {
    return change * residual <= force_tolerance * before;
  }
  template <class Real>
  PRS_INLINED Lanes<Real> stalled(const Real& residual, const Real& before) const {
    return residual > 0.1 * before;
  }
  /// Whether a residual that cannot fall for rounding is small enough.
  template <class Real>
  PRS_INLINED Lanes<Real> rounded(const Real& change, const Real& residual) const {
    return (residual <= rounding_tolerance) & (change <= force_tolerance);
  }
};

enum class NewtonStatus {
  converged,
  iteration_limit,
  line_search_failed,
  not_positive_definite,
  no_equilibrium,
  mechanism,  ///< A part can move freely; stated by callers, not by the solver.
};

std::string_view name(NewtonStatus status);

/// One linear solve and the state it led to.
struct NewtonIteration {
  double energy = 0.0;             ///< Energy [J]; NaN if the solver does not use it.
  double relative_residual = 0.0;  ///< Relative residual after the step.
  double step_length = 0.0;        ///< Share of the full Newton step.
  double shift = 0.0;              ///< Regularisation of this step's matrix; usually 0.
};

/// Reason why the solver stopped, initially a failure, and its history.
struct NewtonSummary {
  NewtonStatus status = NewtonStatus::iteration_limit;
  double initial_relative_residual = 0.0;
  double relative_residual = 0.0;
  double energy = 0.0;
  bool at_rounding = false;  ///< Whether it was stopped by the rounding of the state, above `residual_tolerance`.
  bool wide = false;         ///< Whether doubles were not enough: the last steps used wider numbers.
  std::vector<NewtonIteration> history;

  bool converged() const { return status == NewtonStatus::converged; }
  /// Linear solves, the first included.
  int iterations() const { return static_cast<int>(history.size()); }
};

}  // namespace fe
