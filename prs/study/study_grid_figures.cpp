#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "prs/study/study_pictures.h"
#include "prs/study/study_text.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr std::size_t kMaxPanelTitle = 60;

/// Level of each factor.
using Combination = std::vector<std::size_t>;

/// Which factors the axes, lines and panels stand for.
struct Layout {
  std::size_t x = 0;
  std::size_t line = 0;
  std::vector<std::size_t> panels;
};

std::size_t levels(const Study& study, std::size_t factor) {
  return study.factors[factor].levels.size();
}

/// Of these factors the one with most levels, the first of several.
std::size_t longest(const Study& study, const std::vector<std::size_t>& factors) {
  return *std::ranges::max_element(factors, {}, [&](std::size_t k) { return levels(study, k); });
}

Layout layout_of(const Study& study) {
  std::vector<std::size_t> all(study.factors.size()), numeric;
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::ranges::copy_if(all, std::back_inserter(numeric),
                       [&](std::size_t k) { return study.factors[k].is_numeric(); });
  Layout layout;
  layout.x = longest(study, numeric.empty() ? all : numeric);
  std::erase(all, layout.x);
  layout.line = longest(study, all);
  std::erase(all, layout.line);
  layout.panels = all;
  return layout;
}

/// The row of a combination: the last factor changes fastest.
const StudyRow* row_at(const StudyResult& result, const Combination& combination) {
  std::size_t index = 0;
  for (std::size_t k = 0; k < combination.size(); ++k)
    index = index * levels(result.study, k) + combination[k];
  return index + 1 < result.rows.size() ? &result.rows[index + 1] : nullptr;
}

std::optional<double> value_at(const StudyResult& result, const Combination& combination,
                               std::size_t response) {
  const StudyRow* row = row_at(result, combination);
  return row ? row->responses[response] : std::nullopt;
}

/// The levels along an axis, ascending.
std::vector<std::size_t> ascending(const std::vector<double>& positions) {
  std::vector<std::size_t> order(positions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return positions[k]; });
  return order;
}

/// Interrupted where a design has no answer.
Series series_over(const StudyResult& result, std::size_t response, std::size_t x,
                   Combination combination, std::size_t style) {
  const std::vector<double> at = positions(result.study.factors[x]);
  Series line{style};
  for (const std::size_t k : ascending(at)) {
    combination[x] = k;
    line.add(at[k], value_at(result, combination, response));
  }
  return line;
}

std::string setting_text(const Study& study, std::size_t factor, std::size_t level) {
  const Factor& f = study.factors[factor];
  const std::string text = level_text(f.levels[level], f.unit);
  return fmt::format("{} {}", factor_name(f), text);
}

Figure line_figure(const StudyResult& result, std::size_t response) {
  const Study& study = result.study;
  const Layout layout = layout_of(study);
  Figure figure = response_figure(study.responses, response);
  figure.x = factor_axis(study.factors[layout.x], positions(study.factors[layout.x]));
  const std::vector<std::size_t> lines = spread(levels(study, layout.line), kMostLines);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    Style style = marked_line(k);
    if (!study.factors[layout.x].is_numeric()) style.dash = Dash::none;
    figure.add(setting_text(study, layout.line, lines[k]), style);
  }
  std::size_t panels = 1;
  for (const std::size_t factor : layout.panels) panels *= levels(study, factor);
  const std::size_t shown = std::min(panels, kMostStudyPanels);
  if (shown < panels) figure.title += fmt::format(", {} of {} combinations", shown, panels);
  figure.columns = columns_for(shown);
  for (std::size_t index : spread(panels, kMostStudyPanels)) {
    Combination combination(study.factors.size());
    Panel panel;
    for (std::size_t k = layout.panels.size(); k-- > 0;) {
      const std::size_t factor = layout.panels[k];
      combination[factor] = index % levels(study, factor);
      index /= levels(study, factor);
    }
    for (const std::size_t factor : layout.panels)
      panel.title += fmt::format("{}{}", panel.title.empty() ? "" : ", ",
                                 setting_text(study, factor, combination[factor]));
    panel.title = shortened(panel.title, kMaxPanelTitle);
    for (std::size_t k = 0; k < lines.size(); ++k) {
      combination[layout.line] = lines[k];
      panel.series.push_back(series_over(result, response, layout.x, combination, k));
    }
    figure.panels.push_back(std::move(panel));
  }
  fit_y_range(figure);
  return figure;
}

}  // namespace

Figures grid_lines(const StudyResult& result, const FigureOptions& options) {
  Figures figures;
  for (const std::size_t k : chosen_responses(result.study.responses, options))
    if (Figure figure = line_figure(result, k); has_data(figure))
      figures.push_back(std::move(figure));
  return figures;
}

}  // namespace prs
