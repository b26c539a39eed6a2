#include "prs/study/study.h"

#include <fmt/format.h>

#include <algorithm>

namespace prs {

bool Factor::is_numeric() const {
  return std::ranges::all_of(levels, [](const Level& level) { return level.number.has_value(); });
}

std::size_t design_count(const Study& study) {
  std::size_t count = 1;
  for (const Factor& factor : study.factors) count += factor.levels.size();
  return count;
}

Design design(const Study& study, std::size_t k) {
  if (k == 0) return {};
  std::size_t level = k - 1;
  std::size_t factor = 0;
  while (level >= study.factors[factor].levels.size())
    level -= study.factors[factor++].levels.size();
  return {{{factor, study.factors[factor].levels[level]}}};
}

bool is_base(const Study& study, const Design& design) {
  return std::ranges::all_of(design.settings, [&](const Setting& setting) {
    const std::optional<Level>& base = study.factors[setting.factor].base;
    if (!base) return false;
    return setting.level.text == base->text ||
           (setting.level.number && setting.level.number == base->number);
  });
}

std::vector<std::string> overrides(const Study& study, const Design& design) {
  std::vector<std::string> texts;
  for (const Setting& setting : design.settings)
    texts.push_back(fmt::format("{}={}", study.factors[setting.factor].path, setting.level.text));
  return texts;
}

}  // namespace prs
