#include "prs/svg/panel.h"

#include <fmt/format.h>

#include <algorithm>

#include "prs/indices.h"
#include "prs/record/pictures.h"
#include "prs/svg/map.h"

namespace prs {
namespace {

/// Ticks of an axis with their texts, as many as fit.
std::vector<Tick> shown_ticks(const Axis& axis, int pixels, bool is_horizontal) {
  if (axis.hidden) return {};
  std::vector<Tick> ticks = axis.ticks;
  for (Tick& tick : ticks)
    if (tick.text.empty()) tick.text = tick_text(tick.at, 0.0);
  if (!ticks.empty()) return ticks;
  const double step = axis.logarithmic ? 0.0 : tick_step(axis, pixels, is_horizontal);
  for (const double at : ticks_of(axis, pixels, is_horizontal)) ticks.push_back({at, tick_text(at, step)});
  return ticks;
}

/// A text on a background, with a share of it left of x; as near to the position as possible within the box and without
/// covering another.
std::string placed_text(std::string_view content, double x, double baseline, double share, const Box& box,
                        std::vector<TextBox>& taken) {
  if (content.empty()) return {};
  constexpr std::string_view kClasses[] = {"h", "h m", "h e"};
  TextBox best = text_box(content, x, baseline, share);
  double best_y = baseline;
  for (const double dy : {0.0, -9.0, 9.0, -18.0, 18.0, -27.0, 27.0, -36.0, 36.0, -54.0, 54.0}) {
    const TextBox moved = text_box(content, x, baseline + dy, share);
    const bool inside = dy == 0.0 || (moved.top > box.top && moved.bottom < box.bottom);
    if (!inside || std::ranges::any_of(taken, [&](const TextBox& other) { return moved.overlaps(other); })) continue;
    best = moved;
    best_y = baseline + dy;
    break;
  }
  taken.push_back(best);
  return text(x, best_y, kClasses[static_cast<int>(std::lround(2.0 * share))], content);
}

using Pixels = std::array<double, 2>;

/// Projection of coordinates to pixels. The box of the axes is turned about z and seen from above; x runs along its
/// front edge at the left, y along that at the right.
class View {
 public:
  View(const Frame& f, const Axis& z) : x_(f.x), y_(f.y), z_(z) {
    constexpr double kRoomLeft = 76.0, kRoomRight = 34.0, kRoomBelow = 30.0;
    const double width = 2.0 * kReach, height = 2.0 * kReach * kTilt + kHeight * kRise;
    const double room = f.box.height() - kRoomBelow;
    scale_ = std::min((f.box.width() - kRoomLeft - kRoomRight) / width, room / height);
    left_ = 0.5 * (f.box.left + kRoomLeft + f.box.right - kRoomRight);
    bottom_ = f.box.top + 0.5 * (room + height * scale_) - kReach * kTilt * scale_;
  }

  Pixels operator()(double x, double y, double z) const { return at(share(x_, x), share(y_, y), share(z_, z)); }
  /// Pixels of a point given by shares of the axes.
  Pixels at(double x, double y, double z) const {
    const double u = x - 0.5, v = y - 0.5;
    return {left_ + scale_ * (kCos * u + kSin * v),
            bottom_ - scale_ * (kTilt * (kCos * v - kSin * u) + kHeight * kRise * z)};
  }
  static double share(const Axis& axis, double value) {
    if (axis.logarithmic) return std::log(value / axis.from) / std::log(axis.to / axis.from);
    return (value - axis.from) / (axis.to - axis.from);
  }

 private:
  static constexpr double kCos = 0.8660254, kSin = 0.5;          // Turned by 30 degrees.
  static constexpr double kTilt = 0.6427876, kRise = 0.7660444;  // Seen from 40 degrees above.
  static constexpr double kHeight = 0.7, kReach = 0.5 * (kCos + kSin);

  const Axis &x_, &y_, &z_;
  double scale_ = 1.0, left_ = 0.0, bottom_ = 0.0;
};

std::string line(Pixels a, Pixels b, std::string_view attributes) {
  return segment(a[0], a[1], b[0], b[1], attributes);
}

std::string quad(const View& view, const GridData& grid, std::size_t i, std::size_t j, const ScaleSteps& steps) {
  double sum = 0.0;
  std::string d;
  for (const auto& [k, l] : {std::pair{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}) {
    const double value = grid.at(k, l);
    if (!std::isfinite(value)) return {};
    sum += value;
    const Pixels at = view(grid.x[k], grid.y[l], value);
    d += (d.empty() ? "M" : "L") + tenth_of(at[0]) + " " + tenth_of(at[1]);
  }
  return "<path d=\"" + d + "Z\" fill=\"" + steps.colour(0.25 * sum) + "\" class=\"w\"/>";
}

/// A surface in space, seen obliquely from above, with its axes.
std::string surface_svg(const Surface& surface, const ColourScale& colours, const Frame& f) {
  const View view(f, surface.z);
  const GridData& grid = surface.grid;
  std::string all;
  const auto label = [&](const Axis& axis, Pixels a, Pixels b, double away) {
    const double turn = std::atan2(b[1] - a[1], b[0] - a[0]);
    const double x = 0.5 * (a[0] + b[0]) - away * std::sin(turn);
    const double y = 0.5 * (a[1] + b[1]) + away * std::cos(turn);
    const int length = static_cast<int>(std::hypot(b[0] - a[0], b[1] - a[1])) +
                       (away < 0.0 ? 90 : 30);  // There is space above the z axis.
    const auto lines = fitted_lines(text_of(axis), length);
    all += text(x, y, "m", lines.size() > 1 ? lines.front() + "…" : lines.front(),
                turned(x, y, static_cast<int>(std::lround(turn * 57.29578))));
  };
  std::vector<TextBox> taken;
  // Lines of each tick over the two walls of its axis, via the corner.
  const auto ticks = [&](const Axis& axis, int pixels, bool is_horizontal, const auto& at, Pixels offset,
                         std::string_view classes) {
    double longest = 0.0;
    for (const Tick& tick : shown_ticks(axis, pixels, is_horizontal)) {
      const double s = View::share(axis, tick.at);
      if (s < -1e-9 || s > 1.0 + 1e-9) continue;
      const auto [first, corner, last] = at(s);
      all += line(first, corner, "class=\"g\"") + line(corner, last, "class=\"g\"");
      all += text(first[0] + offset[0], first[1] + offset[1], classes, tick.text);
      taken.push_back(
          text_box(tick.text, first[0] + offset[0], first[1] + offset[1], classes.ends_with('e') ? 1.0 : 0.0));
      longest = std::max(longest, text_width(tick.text));
    }
    return longest;
  };
  const auto at_x = [&](double s) { return std::array{view.at(s, 0, 0), view.at(s, 1, 0), view.at(s, 1, 1)}; };
  const auto at_y = [&](double s) { return std::array{view.at(1, s, 0), view.at(0, s, 0), view.at(0, s, 1)}; };
  const auto at_z = [&](double s) { return std::array{view.at(0, 0, s), view.at(0, 1, s), view.at(1, 1, s)}; };
  ticks(f.x, 200, true, at_x, {-4, 20}, "q e");
  ticks(f.y, 200, true, at_y, {5, 13}, "q");
  const double longest = ticks(surface.z, 160, false, at_z, {-6, 5}, "q e");
  label(f.x, view.at(0, 0, 0), view.at(1, 0, 0), 44.0);
  label(f.y, view.at(1, 0, 0), view.at(1, 1, 0), 52.0);
  label(surface.z, view.at(0, 0, 0), view.at(0, 0, 1), -longest - 16.0);
  for (const auto& [a, b] : {std::pair{view.at(0, 0, 0), view.at(1, 0, 0)},
                             {view.at(1, 0, 0), view.at(1, 1, 0)},
                             {view.at(0, 0, 0), view.at(0, 0, 1)}})
    all += line(a, b, "class=\"t\"");
  ColourScale smooth = colours;
  smooth.levels.clear();
  const ScaleSteps steps(smooth);
  // Drawn from the back to the front.
  for (std::size_t i = 0; i + 1 < grid.x.size(); ++i)
    for (std::size_t j = grid.y.size() - 1; j-- > 0;) all += quad(view, grid, i, j, steps);
  for (const SurfacePoint& point : surface.points) {
    const Pixels at = view(point.x, point.y, point.z);
    all += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" class=\"f6\"/>", at[0], at[1]);
    const bool at_right_edge = View::share(f.x, point.x) > 0.8;
    all +=
        placed_text(point.name, at[0] + (at_right_edge ? -7 : 7), at[1] - 3, at_right_edge ? 1.0 : 0.0, f.box, taken);
  }
  return all;
}

constexpr int kTick = 5;

bool is_within(double value, double from, double to) {
  return value > std::min(from, to) - 1.0 && value < std::max(from, to) + 1.0;
}

std::string x_axis_svg(const Frame& f, bool labelled) {
  const bool slanted = is_crowded(f.x, f.box.width());
  const double y = f.box.bottom;
  std::string all;
  std::vector<TextBox> taken;
  for (const auto& [at, shown] : shown_ticks(f.x, f.box.width(), true)) {
    const double x = f.across(at);
    if (!is_within(x, f.box.left, f.box.right)) continue;
    all += segment(x, y, x, y + kTick, "class=\"t\"");
    if (slanted) {
      all += text(x + 5, y + 18, "q e", shown, turned(x + 5, y + 18, -35));
      continue;
    }
    const TextBox box = text_box(shown, x, y + 22, 0.5);
    if (!taken.empty() && box.left < taken.back().right + 4.0) continue;
    taken.push_back(box);
    all += text(x, y + 22, "q m", shown);
  }
  if (labelled && !f.x.hidden) {
    const double slope = slanted ? kSlope * longest_text(f.x) : 0.0;
    const auto lines = fitted_lines(text_of(f.x), f.box.width());
    all += texts(0.5 * (f.box.left + f.box.right), y + 46 + slope + kLineHeight * static_cast<double>(lines.size() - 1),
                 "m", lines);
  }
  return all;
}

std::string y_axis_svg(const Frame& f, bool labelled, bool gridded) {
  const double x = f.box.left;
  std::string lines, all;
  double longest = 0.0, last = 0.0;
  for (const auto& [at, shown] : shown_ticks(f.y, f.box.height(), false)) {
    const double y = f.up(at);
    if (!is_within(y, f.box.top, f.box.bottom)) continue;
    if (gridded) lines += segment(f.box.left, y, f.box.right, y, "class=\"g\"");
    all += segment(x - kTick, y, x, y, "class=\"t\"");
    if (longest > 0.0 && std::abs(y - last) < kFontSize) continue;
    last = y;
    all += text(x - 9, y + 5, "q e", shown);
    longest = std::max(longest, text_width(shown));
  }
  if (labelled && !f.y.hidden) {
    const double at = x - 20 - longest, middle = 0.5 * (f.box.top + f.box.bottom);
    all += texts(at, middle, "m", fitted_lines(text_of(f.y), f.box.height()), turned(at, middle, -90));
  }
  return lines + all;
}

std::string label_svg(const Label& label, const Frame& f, std::vector<TextBox>& taken) {
  constexpr double kShares[] = {0.0, 0.5, 1.0};
  const double x = label.in_panel ? std::lerp(f.box.left, f.box.right, label.x) : f.across(label.x);
  const double y = label.in_panel ? std::lerp(f.box.bottom, f.box.top, label.y) : f.up(label.y);
  if (!std::isfinite(x + y)) return {};
  // Blanks at an end keep a text at a distance, and are not drawn.
  const std::string_view content = label.text;
  const std::size_t from = content.find_first_not_of(' ');
  if (from == content.npos) return {};
  const std::size_t to = content.find_last_not_of(' ') + 1;
  const double share = look(kShares, label.anchor);
  const double shift = (1.0 - share) * text_width(content.substr(0, from)) - share * text_width(content.substr(to));
  return placed_text(content.substr(from, to - from), x + shift, y + 5, share, f.box, taken);
}

}  // namespace

std::string panel_svg(const Figure& figure, const Layout& layout, std::size_t index, const std::string& id) {
  const Frame f = frame_of(figure, layout, index);
  const Panel& panel = f.panel;
  const Box& b = f.box;
  std::string all;
  if (!panel.title.empty())
    all += texts(0.5 * (b.left + b.right), b.top - 14, "m b", fitted_lines(panel.title, b.width()));
  if (panel.surface && figure.colours) return all + surface_svg(*panel.surface, *figure.colours, f);
  const bool mapped = !panel.map.grid.empty() && figure.colours;
  const bool boxed = figure.to_scale || mapped, bare = f.x.hidden && f.y.hidden;
  const std::string clip = fmt::format("{}-{}", id, index);
  // Width in pixels by which marks at an edge may exceed the panel.
  const int margin = figure.to_scale && !mapped ? 0 : 7;
  all += fmt::format("<clipPath id=\"{}\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>", clip,
                     b.left - margin, b.top - margin, b.width() + 2 * margin, b.height() + 2 * margin);
  all +=
      x_axis_svg(f, panel.x || layout.is_lowest(index)) + y_axis_svg(f, panel.y || layout.is_leftmost(index), !boxed);
  all += fmt::format("<g clip-path=\"url(#{})\">", clip);
  std::vector<Contours> contours;
  if (mapped) {
    contours = contours_of(panel.map, *figure.colours);
    all += map_svg(panel.map, *figure.colours, f) + contours_svg(contours, f);
  }
  for (const ReferenceLine& r : panel.references)
    all += r.vertical ? segment(f.across(r.at), b.bottom, f.across(r.at), b.top, stroke(figure.styles[r.style]))
                      : segment(b.left, f.up(r.at), b.right, f.up(r.at), stroke(figure.styles[r.style]));
  for (const Series& series : panel.series) all += series_svg(figure, series, f);
  all += "</g>";
  if (!bare)
    all += fmt::format(
        "<path d=\"M{0} {1}{2}\" class=\"t\"/>", b.left, b.top,
        boxed ? fmt::format("H{}V{}H{}Z", b.right, b.bottom, b.left) : fmt::format("V{}H{}", b.bottom, b.right));
  std::vector<TextBox> taken;
  for (const Label& label : panel.labels) all += label_svg(label, f, taken);
  return all + contour_numbers(contours, f, taken);
}

std::string colour_bar_svg(const ColourScale& scale, const Box& b) {
  const Axis axis{scale.label, scale.unit, scale.from, scale.to, scale.logarithmic, scale.whole};
  const Ruler across{scale.from, scale.to, b.left, b.right, scale.logarithmic};
  const ScaleSteps steps(scale);
  const double width = static_cast<double>(b.width()) / static_cast<double>(steps.colours().size());
  std::string all;
  double left = b.left;
  for (const auto k : indices(steps.colours())) {
    const double right = scale.levels.size() > 2 ? across(scale.levels[k + 1]) : left + width;
    all += fmt::format("<rect x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" height=\"{}\" fill=\"{}\"/>", left, b.top,
                       right - left + 0.4, b.height(), steps.colours()[k]);
    left = right;
  }
  const double step = axis.logarithmic ? 0.0 : tick_step(axis, b.width(), true);
  for (const double at : ticks_of(axis, b.width(), true)) {
    all += segment(across(at), b.bottom, across(at), b.bottom + kTick, "class=\"t\"");
    all += text(across(at), b.bottom + 21, "q m", tick_text(at, step));
  }
  return all + text(0.5 * (b.left + b.right), b.bottom + 42, "m", fitted_lines(text_of(axis), b.width() + 80).front());
}

namespace {

constexpr double kMarkRadius = 5.0;

/// Sides of a panel beyond which a point lies far outside, one bit each.
unsigned beyond(const Box& b, double x, double y) {
  constexpr double kMargin = 20.0;
  return (x < b.left - kMargin ? 1u : 0u) | (x > b.right + kMargin ? 2u : 0u) | (y < b.top - kMargin ? 4u : 0u) |
         (y > b.bottom + kMargin ? 8u : 0u);
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
    return fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}M{:.1f} {:.1f}L{:.1f} {:.1f}", x - w, y - h, x + w, y + h, x - h,
                       y + w, x + h, y - w);
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
      return "M" + tenth_of(x - r) + " " + tenth_of(y) + "a" + radius + d + " 0a" + radius + "-" + d + " 0Z";
    }
  }
}

bool is_strokes(const Style& style) { return style.open || style.mark >= Mark::plus; }

/// A path in the style's colour, filled if the marks are.
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
         fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z\" class=\"f{}\"/>", x2, y2,
                     x2 - c - 0.35 * s, y2 - s + 0.35 * c, x2 - c + 0.35 * s, y2 - s - 0.35 * c,
                     static_cast<int>(style.colour));
}

}  // namespace

std::string way(const Polyline& points, const Frame& f, bool closed) {
  constexpr double kFar = 1e6;  // Limit of coordinates outside the panel.
  std::string d;
  char next = 'M';
  std::array<double, 2> at{};
  std::array<long, 2> last{};
  const auto placed = [&](std::size_t k) { return std::array{f.across(points[k][0]), f.up(points[k][1])}; };
  unsigned before = 0;
  for (const auto k : indices(points)) {
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

std::string series_svg(const Figure& figure, const Series& series, const Frame& f) {
  const Style& style = figure.styles[series.style];
  std::size_t longest = 0;
  for (const Polyline& part : series.parts) longest = std::max(longest, part.size());
  std::optional<ScaleSteps> scale;
  if (figure.colours && !series.values.empty()) scale.emplace(*figure.colours);
  const bool lined = style.dash != Dash::none;
  constexpr std::size_t kMostMarks = 40;  // Longer lines have about a dozen marks.
  const std::size_t stride = lined && longest > kMostMarks ? longest / 12 : 1;
  const double radius = kMarkRadius * look(kMarkSizes, style.weight);
  std::string all, d, marks;
  for (const auto k : indices(series.parts)) {
    const Polyline& part = series.parts[k];
    const bool valued = k < series.values.size() && scale;
    const std::string colour = valued ? scale->colour(series.values[k]) : "";
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
      for (std::size_t p = 0; p < part.size(); ++p)
        if (p % stride == 0 || p + 1 == part.size())
          if (const double x = f.across(part[p][0]), y = f.up(part[p][1]); std::isfinite(x) && std::isfinite(y))
            own += mark(style.mark, x, y, radius);
      if (valued)
        all += mark_path(style, own, colour);
      else
        marks += own;
    }
  }
  if (!d.empty() && style.shape == Shape::area)
    all += fmt::format("<path d=\"{}\" class=\"{}{}\"/>", d, style.pale ? "p" : "f", static_cast<int>(style.colour));
  else if (!d.empty())
    all += fmt::format("<path d=\"{}\" {}/>", d, stroke(style));
  return all + mark_path(style, marks, "");
}

std::string legend_symbol(const Style& style) {
  constexpr double kX = 1.0, kY = 8.0;
  if (style.shape == Shape::area)
    return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"22\" height=\"12\" class=\"{}{}\"/>", kX + 4, kY - 6,
                       style.pale ? "p" : "f", static_cast<int>(style.colour));
  std::string all;
  if (style.dash != Dash::none) all += segment(kX, kY, kX + kLegendSymbolWidth - 6, kY, stroke(style));
  if (style.shape == Shape::arrows)
    return all + fmt::format("<path d=\"M{0:.1f} {1:.1f}l-8 -4v8Z\" class=\"f{2}\"/>", kX + kLegendSymbolWidth - 4, kY,
                             static_cast<int>(style.colour));
  if (style.mark != Mark::none)
    all += mark_path(style, mark(style.mark, kX + 14, kY, kMarkRadius * look(kMarkSizes, style.weight)), "");
  return all;
}

std::string svg_file(const Figure& drawn) {
  const Figure figure = with_ranges(with_true_legend(drawn));
  const Layout layout(figure);
  const std::vector<std::string> title = fitted_lines(figure.title, layout.width() - 60);
  const bool titled = std::ranges::any_of(figure.panels, [](const Panel& panel) { return !panel.title.empty(); });
  // The layout reserves two lines for titles.
  const int top = (titled ? 0 : 22) + (title.size() < 2 ? 6 : 0);
  const int height = layout.height() - top;
  std::string all = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 {2} {0} "
      "{1}\" font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\">\n"
      "<title>{3}</title>\n<style>\n{4}</style>\n"
      "<rect y=\"{2}\" width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
      layout.width(), height, top, html(figure.title), svg_rules(false));
  const double baseline = top + 25 + kLineHeight * static_cast<double>(title.size() - 1);
  all += texts(0.5 * layout.width(), baseline, "m b", title);
  for (const auto k : indices(figure.panels)) all += "\n" + panel_svg(figure, layout, k, "panel");
  if (figure.colours) all += "\n" + colour_bar_svg(*figure.colours, layout.colour_bar());
  for (const auto k : indices(figure.legend)) {
    const LegendEntry& entry = figure.legend[k];
    const Box box = layout.legend_entry(k);
    all += fmt::format("\n<g transform=\"translate({} {})\">{}</g>", box.left, box.top,
                       legend_symbol(figure.styles[entry.style]));
    const std::vector<std::string> lines = fitted_lines(entry.title, box.width() - kLegendSymbolWidth - 6);
    all += text(box.left + kLegendSymbolWidth + 6, box.top + 13, "",
                lines.size() > 1 ? lines.front() + "…" : lines.front());
  }
  return all + "\n</svg>\n";
}

}  // namespace prs
