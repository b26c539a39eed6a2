#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace prs {

// A picture as data: its content, independent of how it is drawn. Renderers draw it, each in its own style: prs/svg for
// files and pages, python/rollerscrew/plots by matplotlib.

using Polyline = std::vector<std::array<double, 2>>;

/// A colour of the palette, distinguishable with any colour vision (Okabe and Ito), or a role.
enum class Colour : int {
  blue,
  vermillion,
  green,
  purple,
  orange,
  sky,
  ink,  ///< Black on paper.
  grey,
  reference,  ///< Lines in the background: a mean, zero, an axis.
  muted,      ///< Many points behind others.
  bad,        ///< Designs that violate a limit.
};

constexpr std::size_t kPaletteSize = 8;

/// Colour of the k-th line.
constexpr Colour palette(std::size_t k) { return static_cast<Colour>(k % kPaletteSize); }

enum class Dash { none, solid, dashed, dotted, dash_dotted };
enum class Mark { none, circle, square, triangle, diamond, down, plus, cross, star };
enum class Weight { thin, normal, strong };

/// Shape of the parts of a series.
enum class Shape {
  line,    ///< Lines through their points, points marked; `Dash::none`: points alone.
  area,    ///< Polygons.
  arrows,  ///< Two points each, from tail to head.
};

/// Style that distinguishes a series from the others.
struct Style {
  Colour colour = Colour::ink;
  Dash dash = Dash::solid;
  Mark mark = Mark::none;
  Weight weight = Weight::normal;
  Shape shape = Shape::line;
  bool open = false;  ///< Whether marks are outlined, not filled.
  bool pale = false;  ///< Whether areas have a light shade of the colour.
};

constexpr Style line_of(Colour colour, Dash dash = Dash::solid, Weight weight = Weight::normal) {
  return {colour, dash, Mark::none, weight};
}
constexpr Style points_of(Colour colour, Mark mark, Weight weight = Weight::normal) {
  return {colour, Dash::none, mark, weight};
}
constexpr Style area_of(Colour colour) { return {colour, Dash::solid, Mark::none, Weight::normal, Shape::area}; }
constexpr Style arrows_of(Colour colour) { return {colour, Dash::solid, Mark::none, Weight::thin, Shape::arrows}; }

struct Series {
  std::size_t style = 0;  ///< Index into the figure's styles.
  std::vector<Polyline> parts = {};
  /// One value per part, which gives its colour on the figure's scale; empty: the style's colour.
  std::vector<double> values = {};

  /// Appends a point to the last part; a missing value ends the part.
  void add(double x, const std::optional<double>& y);
};

/// A line across the whole panel: a mean, zero.
struct ReferenceLine {
  std::size_t style = 0;
  double at = 0.0;
  bool vertical = false;  ///< Whether the line is at this x, else at this y.
};

struct Tick {
  double at = 0.0;
  std::string text = {};  ///< Text of the tick; empty: the number.
};

constexpr double kFree = std::numeric_limits<double>::quiet_NaN();

struct Axis {
  std::string label;
  std::string unit = {};
  double from = kFree;  ///< Lower end; if free the renderer fits it to the data.
  double to = kFree;
  bool logarithmic = false;      ///< Whether the scale is logarithmic; all data are above 0.
  bool whole = false;            ///< Whether ticks are at whole numbers only.
  std::vector<Tick> ticks = {};  ///< Ticks; empty: the renderer chooses.
  bool hidden = false;           ///< Whether ticks and label are omitted.
};

/// Label with unit: `Lead (mm)`.
std::string text_of(const Axis& axis);

/// Numbers at the nodes (x_i, y_j) of a grid, both ascending; values along y are consecutive. NaN marks missing ones.
struct GridData {
  std::vector<double> x = {};
  std::vector<double> y = {};
  std::vector<double> values = {};

  double at(std::size_t i, std::size_t j) const { return values[i * y.size() + j]; }
  bool empty() const { return values.empty(); }
};

/// A grid in the colours of the figure, below the lines of a panel.
struct Map {
  GridData grid = {};
  /// Whether each node is a rectangle of one colour; else filled contours, with labelled lines at the colour scale's
  /// levels.
  bool cells = false;
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

/// Colours of values.
struct ColourScale {
  std::string label;
  std::string unit = {};
  double from = 0.0;
  double to = 1.0;
  std::vector<double> levels = {};  ///< Levels between which the colour is constant; empty: continuous.
  bool logarithmic = false;
  bool whole = false;  ///< Whether the values are whole numbers.
};

/// A text inside a panel.
struct Label {
  enum class Anchor { left, centre, right };
  std::string text;
  double x = 0.0;
  double y = 0.0;
  bool in_panel = false;         ///< Whether x, y are fractions of the panel from its lower left, else coordinates.
  Anchor anchor = Anchor::left;  ///< Anchor of the text at x; its middle lies at y.
};

struct Panel {
  std::string title = {};
  std::vector<Series> series = {};
  std::vector<ReferenceLine> references = {};
  std::vector<Label> labels = {};
  std::optional<Axis> x = std::nullopt;  ///< Own axes, in place of the figure's.
  std::optional<Axis> y = std::nullopt;
  Map map = {};
  std::optional<Surface> surface = std::nullopt;  ///< Surface, in place of all else.
};

struct LegendEntry {
  std::string title;
  std::size_t style = 0;
};

/// Panels in a grid, filled row by row, that share one legend and, unless they have their own, both
/// axes.
struct Figure {
  std::string name;  ///< Name of its files.
  std::string title;
  Axis x = {};
  Axis y = {};
  std::size_t columns = 1;
  std::vector<Panel> panels = {};
  std::vector<Style> styles = {};
  std::vector<LegendEntry> legend = {};
  std::optional<ColourScale> colours = std::nullopt;

  double aspect = 0.0;    ///< Height of a panel over its width; 0: the renderer chooses.
  double overview = 0.0;  ///< Width of the first panel over that of the others, if it fills the first column; 0: a
                          ///< panel like the others.
  bool to_scale = false;  ///< Whether a unit is as long on both axes: ranges are widened about their middle.

  /// Appends a style; returns its index.
  std::size_t add(const Style& style);
  /// Appends a style with a name in the legend; returns its index.
  std::size_t add(std::string title, const Style& style);
};

/// Range from the smallest to the largest of some values.
struct Range {
  double from = std::numeric_limits<double>::infinity();
  double to = -from;

  void include(double value);  ///< Includes the value if it is finite.
  void include(const Range& other);
  void widen(double share);  ///< Widens both ends, by a share of the length.
  bool empty() const { return from > to; }
};
Range range_of_y(const std::vector<Series>& series);

/// The axis over slightly more than a range, or from zero.
Axis fitted(Axis axis, Range range, bool from_zero = false);

/// Sets the y axis from zero, unless the values fill less than half of that, to slightly above the largest. With
/// `from_zero`: always, if no value is negative.
void fit_y_range(Figure& figure, bool from_zero = false);

/// A figure of one of its panels.
Figure only_panel(Figure figure, std::size_t panel);

/// Figure with all lines in one panel: dashes distinguish the former panels, whose titles go into the legend. Panels
/// with axes other than the first's are left out; a map as the first stays alone.
Figure folded(const Figure& figure);

/// Adds the lines of another picture in grey behind those of the same panels, and widens the axes to show them. Returns
/// the style of the grey lines, for the legend; absent, and nothing changed, if one of the two is drawn to scale or
/// they have different panels.
std::optional<std::size_t> add_behind(Figure& figure, const Figure& before);

}  // namespace prs
