#include "prs/report/svg.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "prs/figures/figure_parts.h"
#include "prs/output/figure_layout.h"
#include "prs/output/table_units.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr int kTick = 5, kTitleTop = 36, kLegendSymbol = 34;
constexpr double kMarkRadius = 5.0, kOverlap = 0.4;  // Pixels; the second hides seams of cells.
constexpr double kLooseEnds = 0.04;                  // Room at the ends of a free axis.
constexpr std::string_view kDashes[] = {"", "", "7 5", "2 4", "9 4 2 4"};

/// As `{:.1f}` has it, which pictures are full of; numbers beyond a picture need not be exact.
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

/// Red, green and blue of the scale's colours.
using Rgb = std::array<int, 3>;
std::vector<Rgb> channels_of_scale() {
  std::vector<Rgb> all;
  for (const std::string_view colour : kScaleColours) {
    Rgb& rgb = all.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      std::from_chars(&colour[1 + 2 * k], &colour[3 + 2 * k], rgb[k], 16);
  }
  return all;
}

/// A colour between those of the scale, at a share of its length, of as many as there are steps.
std::string scale_colour(const ColourScale& scale, double value, double steps = 0.0) {
  if (!std::isfinite(value)) return "none";
  const auto place = [&](double v) { return scale.logarithmic ? std::log(v) : v; };
  double share = (place(value) - place(scale.from)) / (place(scale.to) - place(scale.from));
  if (!std::isfinite(share)) share = 0.0;
  if (const auto& levels = scale.levels; levels.size() > 2) {
    const auto bands = static_cast<double>(levels.size() - 1);
    const auto band = std::ranges::upper_bound(levels, value) - levels.begin() - 1;
    share = std::clamp(static_cast<double>(band), 0.0, bands - 1.0) / (bands - 1.0);
  }
  if (steps > 0.0) share = std::round(share * steps) / steps;
  constexpr auto kLast = static_cast<double>(std::size(kScaleColours) - 1);
  const double at = std::clamp(share, 0.0, 1.0) * kLast;
  const auto k = static_cast<std::size_t>(std::min(std::floor(at), kLast - 1.0));
  static const std::vector<Rgb> channels = channels_of_scale();
  std::string colour = "#";
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const auto level = static_cast<unsigned>(std::lround(
        std::lerp(channels[k][channel], channels[k + 1][channel], at - static_cast<double>(k))));
    for (const unsigned digit : {level / 16, level % 16}) colour += "0123456789abcdef"[digit];
  }
  return colour;
}

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
};

/// A panel in its place, its axes with their ranges.
struct Frame {
  const Panel& panel;
  Box box;
  Axis x, y;
  Ruler across, up;
};

/// All that a panel shows along one axis, 0 for x.
Range shown_range(const Panel& panel, std::size_t axis) {
  Range range;
  for (const Series& series : panel.series)
    for (const Polyline& part : series.parts)
      for (const auto& point : part) range.include(point[axis]);
  for (const ReferenceLine& line : panel.references)
    if (line.vertical == (axis == 0)) range.include(line.at);
  for (const double node : axis == 0 ? panel.map.grid.x : panel.map.grid.y) range.include(node);
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

Frame frame_of(const Figure& figure, const Layout& layout, std::size_t index) {
  const Panel& panel = figure.panels[index];
  auto [x, y] = drawn_axes(figure, layout, index);
  fit(x, shown_range(panel, 0));
  fit(y, shown_range(panel, 1));
  const Box box = layout.panel(index);
  return {panel,
          box,
          x,
          y,
          {x.from, x.to, box.left, box.right, x.logarithmic},
          {y.from, y.to, box.bottom, box.top, y.logarithmic}};
}

std::string text(double x, double y, std::string_view classes, std::string_view content,
                 std::string_view more = "") {
  std::string all = "<text x=\"" + tenth_of(x) + "\" y=\"" + tenth_of(y) + "\" class=\"";
  return all.append(classes).append("\"").append(more).append(">") + html(content) + "</text>";
}

/// Lines of text, the last one at y.
std::string texts(double x, double y, std::string_view classes,
                  const std::vector<std::string>& lines, std::string_view more = "") {
  std::string all;
  for (std::size_t k = 0; k < lines.size(); ++k)
    all += text(x, y - 17.0 * static_cast<double>(lines.size() - 1 - k), classes, lines[k], more);
  return all;
}

std::string segment(double x1, double y1, double x2, double y2, std::string_view attributes) {
  std::string all = "<path d=\"M" + tenth_of(x1) + " " + tenth_of(y1) + "L" + tenth_of(x2) + " " +
                    tenth_of(y2) + "\" ";
  return all.append(attributes).append("/>");
}

std::string stroke(const Style& style) {
  std::string attributes =
      fmt::format("class=\"s{}\" stroke-width=\"{}\"", static_cast<int>(style.colour),
                  look(kLineWidths, style.weight));
  if (const std::string_view dash = look(kDashes, style.dash); !dash.empty())
    attributes += fmt::format(" stroke-dasharray=\"{}\"", dash);
  return attributes;
}

/// On which sides of a panel a point lies well outside, a bit each.
unsigned beyond(const Box& b, double x, double y) {
  constexpr double kMargin = 20.0;
  return (x < b.left - kMargin ? 1u : 0u) | (x > b.right + kMargin ? 2u : 0u) |
         (y < b.top - kMargin ? 4u : 0u) | (y > b.bottom + kMargin ? 8u : 0u);
}

/// Tenths of a unit as a path has them: short, without a space before a sign.
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

/// The way through the points, broken where one has no place. Points that only lead around outside
/// of the panel are left out.
std::string way(const Polyline& points, const Frame& f, bool closed) {
  constexpr double kFar = 1e6;  // Of what leads out of the panel.
  std::string d;
  char next = 'M';
  std::array<double, 2> at{};
  std::array<long, 2> last{};
  const auto placed = [&](std::size_t k) {
    return std::array{f.across(points[k][0]), f.up(points[k][1])};
  };
  unsigned before = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    at = placed(k);
    if (!std::isfinite(at[0]) || !std::isfinite(at[1])) {
      next = 'M';
      before = 0;
      continue;
    }
    const unsigned here = beyond(f.box, at[0], at[1]);
    unsigned after = 0;
    if (k + 1 < points.size()) {
      const auto following = placed(k + 1);
      after = beyond(f.box, following[0], following[1]);
    }
    const bool idle = (std::exchange(before, here) & here & after) != 0;
    const std::array<long, 2> tenth{std::lround(10 * std::clamp(at[0], -kFar, kFar)),
                                    std::lround(10 * std::clamp(at[1], -kFar, kFar))};
    if (next == 'l' && (idle || tenth == last)) continue;
    if (next == 'M') last = {0, 0};
    d += next;
    append_tenths(d, tenth[0] - last[0], true);
    append_tenths(d, tenth[1] - last[1], false);
    next = 'l';
    last = tenth;
  }
  return closed && !d.empty() ? d + "Z" : d;
}

std::string mark(Mark shape, double x, double y, double r) {
  const auto polygon = [&](int corners, double start, double step, double radius) {
    std::string d;
    for (int k = 0; k < corners; ++k)
      d += (k ? "L" : "M") + tenth_of(x + radius * std::sin(start + k * step)) + " " +
           tenth_of(y - radius * std::cos(start + k * step));
    return d + "Z";
  };
  constexpr double kTurn = 6.283185307179586;
  const auto cross = [&](double w, double h) {
    return fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}M{:.1f} {:.1f}L{:.1f} {:.1f}", x - w, y - h,
                       x + w, y + h, x - h, y + w, x + h, y - w);
  };
  switch (shape) {
    case Mark::square:
      return polygon(4, kTurn / 8, kTurn / 4, 1.25 * r);
    case Mark::triangle:
      return polygon(3, 0.0, kTurn / 3, 1.3 * r);
    case Mark::down:
      return polygon(3, kTurn / 2, kTurn / 3, 1.3 * r);
    case Mark::diamond:
      return polygon(4, 0.0, kTurn / 4, 1.3 * r);
    case Mark::plus:
      return cross(r, 0.0);
    case Mark::cross:
      return cross(0.8 * r, 0.8 * r);
    case Mark::star:
      return cross(r, 0.0) + cross(0.7 * r, 0.7 * r);
    default: {
      const std::string radius = tenth_of(r) + " " + tenth_of(r) + " 0 1 0 ", d = tenth_of(2 * r);
      return "M" + tenth_of(x - r) + " " + tenth_of(y) + "a" + radius + d + " 0a" + radius + "-" +
             d + " 0Z";
    }
  }
}

bool is_strokes(const Style& style) { return style.open || style.mark >= Mark::plus; }

/// A path in the style's colour, filled where the marks are.
std::string mark_path(const Style& style, const std::string& d, const std::string& colour) {
  if (d.empty()) return {};
  if (!colour.empty()) return fmt::format("<path d=\"{}\" fill=\"{}\" class=\"o\"/>", d, colour);
  return fmt::format("<path d=\"{}\" class=\"{}{}\"/>", d, is_strokes(style) ? 's' : 'f',
                     static_cast<int>(style.colour));
}

std::string arrow(const Polyline& part, const Frame& f, const Style& style) {
  if (part.size() < 2) return {};
  const double x1 = f.across(part[0][0]), y1 = f.up(part[0][1]);
  const double x2 = f.across(part[1][0]), y2 = f.up(part[1][1]);
  const double length = std::hypot(x2 - x1, y2 - y1), head = std::min(6.0, 0.6 * length);
  if (!(length > 0.5)) return {};
  const double c = head * (x2 - x1) / length, s = head * (y2 - y1) / length;
  return segment(x1, y1, x2, y2, stroke(style)) +
         fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z\" class=\"f{}\"/>", x2,
                     y2, x2 - c - 0.35 * s, y2 - s + 0.35 * c, x2 - c + 0.35 * s, y2 - s - 0.35 * c,
                     static_cast<int>(style.colour));
}

std::string series_svg(const Figure& figure, const Series& series, const Frame& f) {
  const Style& style = figure.styles[series.style];
  std::size_t longest = 0;
  for (const Polyline& part : series.parts) longest = std::max(longest, part.size());
  const bool lined = style.dash != Dash::none;
  const std::size_t stride = lined ? (longest + 11) / 12 : 1;
  const double radius = kMarkRadius * look(kMarkSizes, style.weight);
  std::string all, d, marks;
  for (std::size_t k = 0; k < series.parts.size(); ++k) {
    const Polyline& part = series.parts[k];
    const bool valued = k < series.values.size() && figure.colours.has_value();
    const std::string colour = valued ? scale_colour(*figure.colours, series.values[k]) : "";
    if (style.shape == Shape::arrows) {
      all += arrow(part, f, style);
    } else if (style.shape == Shape::area) {
      const std::string outline = way(part, f, true);
      if (valued)
        all += fmt::format("<path d=\"{}\" fill=\"{}\" class=\"o\"/>", outline, colour);
      else
        d += outline;
    } else {
      if (lined) d += way(part, f, false);
      if (style.mark == Mark::none) continue;
      std::string own;
      for (std::size_t p = 0; p < part.size(); p += std::max<std::size_t>(1, stride))
        if (const double x = f.across(part[p][0]), y = f.up(part[p][1]);
            std::isfinite(x) && std::isfinite(y))
          own += mark(style.mark, x, y, radius);
      if (valued)
        all += mark_path(style, own, colour);
      else
        marks += own;
    }
  }
  if (!d.empty() && style.shape == Shape::area)
    all += fmt::format("<path d=\"{}\" class=\"{}{}\"/>", d, style.pale ? "p" : "f",
                       static_cast<int>(style.colour));
  else if (!d.empty())
    all += fmt::format("<path d=\"{}\" {}/>", d, stroke(style));
  return all + mark_path(style, marks, "");
}

/// Half the way to the neighbours of a node, in pixels.
std::pair<double, double> cell(const std::vector<double>& nodes, std::size_t k,
                               const Ruler& ruler) {
  const auto middle = [&](std::size_t a, std::size_t b) {
    return ruler(0.5 * (nodes[a] + nodes[b]));
  };
  const double at = ruler(nodes[k]);
  const bool single = nodes.size() < 2;
  double before = k > 0 ? middle(k - 1, k) : single ? ruler.start : 2.0 * at - middle(k, k + 1);
  double behind = k + 1 < nodes.size() ? middle(k, k + 1) : single ? ruler.end : 2.0 * at - before;
  if (before > behind) std::swap(before, behind);
  const auto [least, most] = std::minmax(ruler.start, ruler.end);
  return {std::clamp<double>(before, least, most), std::clamp<double>(behind, least, most)};
}

/// Neighbouring nodes of a grid that are drawn as one, and from where to where.
struct Band {
  std::size_t node;
  long from, to;  ///< Tenths of a pixel.
};

/// Bands at least so wide that they can be seen.
std::vector<Band> bands_of(const std::vector<double>& nodes, const Ruler& ruler) {
  constexpr double kLeast = 3.0;  // Pixels.
  std::vector<Band> bands;
  for (std::size_t first = 0; first < nodes.size();) {
    auto [from, to] = cell(nodes, first, ruler);
    std::size_t last = first;
    while (to - from < kLeast && last + 1 < nodes.size()) {
      const auto [next_from, next_to] = cell(nodes, ++last, ruler);
      from = std::min(from, next_from);
      to = std::max(to, next_to);
    }
    bands.push_back(
        {(first + last) / 2, std::lround(10 * from), std::lround(10 * (to + kOverlap))});
    first = last + 1;
  }
  return bands;
}

/// A path of rectangles for each colour, runs of one colour as one rectangle. Maps of many nodes
/// are drawn no finer than a screen shows, in 64 colours.
std::string map_svg(const GridData& grid, const ColourScale& scale, const Frame& f) {
  constexpr std::size_t kMany = 4000;
  const std::vector<Band> columns = bands_of(grid.x, f.across), rows = bands_of(grid.y, f.up);
  const double steps = columns.size() * rows.size() > kMany ? 64.0 : 0.0;
  std::map<std::string, std::string> paths;
  for (const Band& column : columns)
    for (std::size_t j = 0; j < rows.size();) {
      const std::string colour = scale_colour(scale, grid.at(column.node, rows[j].node), steps);
      long top = rows[j].from, bottom = rows[j].to;
      while (++j < rows.size() &&
             scale_colour(scale, grid.at(column.node, rows[j].node), steps) == colour) {
        top = std::min(top, rows[j].from);
        bottom = std::max(bottom, rows[j].to);
      }
      if (colour == "none") continue;
      std::string& d = paths[colour];
      d += 'M';
      append_tenths(d, column.from, true);
      append_tenths(d, top, false);
      d += 'h';
      append_tenths(d, column.to - column.from, true);
      d += 'v';
      append_tenths(d, bottom - top, true);
      d += 'h';
      append_tenths(d, column.from - column.to, true);
      d += 'z';
    }
  std::string all;
  for (const auto& [colour, d] : paths)
    all += "<path class=\"c\" fill=\"" + colour + "\" d=\"" + d + "\"/>";
  return all;
}

/// A number at a tick, no finer than its step needs, with a typographic minus.
std::string tick_text(double value, double step) {
  const double size = std::abs(value);
  if (step > 0.0 && size < 1e-9 * step) value = 0.0;
  std::string shown = fmt::format("{:.6g}", value);
  if (shown.starts_with('-')) shown.replace(0, 1, "\u2212");
  return shown;
}

struct ShownTick {
  double at;
  std::string text;
};

std::vector<ShownTick> ticks_shown(const Axis& axis, int pixels, bool is_horizontal) {
  std::vector<ShownTick> ticks;
  if (axis.hidden) return ticks;
  for (const Tick& tick : axis.ticks)
    ticks.push_back({tick.at, tick.text.empty() ? tick_text(tick.at, 0.0) : tick.text});
  if (!axis.ticks.empty()) return ticks;
  const double step = axis.logarithmic ? 0.0 : tick_step(axis, pixels, is_horizontal);
  for (const double at : ticks_of(axis, pixels, is_horizontal))
    ticks.push_back({at, tick_text(at, step)});
  return ticks;
}

std::string x_axis_svg(const Frame& f, bool labelled) {
  const bool slanted = is_crowded(f.x, f.box.width());
  const double y = f.box.bottom;
  std::string all;
  for (const auto& [at, shown] : ticks_shown(f.x, f.box.width(), true)) {
    const double x = f.across(at);
    if (!(x > f.box.left - 1.0 && x < f.box.right + 1.0)) continue;
    all += segment(x, y, x, y + kTick, "class=\"t\"");
    all += slanted ? text(x, y + 18, "q", shown,
                          fmt::format(" transform=\"rotate(35 {:.1f} {:.1f})\"", x, y + 18))
                   : text(x, y + 22, "q m", shown);
  }
  if (labelled && !f.x.hidden) {
    const double slope = slanted ? 0.6 * kCharacter * static_cast<double>(longest_text(f.x)) : 0.0;
    const auto lines = fitted_lines(text_of(f.x), f.box.width());
    all += texts(0.5 * (f.box.left + f.box.right),
                 y + 46 + slope + 17.0 * static_cast<double>(lines.size() - 1), "m", lines);
  }
  return all;
}

std::string y_axis_svg(const Frame& f, bool labelled, bool gridded) {
  const double x = f.box.left;
  std::string lines, all;
  std::size_t longest = 0;
  for (const auto& [at, shown] : ticks_shown(f.y, f.box.height(), false)) {
    const double y = f.up(at);
    if (!(y > f.box.top - 1.0 && y < f.box.bottom + 1.0)) continue;
    if (gridded) lines += segment(f.box.left, y, f.box.right, y, "class=\"g\"");
    all += segment(x - kTick, y, x, y, "class=\"t\"") + text(x - 9, y + 5, "q e", shown);
    longest = std::max(longest, width(shown));
  }
  if (labelled && !f.y.hidden) {
    const double at = x - 20 - kCharacter * static_cast<double>(longest);
    const double middle = 0.5 * (f.box.top + f.box.bottom);
    all += texts(at, middle, "m", fitted_lines(text_of(f.y), f.box.height()),
                 fmt::format(" transform=\"rotate(-90 {:.1f} {:.1f})\"", at, middle));
  }
  return lines + all;
}

std::string label_svg(const Label& label, const Frame& f) {
  constexpr std::string_view kAnchors[] = {"h", "h m", "h e"};
  const double x = label.in_panel ? std::lerp(f.box.left, f.box.right, label.x) : f.across(label.x);
  const double y = label.in_panel ? std::lerp(f.box.bottom, f.box.top, label.y) : f.up(label.y);
  return std::isfinite(x + y) ? text(x, y + 5, look(kAnchors, label.anchor), label.text) : "";
}

/// Over a panel whose points are threads: where they stand, for scripts.
std::string pick_svg(const Frame& f) {
  if (!f.x.label.starts_with("Thread,")) return {};
  return fmt::format(
      "<rect class=\"pick\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" data-threads=\"{} "
      "{}\"{}/>",
      f.box.left, f.box.top, f.box.width(), f.box.height(), f.x.from, f.x.to,
      f.y.label == "Roller" ? fmt::format(" data-rollers=\"{} {}\"", f.y.from, f.y.to) : "");
}

std::string panel_svg(const Figure& figure, const Layout& layout, std::size_t index,
                      const std::string& id) {
  const Frame f = frame_of(figure, layout, index);
  const Panel& panel = f.panel;
  const Box& b = f.box;
  const GridData& grid = panel.surface ? panel.surface->grid : panel.map.grid;
  const bool boxed = figure.to_scale || !grid.empty();
  const bool bare = f.x.hidden && f.y.hidden;
  const std::string clip = fmt::format("{}-{}", id, index);
  std::string all = fmt::format(
      "<clipPath id=\"{}\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>", clip,
      b.left - 7, b.top - 7, b.width() + 14, b.height() + 14);
  if (!panel.title.empty())
    all += texts(0.5 * (b.left + b.right), b.top - 14, "m b", fitted_lines(panel.title, b.width()));
  all += x_axis_svg(f, panel.x || layout.is_lowest(index)) +
         y_axis_svg(f, panel.y || layout.is_leftmost(index), !boxed);
  all += fmt::format("<g clip-path=\"url(#{})\">", clip);
  if (!grid.empty() && figure.colours) all += map_svg(grid, *figure.colours, f);
  for (const ReferenceLine& r : panel.references)
    all += r.vertical
               ? segment(f.across(r.at), b.bottom, f.across(r.at), b.top,
                         stroke(figure.styles[r.style]))
               : segment(b.left, f.up(r.at), b.right, f.up(r.at), stroke(figure.styles[r.style]));
  for (const Series& series : panel.series) all += series_svg(figure, series, f);
  all += "</g>";
  if (!bare)
    all += fmt::format("<path d=\"M{0} {1}{2}\" class=\"t\"/>", b.left, b.top,
                       boxed ? fmt::format("H{}V{}H{}Z", b.right, b.bottom, b.left)
                             : fmt::format("V{}H{}", b.bottom, b.right));
  for (const Label& label : panel.labels) all += label_svg(label, f);
  return all + pick_svg(f);
}

/// The scale of the colours, an image of its own.
std::string colour_bar_svg(const ColourScale& scale) {
  constexpr Box b{40, kHalfWidth - 40, 8, 22};
  const Axis axis{scale.label, scale.unit, scale.from, scale.to, scale.logarithmic, scale.whole};
  const Ruler across{scale.from, scale.to, b.left, b.right, scale.logarithmic};
  constexpr int kSteps = 60;
  std::string all = fmt::format(
      "<svg viewBox=\"0 0 {} 76\" class=\"half\" role=\"img\" "
      "aria-label=\"{}\">",
      kHalfWidth, html(text_of(axis)));
  for (int k = 0; k < kSteps; ++k) {
    const double share = (k + 0.5) / kSteps;
    const double value = scale.logarithmic ? scale.from * std::pow(scale.to / scale.from, share)
                                           : std::lerp(scale.from, scale.to, share);
    const double width = static_cast<double>(b.width()) / kSteps;
    all += "<rect x=\"" + tenth_of(b.left + k * width) + "\" y=\"" + std::to_string(b.top) +
           "\" width=\"" + tenth_of(width + (k + 1 < kSteps ? kOverlap : 0.0)) + "\" height=\"" +
           std::to_string(b.height()) + "\" fill=\"" + scale_colour(scale, value) + "\"/>";
  }
  const double step = axis.logarithmic ? 0.0 : tick_step(axis, b.width(), true);
  for (const double at : ticks_of(axis, b.width(), true)) {
    all += segment(across(at), b.bottom, across(at), b.bottom + kTick, "class=\"t\"");
    all += text(across(at), b.bottom + 21, "q m", tick_text(at, step));
  }
  return all +
         texts(0.5 * (b.left + b.right), b.bottom + 42, "m",
               {fitted_lines(text_of(axis), kHalfWidth).front()}) +
         "</svg>";
}

std::string legend_symbol(const Style& style) {
  constexpr double kX = 1.0, kY = 8.0;
  if (style.shape == Shape::area)
    return fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"22\" height=\"12\" class=\"{}{}\"/>", kX + 4,
        kY - 6, style.pale ? "p" : "f", static_cast<int>(style.colour));
  std::string all;
  if (style.dash != Dash::none) all += segment(kX, kY, kX + kLegendSymbol - 6, kY, stroke(style));
  if (style.shape == Shape::arrows)
    return all + fmt::format("<path d=\"M{0:.1f} {1:.1f}l-8 -4v8Z\" class=\"f{2}\"/>",
                             kX + kLegendSymbol - 4, kY, static_cast<int>(style.colour));
  if (style.mark != Mark::none)
    all += mark_path(
        style, mark(style.mark, kX + 14, kY, kMarkRadius * look(kMarkSizes, style.weight)), "");
  return all;
}

/// As a list of the page, whose lines break where the screen ends.
std::string legend_html(const Figure& figure) {
  if (figure.legend.empty()) return {};
  std::string all = "<ul class=\"legend\">";
  for (const LegendEntry& entry : figure.legend)
    all += fmt::format("<li><svg viewBox=\"0 0 {} 16\" aria-hidden=\"true\">{}</svg>{}</li>",
                       kLegendSymbol, legend_symbol(figure.styles[entry.style]), html(entry.title));
  return all + "</ul>";
}

/// Whether a panel is drawn half as wide as the page: others are flat, or have words at their axes.
bool is_half(const Figure& figure, const Panel& panel) {
  constexpr std::size_t kWord = 6;
  if (longest_text(x_axis(figure, panel)) > kWord || longest_text(y_axis(figure, panel)) > kWord)
    return false;
  return figure.columns > 1 || figure.aspect == 0.0 || figure.aspect >= 0.5;
}

/// One panel of the figure, which has no legend then.
Figure panel_alone(const Figure& figure, std::size_t index) {
  Figure one{figure.name, figure.title, figure.x, figure.y};
  one.panels.push_back(figure.panels[index]);
  one.styles = figure.styles;
  one.aspect = figure.aspect;
  one.to_scale = figure.to_scale;
  return one;
}

/// An image with one panel.
std::string image(const Figure& figure, std::size_t index, const std::string& id) {
  Figure one = panel_alone(figure, index);
  const bool half = is_half(figure, figure.panels[index]);
  const Layout layout(one, half ? kHalfWidth : kImageWidth);
  one.colours = figure.colours;
  const bool titled =
      std::ranges::any_of(figure.panels, [](const Panel& panel) { return !panel.title.empty(); });
  const int top = titled ? kTitleTop - 6 : kTitleTop + 20;  // The page has the title.
  const std::string& title = figure.panels[index].title;
  constexpr int kSecondLine = 26;  // Room below the axis that few labels need.
  const Axis& x = x_axis(one, one.panels[0]);
  const bool is_short = x.hidden || (longest_text(x) == 0 &&
                                     fitted_lines(text_of(x), layout.panel(0).width()).size() < 2);
  const int height = layout.height() - top - (is_short && !x.hidden ? kSecondLine : 0);
  return fmt::format("<svg viewBox=\"0 {} {} {}\" class=\"{}\" role=\"img\" aria-label=\"{}\">",
                     top, layout.width(), height, half ? "half" : "whole",
                     html(title.empty() ? figure.title : figure.title + ": " + title)) +
         panel_svg(one, layout, 0, fmt::format("{}-{}", id, index)) + "</svg>";
}

/// Axes, colours and texts in the units of tables.
Figure with_table_units(Figure figure) {
  std::set<std::string> units = {figure.x.unit, figure.y.unit};
  if (figure.colours) units.insert(figure.colours->unit);
  figure.title = in_table_units(figure.title);
  for (Panel& panel : figure.panels) {
    for (const std::optional<Axis>& axis : {panel.x, panel.y})
      if (axis) units.insert(axis->unit);
    panel.title = in_table_units(panel.title);
    for (Label& label : panel.labels) label.text = in_table_units(label.text);
  }
  for (const std::string& unit : units)
    figure = in_unit(std::move(figure), {unit, with_table_unit(unit), table_factor(unit)});
  return figure;
}

}  // namespace

std::string html(std::string_view content) {
  if (is_plain_lines(content) && content.find_first_of("<>&\"'\n") == content.npos)
    return std::string(content);
  std::string escaped;
  for (const char c : printable(content)) switch (c) {
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '&':
        escaped += "&amp;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  return escaped;
}

std::string svg(const Figure& drawn, const std::string& id) {
  const Figure figure = with_true_legend(table_system() == UnitSystem::us ? with_table_units(drawn)
                                                                          : in_page_units(drawn));
  std::string all = "<div class=\"panels\">";
  for (std::size_t k = 0; k < figure.panels.size(); ++k) all += image(figure, k, id);
  all += "</div>";
  if (figure.colours) all += colour_bar_svg(*figure.colours);
  return all + legend_html(figure);
}

std::string svg_style() {
  std::string light, dark, classes;
  // On dark paper, what is black or blue must be lighter.
  constexpr std::string_view kOnDark[] = {"#56b4e9", "#ff8a3c", "#2fc79b", "#e6a3cb",
                                          "#f0b73c", "#9bd4f5", "#e8e8e6", "#a5a5a5",
                                          "#b5b5b5", "#6b6b6b", "#ff6b4a"};
  for (std::size_t k = 0; k < std::size(kColours); ++k) {
    light += fmt::format("--c{}:{};", k, kColours[k]);
    dark += fmt::format("--c{}:{};", k, kOnDark[k]);
    classes += fmt::format(
        ".s{0}{{stroke:var(--c{0});fill:none}}.f{0}{{fill:var(--c{0})}}"
        ".p{0}{{fill:var(--c{0});fill-opacity:.22}}\n",
        k);
  }
  return fmt::format(
      ":root{{{}}}\n@media screen and (prefers-color-scheme:dark){{:root{{{}}}}}\n"
      "svg rect,.c{{shape-rendering:crispEdges}}svg .pick{{fill:transparent}}"
      "svg{{display:block;width:100%;height:auto;font-family:inherit;font-size:{}px}}\n"
      "svg text{{fill:var(--ink)}}svg .q{{fill:var(--quiet)}}svg .m{{text-anchor:middle}}"
      "svg .e{{text-anchor:end}}svg .b{{font-weight:600}}\n"
      "svg .h{{paint-order:stroke;stroke:var(--paper);stroke-width:4px;stroke-linejoin:round}}\n"
      ".t{{stroke:var(--quiet);stroke-width:1;fill:none}}.g{{stroke:var(--line);stroke-width:1}}"
      ".o{{stroke:#000;stroke-opacity:.55;stroke-width:.6}}\n{}",
      light, dark, kFontSize, classes);
}

}  // namespace prs
