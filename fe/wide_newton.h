#pragma once

#include <Eigen/Core>
#include <memory>

#include "fe/equations.h"
#include "fe/newton_types.h"

namespace fe {

/// Newton's method in numbers of 113 binary digits, for models whose stiffnesses are so far apart
/// that the assembled tangent loses the softest of them in double precision: stiffnesses 17 decades
/// apart keep 16 digits. Slower by a factor of about a hundred.
class WideNewton {
 public:
  explicit WideNewton(const Equations& equations);
  ~WideNewton();

  /// As NewtonSolver::solve, in at most `limit` linear solves.
  NewtonSummary solve(const Eigen::VectorXd& f, const NewtonOptions& options, int limit, State& q);

  /// As NewtonSolver::solve_tangent.
  bool solve_tangent(const State& q, const Eigen::VectorXd& rate, Eigen::VectorXd& x);

 private:
  struct Numbers;
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace fe
