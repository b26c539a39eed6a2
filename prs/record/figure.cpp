#include "prs/record/figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "prs/indices.h"

namespace prs {
namespace {

bool alike(const Axis& a, const Axis& b) {
  return a.label == b.label && a.unit == b.unit && a.logarithmic == b.logarithmic;
}

void include(Axis& all, const Axis& more) {
  if (std::isnan(all.from) || std::isnan(more.from)) return;
  all.from = std::min(all.from, more.from);
  all.to = std::max(all.to, more.to);
}

}  // namespace

void Series::add(double x, const std::optional<double>& y) {
  if (parts.empty()) parts.emplace_back();
  if (y)
    parts.back().push_back({x, *y});
  else if (!parts.back().empty())
    parts.emplace_back();
}

std::size_t Figure::add(const Style& style) {
  styles.push_back(style);
  return styles.size() - 1;
}

std::size_t Figure::add(std::string entry, const Style& style) {
  legend.push_back({std::move(entry), styles.size()});
  return add(style);
}

std::string text_of(const Axis& axis) {
  if (axis.unit.empty()) return axis.label;
  return fmt::format("{} ({})", axis.label, axis.unit);
}

Range range_of_y(const std::vector<Series>& series) {
  Range range;
  for (const Series& s : series)
    for (const Polyline& part : s.parts)
      for (const auto& [x, y] : part) range.include(y);
  return range;
}

void Range::include(double value) {
  if (!std::isfinite(value)) return;
  from = std::min(from, value);
  to = std::max(to, value);
}

void Range::include(const Range& other) {
  include(other.from);
  include(other.to);
}

void Range::widen(double share) {
  const double margin = to > from ? share * (to - from) : 0.05 * std::max(std::abs(to), 1e-3);
  from -= margin;
  to += margin;
}

Axis fitted(Axis axis, Range range, bool from_zero) {
  if (range.empty()) range = {0.0, 1.0};
  if (from_zero) range.from = 0.0;
  range.widen(0.06);
  axis.from = from_zero ? 0.0 : range.from;
  axis.to = range.to;
  return axis;
}

void fit_y_range(Figure& figure, bool from_zero) {
  Range range;
  for (const Panel& panel : figure.panels)
    if (!panel.y) {
      range.include(range_of_y(panel.series));
      for (const ReferenceLine& r : panel.references)
        if (!r.vertical) range.include(r.at);
    }
  if (range.empty()) return;
  figure.y = fitted(figure.y, range, range.from >= 0.0 && (from_zero || range.from < 0.5 * range.to));
}

Figure only_panel(Figure figure, std::size_t panel) {
  Panel chosen = std::move(figure.panels.at(panel));
  if (!chosen.title.empty() && figure.panels.size() > 1) figure.title += ": " + chosen.title;
  chosen.title.clear();
  if (chosen.x) figure.x = *std::exchange(chosen.x, std::nullopt);
  if (chosen.y) figure.y = *std::exchange(chosen.y, std::nullopt);
  figure.panels.clear();
  figure.panels.push_back(std::move(chosen));
  figure.columns = 1;
  figure.overview = 0.0;
  std::erase_if(figure.legend, [&](const LegendEntry& entry) {
    const Panel& shown = figure.panels[0];
    return std::ranges::find(shown.series, entry.style, &Series::style) == shown.series.end() &&
           std::ranges::find(shown.references, entry.style, &ReferenceLine::style) == shown.references.end();
  });
  return figure;
}

Figure folded(const Figure& figure) {
  if (figure.panels.size() < 2) return figure;
  const Panel& first = figure.panels[0];
  if (!first.map.grid.empty() || first.surface || figure.to_scale) return only_panel(figure, 0);
  Figure one = figure;
  one.panels.resize(1);
  one.panels[0].title.clear();
  one.columns = 1;
  one.overview = 0.0;
  one.x = first.x.value_or(figure.x);
  one.y = first.y.value_or(figure.y);
  one.panels[0].x.reset();
  one.panels[0].y.reset();
  std::size_t dash = 0;
  for (std::size_t k = 1; k < figure.panels.size(); ++k) {
    const Panel& panel = figure.panels[k];
    const Axis &x = panel.x.value_or(figure.x), &y = panel.y.value_or(figure.y);
    if (!alike(one.x, x) || !alike(one.y, y) || panel.surface || !panel.map.grid.empty()) continue;
    include(one.x, x);
    include(one.y, y);
    if (dash == 0 && !first.title.empty()) one.add(first.title, {Colour::ink, Dash::solid});
    const auto look = static_cast<Dash>(static_cast<int>(Dash::solid) + ++dash % 4);
    if (!panel.title.empty()) one.add(panel.title, {Colour::ink, look});
    for (const Series& series : panel.series) {
      Style style = figure.styles[series.style];
      if (style.dash != Dash::none) style.dash = look;
      style.open = true;
      one.panels[0].series.push_back(series);
      one.panels[0].series.back().style = one.add(style);
    }
  }
  return one;
}

std::optional<std::size_t> add_behind(Figure& figure, const Figure& before) {
  if (figure.to_scale || figure.panels.size() != before.panels.size()) return std::nullopt;
  const Style grey = line_of(Colour::muted, Dash::solid, Weight::strong);
  const std::size_t line = figure.add(grey), points = figure.add(points_of(Colour::muted, Mark::circle));
  for (const auto k : indices(figure.panels)) {
    Panel& panel = figure.panels[k];
    std::vector<Series> behind;
    for (const Series& series : before.panels[k].series) {
      const Style& style = before.styles[series.style];
      if (style.shape != Shape::line || !series.values.empty()) continue;
      behind.push_back({style.dash == Dash::none ? points : line, series.parts});
    }
    panel.series.insert(panel.series.begin(), behind.begin(), behind.end());
  }
  const auto widen = [](Axis& axis, const Axis& other) {
    axis.from = std::min(axis.from, other.from);
    axis.to = std::max(axis.to, other.to);
  };
  widen(figure.x, before.x);
  widen(figure.y, before.y);
  return line;
}

}  // namespace prs
