#include "prs/losses/slip_pictures.h"

#include "prs/loads/case_groups.h"
#include "prs/loads/heat_record.h"
#include "prs/loads/load_pictures.h"
#include "prs/losses/slip_record.h"
#include "prs/model/units.h"

namespace prs {
namespace {

constexpr std::size_t kMostFigures = 4;

constexpr Colour kSourceColours[] = {Colour::blue, Colour::vermillion, Colour::green, Colour::sky,
                                     Colour::orange};
static_assert(std::size(kSourceColours) == std::size(kPowerSources));

/// A result and where it stands on the axis.
struct SweepPoint {
  double x = 0.0;
  const SlipResult* slip = nullptr;
};

/// By ascending x.
std::vector<SweepPoint> sweep(const std::vector<double>& x,
                              const std::vector<SlipResult>& results) {
  std::vector<SweepPoint> points;
  for (std::size_t k = 0; k < std::min(x.size(), results.size()); ++k)
    points.push_back({x[k], &results[k]});
  std::ranges::stable_sort(points, {}, &SweepPoint::x);
  return points;
}

/// Neighbours that all have an answer.
std::vector<std::vector<SweepPoint>> unbroken(const std::vector<SweepPoint>& points) {
  std::vector<std::vector<SweepPoint>> runs(1);
  for (const SweepPoint& point : points)
    if (point.slip->converged())
      runs.back().push_back(point);
    else if (!runs.back().empty())
      runs.emplace_back();
  if (runs.back().empty()) runs.pop_back();
  return runs;
}

double power_below(const SlipResult& slip, std::size_t source) {
  double sum = 0.0;
  for (std::size_t k = 0; k < source; ++k) sum += slip.power.*kPowerSources[k].value;
  return sum;
}

/// The polygon between the sums without and with the source.
Polyline area(const std::vector<SweepPoint>& run, std::size_t source, double factor) {
  Polyline polygon;
  for (const SweepPoint& p : run) polygon.push_back({p.x, factor * power_below(*p.slip, source)});
  for (auto p = run.rbegin(); p != run.rend(); ++p)
    polygon.push_back({p->x, factor * power_below(*p->slip, source + 1)});
  return polygon;
}

Polyline total_line(const std::vector<SweepPoint>& run, double factor) {
  Polyline line;
  for (const SweepPoint& p : run) line.push_back({p.x, factor * p.slip->power.total()});
  return line;
}

Polyline efficiency_line(const std::vector<SweepPoint>& run) {
  Polyline line;
  for (const SweepPoint& p : run)
    if (p.slip->efficiency) line.push_back({p.x, *p.slip->efficiency * per_si::percent});
  return line;
}

bool has_power(const std::vector<std::vector<SweepPoint>>& runs, const PowerSource& source) {
  for (const auto& run : runs)
    for (const SweepPoint& p : run)
      if (p.slip->power.*source.value > 0.0) return true;
  return false;
}

/// The points of the options in both panels.
void add_references(Figure& figure, const PowerFigureOptions& options, double factor) {
  for (std::size_t k = 0; k < options.references.size(); ++k) {
    const ReferencePoint& point = options.references[k];
    const std::size_t style = figure.add(
        point.title, points_of(palette(1 + k), static_cast<Mark>(1 + k % 8), Weight::strong));
    if (point.power_loss)
      figure.panels[0].series.push_back({style, {{{point.x, *point.power_loss * factor}}}});
    if (point.efficiency)
      figure.panels[1].series.push_back(
          {style, {{{point.x, *point.efficiency * per_si::percent}}}});
  }
}

void add_comparison(Figure& figure, const PowerFigureOptions& options) {
  if (options.comparison.empty()) return;
  Polyline line;
  for (const auto& [x, efficiency] : options.comparison)
    line.push_back({x, efficiency * per_si::percent});
  const std::size_t style =
      figure.add(options.comparison_title, line_of(Colour::reference, Dash::dashed));
  figure.panels[1].series.push_back({style, {std::move(line)}});
}

Series series_of(std::size_t style, const std::vector<std::vector<SweepPoint>>& runs, auto part) {
  Series line{style};
  for (const auto& run : runs) line.parts.push_back(part(run));
  return line;
}

/// A bar for each load case, stacked.
Figure power_bars(std::vector<const LoadCaseResult*> cases) {
  constexpr std::size_t kMostBars = 12;
  Figure figure{"power_by_source", "Power lost by source"};
  keep_first(cases, kMostBars, figure.title);
  figure.y = {"Power lost", "W", 0.0};
  figure.x = {"", "", 0.4, std::max(static_cast<double>(cases.size()) + 0.6, 2.6)};
  Panel& panel = figure.panels.emplace_back();
  for (std::size_t k = 0; k < std::size(kPowerSources); ++k) {
    Series bars;
    bool any = false;
    for (std::size_t c = 0; c < cases.size(); ++c) {
      const SlipResult& slip = *cases[c]->slip;
      const double at = static_cast<double>(c + 1), power = slip.power.*kPowerSources[k].value;
      const double below = power_below(slip, k);
      any = any || power > 0.0;
      bars.parts.push_back(rectangle(at - 0.3, at + 0.3, below, below + power));
    }
    if (!any) continue;
    bars.style = figure.add(std::string(kPowerSources[k].title), area_of(kSourceColours[k]));
    panel.series.push_back(std::move(bars));
  }
  for (const LoadCaseResult* c : cases)
    figure.x.ticks.push_back(
        {static_cast<double>(figure.x.ticks.size() + 1), shown_name(c->load_case.name)});
  fit_y_range(figure);
  return figure;
}

}  // namespace

Figure power_by_source_figure(const std::vector<double>& x, const Axis& axis,
                              const std::vector<SlipResult>& results,
                              const PowerFigureOptions& options) {
  const auto runs = unbroken(sweep(x, results));
  const double factor = options.relative_to ? per_si::percent / *options.relative_to : 1.0;
  Figure figure{options.name, options.title};
  figure.columns = 2;
  figure.panels.resize(2);
  Panel& power = figure.panels[0];
  power.title = "Power lost";
  for (std::size_t k = 0; k < std::size(kPowerSources); ++k) {
    if (!has_power(runs, kPowerSources[k])) continue;
    const std::size_t style =
        figure.add(std::string(kPowerSources[k].title), area_of(kSourceColours[k]));
    power.series.push_back(
        series_of(style, runs, [&](const auto& r) { return area(r, k, factor); }));
  }
  power.series.push_back(series_of(figure.add(line_of(Colour::ink, Dash::solid, Weight::thin)),
                                   runs, [&](const auto& r) { return total_line(r, factor); }));
  Panel& efficiency = figure.panels[1];
  efficiency.title = "Efficiency";
  const std::size_t style =
      figure.add("efficiency", line_of(Colour::ink, Dash::solid, Weight::strong));
  efficiency.series.push_back(series_of(style, runs, efficiency_line));
  add_comparison(figure, options);
  add_references(figure, options, factor);
  figure.x = axis;
  figure.x.from = runs.front().front().x;
  figure.x.to = runs.back().back().x;
  power.y = fitted({"Power lost", options.relative_to ? "% of the file's" : "W"},
                   range_of_y(power.series), true);
  efficiency.y = fitted({"Efficiency", "%"}, range_of_y(efficiency.series));
  return figure;
}

Figures power_by_source(const Result& result, const FigureOptions& options) {
  Figures figures;
  std::vector<const LoadCaseResult*> cases;
  for (const LoadCaseResult* load_case : chosen(result, options))
    if (has_slip(*load_case)) cases.push_back(load_case);
  if (cases.empty()) return {};
  std::vector<LoadCaseResult> kept;
  if (!options.load_cases.empty())
    for (const LoadCaseResult* load_case : cases) kept.push_back(*load_case);
  const auto sweeps = loaded_configurations(options.load_cases.empty() ? result.load_cases : kept,
                                            kMinSweepPoints, has_slip);
  for (const LoadedConfiguration& configuration : sweeps)
    for (const CaseGroup& group : configuration.groups) {
      if (figures.size() == kMostFigures) return figures;
      std::vector<double> force;
      std::vector<SlipResult> slips;
      for (const LoadCaseResult* load_case : group.cases) {
        force.push_back(load_case->load_case.axial_force * per_si::kilonewton);
        slips.push_back(*load_case->slip);
      }
      PowerFigureOptions shown;
      if (!figures.empty()) shown.name += fmt::format("_{}", figures.size() + 1);
      shown.title += ", " + shown_name(group.name);
      figures.push_back(power_by_source_figure(force, {"Axial load", "kN"}, slips, shown));
    }
  if (figures.empty()) figures.push_back(power_bars(std::move(cases)));
  return figures;
}

namespace {

/// The values over the speed; a line ends where there is none.
Series over_speed(std::size_t style, const StribeckCurve& curve, auto value) {
  Series line{style};
  for (std::size_t k = 0; k < curve.speed.size(); ++k)
    line.add(curve.speed[k] * per_si::revolution_per_minute, value(k));
  return line;
}

Axis decades(std::string label, std::string unit) {
  Axis axis{std::move(label), std::move(unit)};
  axis.logarithmic = true;
  return axis;
}

}  // namespace

Figure stribeck_figure(const LoadCaseResult& result, const StribeckCurve& curve) {
  Figure figure{"stribeck",
                "Friction over the speed, load case " + shown_name(result.load_case.name)};
  figure.columns = 2;
  PerInterface<std::size_t> style;
  for (const Interface i : kInterfaces)
    style[i] = figure.add(
        interface_title(i),
        line_of(colour_of(body_of(i)), i == Interface::nut ? Dash::dashed : Dash::solid));
  const std::size_t whole = figure.add("whole mechanism", line_of(Colour::ink));
  const std::size_t speed = figure.add("speed of the case", line_of(Colour::muted));

  Panel& friction = figure.panels.emplace_back();
  friction.title = "Friction, most loaded threads";
  for (const Interface i : kInterfaces)
    friction.series.push_back(over_speed(
        style[i], curve, [&](std::size_t k) { return std::optional(curve.friction[i][k]); }));
  friction.y = fitted({"Friction coefficient"}, range_of_y(friction.series), true);

  Panel& efficiency = figure.panels.emplace_back();
  efficiency.title = "Efficiency";
  efficiency.series.push_back(over_speed(whole, curve, [&](std::size_t k) {
    return curve.efficiency[k] ? std::optional(*curve.efficiency[k] * per_si::percent)
                               : std::nullopt;
  }));
  efficiency.y = fitted({"Efficiency", "%"}, range_of_y(efficiency.series));

  Panel& power = figure.panels.emplace_back();
  power.title = "Power lost";
  power.series.push_back(
      over_speed(whole, curve, [&](std::size_t k) { return std::optional(curve.power[k]); }));
  power.y = decades("Power lost", "W");

  if (!curve.film_ratio.screw.empty()) {
    Panel& film = figure.panels.emplace_back();
    film.title = "Film over roughness";
    for (const Interface i : kInterfaces)
      film.series.push_back(over_speed(
          style[i], curve, [&](std::size_t k) { return std::optional(curve.film_ratio[i][k]); }));
    film.y = decades("Film over roughness", "");
    const std::size_t bounds = figure.add("boundary, mixed, full film", kMeanStyle);
    film.references = {{bounds, kTouchingFlanks}, {bounds, kFullFilm}};
  }
  for (Panel& panel : figure.panels)
    panel.references.push_back(
        {speed, std::abs(result.slip->speed) * per_si::revolution_per_minute, true});
  figure.x = decades("Speed", "rpm");
  return figure;
}

Figures heat_cycle(const Result& result) {
  if (!result.heat_cycle || !result.heat_cycle->converged()) return {};
  const HeatCycle& cycle = *result.heat_cycle;
  const PartSeries temperature = celsius_of(cycle.temperature);
  const PartNumbers mean = celsius_of(cycle.mean);
  constexpr double kLong = 2.0 * 3600.0;
  const bool hours = cycle.period > kLong;
  const double per_second = hours ? 1.0 / 3600.0 : 1.0;

  Figure figure{"heat_cycle", "Temperatures over the duty cycle"};
  figure.x = Axis{"Time", hours ? "h" : "s", 0.0, cycle.period * per_second};
  figure.y = Axis{"Temperature", "°C"};
  Panel panel;
  const auto add = [&](Part part, std::string name, const std::vector<double>& values,
                       double average) {
    Series line{figure.add(std::move(name), line_of(colour_of(part)))};
    for (std::size_t k = 0; k < values.size(); ++k) line.add(cycle.time[k] * per_second, values[k]);
    panel.series.push_back(std::move(line));
    panel.references.push_back(
        {figure.add(line_of(colour_of(part), Dash::dashed, Weight::thin)), average});
  };
  add(Part::screw, "screw", temperature.screw, mean.screw);
  add(Part::roller, "rollers", temperature.rollers, mean.rollers);
  add(Part::nut, "nut", temperature.nut, mean.nut);
  figure.panels.push_back(std::move(panel));
  return {figure};
}

}  // namespace prs
