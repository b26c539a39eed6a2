#pragma once

#include "prs/study/design_engine.h"
#include "prs/study/study_run.h"

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
double limit_of(const Constraint& constraint, const EvaluatedDesign& design, const EvaluatedDesign& initial);

/// Value of a response in percent of that of the file's own design, less 100.
std::optional<double> change_percent(double value, double initial);

/// The values of a design as `--set` takes them: `mechanism.flank_angle.screw=42.5 deg`. Those that
/// are the file's are left out.
std::vector<std::string> settings_of(const Optimization& optimization, const EvaluatedDesign& design);

/// `screw.peak_pressure_MPa.max >= 0.9 x initial`, with numbers of a design.
std::string constraint_text(const OptimizationResult& result, const Constraint& constraint);

/// Whether a design keeps one of its constraints.
bool keeps(const Constraint& constraint, const EvaluatedDesign& design, const EvaluatedDesign& initial);

/// Designs of both searches, and how many of them were feasible and had no answer.
struct SearchCounts {
  std::size_t designs = 0;
  std::size_t feasible = 0;
  std::size_t without_answer = 0;
};
SearchCounts count(const Search& search);

/// Turns answers into numbers to minimise such that domination among them is Deb's constrained
/// domination (Deb et al. 2002, IEEE Trans. Evol. Comput. 6, section VI): any feasible design
/// before any infeasible one, of two infeasible ones that with less violation.
///
/// A feasible design has its objectives, oriented so that less is better, relative to `scales`, as
/// they are up to 1000 and beyond that compressed to below 2000 without changing their order. An
/// infeasible one has 4000 + 1000 v/(1 + v) of its violation v in all of them, one without an
/// answer 6000.
class Fitness {
 public:
  /// Violations are measured against the file's own design, `initial`, which need not have an
  /// answer.
  Fitness(const Optimization& optimization, const EvaluatedDesign& initial);

  /// Sets the violation and, where a response is missing, the status of a design that has answers.
  void assess(EvaluatedDesign& design) const;

  /// One number an objective of a judged design.
  std::vector<double> operator()(const EvaluatedDesign& design) const;

 private:
  const Optimization& optimization_;
  const EvaluatedDesign& initial_;
  std::vector<double> scales_;  ///< Objective by objective: |initial|, or 1.
};

/// The objectives of a design, oriented so that less is better, in their units.
std::vector<double> costs(const Optimization& optimization, const EvaluatedDesign& design);

/// Indices of the points that no other point dominates, of equal ones the first, ascending in the
/// first coordinate. Less is better. O(n log n) for two coordinates, else O(n x front).
std::vector<std::size_t> non_dominated(const std::vector<std::vector<double>>& points);

/// The front of the designs of both searches, from their own fronts.
std::vector<std::size_t> joint_front(const OptimizationResult& result);

/// The design of `result.front` that the optimization's compromise chooses; the first of equal
/// ones.
std::optional<std::size_t> compromise_of(const OptimizationResult& result);

FrontComparison compare_fronts(const Optimization& optimization, const EvaluatedDesign& initial, const Search& search,
                               const Search& check);

/// Answers designs, a row each.
using EvaluateDesigns = std::function<RowBlock(const std::vector<std::vector<Draw>>& designs)>;

struct OptimizeOptions {
  std::function<bool()> interrupted = {};            ///< Asked before designs are evaluated.
  std::function<void(StudyProgress)> progress = {};  ///< Told after designs were evaluated.
};

/// Searches the front, and once more with the second algorithm; the designs of both compete for the
/// front that is delivered. Every answer goes into the journal
/// at once. A search is a function of the optimization and the answers alone, so that one that was
/// interrupted is run again from its start on the answers that the journal holds, which takes no
/// time, and then goes on as if nothing had happened. Absent where it was interrupted. Throws what
/// `evaluate` and the journal throw.
std::optional<OptimizationResult> optimize(const Optimization& optimization, const EvaluateDesigns& evaluate,
                                           Journal& journal, const OptimizeOptions& options);

/// Value of a variable at x in [0, 1]: numbers are rounded to a power of ten, at most a millionth
/// of their range, so that they are the same wherever they are written down; levels share the
/// interval equally.
Draw draw_at(const Factor& variable, double x);

/// A function that evaluates designs with the engine on `threads` threads. The engine must outlive
/// it.
EvaluateDesigns evaluate_in_parallel(const DesignEngine& engine, std::size_t threads);

}  // namespace prs
