#include "modules/estimation/fit.h"

#include <algorithm>
#include <cmath>

#include "modules/estimation/conclusion.h"

namespace modules::fit {
namespace {

/// A search from a start, and how it ended.
struct Found {
  Search search;
  Status status;
};

/// Deviations to begin with; none where the function has no answer, or an unknown moves no curve.
std::optional<Spread> look_at_start(const Model& model, Differences& function, Result& result) {
  const StatePtr state = function.with_slopes(start_of(model, 0));
  if (!state) return std::nullopt;
  Spread spread = first_spread(model);
  for (const std::size_t c : model.fitted) {
    const Readings& r = model.curves[c];
    if (r.is_estimated && spread[c] == r.floor)  // All readings are equal.
      spread[c] = std::max(spread[c], 0.05 * (r.measured - state->values[c]).lpNorm<Eigen::Infinity>());
  }
  result.without_influence = function.look_at(*state);
  return result.without_influence ? std::nullopt : std::optional(spread);
}

/// Criterion for comparing starts.
double criterion(const Search& s, double objective) {
  for (const std::size_t c : s.model.fitted)
    if (s.model.curves[c].is_estimated)
      objective += 2.0 * static_cast<double>(s.model.problem.curves[c].rows) * std::log(s.spread[c]);
  return objective;
}

StartResult start_result(const Found& found) {
  const Search& s = found.search;
  if (found.status == Status::no_equilibrium) return {.status = found.status};
  Result end;
  const double objective = conclude(s, found.status, end).objective;
  StartResult start{.objective = criterion(s, objective), .status = end.status};
  for (Index j = 0; j < s.model.count(); ++j) start.values.push_back(s.model.value(j, s.z[j]));
  return start;
}

/// Best start; among two at the same minimum the one that came to rest.
std::optional<std::size_t> best_of(const std::vector<StartResult>& starts) {
  const auto rank = [](const StartResult& s) {
    return s.objective ? *s.objective + (s.status == Status::iteration_limit ? 1e-3 : 0.0)
                       : std::numeric_limits<double>::infinity();
  };
  const auto best = std::ranges::min_element(starts, {}, rank);
  if (best == starts.end() || !best->objective) return std::nullopt;
  return static_cast<std::size_t>(best - starts.begin());
}

/// Distance between two places, in standard deviations at the first.
double distance(const Search& a, const Search& b) {
  const VectorXd d = a.z - b.z;
  const Normal n = normal_at(a.model, *a.function.with_slopes(a.z), a.spread);
  return std::sqrt(std::max(0.0, d.dot(n.matrix * d)));
}

}  // namespace

Result solve(const Problem& problem) {
  const Model model = model_of(problem);
  Differences function(model);
  Result result;
  result.curves.resize(problem.curves.size());
  result.unknowns.resize(problem.unknowns.size());
  const std::optional<Spread> spread = look_at_start(model, function, result);
  if (!spread) {
    result.failure = function.failure;
    result.failed_at_start = true;
    return result;
  }
  std::vector<Found> found;
  for (std::size_t k = 0; k < problem.starts; ++k) {
    Search search{model, function, start_of(model, k), *spread};
    const Status status = run(search);
    found.push_back({search, status});
    result.starts.push_back(start_result(found.back()));
  }
  const std::optional<std::size_t> best_start = best_of(result.starts);
  if (!best_start) {
    result.failure = found.front().search.failure;
    return result;
  }
  StartResult& best = result.starts[*best_start];
  auto& [search, status] = found[*best_start];
  best.is_best = true;
  const Normal normal = conclude(search, status, result);
  add_uncertainty(search, normal, result);
  if (result.status == Status::iteration_limit) result.held_by = search.failure;
  for (std::size_t k = 0; k < found.size(); ++k) {
    StartResult& start = result.starts[k];
    result.iterations += found[k].search.iterations;
    if (k == *best_start || !start.objective || *start.objective > *best.objective + 4.0) continue;
    start.is_another_minimum = result.unidentified.empty() && distance(search, found[k].search) > 0.1;
  }
  return result;
}

}  // namespace modules::fit

extern "C" __attribute__((visibility("default"))) const modules::fit::FitModule prs_module{{}, modules::fit::solve};
