#include "prs/model/block_checks.h"

#include <algorithm>

#include "contact/viscosity.h"
#include "prs/model/quantity_text.h"
#include "prs/model/viscosity_points.h"

namespace prs {
namespace {

constexpr std::string_view kLubricantExample = "{name: iso-vg-100, temperature: 60 degC}";

/// The two points must give a line along which the oil gets thinner with temperature; empty where
/// they do not.
std::optional<contact::WaltherLine> line_through(std::span<const ViscosityPoint> points,
                                                 double density, Problems& problems) {
  if (points.size() != 2) {
    problems.add("lubricant.viscosity_at",
                 fmt::format("got a list of {}; expected a list of 2, through which the line goes; "
                             "choose two points",
                             points.size()));
    return std::nullopt;
  }
  struct Measured {
    std::size_t index;
    double viscosity;  ///< [m^2/s]
  };
  const auto text = [&](const Measured& m) {
    const ViscosityPoint& p = points[m.index];
    const std::string kinematic = mm2_per_s(m.viscosity);
    return p.viscosity ? fmt::format("{:.7g} mPa s, {}", 1e3 * *p.viscosity, kinematic) : kinematic;
  };
  const auto path = [&](const Measured& m) {
    return fmt::format("lubricant.viscosity_at[{}].{}", m.index,
                       points[m.index].viscosity ? "viscosity" : "kinematic_viscosity");
  };
  const auto temperature = [&](const Measured& m) { return points[m.index].temperature; };
  const auto measured = [&](std::size_t i) {
    const ViscosityPoint& p = points[i];
    return Measured{i, p.viscosity ? *p.viscosity / density : *p.kinematic_viscosity};
  };
  bool sound = true;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Measured m = measured(i);
    if (m.viscosity > contact::kLeastKinematicViscosity) continue;
    sound = false;
    problems.add(path(m),
                 fmt::format("got {}; expected more than {}, where the line of ASTM D341 ends; "
                             "check value and unit",
                             text(m), mm2_per_s(contact::kLeastKinematicViscosity)));
  }
  if (!sound) return std::nullopt;
  Measured cold = measured(0), hot = measured(1);
  if (temperature(cold) == temperature(hot)) {
    problems.add("lubricant.viscosity_at[1].temperature",
                 fmt::format("got {} a second time; expected two temperatures that differ, usually "
                             "40 degC and 100 degC; change one of them",
                             celsius(temperature(hot))));
    return std::nullopt;
  }
  if (temperature(cold) > temperature(hot)) std::swap(cold, hot);
  if (hot.viscosity >= cold.viscosity) {
    problems.add(path(hot),
                 fmt::format("got {} at {}; expected less than {}, the viscosity at {}: oil gets "
                             "thinner as it warms; check the two points",
                             text(hot), celsius(temperature(hot)), mm2_per_s(cold.viscosity),
                             celsius(temperature(cold))));
    return std::nullopt;
  }
  return contact::walther_line(temperature(cold), cold.viscosity, temperature(hot), hot.viscosity);
}

/// Either sense: force and speed say whether screw or load drives.
void check_speed(const LoadCase& load, double speed, Problems& problems) {
  if (speed == 0.0)
    problems.add(load.speed ? load.input_path + ".speed" : "operation.speed",
                 fmt::format("got {} in case `{}`; expected a speed other than 0: at rest nothing "
                             "slips; change `operation.speed` or give the case a `speed` of its "
                             "own",
                             rpm(speed), load.name));
}

}  // namespace

void check_lubricant(const Lubricant& l, const std::optional<Heat>& heat, Problems& problems) {
  std::array<ViscosityPoint, 2> of_name;
  std::span<const ViscosityPoint> points = l.viscosity_at;
  if (l.name && points.empty() && !l.viscosity && !l.walther) {
    of_name = viscosities_of(*l.name);
    points = of_name;
  }
  const std::optional<double> density =
      l.density || !l.name ? l.density : std::optional(data_of(*l.name).density);
  const bool has_line = l.walther || !points.empty();
  if (heat && (l.viscosity || !has_line))
    return problems.add(
        l.viscosity ? "lubricant.viscosity" : "lubricant.viscosity_at",
        fmt::format("{}; expected a viscosity that follows the temperature, as `heat` computes it; "
                    "state `name`, `viscosity_at` or `walther` in its place",
                    l.viscosity ? fmt::format("got {:.7g} mPa s", 1e3 * *l.viscosity) : "missing"));
  if (l.viscosity && *l.viscosity <= contact::kRoelandsViscosity)
    problems.add("lubricant.viscosity",
                 fmt::format("got {:.7g} mPa s; expected more than {:.4f} mPa s, below which "
                             "Roelands' viscosity falls with pressure; check the unit",
                             1e3 * *l.viscosity, 1e3 * contact::kRoelandsViscosity));
  if (!l.viscosity && !l.temperature && !heat) {
    if (!has_line)
      return problems.add("lubricant.viscosity",
                          "missing; expected a dynamic viscosity > 0 (in place of `temperature`); "
                          "add for example `viscosity: 160 mPa s`");
    return problems.add("lubricant.temperature",
                        fmt::format("missing; expected the temperature in operation, at which {} "
                                    "has its viscosity; add `temperature: 60 degC`, for example",
                                    l.name ? data_of(*l.name).name : "the oil"));
  }
  if (l.viscosity) {
    const auto& heating = l.film.inlet_heating;
    if (heating && !heating->temperature_coefficient)
      problems.add("lubricant.film.inlet_heating.temperature_coefficient",
                   "missing; expected it beside a `viscosity` that has no law of the temperature; "
                   "add `temperature_coefficient: 0.035 1/K`, for example");
    return;
  }
  const bool kinematic = l.walther || std::ranges::any_of(points, [](const auto& p) {
                           return p.kinematic_viscosity.has_value();
                         });
  if (kinematic && !density)
    return problems.add("lubricant.density",
                        "missing; expected the density of the oil, by which its kinematic "
                        "viscosity becomes dynamic; add `density: 870 kg/m^3`, for example");
  const std::optional<contact::WaltherLine> line =
      l.walther ? l.walther
                : line_through(points, density.value_or(contact::kTypicalOilDensity), problems);
  if (!line) return;
  const double temperature = heat ? heat->ambient : *l.temperature;
  const double viscosity = contact::kinematic_viscosity(*line, temperature);
  if (viscosity > contact::kLeastKinematicViscosity &&
      viscosity <= contact::kGreatestKinematicViscosity)
    return;
  problems.add(heat ? "heat.ambient" : "lubricant.temperature",
               fmt::format("got {}, where the oil's line gives {}; expected more than {} and at "
                           "most {} there, within ASTM D341; check the temperature and {}",
                           celsius(temperature), mm2_per_s(viscosity),
                           mm2_per_s(contact::kLeastKinematicViscosity),
                           mm2_per_s(contact::kGreatestKinematicViscosity),
                           l.walther                ? "`walther`"
                           : l.viscosity_at.empty() ? "the name"
                                                    : "the two points"));
}

void check_carrier(const Carrier& carrier, Problems& problems) {
  if (!carrier.bearing) return;
  const HeadBearing& b = *carrier.bearing;
  if (carrier.roller_torque > 0.0)
    problems.add(
        "carrier.roller_torque",
        fmt::format("got {:.7g} N m together with `bearing`, from which it follows; expected one "
                    "of the two; delete the other",
                    carrier.roller_torque));
  if (!b.has_film()) return;
  if (!(b.radial_clearance < 0.1 * b.diameter))
    problems.add("carrier.bearing.radial_clearance",
                 fmt::format("got {}; expected less than {}, a tenth of the diameter, so that the "
                             "film is thin; check the unit",
                             mm(b.radial_clearance), mm(0.1 * b.diameter)));
  if (b.length > 2.0 * b.diameter)
    problems.add("carrier.bearing.length",
                 fmt::format("got {}; expected at most {}, twice the diameter: longer bearings are "
                             "beyond the theory of short ones; shorten it or give "
                             "`roller_torque` instead",
                             mm(b.length), mm(2.0 * b.diameter)));
}

void require_friction(const Conditions& c, Problems& problems) {
  const bool mixed = c.friction && c.friction->model == Friction::Model::mixed;
  if (c.friction && c.friction->of_film() && !c.lubricant)
    problems.add_missing(
        "lubricant",
        fmt::format("the lubricant for `friction: {{model: {}}}`", mixed ? "{mixed: ..}" : "jacod"),
        kLubricantExample);
  if (mixed && !c.roughness)
    problems.add_missing("roughness", "the Rq of the flanks for `friction: {model: {mixed: ..}}`",
                         "0.4 um");
  if (c.carrier.is_oiled() && !c.lubricant)
    problems.add_missing("lubricant",
                         "the lubricant of `carrier.bearing`, whatever the law of friction",
                         kLubricantExample);
}

void require_slip(const Conditions& c, Problems& problems) {
  if (!c.friction)
    problems.add_missing("friction", "a law of friction for `slip`", "{model: jacod}");
  require_friction(c, problems);
  for (const LoadCase& load : c.load_cases) {
    if (!load.speed && !c.operation) {
      problems.add_missing("operation", "the speed for `slip`", "{speed: 400 rpm}");
      continue;
    }
    check_speed(load, load.speed ? *load.speed : c.operation->speed, problems);
  }
}

}  // namespace prs
