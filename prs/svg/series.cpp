#include "prs/svg/series.h"

#include <fmt/format.h>

#include <algorithm>

#include "prs/svg/elements.h"
#include "prs/svg/palette.h"

namespace prs {
namespace {

constexpr double kMarkRadius = 5.0;

/// On which sides of a panel a point lies well outside, a bit each.
unsigned beyond(const Box& b, double x, double y) {
  constexpr double kMargin = 20.0;
  return (x < b.left - kMargin ? 1u : 0u) | (x > b.right + kMargin ? 2u : 0u) |
         (y < b.top - kMargin ? 4u : 0u) | (y > b.bottom + kMargin ? 8u : 0u);
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

}  // namespace

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

std::string series_svg(const Figure& figure, const Series& series, const Frame& f) {
  const Style& style = figure.styles[series.style];
  std::size_t longest = 0;
  for (const Polyline& part : series.parts) longest = std::max(longest, part.size());
  std::optional<ScaleSteps> scale;
  if (figure.colours && !series.values.empty()) scale.emplace(*figure.colours);
  const bool lined = style.dash != Dash::none;
  const std::size_t stride = lined ? (longest + 11) / 12 : 1;
  const double radius = kMarkRadius * look(kMarkSizes, style.weight);
  std::string all, d, marks;
  for (std::size_t k = 0; k < series.parts.size(); ++k) {
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

std::string legend_symbol(const Style& style) {
  constexpr double kX = 1.0, kY = 8.0;
  if (style.shape == Shape::area)
    return fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"22\" height=\"12\" class=\"{}{}\"/>", kX + 4,
        kY - 6, style.pale ? "p" : "f", static_cast<int>(style.colour));
  std::string all;
  if (style.dash != Dash::none)
    all += segment(kX, kY, kX + kLegendSymbolWidth - 6, kY, stroke(style));
  if (style.shape == Shape::arrows)
    return all + fmt::format("<path d=\"M{0:.1f} {1:.1f}l-8 -4v8Z\" class=\"f{2}\"/>",
                             kX + kLegendSymbolWidth - 4, kY, static_cast<int>(style.colour));
  if (style.mark != Mark::none)
    all += mark_path(
        style, mark(style.mark, kX + 14, kY, kMarkRadius * look(kMarkSizes, style.weight)), "");
  return all;
}

}  // namespace prs
