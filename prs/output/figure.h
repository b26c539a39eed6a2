#pragma once

#include <array>
#include <string>
#include <string_view>
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
};

struct Line {
  std::size_t style = 0;  ///< Index into the figure's styles.
  std::vector<Polyline> parts;
};

struct Panel {
  std::string title;
  std::vector<Line> lines;
};

struct Axis {
  std::string label;  ///< With the unit.
  double from = 0.0;
  double to = 1.0;
  std::vector<int> tics;  ///< Empty: gnuplot chooses.
};

struct LegendEntry {
  std::string title;
  std::size_t style = 0;
};

/// Panels in a grid, filled row by row, that share both axes and one legend below.
struct Figure {
  std::string name;  ///< Of its files.
  std::string title;
  Axis x;
  Axis y;
  std::size_t columns = 1;
  std::vector<Panel> panels;
  std::vector<LineStyle> styles;
  std::vector<LegendEntry> legend;
};

/// Sets the range of y: from zero, unless the values fill less than half of that, to a little above
/// the largest.
void fit_y_range(Figure& figure);

/// A gnuplot script with the data inside that draws `NAME.svg` and `NAME.png` into the working
/// directory. Titles may hold any text: it is drawn as it stands and never interpreted.
std::string gnuplot_script(const Figure& figure);

}  // namespace prs
