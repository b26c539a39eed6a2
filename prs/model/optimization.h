#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "prs/study/row_block.h"
#include "prs/model/study.h"

namespace prs {

/// How designs are searched. The first three take several objectives, the others one.
enum class Algorithm {
  nsga2,  ///< Non-dominated sorting genetic algorithm II (Deb et al. 2002).
  nspso,  ///< Non-dominated sorting particle swarm (Li 2003).
  moead,  ///< Decomposition with differential evolution, MOEA/D-DE (Li & Zhang 2009).
  sade,   ///< Self-adaptive differential evolution.
  pso,    ///< Particle swarm.
  cmaes,  ///< Covariance matrix adaptation.
};

/// `nsga2`
std::string_view name(Algorithm algorithm);

bool takes_several_objectives(Algorithm algorithm);

/// A response that is made as small or as large as possible.
struct Objective {
  std::size_t response = 0;  ///< Of the study's.
  bool maximize = false;
};

/// What a response is held against, in its unit.
struct Limit {
  enum class Kind {
    number,    ///< `value`
    initial,   ///< `value` times that of the file's own design.
    response,  ///< Another response of the same design.
  };
  Kind kind = Kind::number;
  double value = 0.0;
  std::size_t response = 0;
};

struct Constraint {
  enum class Sense { at_least, at_most };

  std::string name;  ///< What people read.
  std::size_t response = 0;
  Sense sense = Sense::at_least;
  Limit limit;
};

/// Which design of the front is chosen. u: objectives scaled by the front's extent, 0 best and 1
/// worst of the front.
struct Compromise {
  enum class By {
    ideal,    ///< Least |u|: nearest to the best value of every objective.
    knee,     ///< Least sum of u: farthest from the plane through the ends of the front (Das 1999).
    weights,  ///< Least weighted sum of u.
    best,     ///< Best value of one objective.
  };
  By by = By::ideal;
  std::vector<double> weights;  ///< One an objective.
  std::size_t objective = 0;
};

/// What is varied, what is wanted and how it is searched.
struct Optimization {
  /// Factors are the variables: numbers between the ends of a uniform distribution, or levels. The
  /// responses are those of objectives and constraints.
  Study study;
  std::vector<Objective> objectives;
  std::vector<Constraint> constraints;
  Algorithm algorithm = Algorithm::nsga2;
  std::optional<Algorithm> check;  ///< Searches once more, for comparison.
  std::size_t population = 40;     ///< Designs of a generation.
  std::size_t generations = 50;    ///< The first, random one included.
  std::uint64_t seed = 1;
  Compromise compromise;
};

/// Designs to evaluate: the file's own and those of the searches.
std::size_t design_count(const Optimization& optimization);

/// A design and what came of it.
struct EvaluatedDesign {
  std::vector<Draw> draws;        ///< One a variable.
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
  /// Of `designs`: feasible, and no other is as good in every objective and better in one; the
  /// first of equal ones. Ascending in the first objective.
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
  /// Of `search.designs`; absent where the front is empty.
  std::optional<std::size_t> compromise;
  /// Where the front is empty: the design with an answer that comes nearest to the constraints.
  std::optional<std::size_t> nearest;

  /// The compromise or, without one, the nearest design; null where none has an answer.
  const EvaluatedDesign* chosen() const;
};

/// The number that a limit comes to in a design.
double limit_of(const Constraint& constraint, const EvaluatedDesign& design,
                const EvaluatedDesign& initial);

/// Value of a response in percent of that of the file's own design, less 100.
std::optional<double> change_percent(double value, double initial);

}  // namespace prs
