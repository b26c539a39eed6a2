#include "prs/model/operation_check.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "prs/model/limits.h"
#include "prs/model/quantity_text.h"

namespace prs {
namespace {

constexpr std::string_view kLubricantExample = "{name: iso-vg-100, temperature: 60 degC}";

/// Line through two points, on which the oil must get thinner with temperature; empty if it does not.
std::optional<contact::WaltherLine> line_through(std::span<const ViscosityPoint> points, double density,
                                                 Problems& problems) {
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
    problems.add(path(m), fmt::format("got {}; expected more than {}, where the line of ASTM D341 ends; "
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
    problems.add(path(hot), fmt::format("got {} at {}; expected less than {}, the viscosity at {}: oil gets "
                                        "thinner as it warms; check the two points",
                                        text(hot), celsius(temperature(hot)), mm2_per_s(cold.viscosity),
                                        celsius(temperature(cold))));
    return std::nullopt;
  }
  return contact::walther_line(temperature(cold), cold.viscosity, temperature(hot), hot.viscosity);
}

/// Checks a speed, of either sense: the signs of force and speed decide whether screw or load drives. `may_rest`: at
/// speed 0 static friction holds the screw.
void check_speed(const Conditions& c, const LoadCase& load, bool may_rest, Problems& problems) {
  constexpr double kLeast = 1e-5 * (std::numbers::pi / 30.0);  // Below, sliding is too slow to have a direction.
  const double speed = screw_speed(c, load);
  if (std::abs(speed) >= kLeast) return;
  const std::string path = load.speed ? load.input_path + ".speed" : "operation.speed";
  if (speed != 0.0)
    problems.add(path,
                 fmt::format("got {} in case `{}`; expected 0 for a screw that stands still, or at least {}; take "
                             "one of them",
                             rpm(speed), load.name, rpm(kLeast)));
  else if (may_rest && c.heat)
    problems.add(path,
                 "got {} in case `{}` together with `heat`; expected a speed other than 0: a screw at rest makes no "
                 "heat; write the pause as `rest` in `heat.duty`",
                 rpm(speed), load.name);
  else if (may_rest && c.friction && !c.friction->facts().holds_at_rest())
    problems.add(path,
                 "got {} in case `{}`; expected a speed other than 0 with `friction: {{model: {}}}`, whose film does "
                 "not hold a screw at rest; take `{{coulomb: 0.12}}` or `{{mixed: ..}}` for the torques that hold it",
                 rpm(speed), load.name, c.friction->facts().name);
  else if (!may_rest)
    problems.add(path, fmt::format("got {} in case `{}`; expected a speed other than 0: at rest nothing "
                                   "slips; change `operation.speed` or give the case a `speed` of its "
                                   "own",
                                   rpm(speed), load.name));
}

/// Checks that the heat of every part has a path to the surroundings.
void check_conductance(const Heat::Conductance& c, Problems& problems) {
  if (!(c.to_ambient() > 0.0))
    return problems.add("heat.conductance",
                        "got no conductance to the surroundings; expected `screw_ambient`, "
                        "`nut_ambient` or `rollers_ambient` above 0, or the parts warm without "
                        "end; write `nut_ambient: 8 W/K`, for example");
  const bool screw_to_rollers = c.screw_rollers > 0.0, rollers_to_nut = c.rollers_nut > 0.0;
  bool rollers = c.rollers_ambient > 0.0, screw = c.screw_ambient > 0.0, nut = c.nut_ambient > 0.0;
  rollers = rollers || (screw && screw_to_rollers) || (nut && rollers_to_nut);
  screw = screw || (rollers && screw_to_rollers);
  nut = nut || (rollers && rollers_to_nut);
  const auto refuse = [&](bool holds, std::string_view part, std::string_view keys, std::string_view example) {
    if (!holds)
      problems.add("heat.conductance",
                   "the heat of the {} finds no way to the surroundings; expected one of {} above "
                   "0; state one, `{}: 20 W/K`, for example",
                   part, keys, example);
  };
  refuse(rollers, "rollers", "`screw_rollers`, `rollers_nut`, `rollers_ambient`", "rollers_nut");
  refuse(screw, "screw", "`screw_ambient`, `screw_rollers`", "screw_rollers");
  refuse(nut, "nut", "`nut_ambient`, `rollers_nut`", "rollers_nut");
}

/// `a`, `b` and 3 more.
std::string some_names(const std::vector<LoadCase>& cases) {
  constexpr std::size_t kMost = 5;
  std::vector<std::string> names;
  for (const LoadCase& load : cases) {
    if (names.size() == kMost) break;
    names.push_back(fmt::format("`{}`", load.name));
  }
  std::string text = fmt::to_string(fmt::join(names, ", "));
  if (cases.size() > kMost) text += fmt::format(" and {} more", cases.size() - kMost);
  return text;
}

void check_duty(const Case& c, Problems& problems) {
  for (std::size_t k = 0; k < c.heat->duty.size(); ++k) {
    const std::optional<std::string>& name = c.heat->duty[k].load_case;
    const auto named = [&](const LoadCase& load) { return load.name == *name; };
    if (!name || std::ranges::any_of(c.load_cases, named)) continue;
    const std::string path = fmt::format("heat.duty[{}].load_case", k);
    if (c.load_cases.empty())
      problems.add(path,
                   "got `{}`; expected a case of `load_cases`, which is missing; add it, or write "
                   "`rest: 3 s` for a pause",
                   *name);
    else
      problems.add(path,
                   "got `{}`, which no load case is called; expected one of {}; write one of "
                   "these, or `rest: 3 s` for a pause",
                   *name, some_names(c.load_cases));
  }
}

/// Masses must be computable if the capacities are not given.
void check_capacity(const Case& c, Problems& problems) {
  if (c.heat->capacity) return;
  if (!c.heat->specific_heat)
    return problems.add("heat.specific_heat",
                        "missing; expected it, or `capacity`, with `duty`: how much heat warms the "
                        "parts; add `specific_heat: 460 J/(kg K)`, that of steel");
  if (!c.structure)
    problems.add("heat.capacity",
                 "missing; expected the heat capacities of the parts, whose masses are not known "
                 "without `structure`; add `capacity: {screw: 300 J/K, rollers: 150 J/K, nut: 400 "
                 "J/K}`, for example");
  if (!c.materials) return;
  for (const Part part : kParts)
    if (!(*c.materials)[part].density)
      problems.add("materials",
                   "the {} lacks `density`; expected it with `heat.specific_heat`; add `density: "
                   "7810 kg/m^3`, for example, or `heat.capacity`",
                   name(part));
}

}  // namespace

void check_lubricant(const Lubricant& l, const std::optional<Heat>& heat, Problems& problems) {
  std::array<ViscosityPoint, 2> of_name;
  std::span<const ViscosityPoint> points = l.viscosity_at;
  if (l.name && points.empty() && !l.viscosity && !l.walther) {
    of_name = viscosities_of(*l.name);
    points = of_name;
  }
  const std::optional<double> density = l.density || !l.name ? l.density : std::optional(data_of(*l.name).density);
  const bool has_line = l.walther || !points.empty();
  if (heat && (l.viscosity || !has_line))
    return problems.add(l.viscosity ? "lubricant.viscosity" : "lubricant.viscosity_at",
                        fmt::format("{}; expected a viscosity that follows the temperature, as `heat` computes it; "
                                    "state `name`, `viscosity_at` or `walther` in its place",
                                    l.viscosity ? fmt::format("got {:.7g} mPa s", 1e3 * *l.viscosity) : "missing"));
  if (l.viscosity && *l.viscosity <= contact::kRoelandsViscosity)
    problems.add("lubricant.viscosity", fmt::format("got {:.7g} mPa s; expected more than {:.4f} mPa s, below which "
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
  const bool kinematic =
      l.walther || std::ranges::any_of(points, [](const auto& p) { return p.kinematic_viscosity.has_value(); });
  if (kinematic && !density)
    return problems.add("lubricant.density",
                        "missing; expected the density of the oil, by which its kinematic "
                        "viscosity becomes dynamic; add `density: 870 kg/m^3`, for example");
  const std::optional<contact::WaltherLine> line =
      l.walther ? l.walther : line_through(points, density.value_or(contact::kTypicalOilDensity), problems);
  if (!line) return;
  const auto check = [&](const char* path, double temperature) {
    const double viscosity = contact::kinematic_viscosity(*line, temperature);
    if (viscosity > contact::kLeastKinematicViscosity && viscosity <= contact::kGreatestKinematicViscosity) return;
    problems.add(path,
                 fmt::format("got {}, where the oil's line gives {}; expected more than {} and at "
                             "most {} there, within ASTM D341; check the temperature and {}",
                             celsius(temperature), mm2_per_s(viscosity), mm2_per_s(contact::kLeastKinematicViscosity),
                             mm2_per_s(contact::kGreatestKinematicViscosity),
                             l.walther                ? "`walther`"
                             : l.viscosity_at.empty() ? "the name"
                                                      : "the two points"));
  };
  check(heat ? "heat.ambient" : "lubricant.temperature", heat ? heat->ambient : *l.temperature);
  if (!heat || !heat->start) return;
  const auto& [screw, rollers, nut] = *heat->start;
  for (const double temperature : {std::min({screw, rollers, nut}), std::max({screw, rollers, nut})})
    check("heat.start", temperature);
}

void check_carrier(const Carrier& carrier, Problems& problems) {
  if (!carrier.bearing) return;
  const HeadBearing& b = *carrier.bearing;
  if (carrier.roller_torque > 0.0)
    problems.add("carrier.roller_torque",
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
  const contact::LawFacts law = c.friction ? c.friction->facts() : contact::LawFacts{};
  if (law.has_film() && !c.lubricant)
    problems.add_missing("lubricant", fmt::format("the lubricant for friction of the kind `{}`", law.name),
                         kLubricantExample);
  if (law.lubrication == contact::Lubrication::mixed && !c.roughness)
    problems.add_missing("roughness", fmt::format("the Rq of the flanks for friction of the kind `{}`", law.name),
                         "0.4 um");
  if (c.carrier.is_oiled() && !c.lubricant)
    problems.add_missing("lubricant", "the lubricant of `carrier.bearing`, whatever the law of friction",
                         kLubricantExample);
}

void require_slip(const Conditions& c, Problems& problems, bool may_rest) {
  if (!c.friction) problems.add_missing("friction", "a law of friction for `slip`", "{model: jacod}");
  require_friction(c, problems);
  for (const LoadCase& load : c.load_cases) {
    if (!load.speed && !c.operation) {
      problems.add_missing("operation", "the speed for `slip`", "{speed: 400 rpm}");
      continue;
    }
    check_speed(c, load, may_rest, problems);
  }
}

void check_heat(const Case& c, Problems& problems) {
  check_conductance(c.heat->conductance, problems);
  if (c.deviations.temperature && warms(c.heat))
    problems.add("deviations.temperature",
                 "got temperatures of the parts together with `heat`, which computes them; "
                 "expected one of the two; delete `deviations.temperature` or `heat`");
  if (c.heat->duty.empty()) return;
  check_duty(c, problems);
  if (const std::string wrong = wrong_length(c.heat->cycles, c.heat->duty.size()); !wrong.empty())
    problems.add("heat.cycles", wrong);
  if (warms(c.heat))
    check_capacity(c, problems);
  else if (c.heat->cycles)
    problems.add("heat.cycles",
                 "got a mission, whose losses follow the temperatures, together with `losses: stated`; expected one of "
                 "them; delete `losses` or `cycles`");
}

void require_heat(const Case& c, Problems& problems) {
  if (std::ranges::any_of(c.load_cases, &LoadCase::is_solved)) require_expansion(c, problems);
}

void require_expansion(const Case& c, Problems& problems) {
  if (!c.materials) return;
  for (const Part part : kParts)
    if (!(*c.materials)[part].thermal_expansion)
      problems.add("materials",
                   "the {} lacks `thermal_expansion`; expected it with `heat`, which warms the parts; add "
                   "`thermal_expansion: 11.5 um/m/K`, for example, or `share: equal` to each load case",
                   name(part));
}

}  // namespace prs
