#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "prs/loads/analyze.h"
#include "prs/loads/case_groups.h"
#include "prs/loads/load_record.h"
#include "prs/loads/thread_parts.h"
#include "prs/record/figure_parts.h"

namespace prs {
namespace {

/// The case that stands for a group: the last, which has the full load of a range.
const LoadCaseResult& representative(const CaseGroup& group) { return *group.cases.back(); }

/// Those that the options name, each by itself; else all, ranges by their largest loads.
std::vector<LoadedConfiguration> configurations(const Result& result, const FigureOptions& options,
                                                bool (*keep)(const LoadCaseResult&)) {
  if (options.load_cases.empty()) return loaded_configurations(result.load_cases, 1, keep);
  std::vector<LoadedConfiguration> all;
  for (const LoadCaseResult* load_case : chosen(result, options))
    if (keep(*load_case)) {
      const std::string name = shown_name(load_case->load_case.name);
      all.push_back({name, {{name, load_case->load_case.direction, {load_case}}}});
    }
  return all;
}

/// Names the force where all lines have the same.
std::string common_force(const std::vector<LoadedConfiguration>& all) {
  const auto force = [](const CaseGroup& g) { return representative(g).load_case.axial_force; };
  const double first = force(all.front().groups.front());
  for (const LoadedConfiguration& c : all)
    for (const CaseGroup& group : c.groups)
      if (std::abs(force(group) - first) > 1e-9 * std::abs(first)) return {};
  return fmt::format(", {:.4g} kN", first * per_si::kilonewton);
}

template <std::vector<double> InterfaceLoads::*values>
const std::vector<double>& loads_of(const LoadCaseResult& result, Interface i) {
  return (*result.threads)[i].*values;
}

bool has_pressure(const LoadCaseResult& result) {
  return has_shares(result) && !(result.threads->screw.peak_pressure.empty() &&
                                 result.threads->nut.peak_pressure.empty());
}

}  // namespace

std::optional<Figure> thread_figure(const ThreadPlot& plot, const Result& result,
                                    const FigureOptions& options) {
  std::vector<LoadedConfiguration> all = configurations(result, options, plot.keep);
  if (all.empty()) return std::nullopt;
  Figure figure{plot.name, plot.title + common_force(all)};
  keep_first(all, kMostLines, figure.title);
  figure.y = {plot.label, plot.unit};
  figure.columns = std::size(kInterfaces);
  for (std::size_t c = 0; c < all.size(); ++c) figure.add(all[c].name, case_line(c));
  const std::size_t levels = figure.styles.size();
  for (std::size_t c = 0; c < all.size(); ++c)
    figure.add(line_of(case_colour(c), Dash::dashed, Weight::thin));
  std::size_t threads = 0;
  bool has_level = false;
  for (const std::optional<Direction> direction :
       {std::optional(Direction::tension), std::optional(Direction::compression), {}}) {
    if (std::ranges::none_of(all, [&](const auto& c) { return c.group(direction); })) continue;
    for (const Interface i : kInterfaces) {
      Panel& panel = figure.panels.emplace_back();
      panel.title = interface_title(i);
      if (direction) panel.title += fmt::format(", {}", name(*direction));
      for (std::size_t c = 0; c < all.size(); ++c) {
        const CaseGroup* group = all[c].group(direction);
        if (!group) continue;
        const std::vector<double>& values = plot.values(representative(*group), i);
        threads = std::max(threads, values.size());
        panel.series.push_back({c, {over_threads(values, plot.factor)}});
        const auto level = plot.level ? plot.level(representative(*group), i) : std::nullopt;
        if (level) panel.references.push_back({levels + c, *level * plot.factor});
        has_level = has_level || level;
      }
    }
  }
  if (has_level) figure.add("every thread with equal shares", kMeanStyle);
  figure.x = thread_axis(threads);
  return figure;
}

bool has_shares(const LoadCaseResult& result) { return result.threads && !result.full; }

Figures from_zero(std::optional<Figure> figure) {
  if (!figure) return {};
  fit_y_range(*figure, true);
  return {std::move(*figure)};
}

Figures load_distribution(const Result& result, const FigureOptions& options) {
  std::optional<Figure> figure =
      thread_figure({"load_distribution", "Load distribution", "Share of the load", "%",
                     loads_of<&InterfaceLoads::load_rate>, per_si::percent, has_shares},
                    result, options);
  if (!figure) return {};
  // The threads of a panel's first line share 100 %.
  const Polyline& shares = figure->panels.front().series.front().parts.front();
  add_mean(*figure, per_si::percent / static_cast<double>(shares.size()));
  return from_zero(std::move(figure));
}

/// With the pressure up to which contacts are rated.
Figures peak_pressure(const Result& result, const FigureOptions& options) {
  std::optional<Figure> figure =
      thread_figure({"peak_pressure", "Peak contact pressure", "Peak pressure", "MPa",
                     loads_of<&InterfaceLoads::peak_pressure>, per_si::megapascal, has_pressure},
                    result, options);
  if (!figure) return {};
  const std::size_t limit = figure->add(
      fmt::format("static limit {:.1f} GPa, ISO 76", kStaticPressureLimit * per_si::gigapascal),
      line_of(Colour::bad, Dash::dash_dotted, Weight::thin));
  for (Panel& panel : figure->panels)
    panel.references.push_back({limit, kStaticPressureLimit * per_si::megapascal});
  return from_zero(std::move(figure));
}

}  // namespace prs
