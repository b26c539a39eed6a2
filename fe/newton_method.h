#pragma once

#include "fe/equations.h"
#include "fe/newton_types.h"
#include "fe/rounding.h"

namespace fe {

/// Largest number of steps with a shifted tangent in doubles, before wider numbers decide whether it is singular or
/// only seems so.
inline constexpr int kMostShifted = 8;

/// Relative residual of a state worth continuing from; a state reached with wrong digits may be far away.
inline constexpr double kNear = 1e-6;

/// Whether numbers with more digits may converge where these did not.
inline bool digits_may_help(const NewtonSummary& s) {
  return (s.status == NewtonStatus::line_search_failed || s.status == NewtonStatus::not_positive_definite) &&
         std::isfinite(s.relative_residual);
}

/// Adds the outcome of a solve that continued from the last one.
inline void continue_by(NewtonSummary further, NewtonSummary& summary) {
  further.initial_relative_residual = summary.initial_relative_residual;
  further.history.insert(further.history.begin(), summary.history.begin(), summary.history.end());
  summary = std::move(further);
}

/// Newton's method for any number type. `Numbers` holds the workspace and provides
///
/// - `Energy`, `State`, `Vector`: a number, displacements, and anything else that has an entry for
/// each equation
///
/// - `energy_and_residual(q, f, r)`, `tangent(q)`, `shift_by(change)`, `factorize()`, `solve(b, x)`
///
/// - `factorized_within(share)`: whether the last factorization is that of the last tangent but for
/// this share of the springs
///
/// - `solved(b, x)`: whether x solves for b at all
///
/// - `set_to_step(trial, q, length, step)`: trial = q - length * step
///
/// - `energy_rounding(q, f, energy)`: difference below which two energies count as equal
///
/// - `force_change(q, step)`, `force_rounding(q)`: as Equations has them
///
/// - `residual_is_rounding(q, r)`: whether the residual may be rounding only; `kMostStalls`: number
/// of steps without a decrease of energy or residual after which it counts as rounding too;
/// `kNoGain`: a shortened step whose promised gain is less than this share of `energy_rounding`
/// shows that the step is none that descends
template <class Numbers>
class NewtonMethod {
 public:
  using Energy = typename Numbers::Energy;
  using State = typename Numbers::State;
  using Vector = typename Numbers::Vector;

  template <class... Arguments>
  explicit NewtonMethod(const Equations& equations, Arguments&... arguments)
      : equations_(&equations),
        numbers_(equations, arguments...),
        residual_(equations.size()),
        residual_of_full_step_(equations.size()),
        step_(equations.size()),
        trial_(numbers_.zero_state()),
        further_(numbers_.zero_state()) {}

  Numbers& numbers() { return numbers_; }

  /// Minimises the potential energy under the load `f`, starting from the state `q`, which it
  /// updates. Takes at most `limit` linear solves, at most `shifted_limit` of them with a shift.
  NewtonSummary solve(const Eigen::VectorXd& f, const NewtonOptions& options, int limit, int shifted_limit, State& q) {
    NewtonSummary summary;
    summary.history.reserve(8);
    Energy energy = numbers_.energy_and_residual(q, f, residual_);
    summary.energy = static_cast<double>(energy);
    summary.initial_relative_residual = summary.relative_residual = relative_residual(options);
    const auto stop = [&](NewtonStatus status) {
      summary.status = status;
      return summary;
    };

    bool fresh = false;  // whether the factorization was made at the start of the last step
    bool slow = false;   // whether the last step left more than a tenth of the residual
    int shifted = 0, stalls = 0;
    while (summary.iterations() < limit) {
      NewtonIteration iteration;
      fresh = !(fresh && !slow && summary.relative_residual <= options.reuse_factorization_below);
      if (fresh) {
        numbers_.tangent(q, options.least_tangent);
        const bool must_be_same = slow || options.reuse_factorization_below == 0.0;
        fresh = residual_.size() < kFewUnknowns ||
                !numbers_.factorized_within(must_be_same ? kSameTangent : kSimilarTangent);
      }
      if (fresh) {
        if (factorize_shifted(options, iteration.shift) != FactorizationStatus::ok)
          return stop(NewtonStatus::not_positive_definite);
        if (iteration.shift > 0.0 && ++shifted > shifted_limit) return stop(NewtonStatus::not_positive_definite);
      }
      numbers_.solve(residual_, step_);
      if (summary.iterations() >= kUsualIterations && !numbers_.solved(residual_, step_))
        return stop(NewtonStatus::not_positive_definite);
      const double slope = -static_cast<double>(residual_.dot(step_));
      const bool descended = search_along_step(f, options, q, slope, energy, iteration);
      iteration.relative_residual = relative_residual(options);
      summary.history.push_back(iteration);
      if (!descended) return stop(NewtonStatus::line_search_failed);
      const double left = summary.history.back().relative_residual / summary.relative_residual;
      if (iteration.step_length == 1.0 && left > kLeastLeft && left < kMostLeft &&
          step_further(f, options, q, energy, iteration))
        summary.history.back() = iteration;

      std::swap(q, trial_);
      if (numbers_.largest_approach(q) > options.largest_approach) return stop(NewtonStatus::no_equilibrium);
      const double before = summary.relative_residual;
      summary.energy = iteration.energy;
      summary.relative_residual = iteration.relative_residual;
      const bool stalled = slow = options.stalled(summary.relative_residual, before);
      if (!options.settled(-slope, summary.energy)) continue;
      const bool energy_is_rounding = -slope <= numbers_.energy_rounding(q, f, energy);

      const bool small = options.small(summary.relative_residual);
      if (!small && !stalled) continue;
      const double change = numbers_.force_change(q, step_);
      const bool exact = before == 0.0 || options.exact(change, summary.relative_residual, before);
      const auto resolved = [&] { return numbers_.force_rounding(q) <= options.force_tolerance; };
      if (small && exact) return stop(resolved() ? NewtonStatus::converged : NewtonStatus::line_search_failed);
      // Springs at the point of closing leave a fifth of the residual per step.
      if (energy_is_rounding && summary.relative_residual > kNoLess * before) ++stalls;
      if (stalls > Numbers::kMostStalls || (stalled && numbers_.residual_is_rounding(q, residual_))) {
        summary.at_rounding = true;
        return stop(options.rounded(change, summary.relative_residual) && resolved()
                        ? NewtonStatus::converged
                        : NewtonStatus::line_search_failed);
      }
    }
    return summary;
  }

 private:
  /// Number of linear solves after which their accuracy is checked.
  static constexpr int kUsualIterations = 20;
  /// Share of the last residual above which a step counts as no decrease: a sign of lost digits, not of closing
  /// threads.
  static constexpr double kNoLess = 0.3;

  /// Largest changes of the springs' tangents, relative to the last factorization, with which a step reuses it: a step
  /// costs a twentieth of a factorization of a large model. After a step that left much of the residual only the same
  /// tangent is reused.
  static constexpr double kSimilarTangent = 1e-2, kSameTangent = 1e-6;
  /// Number of unknowns below which a new factorization costs no more than a step.
  static constexpr int kFewUnknowns = 800;
  /// A spring with force ~ w^1.5 that has to open, and nothing else at its end, goes from w to w/3, which leaves 3^-1.5
  /// = 0.19 of its force; a step of 1.5 times the length ends at zero, a slightly longer one opens it.
  static constexpr double kLeastLeft = 0.1, kMostLeft = 0.3, kOpeningStep = 1.6;

  double relative_residual(const NewtonOptions& options) const {
    double force = 0.0, moment = 0.0;
    for (int i = 0; i < equations_->size(); ++i) {
      double& largest = equations_->kind(i) == Dof::theta ? moment : force;
      const double r = std::abs(static_cast<double>(residual_[i]));
      if (!(r <= largest)) largest = r;  // keeps a NaN
    }
    moment /= options.length_scale;
    return (moment > force || std::isnan(moment) ? moment : force) / options.force_scale;
  }

  FactorizationStatus factorize_shifted(const NewtonOptions& options, double& shift) {
    shift = 0.0;
    FactorizationStatus status = numbers_.factorize();
    while (status == FactorizationStatus::not_positive_definite && shift < options.last_shift) {
      const double next = shift == 0.0 ? options.first_shift : kShiftGrowth * shift;
      numbers_.shift_by(next - shift);
      shift = next;
      status = numbers_.factorize();
    }
    return status;
  }

  /// Halves the step until the energy falls; the state reached is `trial_`, its residual
  /// `residual_`, its energy `energy`.
  bool search_along_step(const Eigen::VectorXd& f, const NewtonOptions& options, const State& q, double slope,
                         Energy& energy, NewtonIteration& iteration) {
    const double rounding = numbers_.energy_rounding(q, f, energy);
    double length = 1.0;
    for (int halvings = 0; halvings <= options.max_halvings; ++halvings, length *= 0.5) {
      if (length < 1.0 && -slope * length < Numbers::kNoGain * rounding) return false;
      Numbers::set_to_step(trial_, q, length, step_);
      const Energy reached = numbers_.energy_and_residual(trial_, f, residual_);
      iteration.energy = static_cast<double>(reached);
      iteration.step_length = length;
      if (reached <= energy + (options.sufficient_decrease * length * slope + rounding)) {
        energy = reached;
        return true;
      }
    }
    return false;
  }

  /// Opens springs that the full step to `trial_` leaves closed, if the residual falls by that.
  bool step_further(const Eigen::VectorXd& f, const NewtonOptions& options, const State& q, Energy& energy,
                    NewtonIteration& iteration) {
    Numbers::set_to_step(further_, q, kOpeningStep, step_);
    residual_.swap(residual_of_full_step_);
    const Energy reached = numbers_.energy_and_residual(further_, f, residual_);
    const double residual = relative_residual(options);
    if (!(residual < 0.5 * iteration.relative_residual) || reached > energy + numbers_.energy_rounding(q, f, energy)) {
      residual_.swap(residual_of_full_step_);
      return false;
    }
    std::swap(trial_, further_);
    energy = reached;
    iteration.energy = static_cast<double>(reached);
    iteration.relative_residual = residual;
    iteration.step_length = kOpeningStep;
    return true;
  }

  const Equations* equations_;
  Numbers numbers_;
  Vector residual_, residual_of_full_step_, step_;
  State trial_, further_;
};

}  // namespace fe
