#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "prs/quantities/slip_quantities.h"
#include "prs/figures/figure_style.h"
#include "prs/quantities/response_title.h"
#include "prs/figures/slip_figures.h"
#include "prs/figures/study_figure_parts.h"
#include "prs/study/study_text.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr double kLeastEfficiencySpan = 5.0;  // [%], so that what hardly matters looks so.

/// A design of one factor on the factor's axis.
struct Point {
  double x = 0.0;
  const StudyRow* row = nullptr;
};

/// The designs of a factor, ascending, the base case among them where its place is known.
struct Sweep {
  const Factor* factor = nullptr;
  std::vector<Point> points;
  std::optional<double> base;  ///< Where the base case stands.
};

Sweep sweep_of(const StudyResult& result, std::size_t index) {
  const Factor& factor = result.study.factors[index];
  Sweep sweep{&factor, {}, std::nullopt};
  double position = 0.0;
  for (const StudyRow& row : result.rows) {
    if (row.design.settings.empty() || row.design.settings[0].factor != index) continue;
    position += 1.0;
    const double x = factor.is_numeric() ? *row.design.settings[0].level.number : position;
    sweep.points.push_back({x, &row});
    if (is_base(result.study, row.design)) sweep.base = x;
  }
  const bool on_axis = factor.is_numeric() && factor.base && factor.base->number &&
                       !(factor.logarithmic && *factor.base->number <= 0.0);
  if (!sweep.base && on_axis) {
    sweep.base = factor.base->number;
    sweep.points.push_back({*sweep.base, &result.base()});
  }
  std::ranges::stable_sort(sweep.points, {}, &Point::x);
  return sweep;
}

/// Over the designs with an answer.
Axis axis_of(const Sweep& sweep) {
  std::vector<double> answered;
  for (const Point& point : sweep.points)
    if (point.row->status.converged()) answered.push_back(point.x);
  return factor_axis(*sweep.factor, answered);
}

void widen(Axis& axis, double least) {
  const double margin = std::max(0.0, 0.5 * (least - (axis.to - axis.from)));
  axis.from -= margin;
  axis.to += margin;
}

std::optional<double> recorded(const StudyResult& result, const StudyRow& row,
                               const std::string& path) {
  const auto found = std::ranges::find(result.study.responses, path);
  if (found == result.study.responses.end() || !row.status.converged()) return std::nullopt;
  return row.responses[static_cast<std::size_t>(found - result.study.responses.begin())];
}

std::string share_path(const PowerSource& source) {
  return fmt::format("slip.share_percent.{}", source.key);
}

/// Whether the study records what a figure of power by source shows.
bool has_power(const StudyResult& result) {
  const auto is_recorded = [&](const std::string& path) {
    return std::ranges::find(result.study.responses, path) != result.study.responses.end();
  };
  return is_recorded("slip.power_loss_W") && is_recorded("slip.efficiency") &&
         std::ranges::all_of(kPowerSources, [&](const PowerSource& source) {
           return is_recorded(share_path(source));
         });
}

/// Power by source and efficiency of a row; not converged where it has none.
SlipResult slip_of(const StudyResult& result, const StudyRow& row) {
  SlipResult slip;
  const std::optional<double> loss = recorded(result, row, "slip.power_loss_W");
  if (!loss) return slip;
  slip.status = SlipStatus::converged;
  slip.efficiency = recorded(result, row, "slip.efficiency");
  slip.efficiency_fit = recorded(result, row, "slip.efficiency_fit");
  for (const PowerSource& source : kPowerSources)
    slip.power.*source.value =
        *loss * recorded(result, row, share_path(source)).value_or(0.0) / per_si::percent;
  return slip;
}

std::optional<Figure> power_figure(const StudyResult& result, std::size_t index) {
  const Sweep sweep = sweep_of(result, index);
  std::vector<double> x;
  std::vector<SlipResult> slips;
  PowerFigureOptions options;
  for (const Point& point : sweep.points) {
    x.push_back(point.x);
    slips.push_back(slip_of(result, *point.row));
    if (slips.back().efficiency_fit)
      options.comparison.push_back({point.x, *slips.back().efficiency_fit});
  }
  if (std::ranges::none_of(slips, &SlipResult::converged)) return std::nullopt;
  options.name = study_figure_name(index, sweep.factor->label);
  options.title = fmt::format("{}: power lost by source, efficiency", factor_title(*sweep.factor));
  options.comparison_title = "efficiency by the fit (3.55)";
  const SlipResult base = slip_of(result, result.base());
  if (base.converged() && base.power.total() > 0.0) {
    options.relative_to = base.power.total();
    if (sweep.base)
      options.references = {{"as in the file", *sweep.base, base.power.total(), base.efficiency}};
  }
  const Axis axis = axis_of(sweep);
  Figure figure = power_by_source_figure(x, axis.label, slips, options);
  figure.x = axis;
  if (std::optional<Axis>& efficiency = figure.panels[1].y)
    widen(*efficiency, kLeastEfficiencySpan);
  return figure;
}

// Of the figures of responses.
enum StyleIndex : std::size_t { kLineStyle, kWordStyle, kBaseStyle };

/// The line of a response over a factor, interrupted where a design has none, and the base case.
Panel response_panel(const StudyResult& result, std::size_t factor, std::size_t response) {
  const Sweep sweep = sweep_of(result, factor);
  Panel panel;
  panel.x = axis_of(sweep);
  Line line{sweep.factor->is_numeric() ? kLineStyle : kWordStyle, {{}}};
  for (const Point& point : sweep.points) {
    if (const std::optional<double>& value = point.row->responses[response])
      line.parts.back().push_back({point.x, *value});
    else if (!line.parts.back().empty())
      line.parts.emplace_back();
  }
  panel.lines.push_back(std::move(line));
  const std::optional<double>& base = result.base().responses[response];
  if (sweep.base && base) panel.lines.push_back({kBaseStyle, {{{*sweep.base, *base}}}});
  return panel;
}

std::optional<Figure> response_figure(const StudyResult& result, std::size_t response) {
  const std::string& path = result.study.responses[response];
  Figure figure;
  figure.name = study_figure_name(response, path);
  figure.title = capitalised(response_title(path).name);
  figure.y = response_axis(path);
  figure.styles = {{"#004488", 1, 7, 1.6}, points_of("#004488", 7, 2.4)};
  add_to_legend(figure, "as in the file", points_of("#cc2211", 7, 3.2));
  const std::size_t factors = result.study.factors.size();
  const std::size_t panels = std::min(factors, kMostStudyPanels);
  if (panels < factors) figure.title += fmt::format(", first {} of {} factors", panels, factors);
  figure.columns = columns_for(panels);
  bool has_data = false;
  for (std::size_t k = 0; k < panels; ++k) {
    figure.panels.push_back(response_panel(result, k, response));
    for (const Polyline& part : figure.panels.back().lines[0].parts)
      has_data = has_data || !part.empty();
  }
  if (!has_data) return std::nullopt;
  fit_y_range(figure);
  return figure;
}

}  // namespace

std::vector<Figure> one_at_a_time_figures(const StudyResult& result) {
  const bool power = has_power(result);
  const std::size_t count = power ? result.study.factors.size() : result.study.responses.size();
  std::vector<Figure> figures;
  for (std::size_t k = 0; k < std::min(count, kMostStudyFigures); ++k)
    if (std::optional<Figure> figure = power ? power_figure(result, k) : response_figure(result, k))
      figures.push_back(std::move(*figure));
  return figures;
}

}  // namespace prs
