#include <fmt/format.h>

#include <cmath>

#include "prs/output/gnuplot_script_parts.h"

namespace prs {
namespace {

constexpr int kMostSurfaceTics = 5;
constexpr double kTilt = 58.0;                       // [deg]
constexpr double kTurn = 325.0;                      // With the first corner in front [deg].
constexpr double kScale = 0.98, kHeightScale = 1.2;  // Fill the panel, labels included.

std::string axis_lines(char axis, const Axis& a) {
  const std::string tics =
      a.logarithmic ? "autofreq" : fmt::format("{:.7g}", tic_distance(a.to - a.from, kMostSurfaceTics));
  return fmt::format(
      "{4} logscale {0}\n"
      "set {0}range [{1:.7g}:{2:.7g}]\n"
      "set {0}tics {3} out nomirror scale 0.5 offset 0,0\n"
      "set {0}label {5} rotate parallel\n",
      axis, a.from, a.to, tics, a.logarithmic ? "set" : "unset", gnuplot_string(a.label));
}

/// Turn about the vertical that brings the lowest corner to the front, so that the surface rises
/// away from the eye [deg].
double turn(const GridData& grid) {
  const std::size_t i = grid.x.size() - 1, j = grid.y.size() - 1;
  const double corners[] = {grid.at(0, 0), grid.at(i, 0), grid.at(i, j), grid.at(0, j)};
  int lowest = 0;
  for (int k = 1; k < 4; ++k)
    if (corners[k] < corners[lowest]) lowest = k;
  return std::fmod(kTurn + 90.0 * lowest, 360.0);
}

}  // namespace

std::string surface_data(std::size_t index, const Surface& surface) {
  const GridData& grid = surface.grid;
  std::string script = fmt::format("$surface_{} << END\n", index + 1);
  for (std::size_t i = 0; i < grid.x.size(); ++i) {
    for (std::size_t j = 0; j < grid.y.size(); ++j) {
      const double value = grid.at(i, j);
      script += std::isnan(value)
                    ? fmt::format("{:.7g} {:.7g} NaN\n", grid.x[i], grid.y[j])
                    : fmt::format("{:.7g} {:.7g} {:.7g}\n", grid.x[i], grid.y[j], value);
    }
    script += '\n';
  }
  return script + "END\n";
}

std::string surface_lines(std::size_t index, const Panel& panel, const Axis& x, const Axis& y,
                          const ScreenBox& box) {
  const Surface& surface = *panel.surface;
  std::string script =
      "set lmargin -1; set rmargin -1; set tmargin -1; set bmargin -1\n"
      "set border 15 lc rgb '#777777'; set xyplane relative 0\n"
      "set grid x y z vertical lc rgb '#d9d9d9' lt 1 lw 0.6\n"
      "set pm3d scansautomatic border lc rgb '#8c510a' lw 0.2; set palette maxcolors 0\n";
  script += fmt::format("set origin {:.4f},{:.4f}; set size {:.4f},{:.4f}\n", box.left, box.bottom,
                        box.width, box.height);
  script += fmt::format("set view {},{},{},{}\n", kTilt, turn(surface.grid), kScale, kHeightScale);
  script += fmt::format("set title {}\n", gnuplot_string(panel_title(panel.title)));
  script += axis_lines('x', x) + axis_lines('y', y) + axis_lines('z', surface.z);
  script += "unset label\n";
  for (const SurfacePoint& point : surface.points)
    script += fmt::format(
        "set label {} at {:.7g},{:.7g},{:.7g} point pt 7 ps 0.7 lc rgb 'black' offset 0.6,0.5 "
        "front\n",
        gnuplot_string(panel_title(point.name)), point.x, point.y, point.z);
  script += fmt::format("splot $surface_{} using 1:2:3 with pm3d\n", index + 1);
  return script +
         "set origin 0,0; set size 1,1; unset grid; unset label; unset zlabel; unset logscale\n"
         "set border lc rgb 'black'\n"
         "set xtics out nomirror scale 0.5; set ytics out nomirror scale 0.5\n"
         "set xlabel norotate; set ylabel rotate by 90\n";
}

}  // namespace prs
