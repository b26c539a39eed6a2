#include "fe/newton.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fe/index.h"

namespace fe {

std::string_view name(NewtonStatus status) {
  switch (status) {
    case NewtonStatus::converged:
      return "converged";
    case NewtonStatus::iteration_limit:
      return "iteration_limit";
    case NewtonStatus::line_search_failed:
      return "line_search_failed";
    case NewtonStatus::not_positive_definite:
      return "not_positive_definite";
  }
  return "unknown";
}

NewtonSolver::NewtonSolver(const Equations& equations)
    : equations_(&equations),
      tangent_(equations.linear_stiffness()),
      cholesky_(tangent_),
      residual_(equations.size()),
      step_(equations.size()),
      trial_(Eigen::VectorXd::Zero(equations.size())) {}

double NewtonSolver::relative_residual(const NewtonOptions& options) const {
  double force = 0.0, moment = 0.0;
  for (int i = 0; i < equations_->size(); ++i) {
    double& largest = equations_->kind(i) == Dof::theta ? moment : force;
    const double r = std::abs(residual_[i]);
    if (!(r <= largest)) largest = r;  // keeps a NaN
  }
  moment /= options.length_scale;
  return (moment > force || std::isnan(moment) ? moment : force) / options.force_scale;
}

bool NewtonSolver::residual_is_rounding(const State& q) const {
  return (residual_.array().abs() <= equations_->rounding_residual(q).array()).all();
}

FactorizationStatus NewtonSolver::factorize_shifted(const NewtonOptions& options, double& shift) {
  shift = 0.0;
  FactorizationStatus status = cholesky_.factorize(tangent_);
  const SparseSymmetric& linear = equations_->linear_stiffness();
  while (status == FactorizationStatus::not_positive_definite && shift < options.last_shift) {
    const double next = shift == 0.0 ? options.first_shift : 100.0 * shift;
    for (int j = 0; j < tangent_.size(); ++j) {
      const int diagonal = at(tangent_.column_start, j + 1) - 1;
      at(tangent_.value, diagonal) += (next - shift) * at(linear.value, diagonal);
    }
    shift = next;
    status = cholesky_.factorize(tangent_);
  }
  return status;
}

FactorizationStatus NewtonSolver::factorize_tangent(const State& q, const NewtonOptions& options,
                                                    double& shift) {
  equations_->tangent_stiffness(q, tangent_);
  return factorize_shifted(options, shift);
}

bool NewtonSolver::search_along_step(const Eigen::VectorXd& f, const NewtonOptions& options,
                                     const State& q, double slope, double energy,
                                     NewtonIteration& iteration) {
  // Near the solution the gain drowns in the rounding of the energy, a difference of large works.
  const double rounding =
      64.0 * std::numeric_limits<double>::epsilon() * (std::abs(energy) + std::abs(f.dot(q.head)));
  double length = 1.0;
  for (int halvings = 0; halvings <= options.max_halvings; ++halvings, length *= 0.5) {
    trial_.set_to_step(q, length, step_);
    iteration.energy = equations_->energy_and_residual(trial_, f, residual_);
    iteration.step_length = length;
    if (iteration.energy <= energy + options.sufficient_decrease * length * slope + rounding)
      return true;
  }
  return false;
}

NewtonSummary NewtonSolver::solve(const Eigen::VectorXd& f, const NewtonOptions& options,
                                  State& q) {
  NewtonSummary summary;
  summary.history.reserve(8);
  summary.energy = equations_->energy_and_residual(q, f, residual_);
  summary.initial_relative_residual = summary.relative_residual = relative_residual(options);
  const auto stop = [&](NewtonStatus status) {
    summary.status = status;
    return summary;
  };

  bool fresh = false;  // whether the factorization is that of the last step's start
  while (summary.iterations() < options.max_iterations) {
    NewtonIteration iteration;
    fresh = !(fresh && summary.relative_residual <= options.reuse_factorization_below);
    if (fresh && factorize_tangent(q, options, iteration.shift) != FactorizationStatus::ok)
      return stop(NewtonStatus::not_positive_definite);
    cholesky_.solve(residual_, step_);
    const double slope = -residual_.dot(step_);
    const bool descended = search_along_step(f, options, q, slope, summary.energy, iteration);
    iteration.relative_residual = relative_residual(options);
    summary.history.push_back(iteration);
    if (!descended) return stop(NewtonStatus::line_search_failed);

    std::swap(q, trial_);
    const bool stalled = iteration.relative_residual > 0.1 * summary.relative_residual;
    summary.energy = iteration.energy;
    summary.relative_residual = iteration.relative_residual;
    if (-slope > options.energy_tolerance * std::abs(summary.energy)) continue;
    if (summary.relative_residual <= options.residual_tolerance)
      return stop(NewtonStatus::converged);
    if (stalled && residual_is_rounding(q)) {
      summary.at_rounding = true;
      return stop(summary.relative_residual <= options.rounding_tolerance
                      ? NewtonStatus::converged
                      : NewtonStatus::line_search_failed);
    }
  }
  return summary;
}

bool NewtonSolver::solve_tangent(const State& q, const Eigen::VectorXd& rate, Eigen::VectorXd& x) {
  equations_->tangent_stiffness(q, tangent_);
  if (cholesky_.factorize(tangent_) != FactorizationStatus::ok) return false;
  cholesky_.solve(rate, x);
  return true;
}

}  // namespace fe
