#pragma once

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
  std::size_t response = 0;  ///< Index among the study's responses.
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
  std::vector<double> weights;  ///< One per objective.
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

}  // namespace prs
