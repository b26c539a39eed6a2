#include "prs/optimize/front.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "prs/components/search.h"
#include "prs/optimize/fitness.h"

namespace prs {
namespace {

/// Whether a is nowhere worse than b; equal points do not worsen each other either.
bool covers(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(a, b, std::ranges::less_equal{});
}

/// Least and greatest coordinates.
struct Extent {
  std::vector<double> from, to;

  explicit Extent(std::size_t dimensions)
      : from(dimensions, std::numeric_limits<double>::infinity()), to(from) {
    for (double& x : to) x = -x;
  }
  void include(const std::vector<double>& point) {
    for (std::size_t k = 0; k < point.size(); ++k) {
      from[k] = std::min(from[k], point[k]);
      to[k] = std::max(to[k], point[k]);
    }
  }
  /// From 0 to 1 over the extent.
  std::vector<double> scaled(const std::vector<double>& point) const {
    std::vector<double> u;
    for (std::size_t k = 0; k < point.size(); ++k)
      u.push_back(to[k] > from[k] ? (point[k] - from[k]) / (to[k] - from[k]) : 0.0);
    return u;
  }
};

Points costs_of_front(const Optimization& optimization, const Search& search) {
  Points points;
  for (const std::size_t k : search.front) points.push_back(costs(optimization, search.designs[k]));
  return points;
}

/// What the chosen design has least of.
double merit(const Compromise& compromise, const std::vector<double>& u) {
  switch (compromise.by) {
    case Compromise::By::ideal:
      return std::inner_product(u.begin(), u.end(), u.begin(), 0.0);
    case Compromise::By::knee:
      return std::accumulate(u.begin(), u.end(), 0.0);
    case Compromise::By::weights:
      return std::inner_product(u.begin(), u.end(), compromise.weights.begin(), 0.0);
    case Compromise::By::best:
      break;
  }
  return u[compromise.objective];
}

std::vector<double> best_values(const Optimization& optimization, const Points& points) {
  std::vector<double> best;
  for (std::size_t k = 0; k < optimization.objectives.size(); ++k) {
    double least = std::numeric_limits<double>::infinity();
    for (const std::vector<double>& point : points) least = std::min(least, point[k]);
    best.push_back(optimization.objectives[k].maximize ? -least : least);
  }
  return best;
}

}  // namespace

std::vector<std::size_t> non_dominated(const Points& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // In lexicographic order a point is dominated by an earlier one or not at all.
  std::ranges::stable_sort(
      order, {}, [&](std::size_t k) -> const auto& { return points[k]; });
  std::vector<std::size_t> front;
  for (const std::size_t k : order) {
    const auto covers_k = [&](std::size_t other) { return covers(points[other], points[k]); };
    const bool planar = points[k].size() <= 2 && !front.empty();
    const bool dominated = planar ? covers_k(front.back()) : std::ranges::any_of(front, covers_k);
    if (!dominated) front.push_back(k);
  }
  return front;
}

std::vector<std::size_t> front_of(const Optimization& optimization,
                                  const std::vector<EvaluatedDesign>& designs) {
  std::vector<std::size_t> feasible;
  Points points;
  for (std::size_t k = 0; k < designs.size(); ++k) {
    if (!designs[k].is_feasible()) continue;
    feasible.push_back(k);
    points.push_back(costs(optimization, designs[k]));
  }
  std::vector<std::size_t> front = non_dominated(points);
  for (std::size_t& k : front) k = feasible[k];
  return front;
}

std::vector<std::size_t> joint_front(const OptimizationResult& result) {
  std::vector<std::size_t> candidates = result.search.front;
  if (result.check)
    for (const std::size_t k : result.check->front)
      candidates.push_back(result.search.designs.size() + k);
  Points points;
  for (const std::size_t k : candidates)
    points.push_back(costs(result.optimization, result.design(k)));
  std::vector<std::size_t> front = non_dominated(points);
  for (std::size_t& k : front) k = candidates[k];
  return front;
}

std::optional<std::size_t> compromise_of(const OptimizationResult& result) {
  const Optimization& optimization = result.optimization;
  Points points;
  for (const std::size_t k : result.front) points.push_back(costs(optimization, result.design(k)));
  Extent extent(optimization.objectives.size());
  for (const std::vector<double>& point : points) extent.include(point);
  std::optional<std::size_t> chosen;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double value = merit(optimization.compromise, extent.scaled(points[k]));
    if (value >= least) continue;
    least = value;
    chosen = result.front[k];
  }
  return chosen;
}

FrontComparison compare_fronts(const Optimization& optimization, const EvaluatedDesign& initial,
                               const Search& search, const Search& check) {
  constexpr double kMargin = 0.1;  // So that the ends of a front count.
  FrontComparison comparison;
  Points ours = costs_of_front(optimization, search);
  Points theirs = costs_of_front(optimization, check);
  if (ours.empty() || theirs.empty()) return comparison;
  comparison.best = best_values(optimization, ours);
  comparison.check_best = best_values(optimization, theirs);
  Extent extent(optimization.objectives.size());
  for (const Points* points : {&ours, &theirs})
    for (const std::vector<double>& point : *points) extent.include(point);
  if (initial.status.converged()) extent.include(costs(optimization, initial));
  for (Points* points : {&ours, &theirs})
    for (std::vector<double>& point : *points) point = extent.scaled(point);
  const std::vector<double> corner(optimization.objectives.size(), 1.0 + kMargin);
  const double box = std::accumulate(corner.begin(), corner.end(), 1.0, std::multiplies<double>());
  comparison.hypervolume = modules::loaded<SearchModule>().hypervolume(ours, corner) / box;
  comparison.check_hypervolume = modules::loaded<SearchModule>().hypervolume(theirs, corner) / box;
  return comparison;
}

}  // namespace prs
