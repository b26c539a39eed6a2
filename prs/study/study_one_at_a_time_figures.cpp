#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "prs/losses/slip_parts.h"
#include "prs/losses/slip_record.h"
#include "prs/record/response_title.h"
#include "prs/study/study_pictures.h"

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

}  // namespace

bool has_power(const StudyResult& result) {
  const auto is_recorded = [&](const std::string& path) {
    return std::ranges::find(result.study.responses, path) != result.study.responses.end();
  };
  return is_recorded("slip.power_loss_W") && is_recorded("slip.efficiency") &&
         std::ranges::all_of(kPowerSources, [&](const PowerSource& source) {
           return is_recorded(share_path(source));
         });
}

namespace {

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
  options.title = fmt::format("{}: power lost by source, efficiency", factor_name(*sweep.factor));
  options.comparison_title = "efficiency by the fit (3.55)";
  const SlipResult base = slip_of(result, result.base());
  if (base.converged() && base.power.total() > 0.0) {
    options.relative_to = base.power.total();
    if (sweep.base)
      options.references = {{kBaseTitle, *sweep.base, base.power.total(), base.efficiency}};
  }
  const Axis axis = axis_of(sweep);
  Figure figure = power_by_source_figure(x, axis, slips, options);
  figure.x = axis;
  if (std::optional<Axis>& efficiency = figure.panels[1].y)
    widen(*efficiency, kLeastEfficiencySpan);
  return figure;
}

/// The line of a response over a factor, interrupted where a design has none, and the base case.
Panel factor_panel(const StudyResult& result, std::size_t factor, std::size_t response) {
  const Sweep sweep = sweep_of(result, factor);
  Panel panel;
  panel.x = axis_of(sweep);
  Series line{sweep.factor->is_numeric() ? 0u : 1u};
  for (const Point& point : sweep.points) line.add(point.x, point.row->responses[response]);
  panel.series.push_back(std::move(line));
  const std::optional<double>& base = result.base().responses[response];
  if (sweep.base && base) panel.series.push_back({2, {{{*sweep.base, *base}}}});
  return panel;
}

Figure panels_of_factors(const StudyResult& result, std::size_t response) {
  Figure figure = response_figure(result.study.responses, response);
  figure.add(kDesignStyle);
  figure.add(points_of(Colour::blue, Mark::circle));
  figure.add(kBaseTitle, kBaseStyle);
  const std::size_t factors = result.study.factors.size();
  const std::size_t panels = std::min(factors, kMostStudyPanels);
  if (panels < factors) figure.title += fmt::format(", first {} of {} factors", panels, factors);
  figure.columns = columns_for(panels);
  for (std::size_t k = 0; k < panels; ++k)
    figure.panels.push_back(factor_panel(result, k, response));
  fit_y_range(figure);
  return figure;
}

/// Change of the response over the change of each numeric factor, both in percent of the file's.
std::optional<Figure> changes_of_factors(const StudyResult& result, std::size_t response) {
  const std::optional<double>& base = result.base().responses[response];
  if (!base || *base == 0.0) return std::nullopt;
  const std::string& path = result.study.responses[response];
  Figure figure = response_figure(result.study.responses, response);
  figure.x = {"Change of the factor", "%"};
  figure.y = {fmt::format("Change of {}", response_title(path).name), "%"};
  Panel panel;
  panel.references = {{0, 0.0}, {0, 0.0, true}};
  figure.add(kZeroStyle);
  for (std::size_t k = 0; k < result.study.factors.size(); ++k) {
    const Sweep sweep = sweep_of(result, k);
    const auto& own = sweep.factor->base ? sweep.factor->base->number : std::nullopt;
    if (!own || *own == 0.0 || !sweep.factor->is_numeric() || figure.legend.size() == 12) continue;
    Polyline line;
    for (const Point& point : sweep.points)
      if (const std::optional<double>& value = point.row->responses[response])
        line.push_back({100.0 * (point.x / *own - 1.0), 100.0 * (*value / *base - 1.0)});
    if (line.size() > 1)
      panel.series.push_back(
          {figure.add(factor_name(*sweep.factor), marked_line(figure.legend.size())), {line}});
  }
  if (panel.series.empty()) return std::nullopt;
  figure.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace

Figures one_at_a_time_lines(const StudyResult& result, const FigureOptions& options) {
  Figures figures;
  for (const std::size_t k : chosen_responses(result.study.responses, options)) {
    std::optional<Figure> figure;
    if (options.one_panel && result.study.factors.size() > 1)
      figure = changes_of_factors(result, k);
    if (!figure) figure = panels_of_factors(result, k);
    if (has_data(*figure)) figures.push_back(std::move(*figure));
  }
  return figures;
}

/// With slip, for each factor: power by source, stacked, and efficiency with its fit (Sandu 2018,
/// fig. 3.9 and appendix C).
Figures study_power(const StudyResult& result, const FigureOptions&) {
  Figures figures;
  if (!varies_one_at_a_time(result.study) || !has_power(result)) return figures;
  for (std::size_t k = 0; k < std::min(result.study.factors.size(), kMostStudyFigures); ++k)
    if (std::optional<Figure> figure = power_figure(result, k))
      figures.push_back(std::move(*figure));
  return figures;
}

}  // namespace prs
