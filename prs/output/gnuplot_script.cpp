#include "prs/output/gnuplot_script.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "prs/figures/figure_parts.h"
#include "prs/output/gnuplot_parts.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr double kCellOverlap = 1.02;  // Hides the seams that smoothed edges leave.
constexpr int kMarks[] = {0, 7, 5, 9, 13, 11, 1, 2, 3};      // Point types of gnuplot.
constexpr int kOpenMarks[] = {0, 6, 4, 8, 12, 10, 1, 2, 3};  // Those that are outlined.

std::string margins(const Box& box, int height) {
  const double w = kImageWidth, h = height;
  return fmt::format(
      "set lmargin at screen {:.4f}; set rmargin at screen {:.4f}; "
      "set bmargin at screen {:.4f}; set tmargin at screen {:.4f}\n",
      box.left / w, box.right / w, 1 - box.bottom / h, 1 - box.top / h);
}

std::string style_lines(const std::vector<Style>& styles) {
  std::string script;
  for (std::size_t k = 0; k < styles.size(); ++k) {
    const Style& s = styles[k];
    script += fmt::format("set style line {} lc rgb '{}' dt {} lw {} pt {} ps {}\n", k + 1,
                          look(kColours, s.colour), std::max(1, static_cast<int>(s.dash)),
                          look(kLineWidths, s.weight), look(s.open ? kOpenMarks : kMarks, s.mark),
                          s.mark == Mark::none ? 0.0 : look(kMarkSizes, s.weight));
  }
  return script;
}

std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:.7g}", value) : "NaN";
}

/// The parts, an empty text line between them: points with the value of their part or, of arrows,
/// tail and way to the head.
std::string series_data(const Series& series, bool arrows) {
  std::string data;
  for (std::size_t k = 0; k < series.parts.size(); ++k) {
    const Polyline& part = series.parts[k];
    if (part.empty()) continue;
    if (arrows) {
      data += fmt::format("{:.7g} {:.7g} {:.7g} {:.7g}\n", part[0][0], part[0][1],
                          part[1][0] - part[0][0], part[1][1] - part[0][1]);
      continue;
    }
    if (!data.empty()) data += '\n';
    for (const auto& [x, y] : part)
      data += fmt::format("{} {} {}\n", number(x), number(y),
                          series.values.empty() ? "0" : number(series.values[k]));
  }
  return data.empty() ? "NaN NaN NaN NaN\n" : data;
}

std::string grid_data(const GridData& grid) {
  std::string data;
  for (std::size_t i = 0; i < grid.x.size(); ++i, data += '\n')
    for (std::size_t j = 0; j < grid.y.size(); ++j)
      data += fmt::format("{:.7g} {:.7g} {}\n", grid.x[i], grid.y[j], number(grid.at(i, j)));
  return data;
}

/// The levels of a map that lines can follow.
std::vector<double> lined_levels(const Figure& figure, const Panel& panel) {
  std::vector<double> inner;
  Range range;
  for (const double value : panel.map.grid.values) range.include(value);
  if (figure.colours && !panel.map.cells)
    std::ranges::copy_if(figure.colours->levels, std::back_inserter(inner),
                         [&](double level) { return range.from < level && level < range.to; });
  return inner;
}

/// The lines of a map, and a text `X Y LEVEL ..` of the point of each that is nearest to its
/// centre, where its number stands unless that is at the frame.
std::string contour_data(const GridData& grid, const std::vector<double>& levels,
                         std::size_t number) {
  const double x = grid.x.front(), y = grid.y.front();
  return fmt::format(
      R"(set contour base; unset surface; set cntrparam levels discrete {1:.7g}
set table $lines_{0}; splot $grid_{0} using 1:2:3; unset table
unset contour; set surface
numbers_{0} = ''
across(x) = (x - {2:.7g}) / {3:.7g}
up(y) = (y - {4:.7g}) / {5:.7g}
off(x, y) = (across(x) - across(middle_x))**2 + (up(y) - up(middle_y))**2
lines = 0
if (|$lines_{0}| > 0) {{ stats $lines_{0} using 3 nooutput; lines = int(STATS_blocks) }}
do for [k=0:lines-1] {{
stats $lines_{0} index k using 3 nooutput; level = STATS_max
stats $lines_{0} index k using 1 nooutput; middle_x = STATS_mean
stats $lines_{0} index k using 2 nooutput; middle_y = STATS_mean
stats $lines_{0} index k using (off($1, $2)) nooutput; least = STATS_min
stats $lines_{0} index k using (off($1, $2) <= least ? $1 : NaN) nooutput; x = STATS_min
stats $lines_{0} index k using (off($1, $2) <= least ? $2 : NaN) nooutput; y = STATS_min
if (abs(across(x) - 0.5) < 0.44 && abs(up(y) - 0.5) < 0.47) {{
numbers_{0} = numbers_{0}.sprintf('%.7g %.7g %.7g ', x, y, level)
}}
}}
)",
      number, fmt::join(levels, ", "), x, grid.x.back() - x, y, grid.y.back() - y);
}

/// Blocks of data: for the series of a panel, for its grid and for the lines in that.
std::string data_blocks(std::size_t index, const Figure& figure) {
  const Panel& panel = figure.panels[index];
  std::string script;
  if (!panel.series.empty()) script += fmt::format("$panel_{} << END\n", index + 1);
  for (const Series& series : panel.series)
    script += series_data(series, figure.styles[series.style].shape == Shape::arrows) + "\n\n";
  if (!panel.series.empty()) script += "END\n";
  const GridData& grid = panel.surface ? panel.surface->grid : panel.map.grid;
  if (!grid.empty()) script += fmt::format("$grid_{} << END\n{}END\n", index + 1, grid_data(grid));
  if (const std::vector<double> levels = lined_levels(figure, panel); !levels.empty())
    script += contour_data(grid, levels, index + 1);
  return script;
}

std::string drawn_with(const Style& s, std::size_t style, std::size_t longest_part) {
  if (s.shape == Shape::arrows)
    return fmt::format("vectors filled head size screen 0.008,20 ls {}", style + 1);
  if (s.shape == Shape::area)
    return fmt::format("filledcurves closed fs solid noborder fc rgb '{}'",
                       look(s.pale ? kPaleColours : kColours, s.colour));
  if (s.mark == Mark::none) return fmt::format("lines ls {}", style + 1);
  if (s.dash == Dash::none) return fmt::format("points ls {}", style + 1);
  return fmt::format("linespoints ls {} pi {}", style + 1, (longest_part + 11) / 12);
}

/// What draws series k of a panel.
void add_plots(std::vector<std::string>& plots, const Figure& figure, std::size_t index,
               std::size_t k) {
  const Series& series = figure.panels[index].series[k];
  const Style& style = figure.styles[series.style];
  const bool is_over_map =
      !figure.panels[index].map.grid.empty() && !figure.panels[index].map.cells;
  std::size_t longest = 0;
  for (const Polyline& part : series.parts) longest = std::max(longest, part.size());
  const std::string with = drawn_with(style, series.style, longest);
  const std::string data = fmt::format("$panel_{} index {}", index + 1, k);
  if (is_over_map)
    plots.push_back(fmt::format("{} using 1:2:({:.7g}) with {}", data,
                                figure.colours ? figure.colours->from : 0.0, with));
  else if (series.values.empty())
    plots.push_back(fmt::format("{} with {}", data, with));
  else if (style.shape != Shape::area)
    plots.push_back(fmt::format("{} using 1:2:3 with {} lc palette", data, with));
  else
    for (std::size_t part = 0; part < series.parts.size(); ++part)
      plots.push_back(
          fmt::format("{0} every :::{1}::{1} with filledcurves closed fs solid border rgb "
                      "'#000000' fc palette cb {2:.7g}",
                      data, part, series.values[part]));
}

std::string range_end(double value) {
  return std::isfinite(value) ? fmt::format("{:.7g}", value) : "*";
}

std::string axis_lines(char name, const Axis& a, bool labelled, int pixels) {
  const bool horizontal = name == 'x';
  std::string script =
      fmt::format("{1} logscale {0}\nset {0}range [{2}:{3}]\n", name,
                  a.logarithmic ? "set" : "unset", range_end(a.from), range_end(a.to));
  script += a.hidden
                ? fmt::format("unset {}tics\n", name)
                : fmt::format("set {}tics out nomirror scale 0.5 {} {}\n", name,
                              horizontal && is_crowded(a, pixels) ? "rotate by -35" : "norotate",
                              gnuplot_ticks(a, pixels, horizontal));
  return script + fmt::format("set {}label {}\n", name,
                              labelled && !a.hidden ? gnuplot_fitted(text_of(a), pixels) : "''");
}

std::string axes_lines(const Figure& figure, const Layout& layout, std::size_t index) {
  const Panel& panel = figure.panels[index];
  const Box box = layout.panel(index);
  const auto [x, y] = drawn_axes(figure, layout, index);
  return axis_lines('x', x, panel.x || layout.is_lowest(index), box.width()) +
         axis_lines('y', y, panel.y || layout.is_leftmost(index), box.height());
}

std::string label_lines(const Panel& panel) {
  constexpr std::string_view kAnchors[] = {"left", "center", "right"};
  std::string script = "unset label; unset arrow\n";
  for (const Label& label : panel.labels)
    script += fmt::format("set label {0} at {1}{2:.7g}, {1}{3:.7g} {4} front\n",
                          gnuplot_string(label.text), label.in_panel ? "graph " : "", label.x,
                          label.y, look(kAnchors, label.anchor));
  for (const ReferenceLine& r : panel.references)
    script += r.vertical ? fmt::format(
                               "set arrow from {0:.7g}, graph 0 to {0:.7g}, graph 1 nohead "
                               "ls {1} back\n",
                               r.at, r.style + 1)
                         : fmt::format(
                               "set arrow from graph 0, first {0:.7g} to graph 1, first "
                               "{0:.7g} nohead ls {1} back\n",
                               r.at, r.style + 1);
  return script;
}

/// The colours, before the panels.
std::string palette_lines(const ColourScale& colours) {
  std::string steps;
  for (const std::string_view& colour : kScaleColours)
    steps += fmt::format("{}{} '{}'", steps.empty() ? "" : ", ", &colour - kScaleColours, colour);
  return fmt::format(
      "set palette defined ({})\n"
      "{} logscale cb\nset cbrange [{:.7g}:{:.7g}]\nunset colorbox\nset palette maxcolors {}\n",
      steps, colours.logarithmic ? "set" : "unset", colours.from, colours.to,
      colours.levels.empty() ? 0 : colours.levels.size() - 1);
}

std::string space_axis_lines(char name, Axis a) {
  if (!longest_text(a)) a.ticks.clear();  // There is room for few.
  if (name != 'z') {
    a.label = shortened(text_of(a), 20);  // Two slanted lines would cover each other.
    a.unit.clear();
  }
  return axis_lines(name, a, true, name == 'z' ? 200 : 160) +
         fmt::format("set {0}tics offset 0,0\nset {0}label rotate parallel offset {1},0\n", name,
                     name == 'z' ? 3 - longest_tick(a, 200, false) : 0);
}

/// A surface, drawn into its box with the room of ticks and labels.
std::string surface_lines(const Figure& figure, const Layout& layout, std::size_t index) {
  const Panel& panel = figure.panels[index];
  const Surface& surface = *panel.surface;
  const Box box = layout.panel(index);
  const double h = layout.height();
  std::string script = fmt::format(
      "set lmargin -1; set rmargin -1; set tmargin -1; set bmargin -1\n"
      "set border 31 lc rgb '#777777'; set xyplane relative 0\n"
      "set grid x y z vertical lc rgb '#d9d9d9' lt 1 lw 0.6\n"
      "set pm3d scansautomatic interpolate 1,1 border lc rgb '#8c510a' lw 0.2; set palette "
      "maxcolors 0\n"
      "set origin {:.4f},{:.4f}; set size {:.4f},{:.4f}\n"
      "set view 50,30,1,0.9\nset title {}\nunset label; unset arrow\n",
      (box.left - 10.0) / kImageWidth, 1.0 - (box.bottom + 70.0) / h,
      (box.width() + 10.0) / kImageWidth, (box.height() + 100.0) / h,
      gnuplot_fitted(panel.title, box.width()));
  script += space_axis_lines('x', x_axis(figure, panel)) +
            space_axis_lines('y', y_axis(figure, panel)) + space_axis_lines('z', surface.z);
  for (const SurfacePoint& point : surface.points)
    script += fmt::format(
        "set label {} at {:.7g},{:.7g},{:.7g} point pt 7 ps 0.7 lc rgb 'black' offset 0.6,0.5 "
        "front\n",
        gnuplot_string(point.name), point.x, point.y, point.z);
  return script + fmt::format(
                      "splot $grid_{} using 1:2:3 with pm3d\n"
                      "set origin 0,0; set size 1,1; unset grid; unset label; unset zlabel\n"
                      "unset logscale; set border lc rgb 'black'\n"
                      "set xlabel norotate offset 0,0; set ylabel rotate by 90 offset 0,0\n",
                      index + 1);
}

/// Whether nodes stand at equal distances.
bool is_even(const std::vector<double>& at) {
  const double step = (at.back() - at.front()) / static_cast<double>(at.size() - 1);
  for (std::size_t k = 1; k < at.size(); ++k)
    if (std::abs(at[k] - at[k - 1] - step) > 1e-6 * std::abs(step)) return false;
  return true;
}

/// Whether gnuplot can draw a grid as an image, whose pixels are even and all there.
bool fits_an_image(const GridData& grid, const Axis& x, const Axis& y) {
  return is_even(grid.x) && is_even(grid.y) && !x.logarithmic && !y.logarithmic &&
         std::ranges::all_of(grid.values, [](double value) { return std::isfinite(value); });
}

/// A map in bands with labelled lines between them, seen from above, whatever z a surface drawn
/// before was limited to; as an image where it can be,
/// as polygons of 200 x 200 nodes are 12 MB.
std::string map_lines(const Figure& figure, std::size_t index) {
  constexpr std::size_t kFineNodes = 80;  // So many along an axis show no steps.
  const Panel& panel = figure.panels[index];
  const GridData& grid = panel.map.grid;
  const bool is_image = std::min(grid.x.size(), grid.y.size()) > kFineNodes &&
                        fits_an_image(grid, x_axis(figure, panel), y_axis(figure, panel));
  std::string script = fmt::format(
      "set ylabel offset -1.4,0; set view map; set zrange [*:*]; set pm3d explicit corners2color "
      "mean border retrace "
      "interpolate {},{}\n",
      kFineNodes / grid.y.size() + 1, kFineNodes / grid.x.size() + 1);
  std::vector<std::string> plots = {fmt::format(
      "$grid_{} using {}", index + 1, is_image ? "1:2:(0):3 with image" : "1:2:3 with pm3d")};
  if (!lined_levels(figure, panel).empty()) {
    script += fmt::format(
        "do for [k=3:words(numbers_{0}):3] {{\n"
        "set label word(numbers_{0}, k) at 0 + word(numbers_{0}, k - 2), 0 + word(numbers_{0}, k - "
        "1) "
        "center front\n}}\n",
        index + 1);
    plots.push_back(
        fmt::format("$lines_{} using 1:2:3 with lines lc rgb '#8c510a' lw 0.5", index + 1));
  }
  for (std::size_t k = 0; k < panel.series.size(); ++k) add_plots(plots, figure, index, k);
  return script + fmt::format("splot {}\nset ylabel offset 0,0\n", fmt::join(plots, ", \\\n     "));
}

/// Half the distance of neighbouring nodes.
double half_step(const std::vector<double>& at) {
  return at.size() < 2 ? 0.5 : 0.5 * (at.back() - at.front()) / static_cast<double>(at.size() - 1);
}

std::string panel_lines(const Figure& figure, const Layout& layout, std::size_t index) {
  const Panel& panel = figure.panels[index];
  const Box box = layout.panel(index);
  std::string script =
      figure.to_scale || !panel.map.grid.empty()
          ? "set border 15 lw 0.7; set clip two; unset grid\n"
          : "set border 3 lw 1; unset clip two; set grid y lc rgb '#d9d9d9' lt 1 lw 0.6\n";
  if (figure.colours) script += palette_lines(*figure.colours);
  if (panel.surface) return script + surface_lines(figure, layout, index);
  script += margins(box, layout.height());
  script += fmt::format("set title {}\n", gnuplot_fitted(panel.title, box.width()));
  script += axes_lines(figure, layout, index) + label_lines(panel);
  if (!panel.map.grid.empty() && !panel.map.cells) return script + map_lines(figure, index);
  std::vector<std::string> plots;
  if (!panel.map.grid.empty())
    plots.push_back(fmt::format(
        "$grid_{} using 1:2:({:.7g}):({:.7g}):3 with boxxyerror fs solid noborder fc palette",
        index + 1, kCellOverlap * half_step(panel.map.grid.x),
        kCellOverlap * half_step(panel.map.grid.y)));
  for (std::size_t k = 0; k < panel.series.size(); ++k) add_plots(plots, figure, index, k);
  if (plots.empty()) plots.push_back("NaN");
  return script + fmt::format("plot {}\n", fmt::join(plots, ", \\\n     "));
}

std::string colour_bar_lines(const ColourScale& colours, const Layout& layout) {
  const Box box = layout.colour_bar();
  const double w = kImageWidth, h = layout.height();
  Axis axis{colours.label, colours.unit,        colours.from,
            colours.to,    colours.logarithmic, colours.whole};
  return fmt::format(
      "set colorbox user horizontal origin screen {:.4f},{:.4f} size screen {:.4f},{:.4f}\n"
      "set cbtics {}\nset cblabel {} offset 0,0.4\n",
      box.left / w, 1.0 - box.bottom / h, box.width() / w, box.height() / h,
      gnuplot_ticks(axis, box.width(), true), gnuplot_fitted(text_of(axis), kImageWidth - 200));
}

std::string legend_lines(const Figure& figure, const Layout& layout) {
  std::string script = margins(layout.legend(), layout.height());
  script +=
      "unset logscale xy; unset title; unset xlabel; unset ylabel; unset label; unset arrow\n"
      "unset grid; unset border; unset xtics; unset ytics\n";
  script += fmt::format("set key center horizontal Left reverse maxcols {} samplen 3\n",
                        layout.legend_columns());
  std::vector<std::string> plots;
  if (figure.colours) {
    script += colour_bar_lines(*figure.colours, layout);
    plots.emplace_back("NaN lc palette notitle");
  }
  for (const LegendEntry& entry : figure.legend) {
    const Style& style = figure.styles[entry.style];
    plots.push_back(
        fmt::format("{} with {} title {}",
                    style.shape == Shape::arrows ? "'+' using (NaN):(NaN):(0):(0)" : "NaN",
                    drawn_with(style, entry.style, 1), gnuplot_string(entry.title)));
  }
  if (plots.empty()) return {};
  return script + fmt::format("plot [0:1] [0:1] {}\n", fmt::join(plots, ", \\\n     "));
}

std::string terminal_lines(const Figure& figure, int height) {
  return fmt::format(
      "if (format eq 'svg') {{\n"
      "set terminal svg size {0},{1} noenhanced font 'Helvetica,{2}' background 'white'\n"
      "}} else {{\n"
      "set terminal pngcairo size {3},{4} noenhanced font 'Sans,{5}' linewidth 2 pointscale 2\n"
      "}}\n"
      "set output '{6}.'.format\n",
      kImageWidth, height, kFontSize, 2 * kImageWidth, 2 * height, 1.5 * kFontSize, figure.name);
}

}  // namespace

std::string gnuplot_script(const Figure& drawn) {
  const Figure figure = with_true_legend(drawn);
  const Layout layout(figure);
  std::string script = fmt::format(
      "# Draws {0}.svg and {0}.png: gnuplot {0}.gp\n"
      "set encoding utf8\nset minussign\nset format '%g'\nset title offset 0,-0.8\n",
      figure.name);
  script += style_lines(figure.styles);
  for (std::size_t k = 0; k < figure.panels.size(); ++k) script += data_blocks(k, figure);
  script += "do for [format in 'svg png'] {\n" + terminal_lines(figure, layout.height());
  script += fmt::format("set multiplot title {}\nunset key\n",
                        gnuplot_fitted(figure.title, kImageWidth - 60));
  for (std::size_t k = 0; k < figure.panels.size(); ++k) script += panel_lines(figure, layout, k);
  script += legend_lines(figure, layout);
  return script + "unset multiplot\nunset output\n}\n";
}

}  // namespace prs
