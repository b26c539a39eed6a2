#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "prs/figures/contours.h"
#include "prs/quantities/response_title.h"
#include "prs/figures/study_figure_parts.h"
#include "prs/study/study_text.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr std::size_t kMostBands = 12;
constexpr std::size_t kMostMapNodes = 201;     // Along each axis, of a figure's data.
constexpr std::size_t kMostSurfaceNodes = 41;  // The same, of what is drawn as a mesh.
constexpr LineStyle kContour{"#8c510a", 1, 0, 0.5};
constexpr LineStyle kPoint = points_of("#000000", 7, 2.2);

/// What one figure shows over the grid.
struct Shown {
  std::string name;
  std::string title;
  std::string label;  ///< With the unit.
  const GridMap& map;
};

/// Maps are interpolated, and their lines straight, where an axis is linear.
bool by_logarithm(const MapAxis& axis) { return axis.logarithmic && axis.numbers.front() > 0.0; }

std::vector<double> positions(const MapAxis& axis) {
  std::vector<double> at = axis.numbers;
  if (by_logarithm(axis))
    for (double& x : at) x = std::log(x);
  return at;
}

void to_numbers(const GridMaps& maps, Polyline& line) {
  for (std::size_t a = 0; a < 2; ++a)
    if (by_logarithm(maps.axes[a]))
      for (auto& point : line) point[a] = std::exp(point[a]);
}

/// Appends a style that the legend does not name.
std::size_t add_style(Figure& figure, const LineStyle& style) {
  figure.styles.push_back(style);
  return figure.styles.size() - 1;
}

Panel contour_panel(Figure& figure, const GridMaps& maps, const GridData& grid,
                    const std::vector<double>& levels) {
  Panel panel;
  std::vector<std::size_t> styles;
  for (std::size_t k = 0; k + 1 < levels.size(); ++k)
    styles.push_back(add_style(figure, fill_of_value(0.5 * (levels[k] + levels[k + 1]))));
  styles.resize(levels.size(), styles.back());  // Of what lies on the last level.
  styles.push_back(add_style(figure, fill_of("#ffffff")));
  for (ContourBand& band : contour_bands(grid, levels)) {
    const std::size_t style = styles[band.band];
    if (panel.lines.empty() || panel.lines.back().style != style)
      panel.lines.push_back({style, {}});
    to_numbers(maps, band.outline);
    panel.lines.back().parts.push_back(std::move(band.outline));
  }
  Line contours{add_style(figure, kContour), {}};
  for (const double level : levels) {
    std::vector<Polyline> lines = contour_lines(grid, level);
    if (lines.empty()) continue;
    for (Polyline& line : lines) to_numbers(maps, line);
    const Polyline& longest = *std::ranges::max_element(lines, {}, &Polyline::size);
    const auto& [x, y] = longest[longest.size() / 2];
    panel.labels.push_back({fmt::format("{:g}", level), x, y, false, true});
    std::ranges::move(lines, std::back_inserter(contours.parts));
  }
  panel.lines.push_back(std::move(contours));
  return panel;
}

/// Marks the designs that were read off, on the map and on the surface.
void add_points(Figure& figure, Panel& map, Surface& surface, const StudyResult& result,
                const GridMap& values) {
  const GridMaps& maps = *result.summary.maps;
  Line marks{add_style(figure, kPoint), {}};
  for (const EnvelopePoint& point : result.summary.envelope->points) {
    if (!point.reason.empty()) continue;
    const double x = maps.axes[0].number(point.place[0]), y = maps.axes[1].number(point.place[1]);
    marks.parts.push_back({{x, y}});
    map.labels.push_back({"  " + point.name, x, y});
    const double z = &values == &result.summary.envelope->values
                         ? point.envelope
                         : map_value(maps, values, point.place);
    if (std::isfinite(z)) surface.points.push_back({point.name, x, y, z});
  }
  if (!marks.parts.empty()) map.lines.push_back(std::move(marks));
}

std::optional<Figure> map_figure(const StudyResult& result, const Shown& shown) {
  const GridMaps& maps = *result.summary.maps;
  const GridData whole{positions(maps.axes[0]), positions(maps.axes[1]), shown.map};
  const GridData grid = thinned(whole, kMostMapNodes);
  const std::vector<double> levels = round_levels(grid, kMostBands);
  if (levels.empty()) return std::nullopt;
  Figure figure;
  figure.name = shown.name;
  figure.title = shown.title;
  figure.x = factor_axis(result.study.factors[0], maps.axes[0].numbers);
  figure.y = factor_axis(result.study.factors[1], maps.axes[1].numbers);
  figure.columns = 2;
  figure.panel_height = 400;
  figure.colours =
      ColourScale{shown.label, levels.front(), levels.back(), static_cast<int>(levels.size()) - 1};
  Panel map = contour_panel(figure, maps, grid, levels), space;
  Surface surface{
      thinned({maps.axes[0].numbers, maps.axes[1].numbers, shown.map}, kMostSurfaceNodes),
      Axis{"", levels.front(), levels.back()}};
  add_points(figure, map, surface, result, shown.map);
  space.surface = std::move(surface);
  figure.panels = {std::move(map), std::move(space)};
  return figure;
}

}  // namespace

std::vector<Figure> map_figures(const StudyResult& result) {
  const Study& study = result.study;
  std::vector<Figure> figures;
  if (std::optional<Figure> figure =
          map_figure(result, {"envelope", "Envelope", "Envelope", result.summary.envelope->values}))
    figures.push_back(std::move(*figure));
  for (std::size_t k = 0; k < std::min(study.responses.size(), kMostStudyFigures); ++k) {
    const std::string& path = study.responses[k];
    if (std::optional<Figure> figure =
            map_figure(result, {study_figure_name(k, path), capitalised(response_title(path).name),
                                response_axis(path).label, result.summary.maps->responses[k]}))
      figures.push_back(std::move(*figure));
  }
  return figures;
}

}  // namespace prs
