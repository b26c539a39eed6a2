#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "prs/figures/figure_style.h"
#include "prs/figures/result_figures.h"
#include "prs/figures/slip_figures.h"
#include "prs/quantities/case_groups.h"
#include "prs/quantities/slip_quantities.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr std::size_t kMostFigures = 4;

/// P. Tol's "medium contrast" scheme, from dark to pale and back.
constexpr std::string_view kSourceColours[] = {"#004488", "#6699cc", "#eecc66", "#997700",
                                               "#994455"};
static_assert(std::size(kSourceColours) == std::size(kPowerSources));

constexpr LineStyle kReferenceStyles[] = {
    points_of("#cc2211", 7, 3.2),
    points_of("#000000", 5, 3.2),
    points_of("#117733", 9, 3.2),
    points_of("#aa4499", 13, 3.2),
};

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
  std::stable_sort(points.begin(), points.end(),
                   [](const SweepPoint& a, const SweepPoint& b) { return a.x < b.x; });
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

/// From zero or, of efficiencies, so that the curve fills the panel.
Axis fitted(std::string label, const Panel& panel, bool from_zero) {
  double least = HUGE_VAL, largest = -HUGE_VAL;
  for (const Line& line : panel.lines)
    for (const Polyline& part : line.parts)
      for (const auto& [x, y] : part) {
        least = std::min(least, y);
        largest = std::max(largest, y);
      }
  if (least > largest) return {std::move(label), 0.0, 1.0};
  if (from_zero) least = 0.0;
  const double margin = largest > least ? 0.08 * (largest - least) : 1.0;
  return {std::move(label), from_zero ? 0.0 : least - margin, largest + margin};
}

/// The points of the options in both panels.
void add_references(Figure& figure, const PowerFigureOptions& options, double factor) {
  const std::size_t count = std::min(options.references.size(), std::size(kReferenceStyles));
  for (std::size_t k = 0; k < count; ++k) {
    const ReferencePoint& point = options.references[k];
    const std::size_t style = add_to_legend(figure, point.title, kReferenceStyles[k]);
    if (point.power_loss)
      figure.panels[0].lines.push_back({style, {{{point.x, *point.power_loss * factor}}}});
    if (point.efficiency)
      figure.panels[1].lines.push_back({style, {{{point.x, *point.efficiency * per_si::percent}}}});
  }
}

void add_comparison(Figure& figure, const PowerFigureOptions& options) {
  if (options.comparison.empty()) return;
  Polyline line;
  for (const auto& [x, efficiency] : options.comparison)
    line.push_back({x, efficiency * per_si::percent});
  const std::size_t style = add_to_legend(figure, options.comparison_title, {"#555555", 2, 0, 1.6});
  figure.panels[1].lines.push_back({style, {std::move(line)}});
}

Line line_of(std::size_t style, const std::vector<std::vector<SweepPoint>>& runs, auto part) {
  Line line{style, {}};
  for (const auto& run : runs) line.parts.push_back(part(run));
  return line;
}

}  // namespace

Figure power_by_source_figure(const std::vector<double>& x, const std::string& x_label,
                              const std::vector<SlipResult>& results,
                              const PowerFigureOptions& options) {
  const auto runs = unbroken(sweep(x, results));
  const double factor = options.relative_to ? per_si::percent / *options.relative_to : 1.0;
  Figure figure;
  figure.name = options.name;
  figure.title = options.title;
  figure.columns = 2;
  figure.panel_height = 330;
  figure.panels.resize(2);
  Panel& power = figure.panels[0];
  power.title = "Power lost";
  for (std::size_t k = 0; k < std::size(kPowerSources); ++k) {
    if (!has_power(runs, kPowerSources[k])) continue;
    const std::size_t style =
        add_to_legend(figure, std::string(kPowerSources[k].title), fill_of(kSourceColours[k]));
    power.lines.push_back(line_of(style, runs, [&](const auto& r) { return area(r, k, factor); }));
  }
  const std::size_t total = figure.styles.size();
  figure.styles.push_back({"#000000", 1, 0, 1.2});
  power.lines.push_back(line_of(total, runs, [&](const auto& r) { return total_line(r, factor); }));

  Panel& efficiency = figure.panels[1];
  efficiency.title = "Efficiency";
  const std::size_t style = add_to_legend(figure, "efficiency", {"#000000", 1, 0, 2.2});
  efficiency.lines.push_back(line_of(style, runs, efficiency_line));
  add_comparison(figure, options);
  add_references(figure, options, factor);

  figure.x.label = x_label;
  figure.x.from = runs.front().front().x;
  figure.x.to = runs.back().back().x;
  power.y = fitted(options.relative_to ? "Power lost (% of the reference)" : "Power lost (W)",
                   power, true);
  efficiency.y = fitted("Efficiency (%)", efficiency, false);
  return figure;
}

std::vector<Figure> power_over_load_figures(const Result& result) {
  std::vector<Figure> figures;
  const auto sweeps = loaded_configurations(result.load_cases, kMinSweepPoints, has_slip);
  for (const LoadedConfiguration& configuration : sweeps)
    for (const CaseGroup& group : configuration.groups) {
      if (figures.size() == kMostFigures) return figures;
      std::vector<double> force;
      std::vector<SlipResult> slips;
      for (const LoadCaseResult* load_case : group.cases) {
        force.push_back(load_case->load_case.axial_force * per_si::kilonewton);
        slips.push_back(*load_case->slip);
      }
      PowerFigureOptions options;
      if (!figures.empty()) options.name += fmt::format("_{}", figures.size() + 1);
      options.title += ", " + shortened(printable(group.name), kMaxCaseName);
      figures.push_back(power_by_source_figure(force, "Axial force (kN)", slips, options));
    }
  return figures;
}

}  // namespace prs
