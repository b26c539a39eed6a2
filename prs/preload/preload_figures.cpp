#include <cmath>

#include "prs/model/units.h"
#include "prs/record/figure_parts.h"

namespace prs {
namespace {

enum CurveStyle : std::size_t { kWithout, kWith, kTensionSide, kCompressionSide, kOpening };

/// (load, value) of the points that converged, interrupted at the others.
Series curve_of(std::size_t style, const PreloadCurve& curve, const auto& value) {
  Series line{style};
  for (const PreloadPoint& point : curve.points)
    line.add(point.axial_force * per_si::kilonewton,
             point.solve.converged() ? std::optional<double>(value(point)) : std::nullopt);
  return line;
}

/// With preload, and without where that is known.
Panel curve_panel(const PreloadResult& r, std::string title, Axis axis, const auto& value) {
  Panel panel{std::move(title)};
  if (r.without_preload) panel.series.push_back(curve_of(kWithout, *r.without_preload, value));
  panel.series.push_back(curve_of(kWith, r.curve, value));
  const Range range = range_of_y(panel.series);
  panel.y = fitted(std::move(axis), range, range.from >= 0.0);
  return panel;
}

Panel side_panel(const PreloadResult& r) {
  Panel panel{"Load of each side"};
  for (const Direction d : kDirections)
    panel.series.push_back(curve_of(
        d == Direction::tension ? kTensionSide : kCompressionSide, r.curve,
        [d](const PreloadPoint& p) { return p.sides[d].axial_load.screw * per_si::kilonewton; }));
  panel.y = fitted({"Axial load", "kN"}, range_of_y(panel.series));
  for (const Direction d : kDirections) {
    if (!r.opening_force[d]) continue;
    const double load = sense(d) * -*r.opening_force[d];
    if (load >= r.preload.load.from && load <= r.preload.load.to)
      panel.series.push_back({kOpening, {{{load * per_si::kilonewton, 0.0}}}});
  }
  return panel;
}

}  // namespace

/// Displacement and tangent stiffness over the external load, with preload and without, and what
/// each side carries.
Figures preload_curves(const PreloadResult& r) {
  if (!r.at_rest.solve.converged()) return {};
  Figure figure{"preload", r.preload.backlash ? "Axial play" : "Preload"};
  figure.x = {std::string(kSignedForce), "kN", r.preload.load.from * per_si::kilonewton,
              r.preload.load.to * per_si::kilonewton};
  figure.columns = 3;
  figure.aspect = 1.1;
  figure.add(line_of(Colour::grey, Dash::dashed));
  if (r.without_preload) figure.legend.push_back({"without preload", kWithout});
  figure.add(r.preload.backlash ? "with play" : "with preload",
             line_of(Colour::blue, Dash::solid, Weight::strong));
  const bool single = r.preload.arrangement == Preload::Arrangement::single_nut;
  figure.add(single ? "tension flanks" : "second nut", line_of(Colour::vermillion));
  figure.add(single ? "compression flanks" : "first nut", line_of(Colour::orange, Dash::dashed));
  if (r.opening_force.tension || r.opening_force.compression)
    figure.add("a side opens", points_of(Colour::ink, Mark::circle));
  figure.panels = {curve_panel(r, "Displacement", {"Displacement", "µm"},
                               [](const PreloadPoint& p) -> std::optional<double> {
                                 return p.axial_displacement * per_si::micrometre;
                               }),
                   curve_panel(r, "Stiffness", {"Tangent stiffness", "N/µm"},
                               [](const PreloadPoint& p) -> std::optional<double> {
                                 if (!p.tangent_stiffness) return std::nullopt;
                                 return *p.tangent_stiffness * per_si::newton_per_micrometre;
                               }),
                   side_panel(r)};
  return {std::move(figure)};
}

}  // namespace prs
