#include "prs/study/study_figures.h"

#include <fmt/format.h>

#include <algorithm>

#include "prs/indices.h"
#include "prs/record/table_units.h"
#include "prs/study/recorded.h"

namespace prs {
namespace {

constexpr std::size_t kMostBands = 12;
constexpr std::size_t kMostMapNodes = 201;     // Largest number of nodes along each axis of a figure's data.
constexpr std::size_t kMostSurfaceNodes = 41;  // Largest number of nodes along each axis of a drawn mesh.
constexpr std::size_t kFewLevels = 8;          // Largest number of levels for which lines are the better picture.

/// The grid with at most this many nodes along each axis, the outer ones among them.
GridData thinned(const GridData& grid, std::size_t most) {
  const std::vector<std::size_t> is = spread(grid.x.size(), most), js = spread(grid.y.size(), most);
  GridData some;
  for (const std::size_t i : is) some.x.push_back(grid.x[i]);
  for (const std::size_t j : js) some.y.push_back(grid.y[j]);
  for (const std::size_t i : is)
    for (const std::size_t j : js) some.values.push_back(grid.at(i, j));
  return some;
}

/// The grid without outer rows and columns that have no number: designs without an answer.
GridData answered(const GridData& grid) {
  std::array<std::size_t, 2> from{grid.x.size(), grid.y.size()}, to{};
  for (const auto i : indices(grid.x))
    for (const auto j : indices(grid.y))
      if (std::isfinite(grid.at(i, j))) {
        from = {std::min(from[0], i), std::min(from[1], j)};
        to = {std::max(to[0], i + 1), std::max(to[1], j + 1)};
      }
  GridData inner;
  for (std::size_t i = from[0]; i < to[0]; ++i) {
    inner.x.push_back(grid.x[i]);
    for (std::size_t j = from[1]; j < to[1]; ++j) inner.values.push_back(grid.at(i, j));
  }
  for (std::size_t j = from[1]; j < to[1] && !inner.x.empty(); ++j) inner.y.push_back(grid.y[j]);
  return inner;
}

/// The figure with a map of the grid, and levels for its colours; false if it has no numbers.
bool add_map(Figure& figure, const GridData& grid, std::string label, std::string unit) {
  Range range;
  for (const double value : grid.values) range.include(value);
  std::vector<double> levels = round_levels(range, kMostBands);
  if (levels.empty()) return false;
  figure.colours = ColourScale{std::move(label), std::move(unit), levels.front(), levels.back(), levels};
  figure.panels.emplace_back().map.grid = thinned(grid, kMostMapNodes);
  return true;
}

std::vector<double> without_repeats(std::vector<double> values) {
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

std::size_t index_in(const std::vector<double>& values, double value) {
  return static_cast<std::size_t>(std::ranges::lower_bound(values, value) - values.begin());
}

bool is_mapped(const Factor& factor) { return factor.is_numeric() && factor.levels.size() > 1; }

/// Places of the two factors of a map among the study's: those that the options name, else the ones
/// with most levels, in the order of the study.
std::array<std::size_t, 2> map_factors(const Study& study, const FigureOptions& options) {
  std::vector<std::size_t> usable;
  for (const auto k : indices(study.factors))
    if (is_mapped(study.factors[k])) usable.push_back(k);
  if (usable.size() < 2) throw NoFigure("a map needs two factors of numbers with several values each");
  const auto named = [&](const std::string& name) {
    for (const std::size_t k : usable)
      if (study.factors[k].path == name || study.factors[k].label == name) return k;
    throw NoFigure(fmt::format("no factor of numbers {}", name));
  };
  std::ranges::stable_sort(usable, std::greater{}, [&](std::size_t k) { return study.factors[k].levels.size(); });
  std::optional<std::size_t> x, y;
  if (options.x) x = named(*options.x);
  if (options.y) y = named(*options.y);
  if (x && x == y) throw NoFigure("a map needs two different factors");
  const auto other = [&](const std::optional<std::size_t>& taken) {
    return *std::ranges::find_if(usable, [&](std::size_t k) { return taken != k; });
  };
  if (!x && !y) {
    x = usable[0], y = usable[1];
    if (*x > *y) std::swap(x, y);
  }
  return {x ? *x : other(y), y ? *y : other(x)};
}

/// A factor's number in a design; that of the file where the design does not set it.
std::optional<double> number_in(const Study& study, const StudyRow& row, std::size_t factor) {
  const auto set = std::ranges::find(row.design.settings, factor, &Setting::factor);
  if (set != row.design.settings.end()) return set->level.number;
  return study.factors[factor].base ? study.factors[factor].base->number : std::nullopt;
}

/// The level at which a map holds a factor: that of the file, else the nearest.
std::string held_level(const Factor& factor) {
  const auto& base = factor.base;
  const Level* held = &factor.levels.front();
  for (const Level& level : factor.levels) {
    if (base && level.text == base->text) return level.text;
    if (base && base->number && level.number && held->number &&
        std::abs(*level.number - *base->number) < std::abs(*held->number - *base->number))
      held = &level;
  }
  return held->text;
}

/// Factors that a figure holds, and their levels.
using Held = std::vector<std::pair<std::size_t, std::string>>;

/// All factors but those of the axes, which the title names.
Held hold_others(const Study& study, std::size_t x, std::size_t y, Figure& figure) {
  Held held;
  for (const auto k : indices(study.factors)) {
    if (k == x || k == y) continue;
    held.emplace_back(k, held_level(study.factors[k]));
    if (study.plan == Plan::grid)
      figure.title += fmt::format(", {} {}", factor_name(study.factors[k]), held.back().second);
  }
  return held;
}

bool is_shown(const StudyRow& row, const Held& held) {
  return std::ranges::all_of(held, [&](const auto& h) {
    const auto set = std::ranges::find(row.design.settings, h.first, &Setting::factor);
    return set == row.design.settings.end() || set->level.text == h.second;
  });
}

/// A response of a grid over two factors, the others held.
std::optional<Figure> grid_map(const StudyResult& result, std::size_t response, const FigureOptions& options) {
  const Study& study = result.study;
  const auto [across, up] = map_factors(study, options);
  Figure figure = response_figure(study.responses, response);
  const Held held = hold_others(study, across, up, figure);
  GridData grid{without_repeats(positions(study.factors[across])), without_repeats(positions(study.factors[up])), {}};
  grid.values.assign(grid.x.size() * grid.y.size(), kFree);
  for (std::size_t r = 1; r < result.rows.size(); ++r) {
    const StudyRow& row = result.rows[r];
    const std::optional<double> at_x = number_in(study, row, across);
    const std::optional<double> at_y = number_in(study, row, up);
    const std::optional<double>& value = row.responses[response];
    if (!is_shown(row, held) || !at_x || !at_y || !value) continue;
    const std::size_t i = index_in(grid.x, *at_x), j = index_in(grid.y, *at_y);
    if (i < grid.x.size() && j < grid.y.size()) grid.values[i * grid.y.size() + j] = *value;
  }
  const Axis axis = figure.y;
  grid = answered(grid);
  figure.x = factor_axis(study.factors[across], grid.x);
  figure.y = factor_axis(study.factors[up], grid.y);
  if (!add_map(figure, grid, axis.label, axis.unit)) return std::nullopt;
  return figure;
}

/// The figure with a map of the grid and beside it the same as a surface; false where it has no numbers.
bool add_map_and_surface(Figure& figure, const GridData& grid, Axis axis) {
  figure.columns = 2;
  figure.aspect = 1.0;
  if (grid.empty() || !add_map(figure, grid, axis.label, axis.unit)) return false;
  axis.from = figure.colours->from;
  axis.to = figure.colours->to;
  figure.panels.emplace_back().surface = Surface{thinned(grid, kMostSurfaceNodes), std::move(axis)};
  return true;
}

/// A map of a study with an envelope, with the designs read off it; next to it the same as a
/// surface.
std::optional<Figure> marked_map(const StudyResult& result, Figure figure, const Axis& axis, const GridMap& values) {
  const GridMaps& maps = *result.summary.maps;
  const GridData grid = answered({maps.axes[0].numbers, maps.axes[1].numbers, values});
  figure.x = factor_axis(result.study.factors[0], grid.x);
  figure.y = factor_axis(result.study.factors[1], grid.y);
  if (!add_map_and_surface(figure, grid, axis)) return std::nullopt;
  Series marks{figure.add(points_of(Colour::ink, Mark::circle))};
  const EnvelopeResult& envelope = *result.summary.envelope;
  for (const EnvelopePoint& point : envelope.points) {
    if (!point.reason.empty()) continue;
    const double x = maps.axes[0].number(point.place[0]), y = maps.axes[1].number(point.place[1]);
    marks.parts.push_back({{x, y}});
    const bool at_right = x > 0.2 * grid.x.front() + 0.8 * grid.x.back();
    figure.panels[0].labels.push_back({at_right ? point.name + "  " : "  " + point.name, x, y, false,
                                       at_right ? Label::Anchor::right : Label::Anchor::left});
    const double z = &values == &envelope.values ? point.envelope : map_value(maps, values, point.place);
    if (std::isfinite(z)) figure.panels[1].surface->points.push_back({point.name, x, y, z});
  }
  if (!marks.parts.empty()) figure.panels[0].series.push_back(std::move(marks));
  return figure;
}

/// An array over a factor, the others held (Jung 2017, figs. 4.1 to 4.8).
std::optional<Figure> array_surface(const StudyResult& result, const std::vector<Recorded>& all, std::size_t response,
                                    std::size_t factor) {
  const Study& study = result.study;
  const Recorded& array = all[response];
  Figure figure = response_figure({array.path}, 0);
  figure.name = study_figure_name(response, array.path);
  if (study.factors.size() > 1) figure.name += study_figure_name(factor, study.factors[factor].label).substr(2);
  const Held held = hold_others(study, factor, factor, figure);
  GridData grid{without_repeats(positions(study.factors[factor])), {}, {}};
  for (const auto k : up_to(array.count)) grid.y.push_back(static_cast<double>(k + 1));
  grid.values.assign(grid.x.size() * array.count, kFree);
  for (std::size_t r = 1; r < result.rows.size(); ++r) {
    const StudyRow& row = result.rows[r];
    const std::optional<double> at = number_in(study, row, factor);
    const auto varies = [&](const Setting& setting) { return setting.factor == factor; };
    if (!at || !is_shown(row, held) || std::ranges::none_of(row.design.settings, varies)) continue;
    for (const auto k : up_to(array.count))
      if (const std::optional<double>& value = row.responses[array.first + k])
        grid.values[index_in(grid.x, *at) * array.count + k] = *value;
  }
  grid = answered(grid);
  const Axis axis = figure.y;
  figure.x = factor_axis(study.factors[factor], grid.x);
  figure.y = {"Thread", "", 1.0, std::max(grid.y.empty() ? 1.0 : grid.y.back(), 2.0)};
  figure.y.whole = true;
  if (!add_map_and_surface(figure, grid, axis)) return std::nullopt;
  return figure;
}

constexpr std::size_t kMostBars = 14;
constexpr std::size_t kMostClouds = 6;     // Factors whose designs are drawn.
constexpr std::size_t kMostPoints = 1000;  // Largest number of points of a cloud.

Figure kind_of_figure(const StudyResult& result, std::size_t response, std::string_view kind) {
  Figure figure = response_figure(result.study.responses, response);
  figure.name = fmt::format("{}_{}", kind, figure.name);
  return figure;
}

/// Text for titles: how well the linear surface fits, and to how many designs.
std::string quality_of_fit(const StudyResult& result, std::size_t response, const LinearFit& fit) {
  return fmt::format(": linear surface, R² = {:.4f}, n = {}", fit.r_squared, result.summary.statistics[response].count);
}

/// Yao et al. 2023, figs. 8, 9.
Figure surface_figure(const StudyResult& result, std::size_t response, const LinearFit& fit) {
  Figure figure = kind_of_figure(result, response, "contributions");
  figure.title += quality_of_fit(result, response, fit);
  figure.x = {"Contribution |b| / sum of |b|, with the sign of b", "%"};
  std::vector<std::string> names;
  std::vector<double> values;
  for (const FactorEffect& effect : fit.effects) {
    if (names.size() == kMostBars) break;
    names.push_back(factor_name(result.study.factors[effect.factor]));
    values.push_back(effect.coefficient < 0.0 ? -effect.contribution_percent : effect.contribution_percent);
  }
  return ranked_bars(std::move(figure), names, values);
}

/// The estimate as a bar and its interval as a line with caps [%].
void add_estimate(const Estimate& estimate, double at, Series& bars, Series& intervals) {
  constexpr double kHalfBar = 0.18, kCap = 0.10;
  const double value = 100.0 * estimate.value;
  bars.parts.push_back(rectangle(0.0, value, at - kHalfBar, at + kHalfBar));
  if (!estimate.half_width) return;
  const double from = std::max(value - 100.0 * *estimate.half_width, -20.0);
  const double to = std::min(value + 100.0 * *estimate.half_width, 120.0);
  intervals.parts.push_back({{from, at}, {to, at}});
  for (const double end : {from, to}) intervals.parts.push_back({{end, at - kCap}, {end, at + kCap}});
}

std::string block_name(const Study& study, std::size_t factor) {
  Factor block = study.factors[factor];
  block.path = path_of_block(study, factor);
  block.label = label_of_block(study, factor);
  return factor_name(block);
}

Figure variance_figure(const StudyResult& result, std::size_t response, const ResponseIndices& indices) {
  Figure figure = kind_of_figure(result, response, "variance");
  figure.title += fmt::format(": shares of the variance, {} samples", indices.samples);
  figure.x = {"Share of the variance", "%"};
  Series first{figure.add("alone (first)", area_of(Colour::blue))};
  Series total{figure.add("alone and with others (total)", area_of(Colour::orange))};
  Series intervals{figure.add("95 %", line_of(Colour::ink, Dash::solid, Weight::thin))};
  const std::size_t bars = std::min(indices.factors.size(), kMostBars);
  std::vector<std::string> names;
  for (const auto k : up_to(bars)) {
    const FactorIndices& factor = indices.factors[k];
    names.push_back(block_name(result.study, factor.factor));
    add_estimate(factor.first, rank_position(k, bars) + 0.2, first, intervals);
    add_estimate(factor.total, rank_position(k, bars) - 0.2, total, intervals);
  }
  Panel panel;
  panel.series = {std::move(first), std::move(total), std::move(intervals)};
  return ranked(std::move(figure), std::move(panel), names, 0.065);
}

Figure gain_figure(const StudyResult& result, std::size_t response, const std::vector<ToleranceGain>& gains) {
  Figure figure = kind_of_figure(result, response, "tolerances");
  figure.title += ": what half the deviation of a factor buys";
  figure.x = {"Less of what 95 % of the designs stay below", "%"};
  std::vector<std::string> names;
  std::vector<double> values;
  for (const ToleranceGain& gain : gains) {
    if (names.size() == kMostBars) break;
    names.push_back(block_name(result.study, gain.factor));
    values.push_back(100.0 * gain.gain());
  }
  return ranked_bars(std::move(figure), names, values, {"gain", "loss"});
}

/// Value of the surface over one factor, the others in the middle of their ranges.
Polyline line_of_fit(const FactorEffect& effect, double intercept, const NormalisedFactor& x, double from, double to) {
  return {{from, intercept + effect.coefficient * x(from)}, {to, intercept + effect.coefficient * x(to)}};
}

/// Designs over the most important factors, at most this many of them.
Figure cloud_figure(const StudyResult& result, std::size_t response, const LinearFit& fit, std::size_t most) {
  const std::vector<NormalisedFactor> normalised = normalised_factors(result.study);
  Figure figure = kind_of_figure(result, response, "designs");
  figure.title += quality_of_fit(result, response, fit);
  const std::size_t dots = figure.add("designs", points_of(Colour::sky, Mark::circle, Weight::thin));
  const std::size_t line = figure.add("linear surface, others in the middle", line_of(Colour::vermillion));
  const std::size_t panels = std::min(fit.effects.size(), most);
  figure.columns = columns_for(panels);
  for (const auto rank : up_to(panels)) {
    const std::size_t factor = fit.effects[rank].factor;
    Panel& panel = figure.panels.emplace_back();
    Series cloud{dots, {{}}};
    std::vector<double> values;
    for (std::size_t k = 1; k < result.rows.size() && values.size() < kMostPoints; ++k) {
      const std::optional<double> x = number_in(result.study, result.rows[k], factor);
      const std::optional<double>& y = result.rows[k].responses[response];
      if (!x || !y) continue;
      values.push_back(*x);
      cloud.parts[0].push_back({*x, *y});
    }
    panel.x = factor_axis(result.study.factors[factor], values);
    panel.x->ticks.clear();
    panel.series.push_back(std::move(cloud));
    const NormalisedFactor& x = *std::ranges::find(normalised, factor, &NormalisedFactor::factor);
    panel.series.push_back({line, {line_of_fit(fit.effects[rank], fit.intercept, x, panel.x->from, panel.x->to)}});
  }
  fit_y_range(figure);
  return figure;
}

Panel histogram_panel(const StudyResult& result, std::size_t response) {
  const ResponseStatistics& s = result.summary.statistics[response];
  const Histogram& h = s.histogram;
  Panel panel;
  Series bars{0};
  const double width = (h.to - h.from) / static_cast<double>(h.counts.size());
  Range counts{0.0, 0.0};
  for (const auto k : indices(h.counts)) {
    const double left = h.from + width * static_cast<double>(k);
    const auto count = static_cast<double>(h.counts[k]);
    counts.include(count);
    bars.parts.push_back(rectangle(left, left + width, 0.0, count));
  }
  panel.series.push_back(std::move(bars));
  Range shown{h.from, h.to};
  shown.widen(0.03);
  panel.x = response_axis(result.study.responses[response]);
  panel.x->from = shown.from;
  panel.x->to = shown.to;
  panel.y = Axis{"Designs", "", 0.0, 1.06 * counts.to};
  panel.references = {{1, s.quantiles[1], true}, {1, s.quantiles[3], true}, {2, s.quantiles[2], true}};
  const std::optional<double>& base = result.base().responses[response];
  if (base && *base >= shown.from && *base <= shown.to) panel.references.push_back({3, *base, true});
  return panel;
}

const LinearFit* fit_of(const StudyResult& result, std::size_t response) {
  const auto& surfaces = result.summary.surfaces;
  if (!surfaces || surfaces->fits.empty() || !surfaces->fits[response]) return nullptr;
  return &*surfaces->fits[response];
}

}  // namespace

bool suits_map(const Study& study) {
  return study.plan == Plan::grid && study.factors.size() == 2 &&
         std::ranges::all_of(study.factors, [](const Factor& factor) {
           return factor.is_numeric() && factor.levels.size() > kFewLevels;
         });
}

Figures study_envelope(const StudyResult& result, const FigureOptions&) {
  if (!result.summary.envelope) return {};
  std::optional<Figure> figure =
      marked_map(result, {"envelope", "Envelope"}, {"Envelope"}, result.summary.envelope->values);
  if (!figure) return {};
  return {std::move(*figure)};
}

Figures study_maps(const StudyResult& result, const FigureOptions& options) {
  if (result.study.plan != Plan::grid) return {};
  return figures_of(result.study.responses, options, [&](std::size_t k) {
    if (!result.summary.maps || options.x || options.y) return grid_map(result, k, options);
    Figure figure = response_figure(result.study.responses, k);
    const Axis axis = figure.y;
    return marked_map(result, std::move(figure), axis, result.summary.maps->responses[k]);
  });
}

Figures array_surfaces(const StudyResult& result, const FigureOptions& options) {
  const Study& study = result.study;
  std::vector<std::size_t> factors;
  if (is_sampled(study.plan)) return {};
  for (const auto k : indices(study.factors))
    if (is_mapped(study.factors[k]) &&
        (!options.x || options.x == study.factors[k].path || options.x == study.factors[k].label))
      factors.push_back(k);
  if (!varies_one_at_a_time(study) && !factors.empty())
    factors = {*std::ranges::max_element(factors, {}, [&](std::size_t k) { return study.factors[k].levels.size(); })};
  Figures figures;
  const std::vector<Recorded> all = recorded(study.responses);
  for (const auto k : indices(all)) {
    if (!all[k].is_array() || (options.response && *options.response != all[k].path)) continue;
    for (const std::size_t factor : factors)
      if (auto figure = array_surface(result, all, k, factor); figure && figures.size() < kMostStudyFigures)
        figures.push_back(std::move(*figure));
  }
  return figures;
}

Figures contributions(const StudyResult& result, const FigureOptions& options) {
  return figures_of(result.study.responses, options, [&](std::size_t k) -> std::optional<Figure> {
    const std::vector<ResponseIndices>& indices = result.summary.indices;
    const auto& gains = result.summary.tolerances;
    if (!gains.empty() && !gains[k].empty()) return gain_figure(result, k, gains[k]);
    if (!indices.empty() && !indices[k].factors.empty()) return variance_figure(result, k, indices[k]);
    const LinearFit* fit = fit_of(result, k);
    return fit ? std::optional(surface_figure(result, k, *fit)) : std::nullopt;
  });
}

Figures design_clouds(const StudyResult& result, const FigureOptions& options) {
  return figures_of(result.study.responses, options, [&](std::size_t k) -> std::optional<Figure> {
    const LinearFit* fit = fit_of(result, k);
    if (!fit) return std::nullopt;
    return cloud_figure(result, k, *fit, options.one_panel ? 1 : kMostClouds);
  });
}

Figures histograms(const StudyResult& result, const FigureOptions& options) {
  std::vector<std::size_t> varying;
  for (const std::size_t k : chosen_responses(result.study.responses, options))
    if (!result.summary.statistics[k].histogram.counts.empty()) varying.push_back(k);
  if (varying.empty()) return {};
  Figure figure{"histograms", "How the responses scatter"};
  keep_first(varying, kMostStudyPanels, figure.title);
  figure.add("designs", area_of(Colour::sky));
  figure.add("5 %, 95 %", line_of(Colour::ink, Dash::dashed, Weight::thin));
  figure.add("median", line_of(Colour::ink, Dash::solid, Weight::thin));
  figure.add(kBaseTitle, line_of(Colour::vermillion));
  figure.columns = std::min<std::size_t>(varying.size(), 2);
  for (const std::size_t k : varying) figure.panels.push_back(histogram_panel(result, k));
  return {std::move(figure)};
}

}  // namespace prs
