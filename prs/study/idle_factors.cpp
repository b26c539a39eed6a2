#include "prs/study/idle_factors.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>

#include "prs/study/sampling.h"

namespace prs {
namespace {

constexpr double kClearlyFollowed = 10.0;  // Percent of the effects on a response.
constexpr std::size_t kMostDrawsSeen = 64;

bool has_numbers(std::span<const double> row) {
  return std::ranges::any_of(row, [](double value) { return std::isfinite(value); });
}

bool same_numbers(std::span<const double> one, std::span<const double> other) {
  return std::ranges::equal(
      one, other, [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); });
}

std::uint64_t hash_of(std::span<const double> row) {
  std::uint64_t hash = 0;
  for (const double value : row) {
    const double shown = std::isnan(value) ? kNoResponse : value;
    hash = mixed_bits(hash + kGoldenStep + std::bit_cast<std::uint64_t>(shown));
  }
  return hash;
}

/// Weight of a level; the last level of a factor has minus the sum of the others.
std::uint64_t level_weight(std::size_t level) { return mixed_bits(level + kGoldenStep); }

/// The least and the largest value of a factor among the first designs; none where all are equal.
std::optional<std::pair<Draw, Draw>> extreme_draws(const Study& study, std::size_t factor) {
  const auto place = [](const Draw& draw) { return std::tuple(draw.level, draw.number); };
  std::vector<Draw> drawn;
  for (std::size_t k = 1; k < std::min(design_count(study), kMostDrawsSeen + 1); ++k)
    drawn.push_back(draws(study, k)[factor]);
  if (drawn.empty()) return std::nullopt;
  const auto [least, largest] = std::ranges::minmax_element(drawn, {}, place);
  if (place(*least) == place(*largest)) return std::nullopt;
  return std::pair(*least, *largest);
}

bool is_clearly_followed(const ResponseSurfaces* surfaces, std::size_t factor) {
  if (!surfaces) return false;
  return std::ranges::any_of(surfaces->fits, [&](const std::optional<LinearFit>& fit) {
    return fit && std::ranges::any_of(fit->effects, [&](const FactorEffect& effect) {
             return effect.factor == factor && effect.contribution_percent >= kClearlyFollowed;
           });
  });
}

}  // namespace

FollowedFactors::FollowedFactors(const Study& study) : study_(study), seen_(study.factors.size()) {
  for (std::size_t f = 0; f < seen_.size(); ++f) {
    const std::size_t levels = study.factors[f].levels.size();
    seen_[f].varies = levels != 1;
    for (std::size_t level = 0; level + 1 < levels; ++level)
      seen_[f].last_weight -= level_weight(level);
  }
}

void FollowedFactors::compare(Seen& seen, std::span<const double> row) const {
  if (!has_numbers(row) && !has_numbers(reference_)) return;
  seen.compared = true;
  seen.followed = seen.followed || !same_numbers(row, reference_);
}

void FollowedFactors::add_to_grid(std::span<const double> row, std::size_t design) {
  const std::uint64_t hash = hash_of(row);
  const std::vector<Draw> drawn = draws(study_, design);
  for (std::size_t f = 0; f < seen_.size(); ++f) {
    std::uint64_t line = f;
    for (std::size_t g = 0; g < seen_.size(); ++g)
      if (g != f) line = mixed_bits(line + kGoldenStep + drawn[g].level);
    const std::size_t level = drawn[f].level;
    const bool last = level + 1 == study_.factors[f].levels.size();
    // Odd numbers lose nothing modulo 2^64.
    seen_[f].sum += hash * (line | 1U) * (last ? seen_[f].last_weight : level_weight(level));
    seen_[f].compared = seen_[f].compared || has_numbers(row);
  }
}

void FollowedFactors::add(std::span<const double> row, std::size_t design) {
  const auto keep = [&] { reference_.assign(row.begin(), row.end()); };
  if (study_.plan == Plan::one_at_a_time) {
    if (design == 0) return keep();
    const Design values = prs::design(study_, design);
    Seen& seen = seen_[values.settings.front().factor];
    seen.varies = seen.varies || !is_base(study_, values);
    compare(seen, row);
  } else if (study_.plan == Plan::grid && design > 0) {
    add_to_grid(row, design);
  } else if (study_.plan == Plan::sobol_indices && design > 0) {
    // Both points of a sample, then the first one with a factor of the second.
    const std::size_t k = (design - 1) % (study_.factors.size() + 2);
    if (k == 0) return keep();
    if (k >= 2) compare(seen_[k - 2], row);
  }
}

std::vector<std::size_t> FollowedFactors::idle() const {
  std::vector<std::size_t> idle;
  for (std::size_t f = 0; f < seen_.size(); ++f)
    if (const Seen& s = seen_[f]; s.varies && s.compared && !s.followed && s.sum == 0)
      idle.push_back(f);
  return idle;
}

std::vector<std::size_t> idle_drawn_factors(
    const Study& study, const ResponseSurfaces* surfaces,
    const std::function<RowBlock(const std::vector<std::vector<Draw>>&)>& evaluate) {
  std::vector<std::size_t> tried;
  std::vector<std::vector<Draw>> designs;
  for (std::size_t f = 0; f < study.factors.size(); ++f) {
    if (is_clearly_followed(surfaces, f)) continue;
    const auto extremes = extreme_draws(study, f);
    if (!extremes) continue;
    tried.push_back(f);
    for (const std::size_t others : {std::size_t{0}, std::size_t{1}})
      for (const Draw& value : {extremes->first, extremes->second}) {
        designs.push_back(draws(study, others));
        designs.back()[f] = value;
      }
  }
  std::vector<std::size_t> idle;
  if (designs.empty()) return idle;
  const RowBlock block = evaluate(designs);
  const std::size_t width = study.responses.size();
  const auto row = [&](std::size_t k) {
    return std::span(block.responses).subspan(k * width, width);
  };
  for (std::size_t i = 0; i < tried.size(); ++i) {
    bool compared = false, followed = false;
    for (const std::size_t k : {4 * i, 4 * i + 2}) {
      compared = compared || has_numbers(row(k));
      followed = followed || !same_numbers(row(k), row(k + 1));
    }
    if (compared && !followed) idle.push_back(tried[i]);
  }
  return idle;
}

}  // namespace prs
