#pragma once

#include <functional>

#include "modules/module.h"
#include "prs/model/optimization.h"

namespace prs {

using Points = std::vector<std::vector<double>>;

/// Fitness of points of the unit cube, one row per objective, less being better. What it throws
/// ends the search.
using EvaluatePoints = std::function<Points(const Points&)>;

/// How an algorithm searches the unit cube.
struct SearchOptions {
  Algorithm algorithm = Algorithm::nsga2;
  std::size_t objectives = 2;
  std::size_t generations = 50;  ///< The first population included.
  std::uint64_t seed = 1;
};

/// Search of the unit cube, by pagmo.
struct SearchModule : modules::Module {
  static constexpr modules::Name kName{"prs_pagmo.so", "pagmo", "libpagmo-dev", ""};

  /// Evaluates the first population in one call and lets pagmo evolve it: generations x population
  /// points in all, in an order that depends on the options and the answers alone. All algorithms
  /// ask for a generation at a time but MOEA/D, whose next point depends on the answer to the last.
  void (*search_cube)(const SearchOptions& options, const Points& first_population,
                      const EvaluatePoints& evaluate);

  /// Volume between the points and a corner that each of them dominates. Empty: 0.
  double (*hypervolume)(const Points& points, const std::vector<double>& corner);
};

}  // namespace prs
