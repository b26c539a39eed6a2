#pragma once

#include "prs/study/design_engine.h"
#include "prs/study/study_run.h"

namespace prs {

/// A design and its results.
struct EvaluatedDesign {
  std::vector<Draw> draws;        ///< One draw per variable.
  std::vector<double> responses;  ///< NaN if the design has no value.
  DesignStatus status;            ///< Refused if a response is missing.
  /// Sum of the violations of all constraints, relative to the limit or the response of the file's own design,
  /// whichever is larger (for differences: to the larger response); infinite without a result.
  double violation = 0.0;

  bool is_feasible() const { return status.converged() && violation == 0.0; }
};

/// Designs that one algorithm tried, `population` per generation.
struct Search {
  Algorithm algorithm = Algorithm::nsga2;
  std::vector<EvaluatedDesign> designs;
  /// Pareto front: indices of feasible designs for which no other is as good in every objective and
  /// better in one; the first of equal ones. Ascending in the first objective.
  std::vector<std::size_t> front;
};

/// Comparison of two fronts.
struct FrontComparison {
  /// Shares that each front dominates of the box between the best and the worst values of both fronts and the file's
  /// own design, 10 % wider; both 0 if a front is empty.
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
  /// Pareto front of the designs of both searches together. These indices and the next count through the designs of the
  /// search, then those of the check.
  std::vector<std::size_t> front = {};
  std::optional<std::size_t> compromise = {};  ///< Absent if the front is empty.
  /// The design with a result nearest to the constraints, if the front is empty.
  std::optional<std::size_t> nearest = {};

  std::size_t design_count() const;
  const EvaluatedDesign& design(std::size_t index) const;
  /// The search that tried a design.
  const Search& search_of(std::size_t index) const;

  /// The compromise or, without one, the nearest design; null if no design has a result.
  const EvaluatedDesign* chosen() const;
};

/// Value of a limit for a design.
double limit_of(const Constraint& constraint, const EvaluatedDesign& design, const EvaluatedDesign& initial);

/// Value of a response in percent of that of the file's own design, less 100.
std::optional<double> change_percent(double value, double initial);

/// Values of a design as `--set` takes them: `mechanism.flank_angle.screw=42.5 deg`, without those equal to the file's.
std::vector<std::string> settings_of(const Optimization& optimization, const EvaluatedDesign& design);

/// `screw.peak_pressure_MPa.max >= 0.9 x initial`, with numbers of a design.
std::string constraint_text(const OptimizationResult& result, const Constraint& constraint);

/// Whether a design satisfies one of its constraints.
bool keeps(const Constraint& constraint, const EvaluatedDesign& design, const EvaluatedDesign& initial);

/// Number of designs of both searches, of feasible ones and of those without a result.
struct SearchCounts {
  std::size_t designs = 0;
  std::size_t feasible = 0;
  std::size_t without_answer = 0;
};
SearchCounts count(const Search& search);

/// Numbers to minimise for which domination is Deb's constrained domination (Deb et al. 2002, IEEE Trans. Evol. Comput.
/// 6, section VI): any feasible design before any infeasible one, of two infeasible ones that with less violation.
///
/// A feasible design has its objectives, oriented so that less is better, relative to `scales`, unchanged up to 1000
/// and beyond that compressed to below 2000 without changing their order. An infeasible one has 4000 + 1000 v/(1 + v)
/// with its violation v in all of them, one without a result 6000.
class Fitness {
 public:
  /// Violations are measured against the file's own design, `initial`, which need not have a result.
  Fitness(const Optimization& optimization, const EvaluatedDesign& initial);

  /// Sets the violation and, if a response is missing, the status of a design with results.
  void assess(EvaluatedDesign& design) const;

  /// One number per objective of an assessed design.
  std::vector<double> operator()(const EvaluatedDesign& design) const;

 private:
  const Optimization& optimization_;
  const EvaluatedDesign& initial_;
  std::vector<double> scales_;  ///< |initial|, or 1, for each objective.
};

/// The objectives of a design, oriented so that less is better, in their units.
std::vector<double> costs(const Optimization& optimization, const EvaluatedDesign& design);

/// Indices of the points that no other point dominates, of equal ones the first, ascending in the
/// first coordinate. Less is better. O(n log n) for two coordinates, else O(n x front).
std::vector<std::size_t> non_dominated(const std::vector<std::vector<double>>& points);

/// Front of the designs of both searches, from their separate fronts.
std::vector<std::size_t> joint_front(const OptimizationResult& result);

/// The design of `result.front` that the optimization's compromise chooses; the first of equal
/// ones.
std::optional<std::size_t> compromise_of(const OptimizationResult& result);

FrontComparison compare_fronts(const Optimization& optimization, const EvaluatedDesign& initial, const Search& search,
                               const Search& check);

/// Evaluates designs, one row each.
using EvaluateDesigns = std::function<RowBlock(const std::vector<std::vector<Draw>>& designs)>;

struct OptimizeOptions {
  std::function<bool()> interrupted = {};            ///< Called before designs are evaluated.
  std::function<void(StudyProgress)> progress = {};  ///< Called after designs were evaluated.
};

/// Searches the front, and once more with the second algorithm; the designs of both compete for the resulting front.
/// Every result is written to the journal at once. A search depends only on the optimization and the results, so that
/// an interrupted one is repeated from its start with the results in the journal, which takes no time, and then
/// continues as if nothing had happened. Absent if it was interrupted. Throws the exceptions of `evaluate` and the
/// journal.
std::optional<OptimizationResult> optimize(const Optimization& optimization, const EvaluateDesigns& evaluate,
                                           Journal& journal, const OptimizeOptions& options);

/// Value of a variable at x in [0, 1]: numbers are rounded to a power of ten, at most a millionth of their range, so
/// that they are the same wherever they are written; levels share the interval equally.
Draw draw_at(const Factor& variable, double x);

/// A function that evaluates designs with the engine on `threads` threads. The engine must outlive
/// it.
EvaluateDesigns evaluate_in_parallel(const DesignEngine& engine, std::size_t threads);

}  // namespace prs
