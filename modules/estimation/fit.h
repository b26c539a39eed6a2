#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "modules/module.h"

/// Estimation of unknowns of any function from readings, with their uncertainty: docs/fit.md. Plain vectors in and out;
/// the caller provides the function.
namespace modules::fit {

/// An unknown of the function. Its value, or with `is_log` the value's logarithm, is linear in z from 0 at `from` to 1
/// at `to`. All numbers here and in results are those of the value; intervals of logarithms are exponentials,
/// deviations those of the logarithm times the value.
struct Unknown {
  double from = 0.0, to = 1.0, start = 0.0;
  bool is_bounded = true;  ///< 0 <= z <= 1
  struct Prior {
    double mean = 0.0, deviation = 1.0;
  };
  std::optional<Prior> prior = {};
  /// Whether it is added to the curve that names it instead of being an input of the function.
  bool is_offset = false;
  bool is_log = false;
};

/// rho(s), s = r^2: squares s; huber s up to k^2, then 2 k sqrt(s) - k^2; cauchy k^2 ln(1 + s/k^2).
struct Loss {
  enum class Kind { squares, huber, cauchy };
  Kind kind = Kind::squares;
  double scale = 1.0;

  bool is_robust() const { return kind != Kind::squares; }
};

struct Curve {
  enum class Use { fit, compare, band };  ///< `band`: computed, without readings.
  Use use = Use::fit;
  std::size_t rows = 0;
  std::vector<double> measured = {};
  std::vector<double> deviation = {};  ///< Standard deviation of each reading; empty: estimated.
  Loss loss = {};
  std::optional<std::size_t> offset = {};  ///< Index of the unknown; for `compare` not an unknown.
  bool has_free_mean = false;              ///< `compare` with an offset.
};

struct Failure {
  std::size_t curve = 0, row = 0;
  std::string reason;
  bool is_refused = false;
};

/// Request for values of some curves at values of the unknowns.
struct Request {
  std::vector<double> values;
  std::vector<bool> curves;
};
struct Answer {
  std::vector<std::vector<double>> values;  ///< Values of each requested curve.
  std::optional<Failure> failure = {};
};
/// Function that answers all requests, side by side.
using Evaluate = std::function<std::vector<Answer>(const std::vector<Request>&)>;

struct Problem {
  std::vector<Unknown> unknowns;
  std::vector<Curve> curves;
  Evaluate evaluate;
  double level = 0.9;
  std::size_t starts = 1;
  std::vector<std::size_t> profile = {};
};

/// Outcome, the worst first.
enum class Status { no_equilibrium, not_identifiable, no_redundancy, iteration_limit, converged };

/// Estimate of an unknown, or of a response.
struct Estimate {
  double value = 0.0, deviation = 0.0, low = 0.0, high = 0.0;
  std::optional<double> degrees_of_freedom = {};  ///< Degrees of freedom of Student's quantile; absent: the normal one.
};

struct UnknownResult {
  bool is_identified = true;
  std::optional<double> value = {};
  std::optional<Estimate> estimate = {};
  int at_bound = 0;  ///< -1: `from`, 1: `to`.
  std::optional<double> profile_low = {}, profile_high = {};
  bool profile_failed = false;  ///< Whether an end was not found, which may lie within the bounds.
  bool prior_decides = false;
};

struct Runs {
  std::size_t count = 0;
  double expected = 0.0, p_value = 0.0;
};

struct CurveResult {
  std::vector<double> fitted, residual;  ///< `fitted` includes the offset.
  std::vector<double> deviation, weight;
  std::vector<double> low, high, band_deviation;  ///< Empty: no band.
  bool is_without_noise = false;                  ///< Whether the estimated deviation is at its lower bound.
  double rms = 0.0;
  std::optional<double> redundancy = {}, chi_square = {}, r_squared = {};
  std::optional<Runs> runs = {};
};

/// A direction that the data do not determine.
struct Unidentified {
  std::vector<std::size_t> unknowns;
  std::vector<double> direction;
  double ratio = 0.0;
  double factor = 0.0;                       ///< a + factor b; for logarithms a b^factor.
  std::optional<Estimate> combination = {};  ///< Estimate of the combination, for two unknowns of one scale.
};

struct StartResult {
  std::optional<double> objective = {};  ///< S + 2 sum n ln sigma over estimated deviations.
  std::vector<double> values = {};       ///< Values of the unknowns, if there is an objective.
  Status status = Status::no_equilibrium;
  bool is_best = false;
  bool is_another_minimum = false;  ///< Whether the objective is within 4 of the best.
};

struct Result {
  Status status = Status::no_equilibrium;
  std::optional<Failure> failure = {};
  bool failed_at_start = false;
  /// Row whose missing result made a search reduce its steps, so that it did not converge.
  std::optional<Failure> held_by = {};
  std::optional<std::size_t> without_influence = {};   ///< An unknown that no curve depends on.
  std::optional<std::size_t> without_redundancy = {};  ///< Curve.
  double objective = 0.0;
  double degrees_of_freedom = 0.0;
  std::optional<double> chi_square = {}, reduced_chi_square = {}, p_value = {};
  std::size_t iterations = 0;
  std::vector<UnknownResult> unknowns;
  std::vector<std::size_t> with_deviation;  ///< Unknowns in the covariance below.
  std::vector<std::vector<double>> covariance, correlation;
  std::vector<double> singular_value_ratios;
  std::vector<Unidentified> unidentified;
  std::vector<CurveResult> curves;
  std::vector<StartResult> starts;
};

Result solve(const Problem& problem);

struct FitModule : Module {
  static constexpr Name kName{"prs_fit.so", "Ceres Solver", "libceres-dev", ""};
  Result (*solve)(const Problem&);
};

}  // namespace modules::fit
