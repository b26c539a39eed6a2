#include "prs/figures/study_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "prs/figures/study_figure_parts.h"
#include "prs/study/study_text.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr std::size_t kMaxName = 36;
constexpr std::size_t kMostWords = 8;
constexpr std::size_t kMostWholeTics = 13;
constexpr double kLargestWholeTic = 9999.0;

/// One a value where a few bare whole numbers count something.
std::vector<int> whole_tics(const Factor& factor, const std::vector<double>& values) {
  std::vector<int> tics;
  if (!factor.unit.empty() || values.size() > kMostWholeTics) return tics;
  for (const double value : values) {
    if (value != std::round(value) || std::abs(value) > kLargestWholeTic) return {};
    tics.push_back(static_cast<int>(value));
  }
  return tics;
}

}  // namespace

std::string study_figure_name(std::size_t index, const std::string& label) {
  std::string name = fmt::format("{:02}_", index + 1);
  for (const char c : label.substr(0, kMaxName)) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z');
    if (plain || name.back() != '_') name += plain ? c : '_';
  }
  while (name.back() == '_') name.pop_back();
  return name;
}

Axis factor_axis(const Factor& factor, const std::vector<double>& values) {
  Axis axis{factor_title(factor), 0.0, 0.0};
  if (!values.empty()) {
    const auto [least, largest] = std::ranges::minmax(values);
    axis.from = least;
    axis.to = largest;
  }
  if (axis.from == axis.to || !factor.is_numeric()) axis.from -= 0.5, axis.to += 0.5;
  axis.logarithmic =
      (factor.logarithmic || factor.distribution.kind == Distribution::Kind::log_uniform) &&
      axis.from > 0.0;
  if (factor.is_numeric()) {
    if (!factor.unit.empty()) axis.label += fmt::format(" ({})", printable(factor.unit));
    axis.tics = whole_tics(factor, values);
    return axis;
  }
  const std::size_t words = std::min(factor.levels.size(), kMostWords);
  for (std::size_t k = 0; k < words; ++k) {
    axis.label += fmt::format("{} {} {}", k == 0 ? ":" : ",", k + 1,
                              shortened(printable(factor.levels[k].text), 16));
    axis.tics.push_back(static_cast<int>(k + 1));
  }
  return axis;
}

Axis response_axis(const std::string& path) {
  return {capitalised(shortened(response_text(path), kMaxName + 8))};
}

std::size_t columns_for(std::size_t panels) {
  return panels == 1 ? 1 : panels == 2 || panels == 4 ? 2 : 3;
}

Polyline rectangle(double left, double right, double bottom, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

std::vector<Figure> study_figures(const StudyResult& result) {
  const Study& study = result.study;
  if (result.summary.envelope) return map_figures(result);
  if (study.plan == Plan::one_at_a_time || (study.plan == Plan::grid && study.factors.size() == 1))
    return one_at_a_time_figures(result);
  return study.plan == Plan::grid ? grid_figures(result) : sampled_figures(result);
}

}  // namespace prs
