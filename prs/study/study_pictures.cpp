#include "prs/study/study_pictures.h"

#include "prs/indices.h"
#include "prs/losses/slip_figures.h"
#include "prs/record/table_units.h"
#include "prs/study/recorded.h"
#include "prs/study/study_figures.h"

namespace prs {
namespace {

constexpr std::size_t kLongNumber = 14;
constexpr std::size_t kMaxTitle = 36;

constexpr std::size_t kMostOfName = 36;
constexpr std::size_t kMostWholeTicks = 13;
constexpr double kLargestWholeTick = 9999.0;

/// `µm` for `um`, in whatever stands with it, and other signs.
std::string shown_unit(const std::string& unit) {
  constexpr std::pair<std::string_view, const char*> kSigns[] = {{"um", "µm"}, {"deg", "°"}, {"^2", "²"}, {"^3", "³"}};
  std::string shown = printable(unit);
  for (const auto& [word, sign] : kSigns)
    if (const std::size_t at = shown.find(word); at != std::string::npos) shown.replace(at, word.size(), sign);
  return shown;
}

/// Whether a label is the path of the factor, if with a name in place of the number of an item.
bool is_path(const Factor& factor) { return factor.label.ends_with(factor.path.substr(factor.path.find(']') + 1)); }

}  // namespace

std::string study_figure_name(std::size_t index, const std::string& label) {
  std::string name = fmt::format("{:02}_", index + 1);
  for (const char c : label.substr(0, kMostOfName)) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z');
    if (plain || name.back() != '_') name += plain ? c : '_';
  }
  while (name.back() == '_') name.pop_back();
  return name;
}

std::string level_text(const Level& level, const std::string& unit) {
  const std::string text = printable(level.text);
  if (!level.number || width(text) <= kLongNumber || text.starts_with('{')) return text;
  return fmt::format("{:.6g}{}{}", *level.number, unit.empty() ? "" : " ", printable(unit));
}

std::string factor_title(const Factor& factor) {
  const std::string text = shortened(printable(factor.label), kMaxTitle);
  return is_path(factor) ? text : capitalised(text);
}

std::vector<std::size_t> chosen_responses(const std::vector<std::string>& responses, const FigureOptions& options) {
  if (options.response) {
    const auto found = std::ranges::find(responses, *options.response);
    if (found == responses.end())
      throw NoFigure(fmt::format("no response {}; there is {}", *options.response, fmt::join(responses, ", ")));
    return {static_cast<std::size_t>(found - responses.begin())};
  }
  std::vector<std::size_t> numbers;
  for (const Recorded& r : recorded(responses))
    if (!r.is_array() && numbers.size() < kMostStudyFigures) numbers.push_back(r.first);
  return numbers;
}

Figure response_figure(const std::vector<std::string>& responses, std::size_t response) {
  const std::string& path = responses[response];
  Figure figure{study_figure_name(response, path), capitalised(response_title(path).name)};
  figure.y = response_axis(path);
  return figure;
}

std::string factor_name(const Factor& factor) {
  constexpr std::size_t kMost = 34;
  if (!is_path(factor)) return shortened(factor_title(factor), kMost);
  std::string words = printable(factor.path.substr(factor.path.find('.') + 1));
  std::ranges::replace_if(
      words, [](char c) { return c == '_' || c == '.'; }, ' ');
  if (const std::size_t item = factor.label.find('[') + 1; factor.label != factor.path)
    words += ", " + printable(factor.label.substr(item, factor.label.find(']') - item));
  return shortened(capitalised(words), kMost);
}

Axis factor_axis(const Factor& factor, const std::vector<double>& values) {
  Axis axis{factor_name(factor), factor.is_numeric() ? shown_unit(factor.unit) : ""};
  Range range;
  for (const double value : values) range.include(value);
  if (range.empty()) return axis;
  if (range.from == range.to || !factor.is_numeric()) range.from -= 0.5, range.to += 0.5;
  axis.from = range.from;
  axis.to = range.to;
  axis.logarithmic =
      (factor.logarithmic || factor.distribution.kind == Distribution::Kind::log_uniform) && axis.from > 0.0;
  if (!factor.is_numeric()) {
    for (const auto k : indices(factor.levels))
      axis.ticks.push_back({static_cast<double>(k + 1), shortened(printable(factor.levels[k].text), 16)});
    return axis;
  }
  axis.whole = factor.unit.empty() && std::ranges::all_of(values, [](double value) {
                 return value == std::round(value) && std::abs(value) <= kLargestWholeTick;
               });
  if (axis.whole && values.size() <= kMostWholeTicks)
    for (const double value : values) axis.ticks.push_back({value});
  return axis;
}

Axis response_axis(const std::string& path) {
  constexpr std::size_t kMost = 44;
  const ResponseTitle title = response_title(path);
  return {capitalised(shortened(title.name, kMost)), title.unit};
}

std::vector<double> positions(const Factor& factor) {
  std::vector<double> values;
  for (const auto k : indices(factor.levels))
    values.push_back(factor.is_numeric() ? *factor.levels[k].number : static_cast<double>(k + 1));
  return values;
}

std::vector<std::size_t> spread(std::size_t count, std::size_t most) {
  std::vector<std::size_t> some(std::min(count, most));
  for (const auto k : indices(some)) some[k] = some.size() == 1 ? 0 : k * (count - 1) / (some.size() - 1);
  return some;
}

std::size_t columns_for(std::size_t panels) { return panels == 1 ? 1 : panels == 2 || panels == 4 ? 2 : 3; }

Figure ranked(Figure figure, Panel panel, const std::vector<std::string>& names, double height) {
  panel.references.push_back({figure.add(kZeroStyle), 0.0, true});
  figure.y = ranked_axis(names);
  figure.aspect = 0.08 + height * static_cast<double>(names.size());
  figure.panels.push_back(std::move(panel));
  return figure;
}

Figure ranked_bars(Figure figure, const std::vector<std::string>& names, const std::vector<double>& values,
                   const std::array<const char*, 2>& titles) {
  Series grows{figure.add(titles[0], area_of(Colour::blue))};
  Series falls{figure.add(titles[1], area_of(Colour::vermillion))};
  Panel panel;
  Range range{0.0, 0.0};
  for (const double value : values) range.include(value);
  const double gap = 0.01 * (range.to - range.from);
  for (const auto k : indices(values)) {
    const double value = values[k], at = rank_position(k, values.size());
    (value < 0.0 ? falls : grows)
        .parts.push_back(rectangle(std::min(value, 0.0), std::max(value, 0.0), at - 0.35, at + 0.35));
    panel.labels.push_back({fmt::format("{}{:.3g}", value < 0.0 ? "−" : "", std::abs(value)),
                            value < 0.0 ? value - gap : value + gap, at, false,
                            value < 0.0 ? Label::Anchor::right : Label::Anchor::left});
  }
  panel.series = {std::move(grows), std::move(falls)};
  const double room = 0.14 * std::max(range.to - range.from, 1e-12);
  figure.x.from = range.from - (range.from < 0.0 ? room : 0.0);
  figure.x.to = range.to + (range.to > 0.0 ? room : 0.0);
  return ranked(std::move(figure), std::move(panel), names, 0.045);
}

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
  std::optional<double> base;  ///< Place of the base case.
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
  const bool on_axis =
      factor.is_numeric() && factor.base && factor.base->number && !(factor.logarithmic && *factor.base->number <= 0.0);
  if (!sweep.base && on_axis) {
    sweep.base = factor.base->number;
    sweep.points.push_back({*sweep.base, &result.base()});
  }
  std::ranges::stable_sort(sweep.points, {}, &Point::x);
  return sweep;
}

/// Axis over the designs with a result.
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

std::optional<double> number_at(const StudyResult& result, const StudyRow& row, const std::string& path) {
  const auto found = std::ranges::find(result.study.responses, path);
  if (found == result.study.responses.end() || !row.status.converged()) return std::nullopt;
  return item_at(row.responses, found - result.study.responses.begin());
}

std::string share_path(const PowerSource& source) { return fmt::format("slip.share_percent.{}", source.key); }

/// Power by source and efficiency of a row; not converged where it has none.
SlipResult slip_of(const StudyResult& result, const StudyRow& row) {
  SlipResult slip;
  const std::optional<double> loss = number_at(result, row, "slip.power_loss_W");
  if (!loss) return slip;
  slip.status = SlipStatus::converged;
  slip.efficiency = number_at(result, row, "slip.efficiency");
  slip.efficiency_fit = number_at(result, row, "slip.efficiency_fit");
  for (const PowerSource& source : kPowerSources)
    slip.power.*source.value = *loss * number_at(result, row, share_path(source)).value_or(0.0) / "%"_per_si;
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
    if (slips.back().efficiency_fit) options.comparison.push_back({point.x, *slips.back().efficiency_fit});
  }
  if (std::ranges::none_of(slips, &SlipResult::converged)) return std::nullopt;
  options.name = study_figure_name(index, sweep.factor->label);
  options.title = fmt::format("{}: power lost by source, efficiency", factor_name(*sweep.factor));
  options.comparison_title = "efficiency by the fit (3.55)";
  const SlipResult base = slip_of(result, result.base());
  if (base.converged() && base.power.total() > 0.0) {
    options.relative_to = base.power.total();
    if (sweep.base) options.references = {{kBaseTitle, *sweep.base, base.power.total(), base.efficiency}};
  }
  const Axis axis = axis_of(sweep);
  Figure figure = power_by_source_figure(x, axis, slips, options);
  figure.x = axis;
  if (std::optional<Axis>& efficiency = figure.panels[1].y) widen(*efficiency, kLeastEfficiencySpan);
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
  for (const auto k : up_to(panels)) figure.panels.push_back(factor_panel(result, k, response));
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
  for (const auto k : indices(result.study.factors)) {
    const Sweep sweep = sweep_of(result, k);
    const auto& own = sweep.factor->base ? sweep.factor->base->number : std::nullopt;
    if (!own || *own == 0.0 || !sweep.factor->is_numeric() || figure.legend.size() == 12) continue;
    Polyline line;
    for (const Point& point : sweep.points)
      if (const std::optional<double>& value = point.row->responses[response])
        line.push_back({100.0 * (point.x / *own - 1.0), 100.0 * (*value / *base - 1.0)});
    if (line.size() > 1)
      panel.series.push_back({figure.add(factor_name(*sweep.factor), marked_line(figure.legend.size())), {line}});
  }
  if (panel.series.empty()) return std::nullopt;
  figure.panels.push_back(std::move(panel));
  return figure;
}

constexpr std::size_t kMaxPanelTitle = 60;

/// Level of each factor.
using Combination = std::vector<std::size_t>;

/// Factors of the axes, lines and panels.
struct Layout {
  std::size_t x = 0;
  std::size_t line = 0;
  std::vector<std::size_t> panels;
};

std::size_t levels(const Study& study, std::size_t factor) { return study.factors[factor].levels.size(); }

/// The factor with most levels among these, the first of several.
std::size_t longest(const Study& study, const std::vector<std::size_t>& factors) {
  return *std::ranges::max_element(factors, {}, [&](std::size_t k) { return levels(study, k); });
}

Layout layout_of(const Study& study) {
  std::vector<std::size_t> all = spread(study.factors.size(), study.factors.size()), numeric;
  std::ranges::copy_if(all, std::back_inserter(numeric), [&](std::size_t k) { return study.factors[k].is_numeric(); });
  Layout layout;
  layout.x = longest(study, numeric.empty() ? all : numeric);
  std::erase(all, layout.x);
  layout.line = longest(study, all);
  std::erase(all, layout.line);
  layout.panels = all;
  return layout;
}

/// The response of a combination: the last factor changes fastest.
std::optional<double> value_at(const StudyResult& result, const Combination& combination, std::size_t response) {
  std::size_t index = 0;
  for (const auto k : indices(combination)) index = index * levels(result.study, k) + combination[k];
  return index + 1 < result.rows.size() ? result.rows[index + 1].responses[response] : std::nullopt;
}

/// Series along an ascending axis, interrupted if a design has no result.
Series series_over(const StudyResult& result, std::size_t response, std::size_t x, Combination combination,
                   std::size_t style) {
  const std::vector<double> at = positions(result.study.factors[x]);
  std::vector<std::size_t> order = spread(at.size(), at.size());
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return at[k]; });
  Series line{style};
  for (const std::size_t k : order) {
    combination[x] = k;
    line.add(at[k], value_at(result, combination, response));
  }
  return line;
}

std::string setting_text(const Study& study, std::size_t factor, std::size_t level) {
  const Factor& f = study.factors[factor];
  return fmt::format("{} {}", factor_name(f), level_text(f.levels[level], f.unit));
}

Figure line_figure(const StudyResult& result, std::size_t response) {
  const Study& study = result.study;
  const Layout layout = layout_of(study);
  Figure figure = response_figure(study.responses, response);
  figure.x = factor_axis(study.factors[layout.x], positions(study.factors[layout.x]));
  const std::vector<std::size_t> lines = spread(levels(study, layout.line), kMostLines);
  for (const auto k : indices(lines)) {
    Style style = marked_line(k);
    if (!study.factors[layout.x].is_numeric()) style.dash = Dash::none;
    figure.add(setting_text(study, layout.line, lines[k]), style);
  }
  std::size_t panels = 1;
  for (const std::size_t factor : layout.panels) panels *= levels(study, factor);
  const std::size_t shown = std::min(panels, kMostStudyPanels);
  if (shown < panels) figure.title += fmt::format(", {} of {} combinations", shown, panels);
  figure.columns = columns_for(shown);
  for (std::size_t index : spread(panels, kMostStudyPanels)) {
    Combination combination(study.factors.size());
    Panel panel;
    for (std::size_t k = layout.panels.size(); k-- > 0;) {
      const std::size_t factor = layout.panels[k];
      combination[factor] = index % levels(study, factor);
      index /= levels(study, factor);
    }
    for (const std::size_t factor : layout.panels)
      panel.title +=
          fmt::format("{}{}", panel.title.empty() ? "" : ", ", setting_text(study, factor, combination[factor]));
    panel.title = shortened(panel.title, kMaxPanelTitle);
    for (const auto k : indices(lines)) {
      combination[layout.line] = lines[k];
      panel.series.push_back(series_over(result, response, layout.x, combination, k));
    }
    figure.panels.push_back(std::move(panel));
  }
  fit_y_range(figure);
  return figure;
}

/// Whether the study records what a figure of power by source shows.
bool has_power(const StudyResult& result) {
  const auto is_recorded = [&](const std::string& path) { return contains(result.study.responses, path); };
  return is_recorded("slip.power_loss_W") && is_recorded("slip.efficiency") &&
         std::ranges::all_of(kPowerSources, [&](const PowerSource& source) { return is_recorded(share_path(source)); });
}

/// A response over each factor, a panel each; in one panel its changes over those of the factors.
Figures one_at_a_time_lines(const StudyResult& result, const FigureOptions& options) {
  return figures_of(result.study.responses, options, [&](std::size_t k) {
    std::optional<Figure> figure;
    if (options.one_panel && result.study.factors.size() > 1) figure = changes_of_factors(result, k);
    if (!figure) figure = panels_of_factors(result, k);
    return figure;
  });
}

/// Figures of slip for each factor: power by source, stacked, and efficiency with its fit (Sandu 2018,
/// fig. 3.9 and appendix C).
Figures study_power(const StudyResult& result, const FigureOptions&) {
  Figures figures;
  if (!varies_one_at_a_time(result.study) || !has_power(result)) return figures;
  for (const auto k : up_to(std::min(result.study.factors.size(), kMostStudyFigures)))
    if (std::optional<Figure> figure = power_figure(result, k)) figures.push_back(std::move(*figure));
  return figures;
}

/// A response over the numeric factor with most values, a line for each value of a second factor
/// and a panel for each combination of the others.
Figures grid_lines(const StudyResult& result, const FigureOptions& options) {
  return figures_of(result.study.responses, options, [&](std::size_t k) { return line_figure(result, k); });
}

}  // namespace

Pictures study_pictures(const StudyResult& r) {
  const Study& study = r.study;
  const bool map = r.summary.envelope || suits_map(study);
  const bool sampled = is_sampled(study.plan);
  const bool arrays = std::ranges::any_of(recorded(study.responses), &Recorded::is_array);
  const auto lines = varies_one_at_a_time(study) ? one_at_a_time_lines
                     : study.plan == Plan::grid  ? grid_lines
                                                 : design_clouds;
  const bool power = varies_one_at_a_time(study) && has_power(r);
  return {
      {"envelope", "`study.envelope` in the case", of_result(r, study_envelope)},
      {"map", "`plan: grid` with two factors of numbers", of_result(r, study_maps), drawn_if(map)},
      {"surface", "an array among `study.responses` of the plans one_at_a_time and grid, and a factor of numbers",
       of_result(r, array_surfaces), drawn_if(arrays && !sampled)},
      {"power", "`plan: one_at_a_time` of slip", of_result(r, study_power)},
      {"contributions", "a plan that draws samples, and a response that varies", of_result(r, contributions)},
      {"lines", "designs with an answer", of_result(r, lines), drawn_if(sampled || (!map && !power))},
      {"histogram", "several designs whose responses differ", of_result(r, histograms), drawn_if(sampled)},
  };
}

}  // namespace prs
