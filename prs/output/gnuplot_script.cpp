#include "prs/output/gnuplot_script.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "prs/output/gnuplot_parts.h"

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

/// A block of data for the series of a panel, and one for its grid.
std::string data_blocks(std::size_t index, const Figure& figure) {
  const Panel& panel = figure.panels[index];
  std::string script;
  if (!panel.series.empty()) script += fmt::format("$panel_{} << END\n", index + 1);
  for (const Series& series : panel.series)
    script += series_data(series, figure.styles[series.style].shape == Shape::arrows) + "\n\n";
  if (!panel.series.empty()) script += "END\n";
  const GridData& grid = panel.surface ? panel.surface->grid : panel.map.grid;
  if (!grid.empty()) script += fmt::format("$grid_{} << END\n{}END\n", index + 1, grid_data(grid));
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
    plots.push_back(fmt::format("{} using 1:2:({:.7g}) with {} nocontour", data,
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

/// Turn about the vertical that brings the lowest corner to the front, so that the surface rises
/// away from the eye [deg].
double turn(const GridData& grid) {
  const std::size_t i = grid.x.size() - 1, j = grid.y.size() - 1;
  const double corners[] = {grid.at(0, 0), grid.at(i, 0), grid.at(i, j), grid.at(0, j)};
  const auto lowest = std::ranges::min_element(corners) - std::begin(corners);
  return std::fmod(30.0 + 90.0 * static_cast<double>(lowest), 360.0);
}

std::string space_axis_lines(char name, Axis a) {
  if (!longest_text(a)) a.ticks.clear();  // There is room for few.
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
      "set view 60,{},1,0.9\nset title {}\nunset label; unset arrow\n",
      (box.left - 10.0) / kImageWidth, 1.0 - (box.bottom + 70.0) / h,
      (box.width() + 40.0) / kImageWidth, (box.height() + 100.0) / h, turn(surface.grid),
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

/// A map in bands with labelled lines between them, seen from above.
std::string map_lines(const Figure& figure, std::size_t index) {
  constexpr std::size_t kFineNodes = 80;  // So many along an axis show no steps.
  const bool lined = figure.colours && !figure.colours->levels.empty();
  const GridData& grid = figure.panels[index].map.grid;
  std::string script = fmt::format(
      "set ylabel offset -1.4,0; set view map; set pm3d explicit corners2color mean border retrace "
      "interpolate {},{}\n",
      kFineNodes / grid.y.size() + 1, kFineNodes / grid.x.size() + 1);
  std::vector<std::string> plots = {
      fmt::format("$grid_{} using 1:2:3 with pm3d nocontour", index + 1)};
  if (lined) {
    script += fmt::format(
        "set contour base; set cntrparam levels discrete {:.7g}\n"
        "set cntrlabel onecolor format '%.7g' start 5 interval 10000\n",
        fmt::join(figure.colours->levels, ", "));
    plots.push_back(fmt::format("$grid_{} using 1:2:3 with lines nosurface lc rgb '#8c510a' lw 0.5",
                                index + 1));
    plots.push_back(fmt::format("$grid_{} using 1:2:3 with labels nosurface", index + 1));
  }
  for (std::size_t k = 0; k < figure.panels[index].series.size(); ++k)
    add_plots(plots, figure, index, k);
  return script + fmt::format("splot {}\nunset contour; set ylabel offset 0,0\n",
                              fmt::join(plots, ", \\\n     "));
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

std::string gnuplot_script(const Figure& figure) {
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
