#include "prs/threads/geometry_warnings.h"

#include <algorithm>

#include "prs/model/quantity_text.h"

namespace prs {
namespace {

/// Speed times diameter [m rad/s], which makers state as n d.
constexpr ShownUnit kSpeedTimesDiameter{"", "mm/min", "mm"_per_si * "rpm"_per_si};

// Usual values, with room to either side: a maker's 24 standard screws of 4 to 120 mm (validation/standard_screws) have
// helix angles of 1 to 9 deg, threads over 5 to 7.5 diameters of the roller, and nuts with a wall of 10 to 29 % of the
// pitch diameter.
constexpr double kFlattestHelix = 0.3;  ///< [deg]
constexpr double kSteepestHelix = 20.0;
constexpr double kMostSlender = 20.0;
constexpr double kThinnestWall = 0.04;

/// Radial gap between the pitch cylinders of an interface, overlap < 0 [m].
double pitch_cylinder_gap(const contact::MechanismGeometry& m, Interface i) {
  return i == Interface::screw ? m.centre_distance - m.roller.pitch_radius - m.screw.pitch_radius
                               : m.nut.pitch_radius - m.roller.pitch_radius - m.centre_distance;
}

void warn_of_pitch_cylinders(const contact::MechanismGeometry& m, std::vector<Warning>& warnings) {
  for (const Interface i : kInterfaces) {
    const double gap = pitch_cylinder_gap(m, i);
    if (std::abs(gap) > 0.1 * m.roller.pitch)
      warnings.push_back(Warning{"mechanism.centre_distance", fmt::format("{}_pitch_cylinders", name(i)),
                                 fmt::format("the pitch cylinders of roller and {} {} by {{value}}", name(i),
                                             gap > 0 ? "miss each other" : "overlap")}
                             .with(std::abs(gap), {}, "mm"_unit));
  }
}

void warn_of_proportions(const Conditions& c, const Mechanism& m, std::vector<Warning>& warnings) {
  if (m.rollers < 3)
    warnings.push_back(Warning{"mechanism.rollers", "few_rollers",
                               m.rollers == 1 ? "{value} roller cannot centre the screw"
                                              : "{value} rollers cannot centre the screw: the nut tilts about the "
                                                "line through them"}
                           .with(m.rollers, {}, {}, Warning::Worse::smaller));
  for (const Part p : kParts)
    if (m.flank_angle[p] < 20 * std::numbers::pi / 180 || m.flank_angle[p] > 70 * std::numbers::pi / 180)
      warnings.push_back(Warning{"mechanism.flank_angle", fmt::format("{}_flank_angle", name(p)),
                                 fmt::format("the {}'s flank angle of {{value}} is far from the usual 45 deg", name(p))}
                             .with(m.flank_angle[p], {}, "deg"_unit));
  const double helix =
      180.0 / std::numbers::pi * std::atan(std::abs(m.lead) / (std::numbers::pi * *m.pitch_diameter.screw));
  if (helix > kSteepestHelix || helix < kFlattestHelix) {
    const bool steep = helix > kSteepestHelix;
    warnings.push_back(Warning{"mechanism.lead", "helix_angle",
                               fmt::format("got {}, a helix angle of {{value}} at the screw's pitch diameter of "
                                           "{}; usual are {:g} to {:g} deg",
                                           mm(m.lead), mm(*m.pitch_diameter.screw), kFlattestHelix, kSteepestHelix),
                               "check both"}
                           .with(helix / "deg"_per_si, (steep ? kSteepestHelix : kFlattestHelix) / "deg"_per_si,
                                 "deg"_unit, steep ? Warning::Worse::larger : Warning::Worse::smaller));
  }
  const double slenderness = (m.contacts_per_roller - 1) * axial_pitch(m) / *m.pitch_diameter.roller;
  if (slenderness > kMostSlender)
    warnings.push_back(Warning{"mechanism.contacts_per_roller", "long_roller",
                               fmt::format("got {}, threads over {{value}} times the roller's diameter of {}; "
                                           "usual are up to {{limit}} times",
                                           m.contacts_per_roller, mm(*m.pitch_diameter.roller)),
                               "check the number, the lead and the starts"}
                           .with(slenderness, kMostSlender));
  if (!c.structure) return;
  const Structure& s = *c.structure;
  const double wall = 0.5 * (s.nut.outer_diameter - *m.pitch_diameter.nut);
  if (wall < kThinnestWall * *m.pitch_diameter.nut)
    warnings.push_back(Warning{"structure.nut.outer_diameter", "thin_nut",
                               fmt::format("got {}, a wall of {{value}} outside the nut's pitch diameter of {}; "
                                           "usual are {{limit}} or more",
                                           mm(s.nut.outer_diameter), mm(*m.pitch_diameter.nut)),
                               "check both"}
                           .with(wall, kThinnestWall * *m.pitch_diameter.nut, "mm"_unit, Warning::Worse::smaller));
  if (s.screw.bore > 0.8 * *m.pitch_diameter.screw)
    warnings.push_back(
        Warning{"structure.screw.bore", "thin_screw", "the screw's bore leaves a wall of {value} at the pitch diameter"}
            .with(0.5 * (*m.pitch_diameter.screw - s.screw.bore), {}, "mm"_unit, Warning::Worse::smaller));
  if (s.roller.end_diameter > *m.pitch_diameter.roller)
    warnings.push_back(Warning{"structure.roller.end_diameter", "thick_roller_ends",
                               "the roller's ends ({value}) are thicker than its thread ({limit})"}
                           .with(s.roller.end_diameter, *m.pitch_diameter.roller, "mm"_unit));
}

void warn_of_fine_pitch(const BodyModel& bodies, const Mechanism& m, std::vector<Warning>& warnings) {
  const double pitch = axial_pitch(m);
  if (pitch < bodies.least_pitch * (1.0 - 1e-9))
    warnings.push_back(Warning{"model.bodies", "fine_pitch",
                               fmt::format("the pitch is {{value}}; `{}` was compared with finite elements from "
                                           "{{limit}} on, and {}",
                                           bodies.name, bodies.bias_of_finer),
                               "take `bodies: influence` for pressures and static safety"}
                           .with(pitch, bodies.least_pitch, "mm"_unit, Warning::Worse::smaller)
                           .as_assumption());
}

void warn_of_speed(const std::string& path, double speed, double diameter, std::vector<Warning>& warnings) {
  const double n_d = std::abs(speed) * diameter;
  if (n_d > kGreatestSpeedTimesDiameter)
    warnings.push_back(Warning{path, "speed_times_diameter",
                               fmt::format("got {}, which times the screw's pitch diameter of {} is n d = "
                                           "{{value}}; makers allow up to {{limit}}",
                                           rpm(speed), mm(diameter)),
                               "lower the speed, or ask the maker"}
                           .with(n_d, kGreatestSpeedTimesDiameter, kSpeedTimesDiameter));
}

void warn_of_speeds(const Conditions& c, const Mechanism& m, std::span<const LoadCase> loads,
                    std::vector<Warning>& warnings) {
  const double diameter = *m.pitch_diameter.screw;
  if (c.operation) warn_of_speed("operation.speed", c.operation->speed, diameter, warnings);
  std::string last;  // Last name of a range, whose cases have one speed.
  for (const LoadCase& load : loads) {
    const std::string path = path_in(load, "speed");
    if (load.speed && path != last) warn_of_speed(path, *load.speed, diameter, warnings);
    last = path;
  }
}

void warn_of_free_bearings(const Structure& s, std::vector<Warning>& warnings) {
  const auto warn = [&](std::size_t k, const char* key, const char* free) {
    warnings.push_back({fmt::format("structure.screw.bearings[{}].{}", k, key), "free_bearing",
                        fmt::format("has no effect with `{}: free`", free),
                        fmt::format("write `{}: rigid` or a stiffness", free)});
  };
  for (std::size_t k = 0; k < s.screw.bearings.size(); ++k) {
    const Bearing& b = s.screw.bearings[k];
    if (b.lateral == 0.0 && b.offset != Lateral{}) warn(k, "offset", "lateral");
    if (b.tilt == 0.0 && b.angle != Lateral{}) warn(k, "angle", "tilt");
  }
}

/// Warns of a face of the nut on the side to which the load pushes the nut, which can only be pulled.
void warn_of_pulled_faces(const Conditions& c, std::span<const LoadCase> loads, std::vector<Warning>& warnings) {
  if (!c.structure || !c.model.bodies->grooves) return;
  const Structure::Nut& nut = c.structure->nut;
  for (const Direction d : {Direction::tension, Direction::compression}) {
    const auto carries = [&](const LoadCase& load) { return load.direction == d; };
    const auto& section = d == Direction::tension ? nut.thrust.tension : nut.thrust.compression;
    if (!section || std::ranges::none_of(loads, carries)) continue;
    const auto [before, behind] = nut_diameters_at(nut, *section);
    if (before == behind || (before > behind) == (d == Direction::compression)) continue;
    warnings.push_back({fmt::format("structure.nut.thrust.{}", name(d)), "pulled_face",
                        fmt::format("{} lifts the nut off the face at {{{:g} mm}}: it holds with a bolted "
                                    "flange, not against a housing that only pushes",
                                    name(d), *section * "mm"_per_si)});
  }
}

}  // namespace

std::vector<Warning> geometry_warnings(const Conditions& c, const Contacts& contacts, std::span<const LoadCase> loads) {
  std::vector<Warning> warnings = contacts.warnings;
  warn_of_pitch_cylinders(contacts.threads, warnings);
  warn_of_proportions(c, contacts.mechanism, warnings);
  if (c.structure) {
    warn_of_fine_pitch(*c.model.bodies, contacts.mechanism, warnings);
    warn_of_free_bearings(*c.structure, warnings);
  }
  warn_of_pulled_faces(c, loads, warnings);
  warn_of_speeds(c, contacts.mechanism, loads, warnings);
  return warnings;
}

}  // namespace prs
