#include "prs/figures/optimize_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "prs/figures/figure_style.h"
#include "prs/quantities/response_title.h"
#include "prs/figures/study_figure_parts.h"
#include "prs/study/study_text.h"

namespace prs {
namespace {

constexpr std::size_t kMostPanels = 6;
constexpr std::size_t kMostPoints = 20'000;  // Of a cloud; more designs are thinned evenly.
constexpr double kMargin = 0.06;
constexpr double kInfeasibleRoom = 1.0;  // Spans of the feasible designs to each side.

constexpr LineStyle kInfeasibleStyle = points_of("#cc3311", 7, 0.8);
constexpr LineStyle kFeasibleStyle = points_of("#222222", 7, 0.7);
constexpr LineStyle kInitialStyle = points_of("#0077bb", 5, 2.0);
constexpr LineStyle kChosenStyle = points_of("#009944", 9, 2.8);

struct Range {
  double from = std::numeric_limits<double>::infinity();
  double to = -from;

  void include(double value) {
    if (!std::isfinite(value)) return;
    from = std::min(from, value);
    to = std::max(to, value);
  }
  bool empty() const { return from > to; }
};

/// The feasible designs and the file's own, and of the others, if they count, as many as lie near.
Range range_of(const OptimizationResult& result, std::size_t response, bool with_infeasible) {
  Range inner, all;
  inner.include(result.initial.responses[response]);
  const auto add = [&](const Search& search) {
    for (const EvaluatedDesign& design : search.designs) {
      if (with_infeasible) all.include(design.responses[response]);
      if (design.is_feasible()) inner.include(design.responses[response]);
    }
  };
  add(result.search);
  if (result.check && !with_infeasible) add(*result.check);
  if (inner.empty()) inner = all;
  if (inner.empty()) return {0.0, 1.0};
  if (all.empty()) all = inner;
  const double room = kInfeasibleRoom * (inner.to - inner.from);
  Range range{std::min(inner.from, std::max(all.from, inner.from - room)),
              std::max(inner.to, std::min(all.to, inner.to + room))};
  const double span = range.to - range.from;
  const double margin = span > 0.0 ? kMargin * span : 0.5 * std::max(std::abs(range.to), 1e-3);
  return {range.from - margin, range.to + margin};
}

Axis axis_of(const OptimizationResult& result, std::size_t response, bool with_infeasible) {
  Axis axis = response_axis(result.optimization.study.responses[response]);
  const Range range = range_of(result, response, with_infeasible);
  axis.from = range.from;
  axis.to = range.to;
  return axis;
}

bool is_inside(const Axis& axis, double value) { return value >= axis.from && value <= axis.to; }

// Of the history.
enum HistoryStyle : std::size_t { kInfeasible, kFeasible, kBest, kInitial, kChosen };

Panel history_panel(const OptimizationResult& result, const Objective& objective) {
  const std::vector<EvaluatedDesign>& designs = result.search.designs;
  Panel panel;
  panel.y = axis_of(result, objective.response, true);
  Line infeasible{kInfeasible, {{}}}, feasible{kFeasible, {{}}}, best{kBest, {{}}};
  std::optional<double> so_far;
  const std::size_t step = designs.size() / kMostPoints + 1;
  for (std::size_t k = 0; k < designs.size(); ++k) {
    const double value = designs[k].responses[objective.response];
    const auto at = static_cast<double>(k + 1);
    const bool counts = designs[k].is_feasible();
    if (counts && (!so_far || (objective.maximize ? value > *so_far : value < *so_far))) {
      if (so_far) best.parts[0].push_back({at, *so_far});
      so_far = value;
      best.parts[0].push_back({at, value});
    }
    if (k % step == 0 && std::isfinite(value) && is_inside(*panel.y, value))
      (counts ? feasible : infeasible).parts[0].push_back({at, value});
  }
  if (so_far) best.parts[0].push_back({static_cast<double>(designs.size()), *so_far});
  panel.lines = {std::move(infeasible), std::move(feasible), std::move(best)};
  const double initial = result.initial.responses[objective.response];
  if (std::isfinite(initial)) panel.lines.push_back({kInitial, {{{0.0, initial}}}});
  if (result.compromise) {
    const std::size_t k = *result.compromise;
    panel.lines.push_back(
        {kChosen, {{{static_cast<double>(k + 1), designs[k].responses[objective.response]}}}});
  }
  return panel;
}

Figure history_figure(const OptimizationResult& result) {
  const Optimization& optimization = result.optimization;
  Figure figure;
  figure.name = "history";
  figure.title = fmt::format("Designs of {} in their order", name(optimization.algorithm));
  figure.x = {"design", 0.0, static_cast<double>(result.search.designs.size())};
  add_to_legend(figure, "infeasible", kInfeasibleStyle);
  add_to_legend(figure, "feasible", kFeasibleStyle);
  add_to_legend(figure, "best so far", {"#3366cc", 1, 0, 1.6});
  add_to_legend(figure, "as in the file", kInitialStyle);
  add_to_legend(figure, "compromise", kChosenStyle);
  for (const Objective& objective : optimization.objectives)
    if (figure.panels.size() < kMostPanels)
      figure.panels.push_back(history_panel(result, objective));
  return figure;
}

// Of the fronts.
enum FrontStyle : std::size_t { kCloud, kCheckFront, kFront, kFileDesign, kCompromise };

Polyline points_of_front(const Search& search, std::size_t x, std::size_t y) {
  Polyline points;
  for (const std::size_t k : search.front)
    points.push_back({search.designs[k].responses[x], search.designs[k].responses[y]});
  return points;
}

Panel front_panel(const OptimizationResult& result, std::size_t x, std::size_t y) {
  Panel panel;
  panel.x = axis_of(result, x, false);
  panel.y = axis_of(result, y, false);
  const std::vector<EvaluatedDesign>& designs = result.search.designs;
  Polyline cloud;
  const std::size_t step = designs.size() / kMostPoints + 1;
  for (std::size_t k = 0; k < designs.size(); k += step)
    if (designs[k].is_feasible())
      cloud.push_back({designs[k].responses[x], designs[k].responses[y]});
  panel.lines = {{kCloud, {std::move(cloud)}}};
  if (result.check) panel.lines.push_back({kCheckFront, {points_of_front(*result.check, x, y)}});
  panel.lines.push_back({kFront, {points_of_front(result.search, x, y)}});
  const auto mark = [&](FrontStyle style, const EvaluatedDesign& design) {
    if (std::isfinite(design.responses[x]) && std::isfinite(design.responses[y]))
      panel.lines.push_back({style, {{{design.responses[x], design.responses[y]}}}});
  };
  mark(kFileDesign, result.initial);
  if (result.compromise) mark(kCompromise, designs[*result.compromise]);
  return panel;
}

Figure front_figure(const OptimizationResult& result) {
  const std::vector<Objective>& objectives = result.optimization.objectives;
  Figure figure;
  figure.name = "front";
  figure.title = "Pareto front";
  figure.panel_height = objectives.size() == 2 ? 420 : 300;
  add_to_legend(figure, "feasible designs", points_of("#bbbbbb", 7, 0.5));
  if (result.check)
    add_to_legend(figure, fmt::format("front of {}", name(result.check->algorithm)),
                  points_of("#ee7733", 4, 1.0));
  else
    figure.styles.push_back({"#ee7733"});
  add_to_legend(figure, fmt::format("front of {}", name(result.search.algorithm)),
                points_of("#004488", 7, 1.0));
  add_to_legend(figure, "as in the file", kInitialStyle);
  add_to_legend(figure, "compromise", kChosenStyle);
  for (std::size_t i = 0; i < objectives.size(); ++i)
    for (std::size_t j = i + 1; j < objectives.size(); ++j)
      if (figure.panels.size() < kMostPanels)
        figure.panels.push_back(
            front_panel(result, objectives[i].response, objectives[j].response));
  figure.columns = std::min<std::size_t>(figure.panels.size(), 2);
  return figure;
}

}  // namespace

std::vector<Figure> optimize_figures(const OptimizationResult& result) {
  std::vector<Figure> figures{history_figure(result)};
  if (result.optimization.objectives.size() > 1) figures.push_back(front_figure(result));
  return figures;
}

}  // namespace prs
