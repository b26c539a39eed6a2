#pragma once

#include <memory>

#include "fe/double_tangent.h"
#include "fe/newton_types.h"

namespace fe {

/// Newton's method in numbers of 113 binary digits, for models whose stiffnesses are so far apart
/// that doubles lose the softest of them: stiffnesses 17 decades apart keep 16 digits. Mechanisms with random
/// deviations, free rings and loads near the limit of equilibrium need wide forces; bodies that are rigid compared
/// with their contacts need wide tangents, too.
class WideNewton {
 public:
  /// `doubles`: tangent and factorization of the steps in doubles.
  WideNewton(const Equations& equations, DoubleTangent& doubles);
  ~WideNewton();

  /// Solves as NewtonSolver::solve does, in at most `limit` linear solves: forces are those of wide numbers,
  /// but steps are solved for in doubles, whose errors the next step takes away. Where these are
  /// too large, it goes on with a tangent in wide numbers, a thousand times as slow.
  NewtonSummary solve(const Eigen::VectorXd& f, const NewtonOptions& options, int limit, State& q);

  /// See NewtonSolver::solve_tangent.
  bool solve_tangent(const State& q, const Eigen::VectorXd& rate, Eigen::VectorXd& x);

 private:
  struct Methods;
  std::unique_ptr<Methods> methods_;
};

}  // namespace fe
