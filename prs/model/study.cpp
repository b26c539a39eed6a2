#include "prs/model/study.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace prs {

bool Factor::is_numeric() const {
  return std::ranges::all_of(levels, [](const Level& level) { return level.number.has_value(); });
}

bool is_sampled(Plan plan) {
  return plan == Plan::latin_hypercube || plan == Plan::sobol || plan == Plan::monte_carlo ||
         plan == Plan::sobol_indices || plan == Plan::tolerances;
}

std::vector<std::size_t> blocks_of(const Study& study) {
  std::vector<std::size_t> blocks;
  for (std::size_t i = 0; i < study.factors.size(); ++i)
    if (!study.factors[i].with_previous) blocks.push_back(i);
  return blocks;
}

std::vector<DrawnInput> drawn_inputs(const Study& study) {
  std::vector<DrawnInput> inputs;
  for (std::size_t i = 0; i < study.factors.size(); ++i) {
    inputs.push_back({i, &study.factors[i]});
    for (const Factor& companion : study.factors[i].companions) inputs.push_back({i, &companion});
  }
  return inputs;
}

std::string_view name(Algorithm algorithm) {
  constexpr std::array kNames{"nsga2", "nspso", "moead", "sade", "pso", "cmaes"};
  return kNames.at(static_cast<std::size_t>(algorithm));
}

bool takes_several_objectives(Algorithm algorithm) {
  return algorithm == Algorithm::nsga2 || algorithm == Algorithm::nspso || algorithm == Algorithm::moead;
}

std::size_t design_count(const Optimization& optimization) {
  const std::size_t searches = optimization.check ? 2 : 1;
  return 1 + searches * optimization.population * optimization.generations;
}

namespace {

bool is_continuous(const Factor& factor) {
  return factor.continuous && std::ranges::all_of(factor.companions, [](const Factor& companion) {
           return companion.continuous && companion.is_numeric();
         });
}

std::optional<MapAxis> axis_of(const Study& study, std::size_t factor) {
  const Factor& f = study.factors[factor];
  if (!f.is_numeric() || f.levels.size() < 2) return std::nullopt;
  MapAxis axis{factor, std::vector<std::size_t>(f.levels.size()), {}, f.logarithmic, is_continuous(f)};
  std::iota(axis.levels.begin(), axis.levels.end(), std::size_t{0});
  std::ranges::sort(axis.levels, {}, [&](std::size_t k) { return *f.levels[k].number; });
  for (const std::size_t k : axis.levels) axis.numbers.push_back(*f.levels[k].number);
  const bool distinct = std::ranges::adjacent_find(axis.numbers) == axis.numbers.end();
  return distinct ? std::optional(std::move(axis)) : std::nullopt;
}

}  // namespace

Between between(double place, std::size_t nodes) {
  const double last = static_cast<double>(nodes - 1);
  const double at = std::clamp(place, 0.0, last);
  const double node = std::min(std::floor(at), last - 1.0);
  return {static_cast<std::size_t>(node), at - node};
}

double interpolated(double from, double to, double share, bool logarithmic) {
  if (share == 0.0) return from;
  if (share == 1.0) return to;
  return logarithmic ? from * std::pow(to / from, share) : from + (to - from) * share;
}

double MapAxis::number(double place) const {
  const auto [node, share] = between(place, nodes());
  return interpolated(numbers[node], numbers[node + 1], share, logarithmic);
}

std::optional<double> MapAxis::place(double number) const {
  if (!(number >= numbers.front() && number <= numbers.back())) return std::nullopt;
  const auto above = std::ranges::upper_bound(numbers, number);
  const auto next = std::min(static_cast<std::size_t>(above - numbers.begin()), nodes() - 1);
  const double from = numbers[next - 1], to = numbers[next];
  const double share = logarithmic ? std::log(number / from) / std::log(to / from) : (number - from) / (to - from);
  return static_cast<double>(next - 1) + share;
}

std::optional<std::array<MapAxis, 2>> map_axes(const Study& study) {
  if (study.plan != Plan::grid || study.factors.size() != 2) return std::nullopt;
  std::optional<MapAxis> first = axis_of(study, 0), second = axis_of(study, 1);
  if (!first || !second) return std::nullopt;
  return std::array{std::move(*first), std::move(*second)};
}

}  // namespace prs
