#include "prs/loads/load_pictures.h"

#include <fmt/ranges.h>

#include <set>

#include "prs/indices.h"
#include "prs/loads/analyze.h"
#include "prs/loads/case_table.h"
#include "prs/loads/contact_figures.h"
#include "prs/loads/full_result.h"
#include "prs/loads/load_record.h"
#include "prs/loads/motion_figures.h"
#include "prs/record/table_layout.h"
#include "prs/record/table_units.h"

namespace prs {

double signed_kN(const LoadCaseResult& result) {
  const auto& direction = result.load_case.direction;
  const double sign = direction == Direction::compression ? -1.0 : 1.0;
  return sign * result.load_case.axial_force * "kN"_per_si;
}

std::vector<const LoadCaseResult*> chosen(const Result& result, const FigureOptions& options) {
  std::vector<const LoadCaseResult*> cases;
  for (const std::size_t k : options.load_cases) {
    if (k >= result.load_cases.size())
      throw NoFigure(fmt::format("no load case {}; there are {}", k, result.load_cases.size()));
    cases.push_back(&result.load_cases[k]);
  }
  if (options.load_cases.empty())
    for (const LoadCaseResult& load_case : result.load_cases) cases.push_back(&load_case);
  return cases;
}

const LoadCaseResult* chosen_case(const Result& result, const FigureOptions& options,
                                  bool (*has)(const LoadCaseResult&)) {
  FigureOptions one = options;
  if (options.load_case) one.load_cases = {*options.load_case};
  const auto loads = [](const LoadCaseResult& r) {
    double thread = 0.0;
    for (const Interface i : kInterfaces)
      if (r.threads)
        for (const double load : (*r.threads)[i].normal_load) thread = std::max(thread, load);
    return std::pair(r.load_case.axial_force, thread);
  };
  const LoadCaseResult* largest = nullptr;
  for (const LoadCaseResult* load_case : chosen(result, one))
    if (has(*load_case) && (!largest || loads(*load_case) > loads(*largest))) largest = load_case;
  return largest;
}

namespace {

/// Representative case of a group: the last, which has the full load of a range.
const LoadCaseResult& representative(const CaseGroup& group) { return *group.cases.back(); }

/// Configurations that the options name, each separate; else all, ranges by their largest loads.
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

/// Text with the force if all lines have the same.
std::string common_force(const std::vector<LoadedConfiguration>& all) {
  const auto force = [](const CaseGroup& g) { return representative(g).load_case.axial_force; };
  const double first = force(all.front().groups.front());
  for (const LoadedConfiguration& c : all)
    for (const CaseGroup& group : c.groups)
      if (std::abs(force(group) - first) > 1e-9 * std::abs(first)) return {};
  return ", " + in_table_unit(fmt::format("{:.4g} kN", first * "kN"_per_si));
}

template <std::vector<double> InterfaceLoads::*values>
const std::vector<double>& loads_of(const LoadCaseResult& result, Interface i) {
  return (*result.threads)[i].*values;
}

bool has_pressure(const LoadCaseResult& result) {
  return has_shares(result) &&
         !(result.threads->screw.peak_pressure.empty() && result.threads->nut.peak_pressure.empty());
}

}  // namespace

Figure thread_figure(const ThreadPlot& plot, const Result& result, const FigureOptions& options) {
  std::vector<LoadedConfiguration> all = configurations(result, options, plot.keep);
  if (all.empty()) return {};
  Figure figure{plot.name, plot.title + common_force(all)};
  keep_first(all, kMostLines, figure.title);
  figure.y = {plot.label, plot.unit};
  figure.columns = std::size(kInterfaces);
  for (const auto c : indices(all)) figure.add(all[c].name, case_line(c));
  const std::size_t levels = figure.styles.size();
  for (const auto c : indices(all)) figure.add(line_of(case_colour(c), Dash::dashed, Weight::thin));
  std::size_t threads = 0;
  bool has_level = false;
  for (const std::optional<Direction> direction :
       {std::optional(Direction::tension), std::optional(Direction::compression), {}}) {
    if (std::ranges::none_of(all, [&](const auto& c) { return c.group(direction); })) continue;
    for (const Interface i : kInterfaces) {
      Panel& panel = figure.panels.emplace_back(Panel{interface_title(i)});
      if (direction) panel.title += fmt::format(", {}", name(*direction));
      for (const auto c : indices(all)) {
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
  if (has_level) figure.add("every thread with equal thread loads", kMeanStyle);
  figure.x = thread_axis(threads);
  return figure;
}

bool has_shares(const LoadCaseResult& result) { return result.threads && !result.full; }

/// Whether the loads of the cases are those of a screw at rest or running, in words.
std::string state_of_loads(const Result& result) {
  std::set<std::string> states;
  for (const LoadCaseResult& r : result.load_cases) states.insert(words_of_text(name(r.loads)));
  return fmt::format("{}", fmt::join(states, " and "));
}

Figure from_zero(Figure figure) {
  fit_y_range(figure, true);
  return figure;
}

namespace {

Figure load_distribution(const Result& result, const FigureOptions& options) {
  Figure figure = thread_figure({"load_distribution", "Load distribution", "Share of the load", "%",
                                 loads_of<&InterfaceLoads::load_rate>, "%"_per_si, has_shares},
                                result, options);
  if (figure.panels.empty()) return figure;
  // The threads of a panel's first line share 100 %.
  const Polyline& shares = figure.panels.front().series.front().parts.front();
  add_mean(figure, "%"_per_si / static_cast<double>(shares.size()));
  return from_zero(std::move(figure));
}

/// Figures of the peak pressure, with the pressure up to which contacts are rated.
Figure peak_pressure(const Result& result, const FigureOptions& options) {
  Figure figure = thread_figure({"peak_pressure", "Peak contact pressure", "Peak pressure", "MPa",
                                 loads_of<&InterfaceLoads::peak_pressure>, "MPa"_per_si, has_pressure},
                                result, options);
  const PerInterface<InterfaceContact>& of = result.contacts.interfaces;
  const std::optional<double>&screw = of.screw.pressure_limit, &nut = of.nut.pressure_limit;
  if (!screw && !nut) return from_zero(std::move(figure));
  const auto text = [](const std::optional<double>& limit) {
    return fixed_with_unit(limit, "GPa", 1) + (limit == kStaticPressureLimit ? ", ISO 76" : "");
  };
  const std::size_t limit =
      figure.add(screw == nut ? fmt::format("static limit {}", text(nut))
                              : fmt::format("static limit: roller-screw {}; roller-nut {}", text(screw), text(nut)),
                 line_of(Colour::bad, Dash::dash_dotted, Weight::thin));
  for (const auto p : indices(figure.panels))  // Panels of the screw and of the nut take turns.
    if (const std::optional<double>& pressure = p % 2 == 0 ? screw : nut)
      figure.panels[p].references.push_back({limit, *pressure * "MPa"_per_si});
  return from_zero(std::move(figure));
}

constexpr std::size_t kMostButterflies = 4;

double largest_force_kN(const std::vector<LoadedConfiguration>& sweeps, Direction direction) {
  double largest = 0.0;
  for (const LoadedConfiguration& sweep : sweeps)
    if (const CaseGroup* group = sweep.group(direction))
      for (const LoadCaseResult* result : group->cases) largest = std::max(largest, std::abs(signed_kN(*result)));
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

Polyline over_load(const CaseGroup& group, std::optional<double> LoadCaseResult::*quantity, double factor) {
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

bool has_stiffness(const LoadCaseResult& result) { return result.load_case.direction && result.axial_stiffness; }

/// Figure with one panel for each direction; `draw` adds the lines of a sweep, the c-th of them.
Figure over_load_figure(Figure figure, std::vector<LoadedConfiguration> sweeps, const auto& draw) {
  if (sweeps.empty()) return {};
  figure.x = {"Axial load", "kN", 0.0, 0.0};
  for (const Direction d : {Direction::tension, Direction::compression})
    if (const double largest = largest_force_kN(sweeps, d); largest > 0.0) {
      figure.x.to = std::max(figure.x.to, largest);
      Panel& panel = figure.panels.emplace_back(Panel{d == Direction::tension ? "Tension" : "Compression"});
      for (const auto c : indices(sweeps))
        if (const CaseGroup* group = sweeps[c].group(d)) draw(panel, *group, c);
    }
  figure.columns = figure.panels.size();
  fit_y_range(figure, true);
  return figure;
}

/// Configurations with ranges of loads: a single load is no curve.
std::vector<LoadedConfiguration> sweeps_of(const Result& result) {
  return loaded_configurations(result.load_cases, kMinSweepPoints, has_stiffness);
}

/// Emphasis of a thread in a butterfly (Abevi 2015, figs. 15-18).
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
  Panel panel{fmt::format("{}, {}", interface_title(i), sweep.name)};
  const std::size_t count = thread_count(sweep);
  for (const auto role : indices(kThreadRoles)) {
    Series series{role};
    for (const auto k : up_to(count))
      if (kThreadRoles[role].holds(k, count))
        for (const CaseGroup& group : sweep.groups)
          series.parts.push_back(over_load(
              group,
              [&](const LoadCaseResult& r) {
                const double rate = (*r.threads)[i].load_rate[k];
                return std::optional(rate * static_cast<double>(count) * "%"_per_si);
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

/// Axial stiffness against the load of each range, secant and tangent (Abevi 2015, fig. 10).
Figure stiffness(const Result& result, const FigureOptions&) {
  Figure figure{"stiffness", "Axial stiffness"};
  auto sweeps = sweeps_of(result);
  keep_first(sweeps, kMostLines, figure.title);
  figure.y = {"Axial stiffness", "N/µm"};
  for (const auto c : indices(sweeps)) {
    figure.add(sweeps[c].name, case_line(c));
    Style tangent = case_line(c);
    tangent.dash = Dash::dashed;
    tangent.mark = Mark::none;
    figure.add(tangent);
  }
  figure.add("secant", {Colour::ink, Dash::solid});
  figure.add("tangent", {Colour::ink, Dash::dashed});
  constexpr double kFactor = "N/µm"_per_si;
  return over_load_figure(std::move(figure), std::move(sweeps), [](Panel& panel, const CaseGroup& g, std::size_t c) {
    panel.series.push_back({2 * c, {over_load(g, &LoadCaseResult::axial_stiffness, kFactor)}});
    panel.series.push_back({2 * c + 1, {over_load(g, &LoadCaseResult::tangent_stiffness, kFactor)}});
  });
}

/// Axial displacement against the load of each range, > 0 in the direction of the load.
Figure displacement(const Result& result, const FigureOptions&) {
  Figure figure{"displacement", "Axial displacement"};
  auto sweeps = sweeps_of(result);
  keep_first(sweeps, kMostLines, figure.title);
  figure.y = {"Axial displacement", "µm"};
  for (const auto c : indices(sweeps)) figure.add(sweeps[c].name, case_line(c));
  return over_load_figure(std::move(figure), std::move(sweeps), [](Panel& panel, const CaseGroup& g, std::size_t c) {
    panel.series.push_back({c, {over_load(g, &LoadCaseResult::axial_displacement, "µm"_per_si)}});
  });
}

/// Load of each thread in % of the mean against the load of each range, tension to the right: a row
/// of panels for each configuration, a column for each interface (Abevi 2015, figs. 15-18). `of_load`: as there, in %
/// of the load and tension to the left.
Figure butterfly(const Result& result, bool of_load, const FigureOptions& options) {
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
      if (!options.interface || i == *options.interface) figure.panels.push_back(butterfly_panel(sweep, i));
  figure.columns = options.interface ? 1 : std::size(kInterfaces);
  double mean = "%"_per_si;
  if (of_load) {
    const auto count = static_cast<double>(thread_count(sweeps.front()));
    mean /= count;
    figure.x = {"Axial force, compression >\u00a00", "kN", -figure.x.to, -figure.x.from};
    figure.y.unit = "% of the load";
    for (Panel& panel : figure.panels)
      for (Series& series : panel.series)
        for (Polyline& part : series.parts)
          for (auto& [x, y] : part) x = -x, y /= count;
  }
  add_mean(figure, mean);
  fit_y_range(figure);
  return figure;
}

/// Relative residual after each linear solve, the last case of a range.
Figure convergence(const Result& result, const FigureOptions&) {
  std::vector<const LoadCaseResult*> cases;
  for (const CaseGroup& group : group_cases(result.load_cases))
    if (const LoadCaseResult& last = *group.cases.back(); last.solve && !last.solve->history.empty())
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
    for (const auto k : indices(r->solve->history))
      if (const double residual = r->solve->history[k].relative_residual; residual > 0.0)
        line.push_back({static_cast<double>(k + 1), residual});
    longest = std::max(longest, r->solve->history.size());
    const std::size_t style = figure.add(shown_name(r->load_case.name), case_line(figure.styles.size()));
    panel.series.push_back({style, {std::move(line)}});
  }
  figure.x.from = 0.7;
  figure.x.to = static_cast<double>(longest) + 0.3;
  figure.panels.push_back(std::move(panel));
  return figure;
}

/// Contact ellipses of all threads, to scale, coloured by the peak pressure.
Figure ellipses(const Result&, const LoadCaseResult& shown) {
  constexpr std::size_t kMostInARow = 20;
  Figure figure{"ellipses", "Contact ellipses of the threads, " + shown_name(shown.load_case.name)};
  figure.to_scale = true;
  const std::size_t threads = shown.threads->screw.semi_major.size();
  const std::size_t rows = (threads + kMostInARow - 1) / kMostInARow;
  const std::size_t per_row = (threads + rows - 1) / rows;
  double major = 0.0, minor = 0.0;
  Range pressure;
  for (const Interface i : kInterfaces) {
    const InterfaceLoads& loads = (*shown.threads)[i];
    major = std::max(major, std::ranges::max(loads.semi_major) * "mm"_per_si);
    minor = std::max(minor, std::ranges::max(loads.semi_minor) * "mm"_per_si);
    for (const double p : loads.peak_pressure) pressure.include(p * "MPa"_per_si);
  }
  if (!(major > 0.0)) return {};
  if (!(pressure.from < pressure.to)) pressure.widen(0.05);
  figure.colours = ColourScale{"Peak pressure", "MPa", pressure.from, pressure.to};
  const double step = 2.25 * major, height = 2.0 * minor + 1.7 * major;
  Panel panel;
  Series series{figure.add(area_of(Colour::sky))};
  figure.y = {""};
  double lowest = 0.0;
  for (const auto k : indices(kInterfaces)) {
    const InterfaceLoads& loads = (*shown.threads)[kInterfaces[k]];
    const double top = -static_cast<double>(k * rows) * height - 0.3 * height * static_cast<double>(k);
    for (const auto t : up_to(threads)) {
      const double x = static_cast<double>(t % per_row) * step;
      const double y = top - static_cast<double>(t / per_row) * height;
      series.parts.push_back(ellipse(x, y, loads.semi_major[t] * "mm"_per_si, loads.semi_minor[t] * "mm"_per_si, 0.0));
      series.values.push_back(loads.peak_pressure[t] * "MPa"_per_si);
      panel.labels.push_back({std::to_string(t + 1), x, y + minor + 0.65 * major, false, Label::Anchor::centre});
      lowest = y;
    }
    figure.y.ticks.push_back({top - 0.5 * static_cast<double>(rows - 1) * height, interface_title(kInterfaces[k])});
  }
  // A bar of known length.
  double length = 1.0;
  while (length > 2.0 * major) length /= 10.0;
  const double right = static_cast<double>(per_row) * step - 0.6 * step;
  const double bar = lowest - minor - 0.7 * major;
  panel.series.push_back(std::move(series));
  panel.series.push_back(
      {figure.add(line_of(Colour::ink, Dash::solid, Weight::strong)), {{{right - length, bar}, {right, bar}}}});
  panel.labels.push_back(
      {in_table_unit(fmt::format("{:g} mm", length)), right - length - 0.3 * major, bar, false, Label::Anchor::right});
  figure.x = {"", "", -0.6 * step, static_cast<double>(per_row) * step - 0.4 * step};
  figure.x.hidden = true;
  figure.y.from = bar - 0.7 * major;
  figure.y.to = minor + 1.4 * major;
  figure.aspect = (figure.y.to - figure.y.from) / (figure.x.to - figure.x.from);
  figure.panels.push_back(std::move(panel));
  return figure;
}

using enum Picture::Drawn;

constexpr const char* kRange =
    "a range of loads, `axial_force: {from: .., to: .., steps: ..}`, not of equal thread loads";

/// Whether a solve has not converged: its iterations are then shown.
bool has_failed(const Result& r) {
  return std::ranges::any_of(r.load_cases, [](const LoadCaseResult& c) { return !c.converged(); });
}

/// Whether there are several threads: a single one would be a dot.
bool has_several_threads(const Result& r) {
  return std::ranges::any_of(
      r.load_cases, [](const LoadCaseResult& c) { return c.threads && c.threads->screw.axial_load.size() > 1; });
}

/// Pictures with titles that say whether the screw is at rest or running.
Pictures with_loads_in_titles(Pictures pictures, const Result& r) {
  for (Picture& picture : pictures)
    picture.make = [make = std::move(picture.make), &r](const FigureOptions& options) {
      Figures figures = make(options);
      for (Figure& figure : figures)
        if (!figure.title.empty()) figure.title += ", " + state_of_loads(r);
      return figures;
    };
  return pictures;
}

Pictures load_pictures(const Result& r, bool butterflies_of_load = false) {
  const Picture::Drawn of_threads = drawn_if(has_several_threads(r));
  Pictures all{
      {"load_distribution", "a load case that converged, or equal thread loads", of_result(r, load_distribution),
       of_threads},
      {"peak_pressure", "load cases, and contacts that come from the threads", of_result(r, peak_pressure), of_threads},
      {"ellipses", "load cases, and contacts that come from the threads", of_case(r, has_ellipses, ellipses),
       of_threads},
      {"displacement", kRange, of_result(r, displacement)},
      {"stiffness", kRange, of_result(r, stiffness)},
      {"butterfly", "a sweep of loads, `axial_force: {from: .., to: .., steps: ..}`, that converged",
       [&r, butterflies_of_load](const FigureOptions& options) {
         return in_shown_units(listed(butterfly(r, butterflies_of_load, options)));
       }}};
  append(all, roller_pictures(r));
  append(all, motion_pictures(r));
  all.push_back({"convergence", "at most a few load cases, not of equal thread loads", of_result(r, convergence),
                 has_failed(r) ? always : with_all});
  return all;
}

bool has_turn(const LoadCaseResult& result) { return has_rollers(result) && result.full->orbit; }

Axis roller_axis(int rollers) { return {"Roller", {}, 0.5, rollers + 0.5, false, true}; }

/// Map of rollers over threads, unrolled, of values in shown units.
GridData unrolled(const std::vector<double>& of_threads, int threads_per_roller) {
  GridData grid;
  const auto threads = static_cast<std::size_t>(threads_per_roller);
  const std::size_t rollers = of_threads.size() / threads;
  for (const auto k : up_to(threads)) grid.x.push_back(static_cast<double>(k + 1));
  for (const auto j : up_to(rollers)) grid.y.push_back(static_cast<double>(j + 1));
  for (const auto k : up_to(threads))
    for (const auto j : up_to(rollers)) grid.values.push_back(of_threads[j * threads + k]);
  return grid;
}

/// Removes the colours of missing rollers, which would be that of zero.
void without_missing(Panel& panel, const FullLoads& full) {
  GridData& grid = panel.map.grid;
  for (const int roller : full.missing_rollers) {
    for (const auto k : indices(grid.x)) grid.values[k * grid.y.size() + static_cast<std::size_t>(roller - 1)] = kFree;
    panel.labels.push_back(
        {"missing", 0.5 * (grid.x.front() + grid.x.back()), static_cast<double>(roller), false, Label::Anchor::centre});
  }
}

/// Range of the values of all load cases, to make their pictures comparable.
Range range_of(const Result& result, const OfThreads& of) {
  Range range;
  for (const LoadCaseResult& load_case : result.load_cases)
    for (const Interface i : kInterfaces)
      if (of.has(load_case))
        for (const double value : of.values(load_case, i)) range.include(value);
  return range;
}

std::array<double, 2> towards(double radius, double azimuth) {
  return {radius * std::cos(azimuth), radius * std::sin(azimuth)};
}

}  // namespace

Pictures contact_pictures(const Result& r) { return with(contact_drawings(r), load_pictures(r)); }

Pictures solve_pictures(const Result& r, bool butterflies_of_load) {
  return with(with_loads_in_titles(load_pictures(r, butterflies_of_load), r), contact_drawings(r));
}

bool has_rollers(const LoadCaseResult& result) { return result.full && result.threads; }

Figure map_of_rollers(Figure figure, const Result& result, const FigureOptions& options, ColourScale colours,
                      const OfThreads& of) {
  const LoadCaseResult* chosen = chosen_case(result, options, of.has);
  if (!chosen) return {};
  const LoadCaseResult& shown = *chosen;
  figure.title += ", " + shown_name(shown.load_case.name);
  const int threads = shown.threads->screw.threads_per_roller;
  const Range range = range_of(result, of);
  for (const Interface i : kInterfaces) {
    Panel& panel = figure.panels.emplace_back(Panel{interface_title(i)});
    panel.map = {unrolled(of.values(shown, i), threads), true};
    without_missing(panel, *shown.full);
  }
  figure.x = thread_axis(static_cast<std::size_t>(threads));
  figure.y = roller_axis(shown.full->rollers);
  figure.columns = 2;
  colours.from = std::min(range.from, 0.0);
  colours.to = range.to;
  figure.colours = std::move(colours);
  return figure;
}

namespace {

/// Normal load of every thread of every roller, at both interfaces.
Figure roller_loads(const Result& result, const FigureOptions& options) {
  return map_of_rollers({"roller_loads", "Loads of all rollers"}, result, options, {"Normal load", "N"},
                        {has_rollers, loads_of<&InterfaceLoads::normal_load>});
}

/// Share of each roller in % of equal shares, at its place around the axis, between screw and nut.
Figure roller_shares(const Result& result, const LoadCaseResult& shown) {
  Figure figure{"roller_shares", fmt::format("Shares of the rollers, {}", shown_name(shown.load_case.name))};
  const contact::MechanismGeometry& threads = result.contacts.threads;
  const auto circle = [](double y, double z, double radius) { return ellipse(y, z, radius, radius, 0.0); };
  const double nut = contact::ThreadSurface(threads.nut).pitch_radius;
  const double screw = contact::ThreadSurface(threads.screw).pitch_radius;
  Panel& panel = figure.panels.emplace_back();
  panel.series.push_back({figure.add("screw, pitch circle", line_of(colour_of(Part::screw))), {circle(0, 0, screw)}});
  panel.series.push_back({figure.add("nut, pitch circle", line_of(colour_of(Part::nut))), {circle(0, 0, nut)}});
  Series rollers{figure.add(area_of(colour_of(Part::roller)))};
  const std::vector<double>& share = shown.threads->screw.rollers->share;
  const int count = shown.full->rollers;
  Range range;  // Range of all load cases.
  for (const LoadCaseResult& load_case : result.load_cases)
    if (has_rollers(load_case))
      for (const double part : load_case.threads->screw.rollers->share)
        range.include(part * load_case.full->rollers * "%"_per_si);
  for (int j = 0; j < count; ++j) {
    const double azimuth = shown.full->carrier_angle + 2.0 * std::numbers::pi * j / count;
    const auto [y, z] = towards(threads.centre_distance, azimuth);
    const auto [at_y, at_z] = towards(1.25 * nut, azimuth);
    const bool missing = std::ranges::count(shown.full->missing_rollers, j + 1) > 0;
    const double percent = share[static_cast<std::size_t>(j)] * count * "%"_per_si;
    panel.labels.push_back({missing ? "missing" : number(percent, 0) + " %", at_y, at_z, false, Label::Anchor::centre});
    if (missing) continue;
    panel.labels.push_back({fmt::to_string(j + 1), y, z, false, Label::Anchor::centre});
    rollers.parts.push_back(circle(y, z, contact::ThreadSurface(threads.roller).pitch_radius));
    rollers.values.push_back(percent);
  }
  panel.series.push_back(std::move(rollers));
  constexpr double kUsual = 150.0;  // Smallest upper end, so that equal shares do not look like a peak.
  figure.colours =
      ColourScale{"Share of the roller", "% of the mean", std::min(0.0, range.from), std::max(kUsual, range.to)};
  const double reach = 1.42 * nut;
  figure.x = {"y", {}, -reach, reach};
  figure.y = {"z", {}, -reach, reach};
  figure.x.hidden = figure.y.hidden = true;
  figure.to_scale = true;
  figure.aspect = 0.7;
  return figure;
}

/// Largest thread load of the first present roller over a turn of the carrier.
Figure carrier_turn(const Result&, const LoadCaseResult& shown) {
  const Orbit& orbit = *shown.full->orbit;
  if (orbit.carrier_angle.empty()) return {};
  constexpr double kTurn = 360.0;
  Figure figure{"carrier_turn",
                fmt::format("One roller over a turn of the carrier, {}", shown_name(shown.load_case.name))};
  Panel& panel = figure.panels.emplace_back();
  for (const Interface i : kInterfaces) {
    Polyline line;
    for (const auto m : indices(orbit.carrier_angle))
      line.push_back({orbit.carrier_angle[m] * "deg"_per_si, orbit.loads[i].first_roller[m]});
    line.push_back({line.front()[0] + kTurn, line.front()[1]});  // Repeats the first position.
    panel.series.push_back({figure.add(interface_title(i), line_of(colour_of(body_of(i)),
                                                                   i == Interface::nut ? Dash::dashed : Dash::solid)),
                            {std::move(line)}});
  }
  const double start = panel.series.front().parts.front().front()[0];
  figure.x = {"Angle of the carrier", "°", start, start + kTurn};
  for (double turned = 0.0; turned <= kTurn; turned += 60.0) figure.x.ticks.push_back({start + turned});
  // First present roller.
  const std::vector<int>& missing = shown.full->missing_rollers;
  int roller = 1;
  while (std::ranges::count(missing, roller) > 0) ++roller;
  figure.y = {fmt::format("Largest normal load of roller {}", roller), "N"};
  fit_y_range(figure);
  figure.y.from = 0.0;
  figure.y.to *= 1.1;
  return figure;
}

}  // namespace

Pictures roller_pictures(const Result& r) {
  constexpr const char* kNeeds = "a load case of `model: {mechanism: full}` that converged";
  return {{"roller_loads", kNeeds, of_result(r, roller_loads)},
          {"roller_shares", kNeeds, of_case(r, has_rollers, roller_shares)},
          {"carrier_turn", "`orbit` in a load case of the full mechanism", of_case(r, has_turn, carrier_turn)}};
}

}  // namespace prs
