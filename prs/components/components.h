#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <variant>

#include "modules/module.h"
#include "prs/model/study.h"

namespace prs {

struct PictureModule : modules::Module {
  static constexpr modules::Name kName{"prs_rsvg.so", "librsvg", "librsvg2-dev", ", or leave out --png"};

  /// An SVG file as a PNG file, `scale` times as large. Throws std::runtime_error.
  std::string (*png)(const std::string& svg, double scale);
};

/// Work on several threads, by oneTBB.
struct PipelineModule : modules::Module {
  static constexpr modules::Name kName{"prs_tbb.so", "TBB", "libtbb-dev", ", or take --threads 1"};

  /// Sends work through three steps. At most `places` items are processed at once, each in a slot of its own. `give`
  /// fills one slot at a time until it returns false. `prepare` runs on `threads` threads, even if there are fewer
  /// processors. `take` gets one item at a time, with `in_order` in the order in which they were given. An exception in
  /// a step ends the run and is rethrown.
  void (*run)(std::size_t threads, std::size_t places, bool in_order,
              const std::function<bool(std::size_t place)>& give, const std::function<void(std::size_t place)>& prepare,
              const std::function<void(std::size_t place)>& take);
};

using Points = std::vector<std::vector<double>>;

/// Fitness of points of the unit cube, one row per objective, less being better. Exceptions end the search.
using EvaluatePoints = std::function<Points(const Points&)>;

/// Settings of an algorithm that searches the unit cube.
struct SearchOptions {
  Algorithm algorithm = Algorithm::nsga2;
  std::size_t objectives = 2;
  std::size_t generations = 50;  ///< Number of generations, the first population included.
  std::uint64_t seed = 1;
};

/// Search of the unit cube, by pagmo.
struct SearchModule : modules::Module {
  static constexpr modules::Name kName{"prs_pagmo.so", "pagmo", "libpagmo-dev", ""};

  /// Evaluates the first population in one call and lets pagmo evolve it: generations x population points in all, in an
  /// order that depends only on the options and the answers. All algorithms ask for a generation at a time except
  /// MOEA/D, whose next point depends on the answer to the last.
  void (*search_cube)(const SearchOptions& options, const Points& first_population, const EvaluatePoints& evaluate);

  /// Volume between the points and a corner that each of them dominates. Empty: 0.
  double (*hypervolume)(const Points& points, const std::vector<double>& corner);
};

}  // namespace prs
