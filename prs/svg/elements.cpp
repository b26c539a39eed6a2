#include "prs/svg/elements.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "prs/indices.h"
#include "prs/record/pictures.h"
#include "prs/text.h"

namespace prs {
namespace {

struct Escape {
  char of;
  std::string_view text;
};
constexpr std::array<Escape, 5> kEscapes{
    {{'<', "&lt;"}, {'>', "&gt;"}, {'&', "&amp;"}, {'"', "&quot;"}, {'\'', "&#39;"}}};

constexpr std::string_view kDashes[] = {"", "", "7 5", "2 4", "9 4 2 4"};
constexpr std::size_t kContinuous = 128;

int channel_of(std::string_view colour, std::size_t channel) {
  int level = 0;
  std::from_chars(&colour[1 + 2 * channel], &colour[1 + 2 * channel] + 2, level, 16);
  return level;
}

/// Colour at a share of the scale's length.
std::string colour_at(double share) {
  constexpr auto kLast = static_cast<double>(std::size(kScaleColours) - 1);
  const double at = std::clamp(share, 0.0, 1.0) * kLast;
  const auto k = static_cast<std::size_t>(std::min(std::floor(at), kLast - 1.0));
  std::string colour = "#";
  for (const auto channel : up_to(3))
    colour += fmt::format(
        "{:02x}", std::lround(std::lerp(channel_of(kScaleColours[k], channel),
                                        channel_of(kScaleColours[k + 1], channel), at - static_cast<double>(k))));
  return colour;
}

}  // namespace

std::string html(std::string_view content) {
  if (is_plain_lines(content) && content.find_first_of("<>&\"'\n") == content.npos) return std::string(content);
  std::string escaped;
  for (const char c : printable(content))
    if (const auto* known = std::ranges::find(kEscapes, c, &Escape::of); known != kEscapes.end())
      escaped += known->text;
    else
      escaped += c;
  return escaped;
}

std::string tenth_of(double value) {
  char digits[24];
  const long tenths = std::lround(10.0 * std::clamp(value, -1e7, 1e7));
  char* end = digits;
  if (tenths < 0) *end++ = '-';
  end = std::to_chars(end, std::end(digits), std::abs(tenths) / 10).ptr;
  *end++ = '.';
  *end++ = static_cast<char>('0' + std::abs(tenths) % 10);
  return {digits, end};
}

void append_tenths(std::string& d, long n, bool first) {
  char digits[24];
  char* end = digits;
  if (n < 0)
    *end++ = '-';
  else if (!first)
    *end++ = ' ';
  const long size = std::abs(n);
  if (size >= 10 || size == 0) end = std::to_chars(end, std::end(digits), size / 10).ptr;
  if (size % 10 != 0) {
    *end++ = '.';
    *end++ = static_cast<char>('0' + size % 10);
  }
  d.append(digits, end);
}

std::string tick_text(double value, double step) {
  const double size = std::abs(value);
  if (step > 0.0 && size < 1e-9 * step) value = 0.0;
  std::string shown = fmt::format("{:.6g}", value);
  if (shown.starts_with('-')) shown.replace(0, 1, "\u2212");
  return shown;
}

std::string text(double x, double y, std::string_view classes, std::string_view content, std::string_view more) {
  std::string all = "<text x=\"" + tenth_of(x) + "\" y=\"" + tenth_of(y) + "\" class=\"";
  return all.append(classes).append("\"").append(more).append(">") + html(content) + "</text>";
}

std::string texts(double x, double y, std::string_view classes, const std::vector<std::string>& lines,
                  std::string_view more) {
  std::string all;
  for (const auto k : indices(lines))
    if (!lines[k].empty())
      all += text(x, y - kLineHeight * static_cast<double>(lines.size() - 1 - k), classes, lines[k], more);
  return all;
}

std::string turned(double x, double y, int angle) {
  return " transform=\"rotate(" + std::to_string(angle) + " " + tenth_of(x) + " " + tenth_of(y) + ")\"";
}

std::string segment(double x1, double y1, double x2, double y2, std::string_view attributes) {
  std::string all = "<path d=\"M" + tenth_of(x1) + " " + tenth_of(y1) + "L" + tenth_of(x2) + " " + tenth_of(y2) + "\" ";
  return all.append(attributes).append("/>");
}

namespace {

/// Advance widths of ASCII from the space on, in thousandths of the font's size: DejaVu Sans, which
/// Linux takes where it has neither Helvetica nor Arial, and which is wider than both.
constexpr short kWidths[] = {318,  401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361, 318, 337,
                             636,  636, 636, 636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531,
                             1000, 684, 686, 698, 770, 632, 575, 775, 752, 295, 295, 656, 557, 863, 748, 787,
                             603,  787, 695, 635, 611, 732, 684, 989, 685, 611, 685, 390, 337, 390, 838, 500,
                             500,  613, 635, 550, 635, 615, 352, 635, 634, 278, 278, 579, 278, 974, 634, 612,
                             635,  635, 411, 521, 392, 634, 592, 818, 592, 592, 525, 636, 337, 636, 838};
static_assert(std::size(kWidths) == 95);

constexpr int kOther = 700, kWide = 1000;  // Widths of letters beyond ASCII, and of those of East Asia.

}  // namespace

double text_width(std::string_view text) {
  int thousandths = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 && byte < 0xc0) continue;  // Not the first byte of a character.
    thousandths += byte >= 0xe3                  ? kWide
                   : byte >= 0xc0                ? kOther
                   : byte >= 0x20 && byte < 0x7f ? kWidths[byte - 0x20]
                                                 : 0;
  }
  return 1e-3 * kFontSize * thousandths;
}

TextBox text_box(std::string_view text, double x, double baseline, double share) {
  const double width = text_width(text);
  return {x - share * width, x + (1.0 - share) * width, baseline - 0.75 * kFontSize, baseline + 0.22 * kFontSize};
}

ScaleSteps::ScaleSteps(const ColourScale& scale) : scale_(scale) {
  const std::size_t count = scale.levels.size() > 2 ? scale.levels.size() - 1 : kContinuous;
  for (const auto k : up_to(count))
    colours_.push_back(colour_at(static_cast<double>(k) / static_cast<double>(count - 1)));
}

double ScaleSteps::place(double value) const { return scale_.logarithmic ? std::log(value) : value; }

int ScaleSteps::step(double value) const {
  if (!std::isfinite(value)) return -1;
  const int last = static_cast<int>(colours_.size()) - 1;
  const auto& levels = scale_.levels;
  if (levels.size() > 2) {
    const auto band = std::ranges::upper_bound(levels, value) - levels.begin() - 1;
    return std::clamp(static_cast<int>(band), 0, last);
  }
  const double share = (place(value) - place(scale_.from)) / (place(scale_.to) - place(scale_.from));
  return std::isfinite(share) ? static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * last)) : 0;
}

std::string stroke(const Style& style) {
  std::string attributes =
      fmt::format("class=\"s{}\" stroke-width=\"{}\"", static_cast<int>(style.colour), look(kLineWidths, style.weight));
  if (const std::string_view dash = look(kDashes, style.dash); !dash.empty())
    attributes += fmt::format(" stroke-dasharray=\"{}\"", dash);
  return attributes;
}

std::string svg_rules(bool themed) {
  const auto role = [&](const char* variable, const char* on_paper) {
    return themed ? fmt::format("var({})", variable) : std::string(on_paper);
  };
  const std::string ink = role("--ink", "#1a1a1a"), quiet = role("--quiet", "#555"), line = role("--line", "#ddd"),
                    paper = role("--paper", "#fff");
  std::string rules = fmt::format(
      "svg rect,.c{{shape-rendering:crispEdges}}\n"
      "svg{{font-size:{4}px}}\n"
      "svg text{{fill:{0}}}svg .q{{fill:{1}}}svg .m{{text-anchor:middle}}svg "
      ".e{{text-anchor:end}}svg .b{{font-weight:600}}\n"
      "svg .h{{paint-order:stroke;stroke:{3};stroke-width:4px;stroke-linejoin:round}}\n"
      ".t{{stroke:{1};stroke-width:1;fill:none}}.g{{stroke:{2};stroke-width:1}}.o{{stroke:#000;"
      "stroke-opacity:.55;stroke-width:.6}}\n"
      ".w{{stroke:#8c510a;stroke-width:.3;stroke-opacity:.5}}.l{{stroke:#8c510a;stroke-width:.7;"
      "fill:none}}svg "
      ".n{{fill:#1a1a1a;text-anchor:middle;font-size:13px;paint-order:stroke;stroke:#fff;stroke-"
      "opacity:.6;stroke-width:3px}}\n",
      ink, quiet, line, paper, kFontSize);
  for (const auto k : indices(kColours))
    rules += fmt::format(".s{0}{{stroke:{1};fill:none}}.f{0}{{fill:{1}}}.p{0}{{fill:{1};fill-opacity:.22}}\n", k,
                         themed ? fmt::format("var(--c{})", k) : std::string(kColours[k]));
  return rules;
}

namespace {

constexpr int kRight = 34, kTop = 70, kRowGap = 46, kTitleGap = 34, kBottom = 34, kLabel = 44;
constexpr int kTickHeight = 36, kMostTicks = 9;
constexpr int kLegendRow = 25, kLegendMargin = 14, kLegendSymbol = 70;
constexpr int kColourBarHeight = 14, kColourBarRoom = 78;  // Height of the bar; with numbers and label.
constexpr double kColourBarWidth = 0.5;                    // Width as a share of the image.
constexpr double kBetweenTicks = 14.0;                     // Smallest distance in pixels.

/// Distance with which at most `count` ticks fit in the length.
double tick_distance(double length, int count, bool whole) {
  const double distance = round_step(length / std::max(1, count));
  return whole ? std::max(1.0, std::round(distance)) : distance;
}

/// Width in pixels of the wider number of both ends.
double longest_number(const Axis& axis, double distance) {
  return std::max(text_width(tick_text(distance * std::round(axis.from / distance), distance)),
                  text_width(tick_text(distance * std::round(axis.to / distance), distance)));
}

/// Ticks at 1, 2 and 5 of each decade, or fewer.
std::vector<double> logarithmic_ticks(const Axis& axis, int pixels, bool is_horizontal) {
  const std::size_t most =
      std::max<std::size_t>(2, static_cast<std::size_t>(pixels / (is_horizontal ? 48 : kTickHeight)));
  std::vector<double> ticks;
  const auto [least, greatest] = std::minmax(axis.from, axis.to);
  if (!(least > 0.0 && std::isfinite(greatest))) return ticks;
  const double first = std::floor(std::log10(least)), last = std::ceil(std::log10(greatest));
  for (const std::vector<double>& digits : {std::vector{1.0, 2.0, 5.0}, std::vector{1.0}})
    for (double stride = 1.0; stride <= 512.0; stride *= 2.0) {
      if (digits.size() > 1 && stride > 1.0) break;
      ticks.clear();
      for (double decade = first; decade <= last; decade += stride)
        for (const double digit : digits)
          if (const double tick = digit * std::pow(10.0, decade);
              tick >= least * (1.0 - 1e-9) && tick <= greatest * (1.0 + 1e-9))
            ticks.push_back(tick);
      if (ticks.size() <= most) return ticks;
    }
  return ticks;
}

/// Width in pixels of the longest tick.
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

/// Axis widened about its middle if its range is too small to see.
Axis with_length(Axis axis) {
  constexpr double kLeast = 2e-6;  // Smallest range relative to the numbers, which are written with seven digits.
  if (!(std::isfinite(axis.from) && std::isfinite(axis.to)) || axis.logarithmic) return axis;
  const double size = std::max(std::abs(axis.from), std::abs(axis.to));
  const double margin = size > 0.0 ? kLeast * size : 1.0;
  if (std::abs(axis.to - axis.from) > margin) return axis;
  axis.from -= margin;
  axis.to += margin;
  return axis;
}

/// Width in pixels of ticks and label to the left of a panel.
int room_left(const Figure& figure, const Panel& panel, int height, bool labelled) {
  const Axis axis = with_length(y_axis(figure, panel));
  if (axis.hidden || panel.surface) return 0;
  const bool has_label = (labelled || panel.y) && !axis.label.empty();
  const std::size_t lines = has_label ? fitted_lines(text_of(axis), height).size() : 0;
  return static_cast<int>(longest_tick(axis, height, false)) + (has_label ? 28 : 14) +
         kLineHeight * static_cast<int>(lines);
}

/// Widens the range about its middle to that length.
void widen(Axis& axis, double length) {
  const double margin = std::max(0.0, 0.5 * (length - (axis.to - axis.from)));
  axis.from -= margin;
  axis.to += margin;
}

bool has_range(const Axis& axis) { return std::isfinite(axis.from) && std::isfinite(axis.to); }

}  // namespace

double tick_step(const Axis& axis, int pixels, bool is_horizontal) {
  const double length = std::abs(axis.to - axis.from);
  if (!is_horizontal) return tick_distance(length, std::min(kMostTicks, pixels / kTickHeight), axis.whole);
  for (int count = kMostTicks; count > 1; --count) {
    const double distance = tick_distance(length, count, axis.whole);
    if (length / distance * (longest_number(axis, distance) + kBetweenTicks) <= pixels) return distance;
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
  const double first = std::ceil(std::min(axis.from, axis.to) / distance - 1e-9);
  const double last = std::floor(std::max(axis.from, axis.to) / distance + 1e-9);
  std::vector<double> ticks;
  for (int k = 0; k <= std::min(last - first, double{kMostTicks}); ++k) ticks.push_back((first + k) * distance);
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

const Axis& x_axis(const Figure& figure, const Panel& panel) { return panel.x ? *panel.x : figure.x; }
const Axis& y_axis(const Figure& figure, const Panel& panel) { return panel.y ? *panel.y : figure.y; }

Layout::Layout(const Figure& figure, int image_width)
    : width_(image_width),
      columns_(static_cast<int>(figure.columns)),
      panels_(static_cast<int>(figure.panels.size())),
      overview_(figure.overview > 0.0) {
  const int cells = panels_ - (overview_ ? 1 : 0);
  const int cell_columns = std::max(1, columns_ - (overview_ ? 1 : 0));
  rows_ = (cells + cell_columns - 1) / cell_columns;
  const bool own_x = std::ranges::any_of(figure.panels, [](const Panel& p) { return p.x.has_value(); });
  const bool titled = std::ranges::any_of(figure.panels, [](const Panel& p) { return !p.title.empty(); });
  const double first = overview_ ? figure.overview : 1.0;
  const double usual = overview_ ? 0.75 : columns_ == 1 && width_ == kImageWidth ? 0.5 : columns_ <= 2 ? 0.65 : 0.8;
  const double aspect = figure.aspect > 0.0 ? figure.aspect : usual;
  // The height of a panel follows from its width, and the line breaks of labels from that height.
  for (int pass = 0; pass < 3; ++pass) {
    const int height = pass == 0 ? 240 : panel_height_;
    left_ = 40;
    gap_ = columns_ > 1 ? 34 : 0;
    for (const auto k : indices(figure.panels))
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
  const bool bare = std::ranges::all_of(figure.panels, [&](const Panel& p) { return x_axis(figure, p).hidden; });
  bottom_ = bare ? kLegendMargin : kBottom + kLabel + slanted;
  double longest = 0.0;
  for (const LegendEntry& entry : figure.legend) longest = std::max(longest, text_width(entry.title));
  legend_entry_ = std::min(width_ - 40, kLegendSymbol + static_cast<int>(longest));
  const int entries = static_cast<int>(figure.legend.size());
  legend_columns_ = std::clamp((width_ - 40) / legend_entry_, 1, std::max(1, entries));
  legend_height_ =
      entries == 0 ? kLegendMargin : (entries + legend_columns_ - 1) / legend_columns_ * kLegendRow + kLegendMargin;
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
  const int left = left_ + (c > 0 ? first_width_ + gap_ : 0) + std::max(0, c - 1) * (other_width_ + gap_);
  return {left, left + (c == 0 ? first_width_ : other_width_), top_of(row(index)), top_of(last_row) + panel_height_};
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

constexpr double kLooseEnds = 0.04;  // Share of empty space at the ends of a free axis.

/// Range of the data of a panel along one axis, 0 for x.
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

/// Fits a free axis of the figure to the data of all panels that share it, and the panels' own axes.
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
