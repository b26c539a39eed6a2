#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace prs {

using Polyline = std::vector<std::array<double, 2>>;

/// How a line is drawn. Numbers are gnuplot's dash types and point types, 0 for none.
struct LineStyle {
  std::string_view colour;  ///< #rrggbb
  int dash = 1;
  int point = 0;
  double width = 1.5;
  int point_interval = 1;  ///< Every how many points one is marked.
  bool filled = false;     ///< The parts of the line are polygons, filled and without outline.
  bool arrows = false;     ///< The parts of the line are two points, from tail to head.
  /// Of polygons: filled with the colour of this value on the figure's scale, not with `colour`.
  std::optional<double> value = std::nullopt;
};

constexpr LineStyle fill_of(std::string_view colour) { return {colour, 1, 0, 0.0, 1, true}; }
constexpr LineStyle points_of(std::string_view colour, int point, double width) {
  return {colour, 0, point, width};
}

constexpr LineStyle fill_of_value(double value) {
  return {"#ffffff", 1, 0, 0.0, 1, true, false, value};
}
constexpr LineStyle arrows_of(std::string_view colour, double width) {
  return {colour, 1, 0, width, 1, false, true};
}

struct Line {
  std::size_t style = 0;  ///< Index into the figure's styles.
  std::vector<Polyline> parts;
};

struct Axis {
  std::string label;  ///< With the unit.
  double from = 0.0;
  double to = 1.0;
  std::vector<int> tics = {};  ///< Empty: gnuplot chooses.
  bool logarithmic = false;    ///< The range must lie above 0.
};

/// A rectangle filled with the colour of its value.
struct Cell {
  double x = 0.0;  ///< Its middle.
  double y = 0.0;
  double value = 0.0;
};

/// Cells of one size, below the lines of a panel.
struct CellMap {
  double width = 0.0;
  double height = 0.0;
  std::vector<Cell> cells = {};
};

/// Numbers at the nodes (x_i, y_j) of a grid, both ascending; those along y are consecutive. NaN
/// where there is none.
struct GridData {
  std::vector<double> x = {};
  std::vector<double> y = {};
  std::vector<double> values = {};

  double at(std::size_t i, std::size_t j) const { return values[i * y.size() + j]; }
};

/// A point with its name, drawn over the surface.
struct SurfacePoint {
  std::string name;
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

/// A surface in space, seen from above, in the colours of the figure.
struct Surface {
  GridData grid;
  Axis z;
  std::vector<SurfacePoint> points = {};
};

/// Which colours the cells and surfaces of all panels have: from pale to dark orange.
struct ColourScale {
  std::string label;  ///< With the unit.
  double from = 0.0;
  double to = 1.0;
  int bands = 0;  ///< So many equal ones of one colour each; 0: continuous.
};

/// A text inside a panel.
struct Label {
  std::string text;
  double x = 0.0;
  double y = 0.0;
  bool in_panel = false;  ///< x, y are shares of the panel from its lower left, else coordinates.
  bool centred = false;   ///< Else the text starts at x.
};

struct Panel {
  std::string title;
  std::vector<Line> lines = {};
  std::vector<Label> labels = {};
  std::optional<Axis> x = std::nullopt;  ///< In place of the figure's.
  std::optional<Axis> y = std::nullopt;
  CellMap map = {};
  std::optional<Surface> surface = std::nullopt;  ///< In place of lines, labels and map.
};

struct LegendEntry {
  std::string title;
  std::size_t style = 0;
};

/// Panels in a grid, filled row by row, that share one legend below and, unless they have their
/// own, both axes.
struct Figure {
  std::string name;  ///< Of its files.
  std::string title;
  Axis x;
  Axis y;
  std::size_t columns = 1;
  std::vector<Panel> panels;
  std::vector<LineStyle> styles;
  std::vector<LegendEntry> legend;
  std::optional<ColourScale> colours = std::nullopt;  ///< Of the cells; drawn above the legend.

  int panel_height = 235;          ///< [pixels], where an image is 900 wide.
  double first_column = 1.0;       ///< Width of the first column over that of the others.
  bool first_is_overview = false;  ///< The first panel fills the first column.
  /// A drawing: ranges are widened about their middle until a unit is as long on both axes.
  bool to_scale = false;
};

/// Those figures for which there was something to draw.
template <class... Figures>
std::vector<Figure> drawable(Figures... figures) {
  std::vector<Figure> all;
  ((figures ? all.push_back(std::move(*figures)) : void()), ...);
  return all;
}

/// Sets the range of y: from zero, unless the values fill less than half of that, to a little above
/// the largest.
void fit_y_range(Figure& figure);

}  // namespace prs
