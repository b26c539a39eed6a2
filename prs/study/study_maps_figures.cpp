#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "prs/record/response_title.h"
#include "prs/study/study_pictures.h"
#include "prs/study/study_text.h"

namespace prs {
namespace {

constexpr std::size_t kMostBands = 12;
constexpr std::size_t kMostMapNodes = 201;     // Along each axis, of a figure's data.
constexpr std::size_t kMostSurfaceNodes = 41;  // The same, of what is drawn as a mesh.
constexpr std::size_t kFewLevels = 8;          // Up to so many, lines are the better picture.

/// The grid with at most so many nodes along each axis, the outer ones among them.
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
  for (std::size_t i = 0; i < grid.x.size(); ++i)
    for (std::size_t j = 0; j < grid.y.size(); ++j)
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

/// The figure with a map of the grid, and levels for its colours; false where it has no numbers.
bool add_map(Figure& figure, const GridData& grid, std::string label, std::string unit) {
  Range range;
  for (const double value : grid.values) range.include(value);
  std::vector<double> levels = round_levels(range, kMostBands);
  if (levels.empty()) return false;
  figure.colours =
      ColourScale{std::move(label), std::move(unit), levels.front(), levels.back(), levels};
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
  for (std::size_t k = 0; k < study.factors.size(); ++k)
    if (is_mapped(study.factors[k])) usable.push_back(k);
  if (usable.size() < 2)
    throw NoFigure("a map needs two factors of numbers with several values each");
  const auto named = [&](const std::string& name) {
    for (const std::size_t k : usable)
      if (study.factors[k].path == name || study.factors[k].label == name) return k;
    throw NoFigure(fmt::format("no factor of numbers {}", name));
  };
  std::ranges::stable_sort(usable, std::greater{},
                           [&](std::size_t k) { return study.factors[k].levels.size(); });
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

/// A response of a grid over two factors, the others held.
std::optional<Figure> grid_map(const StudyResult& result, std::size_t response,
                               const FigureOptions& options) {
  const Study& study = result.study;
  const auto [across, up] = map_factors(study, options);
  Figure figure = response_figure(study.responses, response);
  std::vector<std::pair<std::size_t, std::string>> held;
  for (std::size_t k = 0; k < study.factors.size(); ++k)
    if (k != across && k != up) {
      held.emplace_back(k, held_level(study.factors[k]));
      figure.title += fmt::format(", {} {}", factor_name(study.factors[k]), held.back().second);
    }
  const std::vector<double> x = positions(study.factors[across]);
  const std::vector<double> y = positions(study.factors[up]);
  GridData grid{without_repeats(x), without_repeats(y), {}};
  grid.values.assign(grid.x.size() * grid.y.size(), kFree);
  for (std::size_t r = 1; r < result.rows.size(); ++r) {
    const StudyRow& row = result.rows[r];
    const bool shown = std::ranges::all_of(held, [&](const auto& h) {
      const auto set = std::ranges::find(row.design.settings, h.first, &Setting::factor);
      return set == row.design.settings.end() || set->level.text == h.second;
    });
    const std::optional<double> at_x = number_in(study, row, across);
    const std::optional<double> at_y = number_in(study, row, up);
    const std::optional<double>& value = row.responses[response];
    if (!shown || !at_x || !at_y || !value) continue;
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

/// A map of a study with an envelope, with the designs read off it; next to it the same as a
/// surface.
std::optional<Figure> marked_map(const StudyResult& result, Figure figure, Axis axis,
                                 const GridMap& values) {
  const GridMaps& maps = *result.summary.maps;
  const GridData grid = answered({maps.axes[0].numbers, maps.axes[1].numbers, values});
  if (grid.empty()) return std::nullopt;
  figure.x = factor_axis(result.study.factors[0], grid.x);
  figure.y = factor_axis(result.study.factors[1], grid.y);
  figure.columns = 2;
  figure.aspect = 1.0;
  if (!add_map(figure, grid, axis.label, axis.unit)) return std::nullopt;
  axis.from = figure.colours->from;
  axis.to = figure.colours->to;
  Surface surface{thinned(grid, kMostSurfaceNodes), std::move(axis)};
  Series marks{figure.add(points_of(Colour::ink, Mark::circle))};
  const EnvelopeResult& envelope = *result.summary.envelope;
  for (const EnvelopePoint& point : envelope.points) {
    if (!point.reason.empty()) continue;
    const double x = maps.axes[0].number(point.place[0]), y = maps.axes[1].number(point.place[1]);
    marks.parts.push_back({{x, y}});
    const bool at_right = x > 0.2 * grid.x.front() + 0.8 * grid.x.back();
    figure.panels[0].labels.push_back({at_right ? point.name + "  " : "  " + point.name, x, y,
                                       false,
                                       at_right ? Label::Anchor::right : Label::Anchor::left});
    const double z =
        &values == &envelope.values ? point.envelope : map_value(maps, values, point.place);
    if (std::isfinite(z)) surface.points.push_back({point.name, x, y, z});
  }
  if (!marks.parts.empty()) figure.panels[0].series.push_back(std::move(marks));
  figure.panels.emplace_back().surface = std::move(surface);
  return figure;
}

}  // namespace

bool suits_map(const Study& study) {
  return study.plan == Plan::grid && study.factors.size() == 2 &&
         std::ranges::all_of(study.factors, [](const Factor& factor) {
           return factor.is_numeric() && factor.levels.size() > kFewLevels;
         });
}

/// The envelope of several measures over two factors (Jung 2017, figs. 7.7 to 8.8).
Figures study_envelope(const StudyResult& result, const FigureOptions&) {
  if (!result.summary.envelope) return {};
  std::optional<Figure> figure =
      marked_map(result, {"envelope", "Envelope"}, {"Envelope"}, result.summary.envelope->values);
  if (!figure) return {};
  return {std::move(*figure)};
}

/// Responses of a grid over two factors.
Figures study_maps(const StudyResult& result, const FigureOptions& options) {
  if (result.study.plan != Plan::grid) return {};
  Figures figures;
  for (const std::size_t k : chosen_responses(result.study.responses, options)) {
    Figure named = response_figure(result.study.responses, k);
    const Axis axis = named.y;
    std::optional<Figure> figure =
        result.summary.maps && !options.x && !options.y
            ? marked_map(result, std::move(named), axis, result.summary.maps->responses[k])
            : grid_map(result, k, options);
    if (figure) figures.push_back(std::move(*figure));
  }
  return figures;
}

}  // namespace prs
