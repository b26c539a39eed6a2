#include "prs/output/study_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "prs/output/figure_style.h"
#include "prs/output/response_title.h"
#include "prs/output/slip_figures.h"
#include "prs/output/text.h"

namespace prs {
namespace {

constexpr std::size_t kMostFigures = 24;
constexpr std::size_t kMostPanels = 12;
constexpr std::size_t kMostWords = 8;
constexpr std::size_t kMostWholeTics = 13;
constexpr double kLargestWholeTic = 9999.0;
constexpr std::size_t kMaxLabel = 36;
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

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z')
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

/// As a heading; a path stays as it is.
std::string title_of(const Factor& factor) {
  const std::string text = shortened(printable(factor.label), kMaxLabel);
  return factor.label == factor.path ? text : capitalised(text);
}

/// One a design where a few bare whole numbers count something.
std::vector<int> whole_tics(const Sweep& sweep) {
  std::vector<int> tics;
  if (!sweep.factor->unit.empty() || sweep.points.size() > kMostWholeTics) return tics;
  for (const Point& point : sweep.points) {
    if (point.x != std::round(point.x) || std::abs(point.x) > kLargestWholeTic) return {};
    tics.push_back(static_cast<int>(point.x));
  }
  return tics;
}

/// Over the designs with an answer; with the unit or, of words, what the positions stand for.
Axis axis_of(const Sweep& sweep) {
  const Factor& factor = *sweep.factor;
  Axis axis{title_of(factor), HUGE_VAL, -HUGE_VAL};
  for (const Point& point : sweep.points)
    if (point.row->status.converged()) {
      axis.from = std::min(axis.from, point.x);
      axis.to = std::max(axis.to, point.x);
    }
  if (axis.from > axis.to) axis.from = axis.to = 0.0;
  if (axis.from == axis.to || !factor.is_numeric()) axis.from -= 0.5, axis.to += 0.5;
  axis.logarithmic = factor.logarithmic && axis.from > 0.0;
  if (factor.is_numeric()) {
    if (!factor.unit.empty()) axis.label += fmt::format(" ({})", printable(factor.unit));
    axis.tics = whole_tics(sweep);
    return axis;
  }
  const std::size_t words = std::min(factor.levels.size(), kMostWords);
  for (std::size_t k = 0; k < words; ++k) {
    axis.label += fmt::format("{} {} {}", k == 0 ? ":" : ",", k + 1,
                              shortened(printable(factor.levels[k].text), 16));
    axis.tics.push_back(static_cast<int>(k + 1));
  }
  return axis;
}

/// `03_flank_angle`
std::string file_name(std::size_t index, const std::string& label) {
  std::string name = fmt::format("{:02}_", index + 1);
  for (const char c : label.substr(0, kMaxLabel)) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z');
    if (plain || name.back() != '_') name += plain ? c : '_';
  }
  while (name.back() == '_') name.pop_back();
  return name;
}

void widen(Axis& axis, double least) {
  const double margin = std::max(0.0, 0.5 * (least - (axis.to - axis.from)));
  axis.from -= margin;
  axis.to += margin;
}

std::optional<Figure> power_figure(const StudyResult& result, std::size_t index) {
  const Sweep sweep = sweep_of(result, index);
  std::vector<double> x;
  std::vector<SlipResult> slips;
  PowerFigureOptions options;
  for (const Point& point : sweep.points) {
    x.push_back(point.x);
    const bool has_answer = point.row->status.converged() && point.row->slip;
    slips.push_back(has_answer ? *point.row->slip : SlipResult{});
    if (has_answer && point.row->slip->efficiency_fit)
      options.comparison.push_back({point.x, *point.row->slip->efficiency_fit});
  }
  if (std::ranges::none_of(slips, &SlipResult::converged)) return std::nullopt;
  options.name = file_name(index, sweep.factor->label);
  options.title = fmt::format("{}: power lost by source, efficiency", title_of(*sweep.factor));
  options.comparison_title = "efficiency by the fit (3.55)";
  const std::optional<SlipResult>& base = result.base().slip;
  if (base && base->converged() && base->power.total() > 0.0) {
    options.relative_to = base->power.total();
    if (sweep.base)
      options.references = {{"as in the file", *sweep.base, base->power.total(), base->efficiency}};
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
  figure.name = file_name(response, path);
  const ResponseTitle title = response_title(path);
  figure.title = capitalised(title.name);
  figure.y.label = shortened(figure.title, kMaxLabel - title.unit.size());
  if (!title.unit.empty()) figure.y.label += fmt::format(" ({})", title.unit);
  figure.styles = {{"#004488", 1, 7, 1.6}, points_of("#004488", 7, 2.4)};
  add_to_legend(figure, "as in the file", points_of("#cc2211", 7, 3.2));
  const std::size_t factors = result.study.factors.size();
  const std::size_t panels = std::min(factors, kMostPanels);
  if (panels < factors) figure.title += fmt::format(", first {} of {} factors", panels, factors);
  figure.columns = panels == 1 ? 1 : panels == 2 || panels == 4 ? 2 : 3;
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

std::vector<Figure> study_figures(const StudyResult& result) {
  const bool slips = result.study.command == Command::slip;
  const std::size_t count = slips ? result.study.factors.size() : result.study.responses.size();
  std::vector<Figure> figures;
  for (std::size_t k = 0; k < std::min(count, kMostFigures); ++k)
    if (std::optional<Figure> figure = slips ? power_figure(result, k) : response_figure(result, k))
      figures.push_back(std::move(*figure));
  return figures;
}

}  // namespace prs
