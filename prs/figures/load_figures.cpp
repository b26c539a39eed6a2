#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "prs/figures/figure_style.h"
#include "prs/figures/result_figures.h"
#include "prs/quantities/case_groups.h"
#include "prs/quantities/quantities.h"

namespace prs {
namespace {

constexpr std::size_t kMaxButterflies = 4;

double force_kN(const LoadCaseResult& result) {
  return result.load_case.axial_force * per_si::kilonewton;
}

double largest_force_kN(const std::vector<LoadedConfiguration>& sweeps, Direction direction) {
  double largest = 0.0;
  for (const LoadedConfiguration& sweep : sweeps)
    if (const CaseGroup* group = sweep.group(direction))
      for (const LoadCaseResult* result : group->cases)
        largest = std::max(largest, force_kN(*result));
  return largest;
}

/// Points (`sign` x load, value) of the cases that have the value, by ascending load.
Polyline over_load(const CaseGroup& group, double sign, const auto& value) {
  Polyline points;
  for (const LoadCaseResult* result : group.cases)
    if (const std::optional<double> y = value(*result))
      points.push_back({sign * force_kN(*result), *y});
  std::sort(points.begin(), points.end());
  return points;
}

// Stiffness.

bool has_stiffness(const LoadCaseResult& result) {
  return result.load_case.direction && result.axial_stiffness;
}

Polyline stiffness_line(const CaseGroup& group, std::optional<double> LoadCaseResult::*stiffness) {
  return over_load(group, 1.0, [&](const LoadCaseResult& result) -> std::optional<double> {
    if (!(result.*stiffness)) return std::nullopt;
    return *(result.*stiffness) * per_si::newton_per_micrometre;
  });
}

/// Marks about eight points of a line.
LineStyle secant_style(std::size_t configuration, std::size_t points) {
  LineStyle style = kConfigurationStyles[configuration];
  style.point_interval = static_cast<int>((points + 7) / 8);
  return style;
}

LineStyle tangent_style(std::size_t configuration) {
  return {kConfigurationStyles[configuration].colour, 2};
}

Panel stiffness_panel(const std::vector<LoadedConfiguration>& sweeps, Direction direction) {
  Panel panel;
  panel.title = direction == Direction::tension ? "Tension" : "Compression";
  for (std::size_t c = 0; c < sweeps.size(); ++c)
    if (const CaseGroup* group = sweeps[c].group(direction)) {
      panel.lines.push_back({2 * c, {stiffness_line(*group, &LoadCaseResult::axial_stiffness)}});
      panel.lines.push_back(
          {2 * c + 1, {stiffness_line(*group, &LoadCaseResult::tangent_stiffness)}});
    }
  return panel;
}

// Butterfly.

bool is_solved(const LoadCaseResult& result) {
  return result.load_case.direction && result.solve && result.threads;
}

/// How a thread stands out: the colours of Abevi 2015, figs. 15-18.
struct ThreadRole {
  std::string_view title;
  LineStyle style;
  bool (*holds)(std::size_t thread, std::size_t count);
};

/// In the order of drawing: the first thread lies on top.
const ThreadRole kThreadRoles[] = {
    {"others",
     {"#aaaaaa", 1, 0, 1.0},
     [](std::size_t k, std::size_t n) { return k > 1 && k + 1 < n; }},
    {"last thread",
     {"#117733", 4, 0, 2.2},
     [](std::size_t k, std::size_t n) { return k > 1 && k + 1 == n; }},
    {"second thread", {"#0055cc", 2, 0, 2.2}, [](std::size_t k, std::size_t) { return k == 1; }},
    {"first thread", {"#cc2211", 1, 0, 2.2}, [](std::size_t k, std::size_t) { return k == 0; }},
};

Polyline thread_line(const CaseGroup& group, Interface i, std::size_t thread) {
  return over_load(group, sense(*group.direction), [&](const LoadCaseResult& result) {
    return std::optional((*result.threads)[i].load_rate[thread] * per_si::percent);
  });
}

std::size_t thread_count(const LoadedConfiguration& sweep) {
  return sweep.groups.front().cases.front()->threads->screw.load_rate.size();
}

Panel butterfly_panel(const LoadedConfiguration& sweep, Interface i) {
  Panel panel;
  panel.title = fmt::format("{}, {}", interface_title(i), sweep.name);
  const std::size_t count = thread_count(sweep);
  for (std::size_t role = 0; role < std::size(kThreadRoles); ++role) {
    Line line{role, {}};
    for (std::size_t k = 0; k < count; ++k)
      if (kThreadRoles[role].holds(k, count))
        for (const CaseGroup& group : sweep.groups) line.parts.push_back(thread_line(group, i, k));
    panel.lines.push_back(std::move(line));
  }
  return panel;
}

}  // namespace

std::optional<Figure> stiffness_figure(const Result& result) {
  auto sweeps = loaded_configurations(result.load_cases, kMinSweepPoints, has_stiffness);
  if (sweeps.empty()) return std::nullopt;
  Figure figure;
  figure.name = "stiffness";
  figure.title = "Axial stiffness";
  keep_first(sweeps, std::size(kConfigurationStyles), figure.title);
  figure.y.label = "Axial stiffness (N/µm)";
  figure.x.label = "Axial force (kN)";
  for (std::size_t c = 0; c < sweeps.size(); ++c) {
    add_to_legend(figure, sweeps[c].name, secant_style(c, sweeps[c].groups.front().cases.size()));
    figure.styles.push_back(tangent_style(c));
  }
  add_to_legend(figure, "secant", {"#000000", 1, 0});
  add_to_legend(figure, "tangent", {"#000000", 2, 0});
  figure.x.to = 0.0;
  for (const Direction d : {Direction::tension, Direction::compression})
    if (const double largest = largest_force_kN(sweeps, d); largest > 0.0) {
      figure.x.to = std::max(figure.x.to, largest);
      figure.panels.push_back(stiffness_panel(sweeps, d));
    }
  figure.columns = figure.panels.size();
  fit_y_range(figure);
  return figure;
}

std::optional<Figure> butterfly_figure(const Result& result) {
  auto sweeps = loaded_configurations(result.load_cases, kMinSweepPoints, is_solved);
  if (sweeps.empty()) return std::nullopt;
  Figure figure;
  figure.name = "butterfly";
  figure.title = "Load distribution against the load";
  keep_first(sweeps, kMaxButterflies, figure.title);
  figure.x.from = -largest_force_kN(sweeps, Direction::tension);
  figure.x.to = largest_force_kN(sweeps, Direction::compression);
  figure.x.label = figure.x.from < 0.0 ? "Axial force (kN), tension negative" : "Axial force (kN)";
  figure.y.label = "Load rate (%)";
  figure.columns = std::size(kInterfaces);
  for (const ThreadRole& role : kThreadRoles)
    add_to_legend(figure, std::string(role.title), role.style);
  std::reverse(figure.legend.begin(), figure.legend.end());
  for (const LoadedConfiguration& sweep : sweeps)
    for (const Interface i : kInterfaces) figure.panels.push_back(butterfly_panel(sweep, i));
  add_mean(figure, thread_count(sweeps.front()));
  fit_y_range(figure);
  return figure;
}

std::vector<Figure> result_figures(const Result& result) {
  return drawable(load_distribution_figure(result), peak_pressure_figure(result),
                  stiffness_figure(result), butterfly_figure(result));
}

}  // namespace prs
