#pragma once

#include <Eigen/Core>

#include "fe/cholesky.h"
#include "fe/equations.h"
#include "fe/newton_types.h"

namespace fe {

/// Newton's method for one set of equations. Holds the workspace (tangent, factorization, vectors),
/// so that many loads on one model share the symbolic analysis.
class NewtonSolver {
 public:
  explicit NewtonSolver(const Equations& equations);

  /// Minimises the potential energy under the load `f`, from the state `q`, which it updates.
  /// Every step is searched along for a smaller energy; the energy is convex, so a Newton step
  /// always descends.
  NewtonSummary solve(const Eigen::VectorXd& f, const NewtonOptions& options, State& q);

  /// Displacement rate dq/dt at the state `q` for the load rate df/dt = `rate`: tangent x = rate.
  /// False where the tangent is singular.
  bool solve_tangent(const State& q, const Eigen::VectorXd& rate, Eigen::VectorXd& x);

 private:
  double relative_residual(const NewtonOptions& options) const;
  bool residual_is_rounding(const State& q) const;
  FactorizationStatus factorize_tangent(const State& q, const NewtonOptions& options,
                                        double& shift);
  /// Halves the step until the energy falls; the state reached is `trial_`, its residual
  /// `residual_`.
  bool search_along_step(const Eigen::VectorXd& f, const NewtonOptions& options, const State& q,
                         double slope, double energy, NewtonIteration& iteration);
  FactorizationStatus factorize_shifted(const NewtonOptions& options, double& shift);

  const Equations* equations_;
  SparseSymmetric tangent_;
  Cholesky cholesky_;
  Eigen::VectorXd residual_, step_;
  State trial_;
};

}  // namespace fe
