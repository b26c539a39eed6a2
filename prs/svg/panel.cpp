#include "prs/svg/panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "prs/svg/elements.h"
#include "prs/svg/map.h"
#include "prs/svg/palette.h"
#include "prs/svg/series.h"
#include "prs/svg/surface.h"

namespace prs {
namespace {

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
    all += texts(0.5 * (f.box.left + f.box.right),
                 y + 46 + slope + kLineHeight * static_cast<double>(lines.size() - 1), "m", lines);
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
    all +=
        texts(at, middle, "m", fitted_lines(text_of(f.y), f.box.height()), turned(at, middle, -90));
  }
  return lines + all;
}

std::string label_svg(const Label& label, const Frame& f, std::vector<TextBox>& taken) {
  constexpr double kShares[] = {0.0, 0.5, 1.0};
  const double x = label.in_panel ? std::lerp(f.box.left, f.box.right, label.x) : f.across(label.x);
  const double y = label.in_panel ? std::lerp(f.box.bottom, f.box.top, label.y) : f.up(label.y);
  if (!std::isfinite(x + y)) return {};
  // Blanks at an end hold a text off its place, and are not drawn.
  const std::string_view content = label.text;
  const std::size_t from = content.find_first_not_of(' ');
  if (from == content.npos) return {};
  const std::size_t to = content.find_last_not_of(' ') + 1;
  const double share = look(kShares, label.anchor);
  const double shift =
      (1.0 - share) * text_width(content.substr(0, from)) - share * text_width(content.substr(to));
  return placed_text(content.substr(from, to - from), x + shift, y + 5, share, f.box, taken);
}

}  // namespace

std::vector<Tick> shown_ticks(const Axis& axis, int pixels, bool is_horizontal) {
  if (axis.hidden) return {};
  std::vector<Tick> ticks = axis.ticks;
  for (Tick& tick : ticks)
    if (tick.text.empty()) tick.text = tick_text(tick.at, 0.0);
  if (!ticks.empty()) return ticks;
  const double step = axis.logarithmic ? 0.0 : tick_step(axis, pixels, is_horizontal);
  for (const double at : ticks_of(axis, pixels, is_horizontal))
    ticks.push_back({at, tick_text(at, step)});
  return ticks;
}

std::string placed_text(std::string_view content, double x, double baseline, double share,
                        const Box& box, std::vector<TextBox>& taken) {
  if (content.empty()) return {};
  constexpr std::string_view kClasses[] = {"h", "h m", "h e"};
  TextBox best = text_box(content, x, baseline, share);
  double best_y = baseline;
  for (const double dy : {0.0, -9.0, 9.0, -18.0, 18.0, -27.0, 27.0, -36.0, 36.0, -54.0, 54.0}) {
    const TextBox moved = text_box(content, x, baseline + dy, share);
    const bool inside = dy == 0.0 || (moved.top > box.top && moved.bottom < box.bottom);
    if (!inside ||
        std::ranges::any_of(taken, [&](const TextBox& other) { return moved.overlaps(other); }))
      continue;
    best = moved;
    best_y = baseline + dy;
    break;
  }
  taken.push_back(best);
  return text(x, best_y, kClasses[static_cast<int>(std::lround(2.0 * share))], content);
}

std::string panel_svg(const Figure& figure, const Layout& layout, std::size_t index,
                      const std::string& id) {
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
  const int margin = figure.to_scale && !mapped ? 0 : 7;  // Marks at an edge are drawn whole.
  all += fmt::format(
      "<clipPath id=\"{}\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>", clip,
      b.left - margin, b.top - margin, b.width() + 2 * margin, b.height() + 2 * margin);
  all += x_axis_svg(f, panel.x || layout.is_lowest(index)) +
         y_axis_svg(f, panel.y || layout.is_leftmost(index), !boxed);
  all += fmt::format("<g clip-path=\"url(#{})\">", clip);
  std::vector<Contours> contours;
  if (mapped) {
    contours = contours_of(panel.map, *figure.colours);
    all += map_svg(panel.map, *figure.colours, f) + contours_svg(contours, f);
  }
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
  for (std::size_t k = 0; k < steps.colours().size(); ++k) {
    const double right = scale.levels.size() > 2 ? across(scale.levels[k + 1]) : left + width;
    all += fmt::format("<rect x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" height=\"{}\" fill=\"{}\"/>",
                       left, b.top, right - left + 0.4, b.height(), steps.colours()[k]);
    left = right;
  }
  const double step = axis.logarithmic ? 0.0 : tick_step(axis, b.width(), true);
  for (const double at : ticks_of(axis, b.width(), true)) {
    all += segment(across(at), b.bottom, across(at), b.bottom + kTick, "class=\"t\"");
    all += text(across(at), b.bottom + 21, "q m", tick_text(at, step));
  }
  return all + text(0.5 * (b.left + b.right), b.bottom + 42, "m",
                    fitted_lines(text_of(axis), b.width() + 80).front());
}

}  // namespace prs
