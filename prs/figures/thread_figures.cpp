#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "prs/quantities/quantities.h"
#include "prs/quantities/case_groups.h"
#include "prs/figures/figure_style.h"
#include "prs/figures/result_figures.h"
#include "prs/figures/thread_figure.h"

namespace prs {
namespace {

bool is_solved(const LoadCaseResult& result) { return result.solve && result.threads; }

bool has_pressure(const LoadCaseResult& result) {
  return result.threads && !(result.threads->screw.peak_pressure.empty() &&
                             result.threads->nut.peak_pressure.empty());
}

/// The case that stands for a group: the last, which has the full load of a range.
const LoadCaseResult& representative(const CaseGroup& group) { return *group.cases.back(); }

/// Names the force where all lines have the same.
std::string common_force(const std::vector<LoadedConfiguration>& all) {
  const auto force = [](const CaseGroup& g) { return representative(g).load_case.axial_force; };
  const double first = force(all.front().groups.front());
  for (const LoadedConfiguration& c : all)
    for (const CaseGroup& group : c.groups)
      if (std::abs(force(group) - first) > 1e-9 * std::abs(first)) return {};
  return fmt::format(", {:.4g} kN", first * per_si::kilonewton);
}

std::size_t thread_count(const std::vector<LoadedConfiguration>& all) {
  return representative(all.front().groups.front()).threads->screw.axial_load.size();
}

Axis thread_axis(std::size_t threads) {
  const int count = static_cast<int>(threads);
  const int step = count <= 10 ? 1 : count <= 30 ? 5 : 10 * ((count + 99) / 100);
  Axis axis{"Thread, from the loaded end of the screw", 0.4, count + 0.6, {1}};
  for (int tic = step; tic <= count; tic += step)
    if (tic > 1) axis.tics.push_back(tic);
  return axis;
}

std::vector<std::optional<Direction>> directions(const std::vector<LoadedConfiguration>& all) {
  const std::optional<Direction> kAll[] = {Direction::tension, Direction::compression, {}};
  std::vector<std::optional<Direction>> present;
  for (const auto d : kAll)
    if (std::any_of(all.begin(), all.end(), [&](const auto& c) { return c.group(d); }))
      present.push_back(d);
  return present;
}

Polyline over_threads(const std::vector<double>& values, double factor) {
  Polyline points;
  for (const double value : values)
    points.push_back({static_cast<double>(points.size() + 1), value * factor});
  return points;
}

Panel thread_panel(const ThreadPlot& plot, const std::vector<LoadedConfiguration>& all,
                   std::optional<Direction> direction, Interface i) {
  Panel panel;
  panel.title = interface_title(i);
  if (direction) panel.title += fmt::format(", {}", name(*direction));
  for (std::size_t c = 0; c < all.size(); ++c)
    if (const CaseGroup* group = all[c].group(direction))
      panel.lines.push_back(
          {c, {over_threads(plot.values(representative(*group), i), plot.factor)}});
  return panel;
}

/// Where a direction of a configuration stands in the figure.
Panel& panel_at(Figure& figure, std::size_t row, Interface i) {
  return figure.panels[row * std::size(kInterfaces) + (i == Interface::screw ? 0 : 1)];
}

/// The levels of all lines, behind them.
void add_levels(Figure& figure, const ThreadPlot& plot,
                const std::vector<LoadedConfiguration>& all) {
  const std::size_t first_style = figure.styles.size();
  for (std::size_t c = 0; c < all.size(); ++c)
    figure.styles.push_back({kConfigurationStyles[c].colour, 2, 0, 1.2});
  bool any = false;
  const auto rows = directions(all);
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (std::size_t c = 0; c < all.size(); ++c)
      if (const CaseGroup* group = all[c].group(rows[row]))
        for (const Interface i : kInterfaces)
          if (const auto level = plot.level(representative(*group), i)) {
            const double y = *level * plot.factor;
            std::vector<Line>& lines = panel_at(figure, row, i).lines;
            lines.insert(lines.begin(),
                         {first_style + c, {{{figure.x.from, y}, {figure.x.to, y}}}});
            any = true;
          }
  if (any) add_to_legend(figure, plot.level_title, {"#555555", 2, 0, 1.2});
}

template <std::vector<double> InterfaceLoads::*values>
const std::vector<double>& loads_of(const LoadCaseResult& result, Interface i) {
  return (*result.threads)[i].*values;
}

}  // namespace

std::optional<Figure> thread_figure(const ThreadPlot& plot, const Result& result) {
  std::vector<LoadedConfiguration> all = loaded_configurations(result.load_cases, 1, plot.keep);
  if (all.empty()) return std::nullopt;
  Figure figure;
  figure.name = plot.name;
  figure.title = plot.title + common_force(all);
  keep_first(all, std::size(kConfigurationStyles), figure.title);
  figure.x = thread_axis(thread_count(all));
  figure.y.label = plot.y_label;
  figure.columns = std::size(kInterfaces);
  for (std::size_t c = 0; c < all.size(); ++c)
    add_to_legend(figure, all[c].name, kConfigurationStyles[c]);
  for (const auto direction : directions(all))
    for (const Interface i : kInterfaces)
      figure.panels.push_back(thread_panel(plot, all, direction, i));
  if (plot.level) add_levels(figure, plot, all);
  return figure;
}

std::optional<Figure> load_distribution_figure(const Result& result) {
  std::optional<Figure> figure =
      thread_figure({"load_distribution", "Load distribution", "Load rate (%)",
                     loads_of<&InterfaceLoads::load_rate>, per_si::percent, is_solved},
                    result);
  if (!figure) return figure;
  // The threads of a panel's first line share 100 %.
  add_mean(*figure, figure->panels.front().lines.front().parts.front().size());
  fit_y_range(*figure);
  return figure;
}

std::optional<Figure> peak_pressure_figure(const Result& result) {
  std::optional<Figure> figure =
      thread_figure({"peak_pressure", "Peak contact pressure", "Peak pressure (GPa)",
                     loads_of<&InterfaceLoads::peak_pressure>, per_si::gigapascal, has_pressure},
                    result);
  if (figure) fit_y_range(*figure);
  return figure;
}

}  // namespace prs
