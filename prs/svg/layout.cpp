#include "prs/svg/layout.h"

#include <algorithm>

#include "prs/record/figure_parts.h"
#include "prs/svg/elements.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr int kRight = 34, kTop = 70, kRowGap = 46, kTitleGap = 34, kBottom = 34, kLabel = 44;
constexpr int kTickHeight = 36, kMostTicks = 9;
constexpr int kLegendRow = 25, kLegendMargin = 14, kLegendSymbol = 70;
constexpr int kColourBarHeight = 14, kColourBarRoom = 78;  // The room with numbers and label.
constexpr double kColourBarWidth = 0.5;                    // Share of the image.
constexpr double kBetweenTicks = 14.0;                     // Pixels, at least.

/// At which at most `count` ticks fit in the length.
double tick_distance(double length, int count, bool whole) {
  const double distance = round_step(length / std::max(1, count));
  return whole ? std::max(1.0, std::round(distance)) : distance;
}

/// Pixels of the numbers at both ends.
double longest_number(const Axis& axis, double distance) {
  return std::max(text_width(tick_text(distance * std::round(axis.from / distance), distance)),
                  text_width(tick_text(distance * std::round(axis.to / distance), distance)));
}

/// 1, 2 and 5 of each decade, or fewer.
std::vector<double> logarithmic_ticks(const Axis& axis, int pixels, bool is_horizontal) {
  const std::size_t most = std::max<std::size_t>(
      2, static_cast<std::size_t>(pixels / (is_horizontal ? 48 : kTickHeight)));
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

/// What ticks and label take beside a panel.
int room_left(const Figure& figure, const Panel& panel, int height, bool labelled) {
  const Axis& axis = y_axis(figure, panel);
  if (axis.hidden || panel.surface) return 0;
  const bool has_label = (labelled || panel.y) && !axis.label.empty();
  const std::size_t lines = has_label ? fitted_lines(text_of(axis), height).size() : 0;
  return static_cast<int>(longest_tick(axis, height, false)) + (has_label ? 28 : 14) +
         kLineHeight * static_cast<int>(lines);
}

/// A little more about its middle where there is no range to see.
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
    if (length / distance * (longest_number(axis, distance) + kBetweenTicks) <= pixels)
      return distance;
  }
  return tick_distance(length, 1, axis.whole);
}

std::vector<std::string> fitted_lines(std::string_view content, int pixels) {
  const std::string whole = printable(content);
  const double all = text_width(whole);
  if (all <= pixels) return {whole};
  const auto letters = static_cast<double>(width(whole));
  const auto most = static_cast<std::size_t>(std::max(8.0, 0.97 * letters * pixels / all));
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

double longest_text(const Axis& axis) {
  double longest = 0.0;
  for (const Tick& tick : axis.ticks) longest = std::max(longest, text_width(tick.text));
  return longest;
}

bool is_crowded(const Axis& axis, int pixels) {
  const auto count = static_cast<double>(axis.ticks.size());
  return longest_text(axis) > 0.0 && count * (longest_text(axis) + 8.0) > pixels;
}

double longest_tick(const Axis& axis, int pixels, bool is_horizontal) {
  if (axis.hidden) return 0.0;
  double longest = longest_text(axis);
  if (!axis.ticks.empty()) {
    for (const Tick& tick : axis.ticks)
      if (tick.text.empty()) longest = std::max(longest, text_width(tick_text(tick.at, 0.0)));
  } else {
    const double step = axis.logarithmic ? 0.0 : tick_step(axis, pixels, is_horizontal);
    for (const double tick : ticks_of(axis, pixels, is_horizontal))
      longest = std::max(longest, text_width(tick_text(tick, step)));
  }
  return longest;
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
  const double first = overview_ ? figure.overview : 1.0;
  const double usual = overview_                                ? 0.75
                       : columns_ == 1 && width_ == kImageWidth ? 0.5
                       : columns_ <= 2                          ? 0.65
                                                                : 0.8;
  const double aspect = figure.aspect > 0.0 ? figure.aspect : usual;
  // The height of a panel follows from its width, and how labels break from that height.
  for (int pass = 0; pass < 3; ++pass) {
    const int height = pass == 0 ? 240 : panel_height_;
    left_ = 40;
    gap_ = columns_ > 1 ? 34 : 0;
    for (std::size_t k = 0; k < figure.panels.size(); ++k)
      if (column(k) == 0)
        left_ = std::max(left_, room_left(figure, figure.panels[k], height, true));
      else
        gap_ = std::max(gap_, room_left(figure, figure.panels[k], height, false) + 14);
    const double widths = width_ - left_ - kRight - (columns_ - 1) * gap_;
    other_width_ = static_cast<int>(widths / (first + columns_ - 1));
    panel_height_ = static_cast<int>(other_width_ * aspect);
  }
  first_width_ = static_cast<int>(other_width_ * first);
  int slanted = 0;
  for (const Panel& panel : figure.panels)
    if (const Axis& x = x_axis(figure, panel); is_crowded(x, other_width_))
      slanted = std::max(slanted, static_cast<int>(kSlope * longest_text(x)));
  row_gap_ = kRowGap + (titled ? kTitleGap : 0) + (own_x ? kLabel + slanted : 0);
  const bool bare =
      std::ranges::all_of(figure.panels, [&](const Panel& p) { return x_axis(figure, p).hidden; });
  bottom_ = bare ? kLegendMargin : kBottom + kLabel + slanted;
  double longest = 0.0;
  for (const LegendEntry& entry : figure.legend)
    longest = std::max(longest, text_width(entry.title));
  legend_entry_ = std::min(width_ - 40, kLegendSymbol + static_cast<int>(longest));
  const int entries = static_cast<int>(figure.legend.size());
  legend_columns_ = std::clamp((width_ - 40) / legend_entry_, 1, std::max(1, entries));
  legend_height_ =
      entries == 0 ? kLegendMargin
                   : (entries + legend_columns_ - 1) / legend_columns_ * kLegendRow + kLegendMargin;
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

Box Layout::legend_entry(std::size_t index) const {
  const int columns = legend_columns_, k = static_cast<int>(index);
  const int left = (width_ - columns * legend_entry_) / 2 + k % columns * legend_entry_ + 12;
  const int top = height_ - legend_height_ + k / columns * kLegendRow;
  return {left, left + legend_entry_ - 24, top, top + kLegendRow};
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

namespace {

constexpr double kLooseEnds = 0.04;  // Room at the ends of a free axis.

/// All that a panel shows along one axis, 0 for x.
Range shown_range(const Panel& panel, std::size_t axis) {
  Range range;
  for (const Series& series : panel.series)
    for (const Polyline& part : series.parts)
      for (const auto& point : part) range.include(point[axis]);
  for (const ReferenceLine& line : panel.references)
    if (line.vertical == (axis == 0)) range.include(line.at);
  const GridData& grid = panel.surface ? panel.surface->grid : panel.map.grid;
  for (const double node : axis == 0 ? grid.x : grid.y) range.include(node);
  return range;
}

void fit(Axis& axis, Range range) {
  if (has_range(axis)) return;
  if (range.empty()) range = {0.0, 1.0};
  if (!axis.logarithmic) range.widen(kLooseEnds);
  if (range.from == range.to) range = {range.from - 1.0, range.to + 1.0};
  if (!std::isfinite(axis.from)) axis.from = range.from;
  if (!std::isfinite(axis.to)) axis.to = range.to;
}

/// A free axis of the figure, over what all panels that share it show, and those of panels.
void fit(Figure& figure, Axis& shared, std::optional<Axis> Panel::*own, std::size_t axis) {
  Range all;
  for (Panel& panel : figure.panels)
    if (std::optional<Axis>& its = panel.*own)
      fit(*its, shown_range(panel, axis));
    else
      all.include(shown_range(panel, axis));
  fit(shared, all);
}

}  // namespace

Figure with_ranges(Figure figure) {
  fit(figure, figure.x, &Panel::x, 0);
  fit(figure, figure.y, &Panel::y, 1);
  return figure;
}

Frame frame_of(const Figure& figure, const Layout& layout, std::size_t index) {
  const auto [x, y] = drawn_axes(figure, layout, index);
  const Box box = layout.panel(index);
  return {figure.panels[index],
          box,
          x,
          y,
          {x.from, x.to, box.left, box.right, x.logarithmic},
          {y.from, y.to, box.bottom, box.top, y.logarithmic}};
}

}  // namespace prs
