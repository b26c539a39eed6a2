#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "prs/loads/case_groups.h"
#include "prs/loads/load_parts.h"
#include "prs/loads/load_record.h"

namespace prs {
namespace {

constexpr std::size_t kMostButterflies = 4;

double largest_force_kN(const std::vector<LoadedConfiguration>& sweeps, Direction direction) {
  double largest = 0.0;
  for (const LoadedConfiguration& sweep : sweeps)
    if (const CaseGroup* group = sweep.group(direction))
      for (const LoadCaseResult* result : group->cases)
        largest = std::max(largest, std::abs(signed_kN(*result)));
  return largest;
}

/// Points (force, value) of the cases that have the value, by ascending force.
Polyline over_load(const CaseGroup& group, const auto& value, bool with_sign) {
  Polyline points;
  for (const LoadCaseResult* result : group.cases)
    if (const std::optional<double> y = value(*result))
      points.push_back({with_sign ? signed_kN(*result) : std::abs(signed_kN(*result)), *y});
  std::ranges::sort(points);
  return points;
}

Polyline over_load(const CaseGroup& group, std::optional<double> LoadCaseResult::*quantity,
                   double factor) {
  return over_load(
      group,
      [&](const LoadCaseResult& result) -> std::optional<double> {
        if (!(result.*quantity)) return std::nullopt;
        return *(result.*quantity) * factor;
      },
      false);
}

bool is_solved(const LoadCaseResult& result) {
  return result.load_case.direction && result.solve && result.threads && !result.full;
}

bool has_stiffness(const LoadCaseResult& result) {
  return result.load_case.direction && result.axial_stiffness;
}

/// One panel for each direction; `draw` adds the lines of a sweep, the c-th of them.
Figures over_load_figure(Figure figure, std::vector<LoadedConfiguration> sweeps, const auto& draw) {
  if (sweeps.empty()) return {};
  figure.x = {"Axial load", "kN", 0.0, 0.0};
  for (const Direction d : {Direction::tension, Direction::compression})
    if (const double largest = largest_force_kN(sweeps, d); largest > 0.0) {
      figure.x.to = std::max(figure.x.to, largest);
      Panel& panel = figure.panels.emplace_back();
      panel.title = d == Direction::tension ? "Tension" : "Compression";
      for (std::size_t c = 0; c < sweeps.size(); ++c)
        if (const CaseGroup* group = sweeps[c].group(d)) draw(panel, *group, c);
    }
  figure.columns = figure.panels.size();
  fit_y_range(figure, true);
  return {std::move(figure)};
}

/// Ranges of loads: a single load is no curve.
std::vector<LoadedConfiguration> sweeps_of(const Result& result) {
  return loaded_configurations(result.load_cases, kMinSweepPoints, has_stiffness);
}

/// How a thread of a butterfly stands out (Abevi 2015, figs. 15-18).
struct ThreadRole {
  const char* title;
  Style style;
  bool (*holds)(std::size_t thread, std::size_t count);
};

/// In the order of drawing: the first thread lies on top.
constexpr ThreadRole kThreadRoles[] = {
    {"others", line_of(Colour::muted, Dash::solid, Weight::thin),
     [](std::size_t k, std::size_t n) { return k > 1 && k + 1 < n; }},
    {"last thread", line_of(Colour::green, Dash::dash_dotted, Weight::strong),
     [](std::size_t k, std::size_t n) { return k > 1 && k + 1 == n; }},
    {"second thread", line_of(Colour::blue, Dash::dashed, Weight::strong),
     [](std::size_t k, std::size_t) { return k == 1; }},
    {"first thread", line_of(Colour::vermillion, Dash::solid, Weight::strong),
     [](std::size_t k, std::size_t) { return k == 0; }},
};

std::size_t thread_count(const LoadedConfiguration& sweep) {
  return sweep.groups.front().cases.front()->threads->screw.load_rate.size();
}

Panel butterfly_panel(const LoadedConfiguration& sweep, Interface i) {
  Panel panel;
  panel.title = fmt::format("{}, {}", interface_title(i), sweep.name);
  const std::size_t count = thread_count(sweep);
  for (std::size_t role = 0; role < std::size(kThreadRoles); ++role) {
    Series series{role};
    for (std::size_t k = 0; k < count; ++k)
      if (kThreadRoles[role].holds(k, count))
        for (const CaseGroup& group : sweep.groups)
          series.parts.push_back(over_load(
              group,
              [&](const LoadCaseResult& r) {
                const double rate = (*r.threads)[i].load_rate[k];
                return std::optional(rate * static_cast<double>(count) * per_si::percent);
              },
              true));
    panel.series.push_back(std::move(series));
  }
  return panel;
}

bool has_ellipses(const LoadCaseResult& result) {
  return result.threads && !result.full && !result.threads->screw.semi_major.empty() &&
         !result.threads->nut.semi_major.empty();
}

}  // namespace

/// Axial stiffness against the load of each range, secant and tangent (Abevi 2015, fig. 10).
Figures stiffness(const Result& result, const FigureOptions&) {
  Figure figure{"stiffness", "Axial stiffness"};
  auto sweeps = sweeps_of(result);
  keep_first(sweeps, kMostLines, figure.title);
  figure.y = {"Axial stiffness", "N/µm"};
  for (std::size_t c = 0; c < sweeps.size(); ++c) {
    figure.add(sweeps[c].name, case_line(c));
    Style tangent = case_line(c);
    tangent.dash = Dash::dashed;
    tangent.open = true;
    if (sweeps[c].groups.front().cases.size() >= kMinSweepPoints) tangent.mark = Mark::none;
    figure.add(tangent);
  }
  figure.add("secant", {Colour::ink, Dash::solid});
  figure.add("tangent", {Colour::ink, Dash::dashed});
  constexpr double kFactor = per_si::newton_per_micrometre;
  return over_load_figure(
      std::move(figure), std::move(sweeps), [](Panel& panel, const CaseGroup& g, std::size_t c) {
        panel.series.push_back({2 * c, {over_load(g, &LoadCaseResult::axial_stiffness, kFactor)}});
        panel.series.push_back(
            {2 * c + 1, {over_load(g, &LoadCaseResult::tangent_stiffness, kFactor)}});
      });
}

/// Axial displacement against the load of each range, > 0 in the direction of the load.
Figures displacement(const Result& result, const FigureOptions&) {
  Figure figure{"displacement", "Axial displacement"};
  auto sweeps = sweeps_of(result);
  keep_first(sweeps, kMostLines, figure.title);
  figure.y = {"Axial displacement", "µm"};
  for (std::size_t c = 0; c < sweeps.size(); ++c) figure.add(sweeps[c].name, case_line(c));
  return over_load_figure(
      std::move(figure), std::move(sweeps), [](Panel& panel, const CaseGroup& g, std::size_t c) {
        panel.series.push_back(
            {c, {over_load(g, &LoadCaseResult::axial_displacement, per_si::micrometre)}});
      });
}

/// Load of each thread in % of the mean against the load of each range, tension to the right: a row
/// of panels for each configuration, a column for each interface (Abevi 2015, figs. 15-18).
Figures butterfly(const Result& result, const FigureOptions& options) {
  auto sweeps = loaded_configurations(result.load_cases, kMinSweepPoints, is_solved);
  if (sweeps.empty()) return {};
  Figure figure{"butterfly", "Load distribution against the load"};
  keep_first(sweeps, kMostButterflies, figure.title);
  figure.x = {std::string(kSignedForce), "kN", -largest_force_kN(sweeps, Direction::compression),
              largest_force_kN(sweeps, Direction::tension)};
  figure.y = {"Thread load", "% of the mean"};
  for (const ThreadRole& role : kThreadRoles) figure.add(role.title, role.style);
  std::ranges::reverse(figure.legend);
  for (const LoadedConfiguration& sweep : sweeps)
    for (const Interface i : kInterfaces)
      if (!options.interface || i == *options.interface)
        figure.panels.push_back(butterfly_panel(sweep, i));
  figure.columns = options.interface ? 1 : std::size(kInterfaces);
  add_mean(figure, per_si::percent);
  fit_y_range(figure);
  return {std::move(figure)};
}

/// Relative residual after each linear solve, the last case of a range.
Figures convergence(const Result& result, const FigureOptions&) {
  std::vector<const LoadCaseResult*> cases;
  for (const CaseGroup& group : group_cases(result.load_cases))
    if (const LoadCaseResult& last = *group.cases.back();
        last.solve && !last.solve->history.empty())
      cases.push_back(&last);
  if (cases.empty()) return {};
  Figure figure{"convergence", "Convergence"};
  keep_first(cases, kMostLines, figure.title);
  figure.x = {"Linear solve"};
  figure.x.whole = true;
  figure.y = {"Relative residual"};
  figure.y.logarithmic = true;
  Panel panel;
  std::size_t longest = 1;
  for (const LoadCaseResult* r : cases) {
    Polyline line;
    for (std::size_t k = 0; k < r->solve->history.size(); ++k)
      if (const double residual = r->solve->history[k].relative_residual; residual > 0.0)
        line.push_back({static_cast<double>(k + 1), residual});
    longest = std::max(longest, r->solve->history.size());
    const std::size_t style =
        figure.add(shown_name(r->load_case.name), case_line(figure.styles.size()));
    panel.series.push_back({style, {std::move(line)}});
  }
  figure.x.from = 0.7;
  figure.x.to = static_cast<double>(longest) + 0.3;
  figure.panels.push_back(std::move(panel));
  return {std::move(figure)};
}

/// Contact ellipses of all threads, to scale, coloured by the peak pressure.
Figures ellipses(const Result& result, const FigureOptions& options) {
  const LoadCaseResult* shown = chosen_case(result, options, has_ellipses);
  if (!shown) return {};
  constexpr std::size_t kMostInARow = 20;
  Figure figure{"ellipses",
                "Contact ellipses of the threads, " + shown_name(shown->load_case.name)};
  figure.to_scale = true;
  const std::size_t threads = shown->threads->screw.semi_major.size();
  const std::size_t rows = (threads + kMostInARow - 1) / kMostInARow;
  const std::size_t per_row = (threads + rows - 1) / rows;
  double major = 0.0, minor = 0.0;
  Range pressure;
  for (const Interface i : kInterfaces) {
    const InterfaceLoads& loads = (*shown->threads)[i];
    major = std::max(major, std::ranges::max(loads.semi_major) * per_si::millimetre);
    minor = std::max(minor, std::ranges::max(loads.semi_minor) * per_si::millimetre);
    for (const double p : loads.peak_pressure) pressure.include(p * per_si::megapascal);
  }
  if (!(major > 0.0)) return {};
  if (!(pressure.from < pressure.to)) pressure.widen(0.05);
  figure.colours = ColourScale{"Peak pressure", "MPa", pressure.from, pressure.to};
  const double step = 2.25 * major, height = 2.0 * minor + 1.3 * major;
  Panel panel;
  Series series{figure.add(area_of(Colour::sky))};
  figure.y = {""};
  double lowest = 0.0;
  for (std::size_t k = 0; k < std::size(kInterfaces); ++k) {
    const InterfaceLoads& loads = (*shown->threads)[kInterfaces[k]];
    const double top =
        -static_cast<double>(k * rows) * height - 0.3 * height * static_cast<double>(k);
    for (std::size_t t = 0; t < threads; ++t) {
      const double x = static_cast<double>(t % per_row) * step;
      const double y = top - static_cast<double>(t / per_row) * height;
      series.parts.push_back(ellipse(x, y, loads.semi_major[t] * per_si::millimetre,
                                     loads.semi_minor[t] * per_si::millimetre, 0.0));
      series.values.push_back(loads.peak_pressure[t] * per_si::megapascal);
      panel.labels.push_back(
          {std::to_string(t + 1), x, y + minor + 0.42 * major, false, Label::Anchor::centre});
      lowest = y;
    }
    figure.y.ticks.push_back(
        {top - 0.5 * static_cast<double>(rows - 1) * height, interface_title(kInterfaces[k])});
  }
  // A bar of known length.
  double length = 1.0;
  while (length > 2.0 * major) length /= 10.0;
  const double right = static_cast<double>(per_row) * step - 0.6 * step;
  const double bar = lowest - minor - 0.7 * major;
  panel.series.push_back(std::move(series));
  panel.series.push_back({figure.add(line_of(Colour::ink, Dash::solid, Weight::strong)),
                          {{{right - length, bar}, {right, bar}}}});
  panel.labels.push_back({fmt::format("{:g} mm", length), right - length - 0.3 * major, bar, false,
                          Label::Anchor::right});
  figure.x = {"", "", -0.6 * step, static_cast<double>(per_row) * step - 0.4 * step};
  figure.x.hidden = true;
  figure.y.from = bar - 0.7 * major;
  figure.y.to = minor + 0.9 * major;
  figure.aspect = (figure.y.to - figure.y.from) / (figure.x.to - figure.x.from);
  figure.panels.push_back(std::move(panel));
  return {std::move(figure)};
}

}  // namespace prs
