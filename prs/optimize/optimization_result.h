#pragma once

#include "prs/model/optimization.h"
#include "prs/study/designs.h"

namespace prs {

/// A design and what came of it.
struct EvaluatedDesign {
  std::vector<Draw> draws;        ///< One per variable.
  std::vector<double> responses;  ///< NaN where the design has none.
  DesignStatus status;            ///< Refused where a response is missing.
  /// Sum of what is missing to each constraint, relative to its limit or the response of the file's
  /// own design, whichever is larger (of differences: to the larger response); infinite without an
  /// answer.
  double violation = 0.0;

  bool is_feasible() const { return status.converged() && violation == 0.0; }
};

/// Designs that one algorithm tried, `population` a generation.
struct Search {
  Algorithm algorithm = Algorithm::nsga2;
  std::vector<EvaluatedDesign> designs;
  /// Pareto front: indices of feasible designs for which no other is as good in every objective and
  /// better in one; the first of equal ones. Ascending in the first objective.
  std::vector<std::size_t> front;
};

/// How two fronts compare.
struct FrontComparison {
  /// Shares that each front dominates of the box between the best and the worst values of both
  /// fronts and the file's own design, 10 % wider; both 0 where a front is empty.
  double hypervolume = 0.0;
  double check_hypervolume = 0.0;
  /// Best values of each objective, in its unit.
  std::vector<double> best, check_best;
};

struct OptimizationResult {
  Optimization optimization;
  EvaluatedDesign initial;  ///< The file's own design.
  Search search;
  std::optional<Search> check;
  std::optional<FrontComparison> comparison;
  /// Pareto front of the designs of both searches, as that of one. These indices and the next count
  /// through the designs of the search, then those of the check.
  std::vector<std::size_t> front = {};
  std::optional<std::size_t> compromise = {};  ///< Absent where the front is empty.
  /// The answered design nearest to the constraints, if the front is empty.
  std::optional<std::size_t> nearest = {};

  std::size_t design_count() const;
  const EvaluatedDesign& design(std::size_t index) const;
  /// The search that tried a design.
  const Search& search_of(std::size_t index) const;

  /// The compromise or, without one, the nearest design; null where none has an answer.
  const EvaluatedDesign* chosen() const;
};

/// The number that a limit comes to in a design.
double limit_of(const Constraint& constraint, const EvaluatedDesign& design,
                const EvaluatedDesign& initial);

/// Value of a response in percent of that of the file's own design, less 100.
std::optional<double> change_percent(double value, double initial);

/// The values of a design as `--set` takes them: `mechanism.flank_angle.screw=42.5 deg`. Those that
/// are the file's are left out.
std::vector<std::string> settings_of(const Optimization& optimization,
                                     const EvaluatedDesign& design);

/// `screw.peak_pressure_MPa.max >= 0.9 x initial`, with numbers of a design.
std::string constraint_text(const OptimizationResult& result, const Constraint& constraint);

/// Whether a design keeps one of its constraints.
bool keeps(const Constraint& constraint, const EvaluatedDesign& design,
           const EvaluatedDesign& initial);

/// Designs of both searches, and how many of them were feasible and had no answer.
struct SearchCounts {
  std::size_t designs = 0;
  std::size_t feasible = 0;
  std::size_t without_answer = 0;
};
SearchCounts count(const Search& search);

}  // namespace prs
