#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "prs/figures/figure.h"

// Texts, ticks and places of a drawn figure, for every renderer. Layout in pixels of the SVG; a PNG
// has twice as many. Printed 170 mm wide, the text has 8 pt.
namespace prs {

inline constexpr int kImageWidth = 900;
inline constexpr int kHalfWidth = 450;  ///< Of a panel by itself, as a phone shows it.
inline constexpr int kFontSize = 15;
inline constexpr int kCharacter = 8;  ///< Mean width of one.

/// Those of `Colour`, and their light shades.
inline constexpr std::string_view kColours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                "#e69f00", "#56b4e9", "#000000", "#7f7f7f",
                                                "#555555", "#aaaaaa", "#cc3311"};
inline constexpr std::string_view kPaleColours[] = {"#c9dfef", "#f6d9c6", "#cdebdf", "#f3dfe9",
                                                    "#f9e7c3", "#d9edfa", "#d0d0d0", "#dddddd",
                                                    "#d5d5d5", "#eeeeee", "#f3cfc8"};
/// Of colour scales: from the least to the largest value, in equal steps.
inline constexpr std::string_view kScaleColours[] = {"#ffffe5", "#fee391", "#fec44f", "#ec7014",
                                                     "#cc4c02"};
/// Of `Weight`: of lines, and of marks.
inline constexpr double kLineWidths[] = {1.0, 1.6, 2.4};
inline constexpr double kMarkSizes[] = {0.4, 0.75, 1.1};

/// The entry of a table by an enumerator.
template <class Table, class Value>
const auto& look(const Table& table, Value value) {
  return table[static_cast<std::size_t>(value)];
}

/// A text in at most two lines that fit in so many pixels; what is too long loses its middle.
std::vector<std::string> fitted_lines(std::string_view text, int pixels);

bool has_range(const Axis& axis);

/// Distance of the ticks of an axis that is not logarithmic, as `ticks_of` has them.
double tick_step(const Axis& axis, int pixels, bool is_horizontal);

/// Where numbers stand along an axis whose range is known, with room for them in a panel of that
/// size; without ticks of its own.
std::vector<double> ticks_of(const Axis& axis, int pixels, bool is_horizontal);

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
  explicit Layout(const Figure& figure, int image_width = kImageWidth);

  int width() const { return width_; }
  int height() const { return height_; }
  int legend_columns() const { return legend_columns_; }
  Box panel(std::size_t index) const;
  Box legend() const { return {0, width_, height_ - legend_height_, height_}; }
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
  int legend_columns_ = 1, legend_height_ = 0, colour_bar_room_ = 0;
  int height_ = 0;
};

/// The axes of a panel.
const Axis& x_axis(const Figure& figure, const Panel& panel);
const Axis& y_axis(const Figure& figure, const Panel& panel);

/// Axes of a panel as they are drawn: with a range that can be seen, and to scale where that is
/// asked for. What is free stays so.
std::pair<Axis, Axis> drawn_axes(const Figure& figure, const Layout& layout, std::size_t index);

}  // namespace prs
