#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "prs/figures/figure_style.h"
#include "prs/quantities/response_title.h"
#include "prs/figures/study_figure_parts.h"
#include "prs/study/study_text.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr std::size_t kMostLines = std::size(kConfigurationStyles);
constexpr std::size_t kMaxPanelTitle = 60;
constexpr double kEvenSteps = 1e-6;  // By which steps of even levels may differ.

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

/// Up to so many of `count`, evenly spread, both ends among them.
std::vector<std::size_t> spread(std::size_t count, std::size_t most) {
  std::vector<std::size_t> chosen(std::min(count, most));
  for (std::size_t k = 0; k < chosen.size(); ++k)
    chosen[k] = chosen.size() == 1 ? 0 : k * (count - 1) / (chosen.size() - 1);
  return chosen;
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

/// Where the levels of a factor stand, words at 1, 2, ...
std::vector<double> positions(const Factor& factor) {
  std::vector<double> values;
  for (std::size_t k = 0; k < factor.levels.size(); ++k)
    values.push_back(factor.is_numeric() ? *factor.levels[k].number : static_cast<double>(k + 1));
  return values;
}

/// The levels along an axis, ascending.
std::vector<std::size_t> ascending(const std::vector<double>& positions) {
  std::vector<std::size_t> order(positions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return positions[k]; });
  return order;
}

/// Interrupted where a design has no answer.
Line line_of(const StudyResult& result, std::size_t response, std::size_t x,
             Combination combination, std::size_t style) {
  const std::vector<double> at = positions(result.study.factors[x]);
  Line line{style, {{}}};
  for (const std::size_t k : ascending(at)) {
    combination[x] = k;
    if (const std::optional<double> value = value_at(result, combination, response))
      line.parts.back().push_back({at[k], *value});
    else if (!line.parts.back().empty())
      line.parts.emplace_back();
  }
  return line;
}

std::string setting_text(const Study& study, std::size_t factor, std::size_t level) {
  const Factor& f = study.factors[factor];
  const std::string text = level_text(f.levels[level], f.unit);
  return fmt::format("{} {}", printable(f.label), text);
}

bool has_data(const Figure& figure) {
  return std::ranges::any_of(figure.panels, [](const Panel& panel) {
    return !panel.map.cells.empty() || std::ranges::any_of(panel.lines, [](const Line& line) {
      return std::ranges::any_of(line.parts, [](const Polyline& p) { return !p.empty(); });
    });
  });
}

Figure line_figure(const StudyResult& result, std::size_t response) {
  const Study& study = result.study;
  const Layout layout = layout_of(study);
  const std::string& path = study.responses[response];
  Figure figure;
  figure.name = study_figure_name(response, path);
  figure.title = capitalised(response_title(path).name);
  figure.x = factor_axis(study.factors[layout.x], positions(study.factors[layout.x]));
  figure.y = response_axis(path);
  const std::vector<std::size_t> lines = spread(levels(study, layout.line), kMostLines);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    LineStyle style = kConfigurationStyles[k];
    if (!study.factors[layout.x].is_numeric()) style.dash = 0;
    add_to_legend(figure, setting_text(study, layout.line, lines[k]), style);
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
      panel.lines.push_back(line_of(result, response, layout.x, combination, k));
    }
    figure.panels.push_back(std::move(panel));
  }
  fit_y_range(figure);
  return figure;
}

/// Distance of neighbouring levels; absent where they are few, words or unevenly spaced.
std::optional<double> even_step(const Factor& factor) {
  if (!factor.is_numeric() || factor.levels.size() <= kMostLines || factor.logarithmic) return {};
  std::vector<double> at = positions(factor);
  std::ranges::sort(at);
  const double step = (at.back() - at.front()) / static_cast<double>(at.size() - 1);
  for (std::size_t k = 1; k < at.size(); ++k)
    if (!(std::abs(at[k] - at[k - 1] - step) <= kEvenSteps * step)) return {};
  return step;
}

Axis map_axis(const Factor& factor, double step) {
  Axis axis = factor_axis(factor, positions(factor));
  axis.from -= 0.5 * step;
  axis.to += 0.5 * step;
  return axis;
}

/// The response as a colour over two numeric factors; absent where lines are the better picture.
std::optional<Figure> map_figure(const StudyResult& result, std::size_t response) {
  const Study& study = result.study;
  if (study.factors.size() != 2) return std::nullopt;
  const Factor &first = study.factors[0], &second = study.factors[1];
  const std::optional<double> width = even_step(first), height = even_step(second);
  if (!width || !height) return std::nullopt;
  const std::vector<double> x = positions(first), y = positions(second);
  const std::string& path = study.responses[response];
  Figure figure;
  figure.name = study_figure_name(response, path);
  figure.title = capitalised(response_title(path).name);
  figure.x = map_axis(first, *width);
  figure.y = map_axis(second, *height);
  figure.panel_height = 420;
  Panel panel;
  panel.map.width = *width;
  panel.map.height = *height;
  ColourScale colours{response_axis(path).label, HUGE_VAL, -HUGE_VAL};
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < y.size(); ++j)
      if (const std::optional<double> value = value_at(result, {i, j}, response)) {
        panel.map.cells.push_back({x[i], y[j], *value});
        colours.from = std::min(colours.from, *value);
        colours.to = std::max(colours.to, *value);
      }
  if (!(colours.from < colours.to)) colours.to = colours.from + 1.0;
  figure.colours = colours;
  figure.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace

std::vector<Figure> grid_figures(const StudyResult& result) {
  std::vector<Figure> figures;
  for (std::size_t k = 0; k < std::min(result.study.responses.size(), kMostStudyFigures); ++k) {
    std::optional<Figure> map = map_figure(result, k);
    Figure figure = map ? std::move(*map) : line_figure(result, k);
    if (has_data(figure)) figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace prs
