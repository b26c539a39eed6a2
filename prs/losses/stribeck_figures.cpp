#include <cmath>
#include <utility>

#include "prs/losses/slip_parts.h"
#include "prs/model/units.h"
#include "prs/record/figure_parts.h"

namespace prs {
namespace {

/// The values over the speed; a line ends where there is none.
Series over_speed(std::size_t style, const StribeckCurve& curve, auto value) {
  Series line{style};
  for (std::size_t k = 0; k < curve.speed.size(); ++k)
    line.add(curve.speed[k] * per_si::revolution_per_minute, value(k));
  return line;
}

Axis decades(std::string label, std::string unit) {
  Axis axis{std::move(label), std::move(unit)};
  axis.logarithmic = true;
  return axis;
}

}  // namespace

Figure stribeck_figure(const LoadCaseResult& result, const StribeckCurve& curve) {
  Figure figure{"stribeck",
                "Friction over the speed, load case " + shown_name(result.load_case.name)};
  figure.columns = 2;
  PerInterface<std::size_t> style;
  for (const Interface i : kInterfaces)
    style[i] = figure.add(
        interface_title(i),
        line_of(colour_of(body_of(i)), i == Interface::nut ? Dash::dashed : Dash::solid));
  const std::size_t whole = figure.add("whole mechanism", line_of(Colour::ink));
  const std::size_t speed = figure.add("speed of the case", line_of(Colour::muted));

  Panel& friction = figure.panels.emplace_back();
  friction.title = "Friction, most loaded threads";
  for (const Interface i : kInterfaces)
    friction.series.push_back(over_speed(
        style[i], curve, [&](std::size_t k) { return std::optional(curve.friction[i][k]); }));
  friction.y = fitted({"Friction coefficient"}, range_of_y(friction.series), true);

  Panel& efficiency = figure.panels.emplace_back();
  efficiency.title = "Efficiency";
  efficiency.series.push_back(over_speed(whole, curve, [&](std::size_t k) {
    return curve.efficiency[k] ? std::optional(*curve.efficiency[k] * per_si::percent)
                               : std::nullopt;
  }));
  efficiency.y = fitted({"Efficiency", "%"}, range_of_y(efficiency.series));

  Panel& power = figure.panels.emplace_back();
  power.title = "Power lost";
  power.series.push_back(
      over_speed(whole, curve, [&](std::size_t k) { return std::optional(curve.power[k]); }));
  power.y = decades("Power lost", "W");

  if (!curve.film_ratio.screw.empty()) {
    Panel& film = figure.panels.emplace_back();
    film.title = "Film over roughness";
    for (const Interface i : kInterfaces)
      film.series.push_back(over_speed(
          style[i], curve, [&](std::size_t k) { return std::optional(curve.film_ratio[i][k]); }));
    film.y = decades("Film over roughness", "");
    const std::size_t bounds = figure.add("boundary, mixed, full film", kMeanStyle);
    film.references = {{bounds, kTouchingFlanks}, {bounds, kFullFilm}};
  }
  for (Panel& panel : figure.panels)
    panel.references.push_back(
        {speed, std::abs(result.slip->speed) * per_si::revolution_per_minute, true});
  figure.x = decades("Speed", "rpm");
  return figure;
}

}  // namespace prs
