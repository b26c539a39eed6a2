#include "prs/figures/preload_figures.h"

#include <algorithm>
#include <cmath>

#include "prs/model/units.h"
#include "prs/figures/figure_style.h"

namespace prs {
namespace {

enum StyleIndex : std::size_t { kWithout, kWith, kTensionSide, kCompressionSide, kOpening };

/// (load, value) of the points that converged, interrupted at the others.
Line line_of(std::size_t style, const PreloadCurve& curve, const auto& value) {
  Line line{style, {{}}};
  for (const PreloadPoint& point : curve.points) {
    if (point.solve.converged())
      line.parts.back().push_back({point.axial_force * per_si::kilonewton, value(point)});
    else if (!line.parts.back().empty())
      line.parts.emplace_back();
  }
  return line;
}

Axis axis_over(const std::string& label, const std::vector<Line>& lines) {
  Axis axis{label, HUGE_VAL, -HUGE_VAL};
  for (const Line& line : lines)
    for (const Polyline& part : line.parts)
      for (const auto& [x, y] : part) {
        axis.from = std::min(axis.from, y);
        axis.to = std::max(axis.to, y);
      }
  if (!(axis.from < axis.to)) return {label};
  const double margin = 0.06 * (axis.to - axis.from);
  return {label, axis.from == 0.0 ? 0.0 : axis.from - margin, axis.to + margin};
}

Panel displacement_panel(const PreloadResult& r) {
  const auto displacement = [](const PreloadPoint& p) {
    return p.axial_displacement * per_si::micrometre;
  };
  Panel panel{"Displacement"};
  if (r.without_preload) panel.lines.push_back(line_of(kWithout, *r.without_preload, displacement));
  panel.lines.push_back(line_of(kWith, r.curve, displacement));
  panel.y = axis_over("Displacement (µm), tension > 0", panel.lines);
  return panel;
}

Panel side_panel(const PreloadResult& r) {
  Panel panel{"Load of each side"};
  for (const Direction d : kDirections)
    panel.lines.push_back(line_of(
        d == Direction::tension ? kTensionSide : kCompressionSide, r.curve,
        [d](const PreloadPoint& p) { return p.sides[d].axial_load.screw * per_si::kilonewton; }));
  panel.y = axis_over("Axial load (kN)", panel.lines);
  for (const Direction d : kDirections) {
    if (!r.opening_force[d]) continue;
    const double load = (d == Direction::tension ? 1.0 : -1.0) * *r.opening_force[d];
    if (load >= r.preload.load.from && load <= r.preload.load.to)
      panel.lines.push_back({kOpening, {{{load * per_si::kilonewton, 0.0}}}});
  }
  return panel;
}

}  // namespace

std::vector<Figure> preload_figures(const PreloadResult& r) {
  if (!r.at_rest.solve.converged()) return {};
  Figure figure;
  figure.name = "preload";
  figure.title = r.preload.backlash ? "Axial play" : "Preload";
  figure.x = {"Axial force (kN), tension > 0", r.preload.load.from * per_si::kilonewton,
              r.preload.load.to * per_si::kilonewton};
  figure.columns = 2;
  figure.panel_height = 330;
  figure.styles = {{"#777777", 2, 0, 1.8}};
  if (r.without_preload) figure.legend.push_back({"without preload", kWithout});
  add_to_legend(figure, r.preload.backlash ? "with play" : "with preload", {"#004488", 1, 0, 2.4});
  const bool single = r.preload.arrangement == Preload::Arrangement::single_nut;
  add_to_legend(figure, single ? "tension flanks" : "second nut", {"#bb5566", 1, 0, 2.0});
  add_to_legend(figure, single ? "compression flanks" : "first nut", {"#ddaa33", 1, 0, 2.0});
  if (r.opening_force.tension || r.opening_force.compression)
    add_to_legend(figure, "a side opens", points_of("#000000", 6, 2.0));
  figure.panels = {displacement_panel(r), side_panel(r)};
  return {figure};
}

}  // namespace prs
