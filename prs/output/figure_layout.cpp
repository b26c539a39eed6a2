#include "prs/output/figure_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "prs/figures/figure_parts.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr int kRight = 34, kTop = 70, kRowGap = 46, kTitleGap = 34, kBottom = 34, kLabel = 44;
constexpr int kTickHeight = 36, kMostTicks = 9;
constexpr int kLegendRow = 25, kLegendMargin = 14, kLegendSymbol = 75;
constexpr int kColourBarHeight = 14, kColourBarRoom = 78;  // The room with numbers and label.
constexpr double kColourBarWidth = 0.5;                    // Share of the image.
constexpr double kFreeCharacters = 6.0;

/// At which at most `count` ticks fit in the length.
double tick_distance(double length, int count, bool whole) {
  const double distance = round_step(length / std::max(1, count));
  return whole ? std::max(1.0, std::round(distance)) : distance;
}

int characters(double number) { return static_cast<int>(fmt::format("{:g}", number).size()); }

/// Characters of the numbers at both ends.
int longest_number(const Axis& axis, double distance) {
  return std::max(characters(distance * std::round(axis.from / distance)),
                  characters(distance * std::round(axis.to / distance)));
}

/// 1, 2 and 5 of each decade, or fewer.
std::vector<double> logarithmic_ticks(const Axis& axis, int pixels, bool is_horizontal) {
  const std::size_t most = std::max<std::size_t>(
      2, static_cast<std::size_t>(pixels / (is_horizontal ? 6 * kCharacter : kTickHeight)));
  std::vector<double> ticks;
  const double first = std::floor(std::log10(axis.from)), last = std::ceil(std::log10(axis.to));
  for (const std::vector<double>& digits : {std::vector{1.0, 2.0, 5.0}, std::vector{1.0}})
    for (double stride = 1.0; stride <= 16.0; stride *= 2.0) {
      if (digits.size() > 1 && stride > 1.0) break;
      ticks.clear();
      for (double decade = first; decade <= last; decade += stride)
        for (const double digit : digits)
          if (const double tick = digit * std::pow(10.0, decade);
              tick >= axis.from * (1.0 - 1e-9) && tick <= axis.to * (1.0 + 1e-9))
            ticks.push_back(tick);
      if (ticks.size() <= most) return ticks;
    }
  return ticks;
}

template <class AxisOf>
int room_left(const Figure& figure, int image, AxisOf axis_of, bool first_column, bool labelled) {
  int room = 0;
  for (std::size_t k = 0; k < figure.panels.size(); ++k) {
    if ((k % figure.columns == 0) != first_column) continue;
    const Axis& axis = axis_of(figure, figure.panels[k]);
    if (axis.hidden) continue;
    const bool has_label = (labelled || figure.panels[k].y) && !axis.label.empty();
    // Two lines where the panel is too low for one.
    const int height = image < kImageWidth   ? 220
                       : figure.columns == 1 ? 400
                       : figure.columns == 2 ? 270
                                             : 180;
    const bool wraps = kCharacter * static_cast<int>(width(text_of(axis))) > height;
    const int label = !has_label ? 18 : wraps ? 82 : 62;
    room = std::max(room, kCharacter * longest_tick(axis, 240, false) + label);
  }
  return room;
}

/// A little more about its middle where gnuplot would see no range.
Axis with_length(Axis axis) {
  constexpr double kLeast = 2e-6;  // Of the numbers, which are written with seven digits.
  if (!(std::isfinite(axis.from) && std::isfinite(axis.to)) || axis.logarithmic) return axis;
  const double size = std::max(std::abs(axis.from), std::abs(axis.to));
  const double margin = size > 0.0 ? kLeast * size : 1.0;
  if (std::abs(axis.to - axis.from) > margin) return axis;
  axis.from -= margin;
  axis.to += margin;
  return axis;
}

/// Widens the range about its middle to that length.
void widen(Axis& axis, double length) {
  const double margin = std::max(0.0, 0.5 * (length - (axis.to - axis.from)));
  axis.from -= margin;
  axis.to += margin;
}

}  // namespace

bool has_range(const Axis& axis) { return std::isfinite(axis.from) && std::isfinite(axis.to); }

double tick_step(const Axis& axis, int pixels, bool is_horizontal) {
  const double length = std::abs(axis.to - axis.from);
  if (!is_horizontal)
    return tick_distance(length, std::min(kMostTicks, pixels / kTickHeight), axis.whole);
  for (int count = kMostTicks; count > 1; --count) {
    const double distance = tick_distance(length, count, axis.whole);
    if (length / distance * kCharacter * (longest_number(axis, distance) + 1.5) <= pixels)
      return distance;
  }
  return tick_distance(length, 1, axis.whole);
}

std::vector<std::string> fitted_lines(std::string_view text, int pixels) {
  const auto most = static_cast<std::size_t>(std::max(8, pixels / kCharacter));
  const std::string whole = printable(text);
  if (width(whole) <= most) return {whole};
  const std::string lines = wrapped(whole, "", most);
  const std::string first = lines.substr(0, lines.find('\n'));
  if (first.size() + 1 >= whole.size()) return {shortened(whole, most)};
  return {shortened(first, most), shortened(whole.substr(first.size() + 1), most)};
}

std::vector<double> ticks_of(const Axis& axis, int pixels, bool is_horizontal) {
  if (axis.logarithmic) return logarithmic_ticks(axis, pixels, is_horizontal);
  const double distance = tick_step(axis, pixels, is_horizontal);
  std::vector<double> ticks;
  const double least = std::min(axis.from, axis.to), most = std::max(axis.from, axis.to);
  for (double k = std::ceil(least / distance - 1e-9); k * distance <= most + 1e-9 * distance; ++k)
    ticks.push_back(k * distance);
  return ticks;
}

std::size_t longest_text(const Axis& axis) {
  std::size_t longest = 0;
  for (const Tick& tick : axis.ticks) longest = std::max(longest, width(tick.text));
  return longest;
}

bool is_crowded(const Axis& axis, int pixels) {
  const auto count = static_cast<int>(axis.ticks.size());
  return count > 0 && longest_text(axis) > 0 &&
         count * kCharacter * (static_cast<int>(longest_text(axis)) + 1) > pixels;
}

int longest_tick(const Axis& axis, int pixels, bool is_horizontal) {
  if (axis.hidden) return 0;
  if (const std::size_t text = longest_text(axis); text > 0) return static_cast<int>(text);
  if (!has_range(axis)) return static_cast<int>(kFreeCharacters);
  if (axis.logarithmic) {
    std::size_t longest = 1;
    for (const double tick : logarithmic_ticks(axis, pixels, is_horizontal))
      longest = std::max(longest, fmt::format("{:g}", tick).size());
    return static_cast<int>(longest);
  }
  return longest_number(axis, tick_step(axis, pixels, is_horizontal));
}

const Axis& x_axis(const Figure& figure, const Panel& panel) {
  return panel.x ? *panel.x : figure.x;
}
const Axis& y_axis(const Figure& figure, const Panel& panel) {
  return panel.y ? *panel.y : figure.y;
}

Layout::Layout(const Figure& figure, int image_width)
    : width_(image_width),
      columns_(static_cast<int>(figure.columns)),
      panels_(static_cast<int>(figure.panels.size())),
      overview_(figure.overview > 0.0) {
  const int cells = panels_ - (overview_ ? 1 : 0);
  const int cell_columns = std::max(1, columns_ - (overview_ ? 1 : 0));
  rows_ = (cells + cell_columns - 1) / cell_columns;
  const bool own_x =
      std::ranges::any_of(figure.panels, [](const Panel& p) { return p.x.has_value(); });
  const bool titled =
      std::ranges::any_of(figure.panels, [](const Panel& p) { return !p.title.empty(); });
  left_ = std::max(40, room_left(figure, width_, y_axis, true, true));
  gap_ = columns_ > 1 ? std::max(34, room_left(figure, width_, y_axis, false, false) + 12) : 0;
  if (std::ranges::any_of(figure.panels, [](const Panel& p) { return p.surface.has_value(); }))
    gap_ += 40;  // A title of z.
  const double first = overview_ ? figure.overview : 1.0;
  const double widths = width_ - left_ - kRight - (columns_ - 1) * gap_;
  other_width_ = static_cast<int>(widths / (first + columns_ - 1));
  first_width_ = static_cast<int>(other_width_ * first);
  const double usual = overview_                                ? 0.75
                       : columns_ == 1 && width_ == kImageWidth ? 0.5
                       : columns_ <= 2                          ? 0.65
                                                                : 0.8;
  panel_height_ = static_cast<int>(other_width_ * (figure.aspect > 0.0 ? figure.aspect : usual));
  int slanted = 0;
  for (const Panel& panel : figure.panels)
    if (const Axis& x = x_axis(figure, panel); is_crowded(x, other_width_))
      slanted =
          std::max(slanted, static_cast<int>(0.6 * kCharacter) * static_cast<int>(longest_text(x)));
  row_gap_ = kRowGap + (titled ? kTitleGap : 0) + (own_x ? kLabel + slanted : 0);
  const bool bare =
      std::ranges::all_of(figure.panels, [&](const Panel& p) { return x_axis(figure, p).hidden; });
  bottom_ = bare ? kLegendMargin : kBottom + kLabel + slanted;
  std::size_t longest = 0;
  for (const LegendEntry& entry : figure.legend)
    longest = std::max(longest, prs::width(entry.title));
  const int entry_width = kLegendSymbol + (kCharacter + 1) * static_cast<int>(longest);
  const int entries = static_cast<int>(figure.legend.size());
  legend_columns_ = std::clamp((width_ - 40) / entry_width, 1, std::max(1, entries));
  legend_height_ = (entries + legend_columns_ - 1) / legend_columns_ * kLegendRow + kLegendMargin;
  colour_bar_room_ = figure.colours ? kColourBarRoom : 0;
  const int below = kTop + rows_ * panel_height_ + (rows_ - 1) * row_gap_ + bottom_;
  height_ = below + colour_bar_room_ + legend_height_;
}

int Layout::column(std::size_t index) const {
  if (!overview_) return static_cast<int>(index) % columns_;
  return index == 0 ? 0 : 1 + (static_cast<int>(index) - 1) % (columns_ - 1);
}

int Layout::row(std::size_t index) const {
  if (!overview_) return static_cast<int>(index) / columns_;
  return index == 0 ? 0 : (static_cast<int>(index) - 1) / (columns_ - 1);
}

bool Layout::is_lowest(std::size_t index) const {
  return is_overview(index) || static_cast<int>(index) + columns_ - (overview_ ? 1 : 0) >= panels_;
}

Box Layout::panel(std::size_t index) const {
  const int c = column(index), last_row = is_overview(index) ? rows_ - 1 : row(index);
  const auto top_of = [&](int row) { return kTop + row * (panel_height_ + row_gap_); };
  const int left =
      left_ + (c > 0 ? first_width_ + gap_ : 0) + std::max(0, c - 1) * (other_width_ + gap_);
  return {left, left + (c == 0 ? first_width_ : other_width_), top_of(row(index)),
          top_of(last_row) + panel_height_};
}

Box Layout::colour_bar() const {
  const int top = height_ - legend_height_ - colour_bar_room_;
  const auto margin = static_cast<int>(0.5 * (1.0 - kColourBarWidth) * width_);
  return {margin, width_ - margin, top, top + kColourBarHeight};
}

std::pair<Axis, Axis> drawn_axes(const Figure& figure, const Layout& layout, std::size_t index) {
  const Panel& panel = figure.panels[index];
  const Box box = layout.panel(index);
  Axis x = with_length(x_axis(figure, panel)), y = with_length(y_axis(figure, panel));
  if (figure.to_scale) {
    const double unit = std::min(box.width() / (x.to - x.from), box.height() / (y.to - y.from));
    widen(x, box.width() / unit);
    widen(y, box.height() / unit);
  }
  return {std::move(x), std::move(y)};
}

}  // namespace prs
