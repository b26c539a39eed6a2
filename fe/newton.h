#pragma once

#include <functional>
#include <memory>

#include "fe/equations.h"
#include "fe/newton_types.h"

namespace fe {

class WideNewton;

/// A load that grows with the forces of springs: constant + sum_k force_k per_force[k].
struct FollowingLoad {
  struct Share {
    int equation;
    double times;  ///< Load on the equation per force of the spring.
  };
  /// `loads`: per force of each spring.
  FollowingLoad(const Equations& equations, Eigen::VectorXd constant, const std::vector<std::vector<NodalLoad>>& loads);

  Eigen::VectorXd constant;
  std::vector<std::vector<Share>> per_force;  ///< Shares per force of each spring.
};

/// Newton's method for one set of equations. Holds the workspace (tangent, factorization, vectors), so that many loads
/// on one model share the symbolic analysis. If doubles lose the softest stiffness among the largest, it goes on in
/// wider numbers (WideNewton).
class NewtonSolver {
 public:
  /// `smallest_pivot_ratio`: see Cholesky::factorize; 0 if the caller knows that no motion is free.
  explicit NewtonSolver(const Equations& equations, double smallest_pivot_ratio = kSmallestPivotRatio);
  ~NewtonSolver();
  NewtonSolver(NewtonSolver&&) noexcept;
  NewtonSolver& operator=(NewtonSolver&&) noexcept;

  /// Updates the solver; call it after Equations::take.
  void equations_changed();

  /// Minimises the potential energy under the load `f`, from the state `q`, which it updates. Every step is searched
  /// along for a smaller energy; the energy is convex, so a Newton step always descends. `held`, if given, is called
  /// before wider numbers are used: if it returns false, nothing holds the load and they would only find that out more
  /// slowly.
  NewtonSummary solve(const Eigen::VectorXd& f, const NewtonOptions& options, State& q,
                      const std::function<bool()>& held = {});

  /// Continues to equilibrium under a load that follows the springs: with the tangent at `q`, factorized once, and if
  /// the residual does not shrink fast by Newton's method with the unsymmetric matrix. Returns false, with `q`
  /// unchanged, if that fails too.
  bool follow(const FollowingLoad& load, const NewtonOptions& options, State& q);

  /// Sets a state to start from: that of bilateral linear springs of the given stiffnesses in place of the contacts,
  /// gaps included. Returns false if the structure is still singular.
  bool start(const Eigen::VectorXd& f, const std::vector<double>& stiffness, State& q);

  /// Displacements by the loads on linear springs of the given stiffnesses in place of the contacts, each refined to
  /// rounding. Returns false if the structure is singular. `near`: the last factorization is reused if no stiffness in
  /// it differs by more than this share.
  bool solve_linear(const std::vector<double>& stiffness, const std::vector<Eigen::VectorXd>& loads,
                    std::vector<Eigen::VectorXd>& displacements, double near = 0.0);

  /// Displacement rate dq/dt at the state `q` for the load rate df/dt = `rate`: tangent x = rate, refined until rate'x
  /// is known to 1e-11. Returns false if the tangent is singular.
  bool solve_tangent(const State& q, const Eigen::VectorXd& rate, Eigen::VectorXd& x);

 private:
  struct Doubles;
  WideNewton& wide();

  const Equations* equations_;
  std::unique_ptr<Doubles> doubles_;
  std::unique_ptr<WideNewton> wide_;
};

}  // namespace fe
