#include "fe/newton.h"

#include <Eigen/SparseLU>

#include "fe/newton_method.h"
#include "fe/wide_newton.h"

namespace fe {
namespace {

using Eigen::VectorXd;

constexpr double kTangentTolerance = 1e-11;
constexpr int kMostRefinements = 10;
/// Relative correction after which the next one would be rounding.
constexpr double kRefined = 1e-8;

class DoubleNumbers : public DoubleTangent {
 public:
  static constexpr int kMostStalls = 3;
  static constexpr double kNoGain = 1e-3;
  using Energy = double;
  using State = fe::State;
  using Vector = VectorXd;

  explicit DoubleNumbers(const Equations& equations) : DoubleTangent(equations), equations_(&equations) {}

  State zero_state() const { return Vector(Vector::Zero(equations_->size())); }

  double energy_and_residual(const State& q, const Vector& f, Vector& residual) const {
    return equations_->energy_and_residual(q, f, residual);
  }
  /// The factorized secant matrix, kept for later calls: models that differ in gaps and loads share it. Null if it is
  /// singular.
  const Cholesky* start_factor() {
    if (matrix().value != start_value_) {
      start_value_ = matrix().value;
      start_.reset();
      return factorize() == FactorizationStatus::ok ? &cholesky() : nullptr;
    }
    if (!start_) {
      start_ = std::make_unique<Cholesky>(matrix());
      if (start_->factorize(matrix(), smallest_pivot_ratio) != FactorizationStatus::ok) start_.reset();
    }
    return start_.get();
  }
  double force_change(const State& q, const Vector& x) const { return equations_->force_change(q, x); }
  double largest_approach(const State& q) const { return equations_->largest_approach(q); }
  double force_rounding(const State& q) const { return equations_->force_rounding(q); }
  bool residual_is_rounding(const State& q, const Vector& residual) const {
    return (residual.array().abs() <= equations_->rounding_residual(q).array()).all();
  }
  /// Rounding of the energy, a difference of large works.
  static double energy_rounding(const State& q, const Vector& f, double energy) {
    return kEnergyRounding * (std::abs(energy) + std::abs(f.dot(q.head)));
  }
  static void set_to_step(State& to, const State& from, double length, const Vector& step) {
    to.set_to_step(from, length, step);
  }

 private:
  const Equations* equations_;
  std::vector<double> start_value_;
  std::unique_ptr<Cholesky> start_;
};

/// The tangent minus the derivative of the following load: K + (B - P)' t B.
Eigen::SparseMatrix<double> unsymmetric(const SparseSymmetric& tangent, const Equations& equations,
                                        const FollowingLoad& load, const State& q) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < tangent.size(); ++j)
    for (int k = at(tangent.column_start, j); k < at(tangent.column_start, j + 1); ++k) {
      const int i = at(tangent.row, k);
      entries.emplace_back(i, j, at(tangent.value, k));
      if (i != j) entries.emplace_back(j, i, at(tangent.value, k));
    }
  for (std::size_t k = 0; k < load.per_force.size(); ++k) {
    const Equations::Spring& spring = equations.springs()[k];
    const double stiffness = equations.response(q, static_cast<int>(k)).tangent;
    for (const FollowingLoad::Share& share : load.per_force[k])
      for (std::size_t i = 0; i < spring.count; ++i)
        entries.emplace_back(share.equation, spring.equation[i], -stiffness * share.times * spring.coefficient[i]);
  }
  Eigen::SparseMatrix<double> matrix(tangent.size(), tangent.size());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

std::string_view name(NewtonStatus status) {
  constexpr std::string_view kNames[] = {
      "converged", "iteration_limit", "line_search_failed", "not_positive_definite", "no_equilibrium", "mechanism"};
  return kNames[static_cast<std::size_t>(status)];
}

struct NewtonSolver::Doubles {
  explicit Doubles(const Equations& equations)
      : method(equations), residual(equations.size()), correction(equations.size()) {}

  NewtonMethod<DoubleNumbers> method;
  VectorXd residual, correction;
};

NewtonSolver::NewtonSolver(const Equations& equations, double smallest_pivot_ratio)
    : equations_(&equations), doubles_(std::make_unique<Doubles>(equations)) {
  doubles_->method.numbers().smallest_pivot_ratio = smallest_pivot_ratio;
}
NewtonSolver::~NewtonSolver() = default;
NewtonSolver::NewtonSolver(NewtonSolver&&) noexcept = default;
NewtonSolver& NewtonSolver::operator=(NewtonSolver&&) noexcept = default;

void NewtonSolver::equations_changed() {
  wide_.reset();
  doubles_->method.numbers().forget();
}

WideNewton& NewtonSolver::wide() {
  if (!wide_) wide_ = std::make_unique<WideNewton>(*equations_, doubles_->method.numbers());
  return *wide_;
}

NewtonSummary NewtonSolver::solve(const VectorXd& f, const NewtonOptions& options, State& q,
                                  const std::function<bool()>& held) {
  const int limit = options.iteration_limit(static_cast<int>(equations_->springs().size()));
  const State start = q;
  NewtonSummary summary = doubles_->method.solve(f, options, limit, kMostShifted, q);
  if (!digits_may_help(summary)) return summary;
  if (held && !held()) {
    summary.status = NewtonStatus::no_equilibrium;
    return summary;
  }
  if (!(summary.relative_residual <= kNear)) q = start;
  continue_by(wide().solve(f, options, limit - summary.iterations(), q), summary);
  return summary;
}

FollowingLoad::FollowingLoad(const Equations& equations, VectorXd unchanged,
                             const std::vector<std::vector<NodalLoad>>& loads)
    : constant(std::move(unchanged)), per_force(loads.size()) {
  for (std::size_t k = 0; k < loads.size(); ++k) {
    per_force[k].reserve(loads[k].size());
    equations.for_each_load(loads[k], [&](int equation, double force) {
      if (force != 0.0) per_force[k].push_back({equation, force});
    });
  }
}

bool NewtonSolver::follow(const FollowingLoad& load, const NewtonOptions& options, State& q) {
  constexpr int kMostSteps = 40, kFullSteps = 10;
  constexpr double kMuchTheSame = 0.05;  // Change of stiffness that friction tolerates less exactly.
  DoubleNumbers& numbers = doubles_->method.numbers();
  VectorXd &residual = doubles_->residual, &correction = doubles_->correction;
  const State first = q;
  double left = 0.0;  // Remaining relative residual of the forces.
  const auto left_at = [&](const State& state) {
    equations_->linear_forces(state, residual);
    residual -= load.constant;
    for (std::size_t k = 0; k < load.per_force.size(); ++k) {
      const Equations::Spring& spring = equations_->springs()[k];
      const double force = equations_->response(state, static_cast<int>(k)).force;
      for (std::size_t i = 0; i < spring.count; ++i) residual[spring.equation[i]] += force * spring.coefficient[i];
      for (const FollowingLoad::Share& share : load.per_force[k]) residual[share.equation] -= force * share.times;
    }
    double largest = 0.0;
    for (int i = 0; i < equations_->size(); ++i)
      largest =
          std::max(largest, std::abs(residual[i]) / (equations_->kind(i) == Dof::theta ? options.length_scale : 1.0));
    return largest / options.force_scale;
  };
  numbers.tangent(q, 0.0);
  if (!numbers.factorized_within(kMuchTheSame) && numbers.factorize() != FactorizationStatus::ok) return false;
  Eigen::SparseLU<Eigen::SparseMatrix<double>> lu;
  for (const bool newton : {false, true}) {
    double before = std::numeric_limits<double>::infinity();
    for (int step = 0; step < kMostSteps; ++step, before = left) {
      left = left_at(q);
      const bool fast = left < 0.5 * before;
      const bool small =
          left <= options.rounding_tolerance || (newton && !fast && numbers.residual_is_rounding(q, residual));
      if (newton ? !std::isfinite(left) : !small && !fast) break;
      if (newton) {
        numbers.tangent(q, 0.0);
        lu.compute(unsymmetric(numbers.matrix(), *equations_, load, q));
        if (lu.info() != Eigen::Success) break;
        correction = lu.solve(residual);
      } else {
        numbers.solve(residual, correction);
      }
      // Full steps can cycle if springs open and close in turn.
      q.set_to_step(State(q), step < kFullSteps || fast ? 1.0 : 0.5, correction);
      // This step reduces the error found to a tenth.
      if (left <= options.residual_tolerance || (small && !fast)) return true;
    }
    q = first;
  }
  return false;
}

bool NewtonSolver::start(const VectorXd& f, const std::vector<double>& stiffness, State& q) {
  DoubleNumbers& numbers = doubles_->method.numbers();
  VectorXd& residual = doubles_->residual;
  q = State(VectorXd::Zero(equations_->size()));
  equations_->secant_residual(stiffness, f, residual);
  numbers.secant(stiffness);
  const Cholesky* factor = numbers.start_factor();
  if (!factor) return false;
  factor->solve(residual, doubles_->correction);
  q.set_to_step(q, -1.0, doubles_->correction);
  return true;
}

bool NewtonSolver::solve_linear(const std::vector<double>& stiffness, const std::vector<VectorXd>& loads,
                                std::vector<VectorXd>& displacements, double near) {
  DoubleNumbers& numbers = doubles_->method.numbers();
  numbers.secant(stiffness);
  if (!(near > 0.0 && numbers.factorized_within(near)) && numbers.factorize() != FactorizationStatus::ok) return false;
  VectorXd& correction = doubles_->correction;
  for (const VectorXd& load : loads) {
    VectorXd x;
    numbers.solve(load, x);
    State refined(std::move(x));
    // A refinement leaves about the square of the error that it corrects.
    for (int k = 0; k < kMostRefinements; ++k) {
      equations_->secant_residual(stiffness, refined, load, doubles_->residual);
      numbers.solve(doubles_->residual, correction);
      refined.set_to_step(refined, -1.0, correction);
      if (correction.norm() <= kRefined * refined.head.norm()) break;
    }
    displacements.push_back(std::move(refined.head));
  }
  return true;
}

bool NewtonSolver::solve_tangent(const State& q, const VectorXd& rate, VectorXd& x) {
  DoubleNumbers& numbers = doubles_->method.numbers();
  numbers.tangent(q, 0.0);
  if (numbers.factorize() != FactorizationStatus::ok) return wide().solve_tangent(q, rate, x);
  VectorXd& residual = doubles_->residual;
  VectorXd& correction = doubles_->correction;
  numbers.solve(rate, x);
  State refined(x);
  for (int k = 0; k <= kMostRefinements; ++k) {
    equations_->tangent_residual(q, refined, rate, residual);
    if (std::abs(refined.head.dot(residual)) <= kTangentTolerance * refined.head.dot(rate)) {
      x = refined.head;
      return true;
    }
    numbers.solve(residual, correction);
    refined.set_to_step(State(refined), -1.0, correction);
  }
  return wide().solve_tangent(q, rate, x);
}

}  // namespace fe
