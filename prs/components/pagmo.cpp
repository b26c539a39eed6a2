#include <algorithm>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/algorithms/moead.hpp>
#include <pagmo/algorithms/nsga2.hpp>
#include <pagmo/algorithms/nspso.hpp>
#include <pagmo/algorithms/pso_gen.hpp>
#include <pagmo/algorithms/sade.hpp>
#include <pagmo/batch_evaluators/member_bfe.hpp>
#include <pagmo/bfe.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#include <pagmo/utils/hypervolume.hpp>

#include "prs/components/components.h"

namespace prs {
namespace {

using pagmo::vector_double;

/// Points of one generation of an algorithm that asks for them one after the other, although none depends on the
/// answers to the others. In a rehearsal on copies they are recorded; then all are evaluated at once, and the algorithm
/// itself finds the answers here.
struct Generation {
  bool rehearsal = false;
  Points points, answers;
  std::size_t next = 0;
};

/// The unit cube as a problem for pagmo.
struct CubeProblem {
  std::size_t dimensions = 1;
  std::size_t objectives = 1;
  const EvaluatePoints* evaluate = nullptr;
  Generation* generation = nullptr;

  vector_double fitness(const vector_double& x) const {
    Generation& g = *generation;
    if (g.rehearsal) {
      g.points.push_back(x);
      return vector_double(objectives, 0.0);
    }
    if (g.next < g.answers.size() && g.points[g.next] == x) return g.answers[g.next++];
    return (*evaluate)({x}).front();
  }

  vector_double batch_fitness(const vector_double& xs) const {
    Points points;
    for (auto at = xs.begin(); at != xs.end(); at += static_cast<std::ptrdiff_t>(dimensions))
      points.emplace_back(at, at + static_cast<std::ptrdiff_t>(dimensions));
    vector_double all;
    for (const std::vector<double>& values : (*evaluate)(points)) all.insert(all.end(), values.begin(), values.end());
    return all;
  }

  vector_double::size_type get_nobj() const { return objectives; }
  std::pair<vector_double, vector_double> get_bounds() const {
    return {vector_double(dimensions, 0.0), vector_double(dimensions, 1.0)};
  }
};

/// Evolves by an algorithm of one generation that keeps its memory from call to call.
void evolve_rehearsed(const pagmo::algorithm& algorithm, std::size_t generations, const EvaluatePoints& evaluate,
                      Generation& generation, pagmo::population population) {
  for (std::size_t k = 0; k < generations; ++k) {
    generation = {.rehearsal = true, .points = {}, .answers = {}};
    pagmo::algorithm(algorithm).evolve(population);
    generation.answers = evaluate(generation.points);
    generation.rehearsal = false;
    population = algorithm.evolve(population);
  }
}

/// Whether `algorithm_of` gives an algorithm for `evolve_rehearsed`.
bool is_rehearsed(Algorithm algorithm) { return algorithm == Algorithm::sade || algorithm == Algorithm::cmaes; }

template <class A>
pagmo::algorithm in_batches(A algorithm) {
  algorithm.set_bfe(pagmo::bfe(pagmo::member_bfe()));
  return pagmo::algorithm(std::move(algorithm));
}

/// The algorithm with pagmo's default settings, except that none stops before its last generation.
pagmo::algorithm algorithm_of(const SearchOptions& options, std::size_t dimensions, std::size_t population) {
  const auto generations = static_cast<unsigned>(options.generations - 1);
  const auto seed = static_cast<unsigned>(options.seed ^ (options.seed >> 32U));
  switch (options.algorithm) {
    case Algorithm::nsga2:
      // A variable mutates with probability 1/n, as in the authors' paper.
      return in_batches(pagmo::nsga2(generations, 0.95, 10.0, 1.0 / static_cast<double>(dimensions), 50.0, seed));
    case Algorithm::nspso: {
      pagmo::nspso swarm(generations);
      swarm.set_seed(seed);
      return in_batches(std::move(swarm));
    }
    case Algorithm::moead: {
      const std::size_t neighbours = std::min<std::size_t>(20, population - 1);
      return pagmo::algorithm(pagmo::moead(generations, options.objectives == 2 ? "grid" : "low discrepancy",
                                           "tchebycheff", neighbours, 1.0, 0.5, 20.0, 0.9, 2, true, seed));
    }
    case Algorithm::sade:
      return pagmo::algorithm(pagmo::sade(1, 2, 1, 0.0, 0.0, true, seed));
    case Algorithm::pso: {
      pagmo::pso_gen swarm(generations);
      swarm.set_seed(seed);
      return in_batches(std::move(swarm));
    }
    case Algorithm::cmaes:
      break;
  }
  return pagmo::algorithm(pagmo::cmaes(1, -1, -1, -1, -1, 0.3, 0.0, 0.0, true, true, seed));
}

void search_cube(const SearchOptions& options, const Points& first_population, const EvaluatePoints& evaluate) {
  const std::size_t dimensions = first_population.front().size();
  Generation generation;
  pagmo::population population(pagmo::problem(CubeProblem{dimensions, options.objectives, &evaluate, &generation}), 0U,
                               0U);
  const Points fitness = evaluate(first_population);
  for (std::size_t k = 0; k < first_population.size(); ++k) population.push_back(first_population[k], fitness[k]);
  if (options.generations < 2) return;
  const pagmo::algorithm algorithm = algorithm_of(options, dimensions, first_population.size());
  if (is_rehearsed(options.algorithm))
    evolve_rehearsed(algorithm, options.generations - 1, evaluate, generation, std::move(population));
  else
    algorithm.evolve(population);
}

double hypervolume(const Points& points, const std::vector<double>& corner) {
  if (points.empty()) return 0.0;
  if (corner.size() == 1) {  // pagmo needs at least two dimensions.
    double best = corner[0];
    for (const std::vector<double>& point : points) best = std::min(best, point[0]);
    return corner[0] - best;
  }
  return pagmo::hypervolume(points, false).compute(corner);
}

}  // namespace
}  // namespace prs

extern "C" __attribute__((visibility("default")))
const prs::SearchModule prs_module{{}, prs::search_cube, prs::hypervolume};
