#pragma once

#include <cmath>
#include <string_view>
#include <utility>

#include "prs/record/figure.h"

namespace prs {

/// A text for HTML and SVG: `printable`, with markup escaped.
std::string html(std::string_view text);

/// Number as `{:.1f}` formats it, frequent in pictures; numbers beyond a picture need not be exact.
std::string tenth_of(double value);

/// Appends tenths of a unit to a path: short, without a space before a sign.
void append_tenths(std::string& path, long tenths, bool first);

/// A number at a tick, no finer than its step needs, with a typographic minus.
std::string tick_text(double value, double step);

/// A text element. The classes determine its alignment.
std::string text(double x, double y, std::string_view classes, std::string_view content, std::string_view more = "");

constexpr int kLineHeight = 17;  ///< Distance of lines of text.

/// Lines of text, the last one at y.
std::string texts(double x, double y, std::string_view classes, const std::vector<std::string>& lines,
                  std::string_view more = "");

/// The attribute that turns a text about its position, in degrees.
std::string turned(double x, double y, int angle);

std::string segment(double x1, double y1, double x2, double y2, std::string_view attributes);

/// Width in pixels of a text in the widest of the fonts that replace Helvetica or Arial.
double text_width(std::string_view text);

/// Rectangle of a text in a picture, pixels from the upper left.
struct TextBox {
  double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0;

  bool overlaps(const TextBox& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

/// Box of a line of text with `share` of it to the left of x: 1 ends, 0 begins, 0.5 centres it there.
TextBox text_box(std::string_view text, double x, double baseline, double share);

/// Colours of `Colour`.
inline constexpr std::string_view kColours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9",
                                                "#000000", "#7f7f7f", "#555555", "#aaaaaa", "#cc3311"};
/// Colours of scales, from the smallest to the largest value, in equal steps.
inline constexpr std::string_view kScaleColours[] = {"#ffffe5", "#fee391", "#fec44f", "#ec7014", "#cc4c02"};
/// Widths of lines and sizes of marks, by `Weight`.
inline constexpr double kLineWidths[] = {1.0, 1.6, 2.4};
inline constexpr double kMarkSizes[] = {0.4, 0.75, 1.1};

/// Entry of a table for an enumerator.
template <class Table, class Value>
const auto& look(const Table& table, Value value) {
  return table[static_cast<std::size_t>(value)];
}

/// Colours of a scale: one per band between its levels, or enough steps to look continuous.
class ScaleSteps {
 public:
  explicit ScaleSteps(const ColourScale& scale);

  /// Index of the colour of a value; -1 if it has none.
  int step(double value) const;
  std::string colour(double value) const {
    const int at = step(value);
    return at < 0 ? "none" : colours_[static_cast<std::size_t>(at)];
  }
  const std::vector<std::string>& colours() const { return colours_; }

 private:
  double place(double value) const;

  ColourScale scale_;
  std::vector<std::string> colours_;
};

/// Attributes of a line: class, width and dashes.
std::string stroke(const Style& style);

/// Rules for the classes of all pictures. On a page (`themed`) colours are the variables of its theme, `--ink`,
/// `--quiet`, `--line` and `--paper`, and those of `svg_style`; else those for white paper.
std::string svg_rules(bool themed);

// Dimensions of a drawn figure. Pixels are those of the SVG; a PNG has twice as many. Printed 170 mm wide, the text has
// 8 pt.

inline constexpr int kImageWidth = 900;
inline constexpr int kHalfWidth = 450;  ///< Width of a single panel, as on a phone.
inline constexpr int kFontSize = 15;
inline constexpr double kSlope = 0.6;  ///< Slope of slanted texts below an axis: height over length.

/// A text in at most two lines of this width in pixels; a longer one loses its middle.
std::vector<std::string> fitted_lines(std::string_view text, int pixels);

/// Distance of the ticks of a linear axis, as in `ticks_of`.
double tick_step(const Axis& axis, int pixels, bool is_horizontal);

/// Positions of numbers along an axis with known range, as many as fit in a panel of that size; for an axis without its
/// own ticks.
std::vector<double> ticks_of(const Axis& axis, int pixels, bool is_horizontal);

/// Width in pixels of the longest text of a tick; 0 if all are numbers.
double longest_text(const Axis& axis);

/// Whether the texts of ticks along x do not fit side by side.
bool is_crowded(const Axis& axis, int pixels);

/// Rectangle in pixels from the upper left of the image.
struct Box {
  int left = 0, right = 0, top = 0, bottom = 0;

  int width() const { return right - left; }
  int height() const { return bottom - top; }
};

/// Positions of panels, colour bar and legend in the image.
class Layout {
 public:
  explicit Layout(const Figure& figure, int image_width = kImageWidth);

  int width() const { return width_; }
  int height() const { return height_; }
  Box panel(std::size_t index) const;
  Box legend_entry(std::size_t index) const;
  Box colour_bar() const;
  bool is_leftmost(std::size_t index) const { return column(index) == 0; }
  bool is_lowest(std::size_t index) const;

 private:
  bool is_overview(std::size_t index) const { return overview_ && index == 0; }
  int column(std::size_t index) const;
  int row(std::size_t index) const;

  int width_ = kImageWidth, columns_ = 1, rows_ = 1, panels_ = 1;
  bool overview_ = false;
  int left_ = 0, gap_ = 0, row_gap_ = 0, bottom_ = 0;
  int first_width_ = 0, other_width_ = 0, panel_height_ = 0;
  int legend_columns_ = 1, legend_entry_ = 0, legend_height_ = 0, colour_bar_room_ = 0;
  int height_ = 0;
};

/// Axes of a panel.
const Axis& x_axis(const Figure& figure, const Panel& panel);
const Axis& y_axis(const Figure& figure, const Panel& panel);

/// Axes of a panel as drawn: with a visible range, and to scale if requested.
std::pair<Axis, Axis> drawn_axes(const Figure& figure, const Layout& layout, std::size_t index);

/// Conversion of coordinates to pixels along one side of a panel.
struct Ruler {
  double from = 0.0, to = 1.0;
  int start = 0, end = 1;
  bool logarithmic = false;

  double operator()(double value) const {
    const double share = logarithmic ? std::log(value / from) / std::log(to / from) : (value - from) / (to - from);
    return start + share * (end - start);
  }
  /// Coordinate of a pixel.
  double value_at(double pixel) const {
    const double share = (pixel - start) / (end - start);
    return logarithmic ? from * std::pow(to / from, share) : from + share * (to - from);
  }
};

/// A panel at its position, with the ranges of its axes.
struct Frame {
  const Panel& panel;
  Box box;
  Axis x, y;
  Ruler across, up;
};

/// The figure with its free axes fitted to the data, as the following functions require.
Figure with_ranges(Figure figure);

Frame frame_of(const Figure& figure, const Layout& layout, std::size_t index);

}  // namespace prs
