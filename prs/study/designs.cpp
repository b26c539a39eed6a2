#include "prs/study/designs.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "prs/study/sampling.h"

namespace prs {
namespace {

/// A design of a sampled plan: the sample, and which of its factors come from Saltelli's second
/// matrix.
struct Sample {
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  static constexpr std::size_t kAll = static_cast<std::size_t>(-2);

  std::size_t index = 0;
  std::size_t from_second = kNone;
};

/// Designs of each sample: one, or of `sobol_indices` A, B, and A with each column from B in turn
/// (Saltelli et al. 2010, Computer Physics Communications 181, table 2).
std::size_t designs_per_sample(const Study& study) {
  return study.plan == Plan::sobol_indices ? study.factors.size() + 2 : 1;
}

Sample sample_of(const Study& study, std::size_t k) {
  const std::size_t each = designs_per_sample(study);
  const std::size_t which = (k - 1) % each;
  const std::size_t from_second = which == 0   ? Sample::kNone
                                  : which == 1 ? Sample::kAll
                                               : which - 2;
  return {(k - 1) / each, from_second};
}

/// Where in (0, 1) of its distribution a factor lies.
double share(const Study& study, std::size_t factor, const Sample& sample) {
  switch (study.plan) {
    case Plan::latin_hypercube:
      return latin_hypercube_number(study.seed, factor, sample.index, study.samples);
    case Plan::monte_carlo:
      return monte_carlo_number(study.seed, factor, sample.index);
    case Plan::sobol_indices: {
      const bool second = sample.from_second == Sample::kAll || sample.from_second == factor;
      return sobol_number(study.seed, factor + (second ? study.factors.size() : 0), sample.index);
    }
    default:
      return sobol_number(study.seed, factor, sample.index);
  }
}

Draw drawn(const Factor& factor, double share) {
  const auto& [kind, first, second] = factor.distribution;
  switch (kind) {
    case Distribution::Kind::uniform:
      return {.kind = Draw::Kind::number, .number = first + (second - first) * share};
    case Distribution::Kind::log_uniform:
      return {.kind = Draw::Kind::number, .number = first * std::pow(second / first, share)};
    case Distribution::Kind::normal:
      return {.kind = Draw::Kind::number, .number = first + second * normal_quantile(share)};
    case Distribution::Kind::levels:
      break;
  }
  const auto count = static_cast<double>(factor.levels.size());
  const auto level = static_cast<std::size_t>(share * count);
  return {.kind = Draw::Kind::level, .level = std::min(level, factor.levels.size() - 1)};
}

/// The factor that varies in design k of `one_at_a_time`, and its level.
void draw_one(const Study& study, std::size_t k, std::vector<Draw>& draws) {
  std::size_t level = k - 1;
  std::size_t factor = 0;
  while (level >= study.factors[factor].levels.size())
    level -= study.factors[factor++].levels.size();
  draws[factor] = {.kind = Draw::Kind::level, .level = level};
}

void draw_combination(const Study& study, std::size_t k, std::vector<Draw>& draws) {
  std::size_t combination = k - 1;
  for (std::size_t i = study.factors.size(); i-- > 0;) {
    const std::size_t count = study.factors[i].levels.size();
    draws[i] = {.kind = Draw::Kind::level, .level = combination % count};
    combination /= count;
  }
}

Level level_of(const Factor& factor, const Draw& draw) {
  if (draw.kind == Draw::Kind::level) return factor.levels[draw.level];
  assert(factor.companions.empty());  // They have no value between two levels.
  return {
      fmt::format(FMT_COMPILE("{}{}{}"), draw.number, factor.unit.empty() ? "" : " ", factor.unit),
      draw.number};
}

bool is_same(const Level& level, const std::optional<Level>& base) {
  if (!base) return false;
  return level.text == base->text || (level.number && level.number == base->number);
}

std::string override_text(const Factor& factor, const Level& level) {
  return fmt::format("{}={}", factor.path, level.text);
}

}  // namespace

std::size_t design_count(const Study& study) {
  if (study.plan == Plan::derivatives) return 1;
  if (is_sampled(study.plan)) return 1 + study.samples * designs_per_sample(study);
  const bool grid = study.plan == Plan::grid;
  std::size_t count = grid ? 1 : 0;
  for (const Factor& factor : study.factors)
    count = grid ? count * factor.levels.size() : count + factor.levels.size();
  return 1 + count;
}

std::vector<Draw> draws(const Study& study, std::size_t k) {
  std::vector<Draw> draws;
  set_draws(study, k, draws);
  return draws;
}

void set_draws(const Study& study, std::size_t k, std::vector<Draw>& draws) {
  assert(k < design_count(study));
  draws.assign(study.factors.size(), {});
  if (k == 0) return;
  if (study.plan == Plan::one_at_a_time) {
    draw_one(study, k, draws);
  } else if (study.plan == Plan::grid) {
    draw_combination(study, k, draws);
  } else {
    const Sample sample = sample_of(study, k);
    for (std::size_t i = 0; i < draws.size(); ++i)
      draws[i] = drawn(study.factors[i], share(study, i, sample));
  }
}

Design design(const Study& study, std::size_t k) { return design(study, draws(study, k)); }

Design design(const Study& study, const std::vector<Draw>& draws) {
  assert(draws.size() == study.factors.size());
  Design design;
  design.settings.reserve(draws.size());
  for (std::size_t i = 0; i < draws.size(); ++i) {
    if (draws[i].kind == Draw::Kind::as_in_file) continue;
    const Factor& factor = study.factors[i];
    Setting setting{i, level_of(factor, draws[i]), {}};
    for (const Factor& companion : factor.companions)
      setting.companions.push_back(level_of(companion, draws[i]));
    design.settings.push_back(std::move(setting));
  }
  return design;
}

bool is_base(const Study& study, const Design& design) {
  return std::ranges::all_of(design.settings, [&](const Setting& setting) {
    const Factor& factor = study.factors[setting.factor];
    if (!is_same(setting.level, factor.base)) return false;
    for (std::size_t k = 0; k < factor.companions.size(); ++k)
      if (!is_same(setting.companions[k], factor.companions[k].base)) return false;
    return true;
  });
}

std::vector<std::string> overrides(const Study& study, const Design& design) {
  std::vector<std::string> texts;
  for (const Setting& setting : design.settings) {
    const Factor& factor = study.factors[setting.factor];
    texts.push_back(override_text(factor, setting.level));
    for (std::size_t k = 0; k < factor.companions.size(); ++k)
      texts.push_back(override_text(factor.companions[k], setting.companions[k]));
  }
  return texts;
}

std::vector<std::string> overrides(const Study& study, const std::vector<Draw>& draws) {
  return overrides(study, design(study, draws));
}

}  // namespace prs
