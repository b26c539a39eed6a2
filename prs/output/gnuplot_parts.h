#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "prs/figures/figure.h"

// Text, ticks and places of what gnuplot draws. Layout in pixels of the SVG; the PNG has twice as
// many. Printed 170 mm wide, the text has 8 pt.
namespace prs {

inline constexpr int kImageWidth = 900;
inline constexpr int kCharacter = 8;  ///< Mean width of one.

/// A gnuplot string in which nothing is interpreted: what means something to gnuplot becomes an
/// octal escape. (Single quotes would not do: gnuplot 5.4 takes a leading doubled quote for the
/// end.)
std::string gnuplot_string(std::string_view text);

/// A string in at most two lines that fit in so many pixels; what is too long loses its middle.
std::string gnuplot_fitted(std::string_view text, int pixels);

/// Ticks as `set xtics` takes them, with room for their numbers in a panel of that size.
std::string gnuplot_ticks(const Axis& axis, int pixels, bool is_horizontal);

/// Characters of the longest text of a tick; 0 where all are numbers.
std::size_t longest_text(const Axis& axis);

/// Characters of the longest tick.
int longest_tick(const Axis& axis, int pixels, bool is_horizontal);

/// Whether the texts of ticks along x do not fit side by side.
bool is_crowded(const Axis& axis, int pixels);

/// Pixels from the upper left of the image.
struct Box {
  int left = 0, right = 0, top = 0, bottom = 0;

  int width() const { return right - left; }
  int height() const { return bottom - top; }
};

/// Where panels, colour bar and legend lie in the image.
class Layout {
 public:
  explicit Layout(const Figure& figure);

  int height() const { return height_; }
  int legend_columns() const { return legend_columns_; }
  Box panel(std::size_t index) const;
  Box legend() const { return {0, kImageWidth, height_ - legend_height_, height_}; }
  Box colour_bar() const;
  bool is_leftmost(std::size_t index) const { return column(index) == 0; }
  bool is_lowest(std::size_t index) const;

 private:
  bool is_overview(std::size_t index) const { return overview_ && index == 0; }
  int column(std::size_t index) const;
  int row(std::size_t index) const;

  int columns_ = 1, rows_ = 1, panels_ = 1;
  bool overview_ = false;
  int left_ = 0, gap_ = 0, row_gap_ = 0, bottom_ = 0;
  int first_width_ = 0, other_width_ = 0, panel_height_ = 0;
  int legend_columns_ = 1, legend_height_ = 0, colour_bar_room_ = 0;
  int height_ = 0;
};

/// The axes of a panel.
const Axis& x_axis(const Figure& figure, const Panel& panel);
const Axis& y_axis(const Figure& figure, const Panel& panel);

}  // namespace prs
