#pragma once

#include <cmath>
#include <string_view>
#include <utility>

#include "prs/record/figure.h"

// Texts, ticks and places of a drawn figure. Pixels are those of the SVG; a PNG has twice as many.
// Printed 170 mm wide, the text has 8 pt.

namespace prs {

inline constexpr int kImageWidth = 900;
inline constexpr int kHalfWidth = 450;  ///< Width of a single panel, as a phone shows it.
inline constexpr int kFontSize = 15;
inline constexpr double kSlope = 0.6;  ///< Slope of slanted texts below an axis: down per length.

/// A text in at most two lines that fit in so many pixels; what is too long loses its middle.
std::vector<std::string> fitted_lines(std::string_view text, int pixels);

bool has_range(const Axis& axis);

/// Distance of the ticks of an axis that is not logarithmic, as `ticks_of` has them.
double tick_step(const Axis& axis, int pixels, bool is_horizontal);

/// Positions of numbers along an axis whose range is known, with room for them in a panel of that
/// size; without ticks of its own.
std::vector<double> ticks_of(const Axis& axis, int pixels, bool is_horizontal);

/// Pixels of the longest text of a tick; 0 where all are numbers.
double longest_text(const Axis& axis);

/// Pixels of the longest tick.
double longest_tick(const Axis& axis, int pixels, bool is_horizontal);

/// Whether the texts of ticks along x do not fit side by side.
bool is_crowded(const Axis& axis, int pixels);

/// Pixels from the upper left of the image.
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

/// The axes of a panel.
const Axis& x_axis(const Figure& figure, const Panel& panel);
const Axis& y_axis(const Figure& figure, const Panel& panel);

/// Axes of a panel as they are drawn: with a range that can be seen, and to scale where that is
/// asked for.
std::pair<Axis, Axis> drawn_axes(const Figure& figure, const Layout& layout, std::size_t index);

/// Along one side of a panel: from coordinates to pixels.
struct Ruler {
  double from = 0.0, to = 1.0;
  int start = 0, end = 1;
  bool logarithmic = false;

  double operator()(double value) const {
    const double share =
        logarithmic ? std::log(value / from) / std::log(to / from) : (value - from) / (to - from);
    return start + share * (end - start);
  }
  /// And back.
  double value_at(double pixel) const {
    const double share = (pixel - start) / (end - start);
    return logarithmic ? from * std::pow(to / from, share) : from + share * (to - from);
  }
};

/// A panel in its place, its axes with their ranges.
struct Frame {
  const Panel& panel;
  Box box;
  Axis x, y;
  Ruler across, up;
};

/// The figure with its free axes fitted to what is shown. What follows needs it.
Figure with_ranges(Figure figure);

Frame frame_of(const Figure& figure, const Layout& layout, std::size_t index);

}  // namespace prs
