#include "prs/optimize/optimize_pictures.h"

#include "prs/indices.h"

#include "prs/record/table_units.h"
#include "prs/study/study_pictures.h"

namespace prs {
namespace {

constexpr std::size_t kMostPanels = 6;
constexpr std::size_t kMostPoints = 20'000;  // Largest number of points of a cloud; more designs are thinned evenly.
constexpr double kMargin = 0.06;

constexpr Style kInfeasibleStyle = points_of(Colour::bad, Mark::circle, Weight::thin);
constexpr Style kFeasibleStyle = points_of(Colour::ink, Mark::circle, Weight::thin);
constexpr Style kInitialStyle = points_of(Colour::sky, Mark::square);
constexpr Style kChosenStyle = points_of(Colour::green, Mark::triangle, Weight::strong);

/// All of `inner`, and the part of `all` within this many spans of it.
Range about(Range inner, Range all, double spans) {
  if (inner.empty()) inner = all;
  if (inner.empty()) return {0.0, 1.0};
  if (all.empty()) all = inner;
  const double room = spans * (inner.to - inner.from);
  Range range{std::min(inner.from, std::max(all.from, inner.from - room)),
              std::max(inner.to, std::min(all.to, inner.to + room))};
  range.widen(kMargin);
  return range;
}

/// Range of the feasible designs and the file's own, and the near part of the others.
Range history_range(const OptimizationResult& result, std::size_t response) {
  Range inner, all;
  inner.include(result.initial.responses[response]);
  for (const auto k : up_to(result.design_count())) {
    const EvaluatedDesign& design = result.design(k);
    (design.is_feasible() ? inner : all).include(design.responses[response]);
  }
  return about(inner, all, 1.0);
}

/// Range of the fronts and the file's own design, and the near part of the feasible designs.
Range front_range(const OptimizationResult& result, std::size_t response) {
  Range inner, all;
  inner.include(result.initial.responses[response]);
  const auto add = [&](const Search& search) {
    for (const std::size_t k : search.front) inner.include(search.designs[k].responses[response]);
    for (const EvaluatedDesign& design : search.designs)
      if (design.is_feasible()) all.include(design.responses[response]);
  };
  add(result.search);
  if (result.check) add(*result.check);
  return about(inner, all, 0.3);
}

Axis axis_of(const OptimizationResult& result, std::size_t response, const Range& range) {
  Axis axis = response_axis(result.optimization.study.responses[response]);
  axis.from = range.from;
  axis.to = range.to;
  return axis;
}

bool is_inside(const Axis& axis, double value) { return value >= axis.from && value <= axis.to; }

// Styles of the history.
enum HistoryStyle : std::size_t { kInfeasible, kFeasible, kBest, kInitial, kChosen };

Panel history_panel(const OptimizationResult& result, const Objective& objective) {
  const std::size_t designs = result.design_count();
  Panel panel;
  panel.y = axis_of(result, objective.response, history_range(result, objective.response));
  Series infeasible{kInfeasible, {{}}}, feasible{kFeasible, {{}}}, best{kBest, {{}}};
  std::optional<double> so_far;
  const std::size_t step = designs / kMostPoints + 1;
  for (const auto k : up_to(designs)) {
    const double value = result.design(k).responses[objective.response];
    const auto at = static_cast<double>(k + 1);
    const bool counts = result.design(k).is_feasible();
    if (counts && (!so_far || (objective.maximize ? value > *so_far : value < *so_far))) {
      if (so_far) best.parts[0].push_back({at, *so_far});
      so_far = value;
      best.parts[0].push_back({at, value});
    }
    if (k % step == 0 && std::isfinite(value) && is_inside(*panel.y, value))
      (counts ? feasible : infeasible).parts[0].push_back({at, value});
  }
  if (so_far) best.parts[0].push_back({static_cast<double>(designs), *so_far});
  panel.series = {std::move(infeasible), std::move(feasible), std::move(best)};
  const double initial = result.initial.responses[objective.response];
  if (std::isfinite(initial)) panel.series.push_back({kInitial, {{{0.0, initial}}}});
  if (const auto shown = result.compromise ? result.compromise : result.nearest) {
    const std::size_t k = *shown;
    panel.series.push_back({kChosen, {{{static_cast<double>(k + 1), result.design(k).responses[objective.response]}}}});
  }
  return panel;
}

// Styles of the fronts.
enum FrontStyle : std::size_t { kCloud, kCheckFront, kFront, kFileDesign, kCompromise };

Polyline points_of_front(const Search& search, std::size_t x, std::size_t y) {
  Polyline points;
  for (const std::size_t k : search.front)
    points.push_back({search.designs[k].responses[x], search.designs[k].responses[y]});
  return points;
}

Panel front_panel(const OptimizationResult& result, std::size_t x, std::size_t y) {
  Panel panel;
  panel.x = axis_of(result, x, front_range(result, x));
  panel.y = axis_of(result, y, front_range(result, y));
  const std::vector<EvaluatedDesign>& designs = result.search.designs;
  Polyline cloud;
  const std::size_t step = designs.size() / kMostPoints + 1;
  for (std::size_t k = 0; k < designs.size(); k += step)
    if (designs[k].is_feasible()) cloud.push_back({designs[k].responses[x], designs[k].responses[y]});
  panel.series = {{kCloud, {std::move(cloud)}}};
  const auto mark = [&](FrontStyle style, const EvaluatedDesign& design) {
    if (std::isfinite(design.responses[x]) && std::isfinite(design.responses[y]))
      panel.series.push_back({style, {{{design.responses[x], design.responses[y]}}}});
  };
  mark(kFileDesign, result.initial);
  if (const EvaluatedDesign* chosen = result.chosen()) mark(kCompromise, *chosen);
  // On top of the compromise, which is larger: a front may be that design alone.
  if (result.check) panel.series.push_back({kCheckFront, {points_of_front(*result.check, x, y)}});
  panel.series.push_back({kFront, {points_of_front(result.search, x, y)}});
  return panel;
}

/// The fronts alone, if the other designs compress them into a corner.
std::optional<Panel> enlarged_front(const OptimizationResult& result, Panel panel, std::size_t x, std::size_t y) {
  constexpr double kSqueezed = 0.25;  // Share of an axis below which a front counts as compressed.
  Range at_x, at_y;
  const auto add = [&](const Search& search) {
    for (const std::size_t k : search.front) {
      at_x.include(search.designs[k].responses[x]);
      at_y.include(search.designs[k].responses[y]);
    }
  };
  add(result.search);
  if (result.check) add(*result.check);
  const auto is_squeezed = [&](const Range& range, const Axis& axis) {
    return !range.empty() && range.to - range.from < kSqueezed * (axis.to - axis.from);
  };
  if (!is_squeezed(at_x, *panel.x) || !is_squeezed(at_y, *panel.y)) return std::nullopt;
  panel.title = "The front, enlarged";
  panel.x = fitted(*std::move(panel.x), at_x);
  panel.y = fitted(*std::move(panel.y), at_y);
  return panel;
}

}  // namespace

/// Each objective over the designs in their order, those of a check after those of the search,
/// feasible and infeasible, the best so far and the chosen one (as Yao et al. 2023, fig. 12).
Figure optimization_history(const OptimizationResult& result) {
  const Optimization& optimization = result.optimization;
  const std::string then = result.check ? fmt::format(", then of {},", name(result.check->algorithm)) : "";
  Figure figure{"history", fmt::format("Designs of {}{} in their order", name(optimization.algorithm), then)};
  figure.x = {"Design", "", 0.0, static_cast<double>(result.design_count())};
  figure.add("infeasible", kInfeasibleStyle);
  figure.add("feasible", kFeasibleStyle);
  figure.add("best so far", line_of(Colour::blue));
  figure.add("as in the file", kInitialStyle);
  figure.add(result.compromise ? "compromise" : "nearest to the limits", kChosenStyle);
  for (const Objective& objective : optimization.objectives)
    if (figure.panels.size() < kMostPanels) figure.panels.push_back(history_panel(result, objective));
  figure.aspect = 0.3;
  return figure;
}

/// The designs and the fronts of both searches, a panel for each pair of objectives, with the
/// file's own design and the compromise.
Figure pareto_front(const OptimizationResult& result) {
  const std::vector<Objective>& objectives = result.optimization.objectives;
  if (objectives.size() < 2) return {};
  Figure figure{"front", "Pareto front"};
  figure.add("feasible designs", points_of(Colour::muted, Mark::circle, Weight::thin));
  if (result.check) {
    Style check = points_of(Colour::orange, Mark::square);
    check.open = true;
    figure.add(fmt::format("front of {}", name(result.check->algorithm)), check);
  } else {
    figure.add(points_of(Colour::orange, Mark::square));
  }
  figure.add(fmt::format("front of {}", name(result.search.algorithm)), points_of(Colour::blue, Mark::circle));
  figure.add("as in the file", kInitialStyle);
  figure.add(result.compromise ? "compromise" : "nearest to the limits", kChosenStyle);
  for (const auto i : indices(objectives))
    for (std::size_t j = i + 1; j < objectives.size(); ++j)
      if (figure.panels.size() < kMostPanels) {
        const std::size_t x = objectives[i].response, y = objectives[j].response;
        figure.panels.push_back(front_panel(result, x, y));
        if (auto large = enlarged_front(result, figure.panels.back(), x, y)) figure.panels.push_back(std::move(*large));
      }
  figure.columns = std::min<std::size_t>(figure.panels.size(), 2);
  return figure;
}

Figure optimization_history(const OptimizationResult& result);
Figure pareto_front(const OptimizationResult& result);

Pictures optimization_pictures(const OptimizationResult& r) {
  return {{"history", "designs", of_result(r, optimization_history)},
          {"front", "several objectives", of_result(r, pareto_front)}};
}

}  // namespace prs
