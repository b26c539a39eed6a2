#include "prs/optimize/front.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "prs/components/search.h"

namespace prs {
namespace {

constexpr double kLinear = 1e3;      // Up to here an objective is as it is,
constexpr double kInfeasible = 4e3;  // above twice that are the infeasible designs,
constexpr double kNoAnswer = 6e3;    // above these the ones without an answer.

/// Strictly increasing, smooth, between -2000 and 2000.
double compressed(double x) {
  const double size = std::abs(x);
  return size <= kLinear ? x : std::copysign(2.0 * kLinear - kLinear * kLinear / size, x);
}

/// What is missing to a constraint, relative.
double violation(const Constraint& constraint, const EvaluatedDesign& design,
                 const EvaluatedDesign& initial) {
  const double value = design.responses[constraint.response];
  const double limit = limit_of(constraint, design, initial);
  const double missing =
      constraint.sense == Constraint::Sense::at_least ? limit - value : value - limit;
  if (!(missing > 0.0)) return std::isnan(missing) ? std::numeric_limits<double>::infinity() : 0.0;
  double scale = std::max(std::abs(limit), std::abs(value));
  if (constraint.limit.kind != Limit::Kind::response) {
    const double usual = std::abs(initial.responses[constraint.response]);
    scale = std::max(std::abs(limit), std::isfinite(usual) ? usual : 0.0);
  }
  return missing / (scale > 0.0 ? scale : 1.0);
}

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

Fitness::Fitness(const Optimization& optimization, const EvaluatedDesign& initial)
    : optimization_(optimization), initial_(initial) {
  for (const Objective& objective : optimization.objectives) {
    const double size = std::abs(initial.responses[objective.response]);
    scales_.push_back(std::isfinite(size) && size > 0.0 ? size : 1.0);
  }
}

void Fitness::assess(EvaluatedDesign& design) const {
  design.violation = std::numeric_limits<double>::infinity();
  if (!design.status.converged()) return;
  const auto none = std::ranges::find_if(design.responses, [](double y) { return std::isnan(y); });
  if (none != design.responses.end()) {
    const auto index = static_cast<std::size_t>(none - design.responses.begin());
    design.status = {"refused", fmt::format("{} is not defined in this design",
                                            optimization_.study.responses[index])};
    return;
  }
  design.violation = 0.0;
  for (const Constraint& constraint : optimization_.constraints)
    design.violation += violation(constraint, design, initial_);
}

std::vector<double> Fitness::operator()(const EvaluatedDesign& design) const {
  const std::size_t count = optimization_.objectives.size();
  if (!design.status.converged()) return std::vector<double>(count, kNoAnswer);
  if (!design.is_feasible()) {
    const double v = design.violation;
    const double share = std::isfinite(v) ? v / (1.0 + v) : 1.0;
    return std::vector<double>(count, kInfeasible + 1e3 * share);
  }
  std::vector<double> values = costs(optimization_, design);
  for (std::size_t k = 0; k < count; ++k) values[k] = compressed(values[k] / scales_[k]);
  return values;
}

std::vector<double> costs(const Optimization& optimization, const EvaluatedDesign& design) {
  std::vector<double> values;
  for (const Objective& objective : optimization.objectives) {
    const double value = design.responses[objective.response];
    values.push_back(objective.maximize ? -value : value);
  }
  return values;
}

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
