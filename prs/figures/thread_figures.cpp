#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "prs/figures/figure_parts.h"
#include "prs/loads/analyze.h"
#include "prs/quantities/case_groups.h"
#include "prs/quantities/quantities.h"
#include "prs/quantities/slip_quantities.h"

namespace prs {
namespace {

/// What the threads are compared by.
struct ThreadPlot {
  const char* name;
  const char* title;
  const char* label;
  const char* unit;
  const std::vector<double>& (*values)(const LoadCaseResult&, Interface);
  double factor;
  bool (*keep)(const LoadCaseResult&);
  /// A dashed level of the colour of its line, where a case has one.
  std::optional<double> (*level)(const LoadCaseResult&, Interface) = nullptr;
};

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

/// A row of panels a direction, one column per interface, one line per configuration.
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

template <std::vector<double> InterfaceLoads::*values>
const std::vector<double>& loads_of(const LoadCaseResult& result, Interface i) {
  return (*result.threads)[i].*values;
}

template <std::vector<double> InterfaceSlip::*values>
const std::vector<double>& slip_of(const LoadCaseResult& result, Interface i) {
  return result.slip->threads[i].*values;
}

bool has_shares(const LoadCaseResult& result) { return result.threads && !result.full; }

bool has_pressure(const LoadCaseResult& result) {
  return has_shares(result) && !(result.threads->screw.peak_pressure.empty() &&
                                 result.threads->nut.peak_pressure.empty());
}

bool has_thread_slip(const LoadCaseResult& result) {
  return has_slip(result) && has_shares(result);
}

std::optional<double> with_equal_shares(const LoadCaseResult& result, Interface i) {
  const std::optional<EqualShareSlip>& equal = result.slip->equal_shares;
  return equal ? std::optional(equal->thread_power[i]) : std::nullopt;
}

Figures fitted(std::optional<Figure> figure) {
  if (!figure) return {};
  fit_y_range(*figure, true);
  return {std::move(*figure)};
}

}  // namespace

Figures load_distribution(const Result& result, const FigureOptions& options) {
  std::optional<Figure> figure =
      thread_figure({"load_distribution", "Load distribution", "Share of the load", "%",
                     loads_of<&InterfaceLoads::load_rate>, per_si::percent, has_shares},
                    result, options);
  if (!figure) return {};
  // The threads of a panel's first line share 100 %.
  const Polyline& shares = figure->panels.front().series.front().parts.front();
  add_mean(*figure, per_si::percent / static_cast<double>(shares.size()));
  return fitted(std::move(figure));
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
  return fitted(std::move(figure));
}

Figures thread_power(const Result& result, const FigureOptions& options) {
  FigureOptions one = options;
  if (options.load_case) one.load_cases = {*options.load_case};
  return fitted(
      thread_figure({"thread_power", "Power lost at each thread of a roller", "Power", "W",
                     slip_of<&InterfaceSlip::power>, 1.0, has_thread_slip, with_equal_shares},
                    result, one));
}

/// Friction coefficient and sliding speed of each thread, a panel each.
Figures friction(const Result& result, const FigureOptions& options) {
  const LoadCaseResult* shown = chosen_case(result, options, has_thread_slip);
  if (!shown) return {};
  Figure figure{"friction",
                "Friction and sliding of each thread, " + shown_name(shown->load_case.name)};
  figure.columns = 2;
  struct Shown {
    const char* title;
    const char* unit;
    std::vector<double> InterfaceSlip::*values;
    double factor;
  };
  constexpr Shown kShown[] = {
      {"Friction coefficient", "", &InterfaceSlip::friction_coefficient, 1.0},
      {"Sliding speed", "mm/s", &InterfaceSlip::sliding_speed, per_si::millimetre}};
  for (std::size_t k = 0; k < std::size(kInterfaces); ++k)
    figure.add(interface_title(kInterfaces[k]), marked_line(k));
  for (const Shown& s : kShown) {
    Panel& panel = figure.panels.emplace_back();
    panel.title = s.title;
    for (std::size_t k = 0; k < std::size(kInterfaces); ++k)
      panel.series.push_back(
          {k, {over_threads(shown->slip->threads[kInterfaces[k]].*s.values, s.factor)}});
    panel.y = fitted({s.title, s.unit}, range_of_y(panel.series), true);
  }
  figure.x = thread_axis(shown->threads->screw.axial_load.size());
  return {std::move(figure)};
}

}  // namespace prs
