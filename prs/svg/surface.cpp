#include "prs/svg/surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "prs/svg/elements.h"
#include "prs/svg/palette.h"
#include "prs/svg/panel.h"

namespace prs {
namespace {

using Pixels = std::array<double, 2>;

/// From coordinates to pixels. The box of the axes is turned about z and seen from above; x runs
/// along its front edge at the left, y along that at the right.
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

  Pixels operator()(double x, double y, double z) const {
    return at(share(x_, x), share(y_, y), share(z_, z));
  }
  /// At shares of the axes.
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

std::string quad(const View& view, const GridData& grid, std::size_t i, std::size_t j,
                 const ScaleSteps& steps) {
  double sum = 0.0;
  std::string d;
  for (const auto& [k, l] : {std::pair{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}) {
    const double value = grid.at(k, l);
    sum += value;
    const Pixels at = view(grid.x[k], grid.y[l], value);
    d += (d.empty() ? "M" : "L") + tenth_of(at[0]) + " " + tenth_of(at[1]);
  }
  if (!std::isfinite(sum)) return {};
  return "<path d=\"" + d + "Z\" fill=\"" + steps.colour(0.25 * sum) + "\" class=\"w\"/>";
}

}  // namespace

std::string surface_svg(const Surface& surface, const ColourScale& colours, const Frame& f) {
  const View view(f, surface.z);
  const GridData& grid = surface.grid;
  std::string all;
  const auto label = [&](const Axis& axis, Pixels a, Pixels b, double away) {
    const double turn = std::atan2(b[1] - a[1], b[0] - a[0]);
    const double x = 0.5 * (a[0] + b[0]) - away * std::sin(turn);
    const double y = 0.5 * (a[1] + b[1]) + away * std::cos(turn);
    const int length = static_cast<int>(std::hypot(b[0] - a[0], b[1] - a[1])) +
                       (away < 0.0 ? 90 : 0);  // Above the axis of z there is room.
    const auto lines = fitted_lines(text_of(axis), length);
    all += text(x, y, "m", lines.size() > 1 ? lines.front() + "…" : lines.front(),
                turned(x, y, static_cast<int>(std::lround(turn * 57.29578))));
  };
  // Lines of each tick over the two walls of its axis, by way of the corner.
  const auto ticks = [&](const Axis& axis, int pixels, bool is_horizontal, const auto& at,
                         Pixels offset, std::string_view classes) {
    double longest = 0.0;
    for (const Tick& tick : shown_ticks(axis, pixels, is_horizontal)) {
      const double s = View::share(axis, tick.at);
      if (s < -1e-9 || s > 1.0 + 1e-9) continue;
      const auto [first, corner, last] = at(s);
      all += line(first, corner, "class=\"g\"") + line(corner, last, "class=\"g\"");
      all += text(first[0] + offset[0], first[1] + offset[1], classes, tick.text);
      longest = std::max(longest, text_width(tick.text));
    }
    return longest;
  };
  const auto at_x = [&](double s) {
    return std::array{view.at(s, 0, 0), view.at(s, 1, 0), view.at(s, 1, 1)};
  };
  const auto at_y = [&](double s) {
    return std::array{view.at(1, s, 0), view.at(0, s, 0), view.at(0, s, 1)};
  };
  const auto at_z = [&](double s) {
    return std::array{view.at(0, 0, s), view.at(0, 1, s), view.at(1, 1, s)};
  };
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
  // From the back to the front.
  for (std::size_t i = 0; i + 1 < grid.x.size(); ++i)
    for (std::size_t j = grid.y.size() - 1; j-- > 0;) all += quad(view, grid, i, j, steps);
  std::vector<TextBox> taken;
  for (const SurfacePoint& point : surface.points) {
    const Pixels at = view(point.x, point.y, point.z);
    all +=
        fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" class=\"f6\"/>", at[0], at[1]);
    all += placed_text(point.name, at[0] + 7, at[1] - 3, 0.0, f.box, taken);
  }
  return all;
}

}  // namespace prs
