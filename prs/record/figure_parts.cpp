#include "prs/record/figure_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "prs/text.h"

namespace prs {

Style marked_line(std::size_t k) {
  Style style{palette(k)};
  style.mark = static_cast<Mark>(1 + k % 8);
  return style;
}

Style case_line(std::size_t k) {
  Style style = marked_line(k);
  style.colour = case_colour(k);
  return style;
}

std::string interface_title(Interface i) {
  return i == Interface::screw ? "Roller-screw" : "Roller-nut";
}

std::string shown_name(std::string_view name) {
  constexpr std::size_t kMost = 30;
  return shortened(printable(name), kMost);
}

Figure in_kilonewtons(Figure figure) { return in_unit(std::move(figure), {"N", "kN", 1e-3, 1e4}); }

Figure in_page_units(Figure figure) {
  return in_unit(in_unit(std::move(figure), {"N", "kN", 1e-3, 1e3}), {"MPa", "GPa"});
}

Figure in_unit(Figure figure, const UnitChange& change) {
  const auto scale = [&](auto&... values) { ((values *= change.factor), ...); };
  const auto scale_all = [&](std::vector<double>& values) {
    for (double& value : values) value *= change.factor;
  };
  const auto is_large = [&](const std::string& unit, const Range& range) {
    return unit == change.from && std::max(-range.from, range.to) >= change.least;
  };
  for (const std::size_t d : {0U, 1U}) {
    const auto axis_of = [&](Panel& panel) -> Axis& {
      std::optional<Axis>& own = d == 0 ? panel.x : panel.y;
      return own ? *own : d == 0 ? figure.x : figure.y;
    };
    std::map<Axis*, Range> shown;
    for (Panel& panel : figure.panels)
      for (const Series& series : panel.series)
        for (const Polyline& part : series.parts)
          for (const auto& point : part) shown[&axis_of(panel)].include(point[d]);
    std::erase_if(shown,
                  [&](const auto& axis) { return !is_large(axis.first->unit, axis.second); });
    for (const auto& axis : shown) {
      Axis& a = *axis.first;
      a.unit = change.to;
      scale(a.from, a.to);
      for (Tick& tick : a.ticks) scale(tick.at);
    }
    for (Panel& panel : figure.panels) {
      if (!shown.contains(&axis_of(panel))) continue;
      for (Series& series : panel.series)
        for (Polyline& part : series.parts)
          for (auto& point : part) scale(point[d]);
      for (ReferenceLine& reference : panel.references)
        if (reference.vertical == (d == 0)) scale(reference.at);
      for (Label& label : panel.labels)
        if (!label.in_panel) scale(d == 0 ? label.x : label.y);
      scale_all(d == 0 ? panel.map.grid.x : panel.map.grid.y);
      if (!panel.surface) continue;
      scale_all(d == 0 ? panel.surface->grid.x : panel.surface->grid.y);
      for (SurfacePoint& point : panel.surface->points) scale(d == 0 ? point.x : point.y);
    }
  }
  if (!figure.colours ||
      !is_large(figure.colours->unit, {figure.colours->from, figure.colours->to}))
    return figure;
  figure.colours->unit = change.to;
  scale(figure.colours->from, figure.colours->to);
  scale_all(figure.colours->levels);
  for (Panel& panel : figure.panels) {
    for (Series& series : panel.series) scale_all(series.values);
    scale_all(panel.map.grid.values);
    if (!panel.surface) continue;
    panel.surface->z.unit = change.to;
    scale(panel.surface->z.from, panel.surface->z.to);
    scale_all(panel.surface->grid.values);
    for (SurfacePoint& point : panel.surface->points) scale(point.z);
  }
  return figure;
}

namespace {

/// All points that a style draws in a panel.
std::vector<std::array<double, 2>> points_of_style(const Panel& panel, std::size_t style) {
  std::vector<std::array<double, 2>> points;
  for (const Series& series : panel.series)
    if (series.style == style)
      for (const Polyline& part : series.parts)
        points.insert(points.end(), part.begin(), part.end());
  return points;
}

/// Whether the lines of two styles are one wherever either is shown, as far as an eye sees.
bool are_alike(const Figure& figure, std::size_t a, std::size_t b) {
  constexpr double kSeen = 0.004;  // Of the height of a panel.
  bool shown = false;
  for (const Panel& panel : figure.panels) {
    const auto left = points_of_style(panel, a), right = points_of_style(panel, b);
    if (left.size() != right.size()) return false;
    shown = shown || left.size() > 1;
    Range range = range_of_y(panel.series);
    if (const Axis& y = panel.y ? *panel.y : figure.y; std::isfinite(y.from + y.to))
      range = {std::min(y.from, y.to), std::max(y.from, y.to)};
    for (std::size_t k = 0; k < left.size(); ++k)
      if (left[k][0] != right[k][0] ||
          !(std::abs(left[k][1] - right[k][1]) <= kSeen * (range.to - range.from)))
        return false;
  }
  return shown;
}

/// Whether some series have the style, and no point.
bool is_empty(const Figure& figure, std::size_t style) {
  bool used = false;
  for (const Panel& panel : figure.panels) {
    if (!points_of_style(panel, style).empty()) return false;
    for (const Series& series : panel.series) used = used || series.style == style;
  }
  return used;
}

}  // namespace

Figure with_true_legend(Figure figure) {
  std::erase_if(figure.legend, [&](const LegendEntry& e) { return is_empty(figure, e.style); });
  const auto is_line = [&](const LegendEntry& e) {
    const Style& style = figure.styles[e.style];
    return style.shape == Shape::line && style.dash != Dash::none;
  };
  const std::vector<LegendEntry> plain = figure.legend;
  for (std::size_t k = 0; k < plain.size(); ++k)
    for (std::size_t above = k + 1; above < plain.size() && is_line(plain[k]); ++above)
      if (is_line(plain[above]) && are_alike(figure, plain[k].style, plain[above].style)) {
        figure.legend[k].title += fmt::format(", under {}", plain[above].title);
        break;
      }
  return figure;
}

Axis thread_axis(std::size_t threads) {
  const std::size_t step = threads <= 10 ? 1 : threads <= 30 ? 5 : 10 * ((threads + 99) / 100);
  Axis axis{"Thread, from the loaded end of the screw", "", 0.4,
            static_cast<double>(threads) + 0.6};
  axis.whole = true;
  axis.ticks.push_back({1.0});
  for (std::size_t tick = step; tick <= threads; tick += step)
    if (tick > 1) axis.ticks.push_back({static_cast<double>(tick)});
  return axis;
}

Polyline over_threads(const std::vector<double>& values, double factor) {
  Polyline points;
  for (const double value : values)
    points.push_back({static_cast<double>(points.size() + 1), value * factor});
  return points;
}

Polyline rectangle(double left, double right, double bottom, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

Polyline ellipse(double x, double y, double semi_major, double semi_minor, double angle) {
  constexpr int kPoints = 72;
  const double c = std::cos(angle), s = std::sin(angle);
  Polyline points;
  for (int k = 0; k <= kPoints; ++k) {
    const double t = 2.0 * std::numbers::pi * k / kPoints;
    const double u = semi_major * std::cos(t), v = semi_minor * std::sin(t);
    points.push_back({x + c * u - s * v, y + s * u + c * v});
  }
  return points;
}

std::string number(double value, int decimals) {
  const bool is_negative = value < -0.5 * std::pow(10.0, -decimals);
  return fmt::format("{}{:.{}f}", is_negative ? "−" : "", std::abs(value), decimals);
}

double rank_position(std::size_t k, std::size_t count) { return static_cast<double>(count - k); }

Axis ranked_axis(const std::vector<std::string>& names) {
  Axis axis{"", "", 0.5, static_cast<double>(names.size()) + 0.5};
  for (std::size_t k = 0; k < names.size(); ++k)
    axis.ticks.push_back({rank_position(k, names.size()), names[k]});
  return axis;
}

void add_mean(Figure& figure, double mean) {
  const std::size_t style = figure.add("equal shares", kMeanStyle);
  for (Panel& panel : figure.panels) panel.references.push_back({style, mean});
}

double round_step(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double digit : {1.0, 2.0, 5.0})
    if (digit * power >= least * (1.0 - 1e-9)) return digit * power;
  return 10.0 * power;
}

std::vector<double> round_levels(const Range& range, std::size_t most_steps) {
  if (range.empty()) return {};
  const double least = range.from, largest = range.to;
  const double magnitude = std::max(std::abs(least), std::abs(largest));
  if (largest - least <= 1e-9 * magnitude || largest == least) {
    const double margin = magnitude > 0.0 ? 0.05 * magnitude : 1.0;
    return {least - margin, largest + margin};
  }
  const double most = static_cast<double>(most_steps);
  double step = round_step((largest - least) / most);
  while (std::ceil(largest / step) - std::floor(least / step) > most) step = round_step(1.5 * step);
  std::vector<double> levels;
  for (double k = std::floor(least / step); k <= std::ceil(largest / step); k += 1.0)
    levels.push_back(k * step);
  return levels;
}

}  // namespace prs
