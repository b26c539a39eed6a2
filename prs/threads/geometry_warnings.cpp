#include "prs/threads/geometry_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "prs/model/units.h"

namespace prs {
namespace {

/// Radial distance by which the pitch cylinders of an interface miss each other, overlap < 0 [m].
double pitch_cylinder_gap(const contact::MechanismGeometry& m, Interface i) {
  return i == Interface::screw ? m.centre_distance - m.roller.pitch_radius - m.screw.pitch_radius
                               : m.nut.pitch_radius - m.roller.pitch_radius - m.centre_distance;
}

void warn_of_pitch_cylinders(const contact::MechanismGeometry& m,
                             std::vector<std::string>& warnings) {
  for (const Interface i : kInterfaces) {
    const double gap = pitch_cylinder_gap(m, i);
    if (std::abs(gap) > 0.1 * m.roller.pitch)
      warnings.push_back(fmt::format("the pitch cylinders of roller and {} {} by {:.4f} mm",
                                     name(i), gap > 0 ? "miss each other" : "overlap",
                                     std::abs(gap) * per_si::millimetre));
  }
}

void warn_of_proportions(const Conditions& c, const Mechanism& m,
                         std::vector<std::string>& warnings) {
  if (m.rollers < 3)
    warnings.push_back(
        fmt::format("{} roller{} cannot centre the screw", m.rollers, m.rollers == 1 ? "" : "s"));
  for (const Part p : kParts)
    if (m.flank_angle[p] < 20 * std::numbers::pi / 180 ||
        m.flank_angle[p] > 70 * std::numbers::pi / 180)
      warnings.push_back(
          fmt::format("the {}'s flank angle of {:g} deg is far from the usual 45 deg", name(p),
                      m.flank_angle[p] * 180 / std::numbers::pi));
  if (!c.structure) return;
  const Structure& s = *c.structure;
  if (s.screw.bore > 0.8 * *m.pitch_diameter.screw)
    warnings.push_back(
        fmt::format("the screw's bore leaves a wall of {:.2f} mm at the pitch diameter",
                    0.5 * (*m.pitch_diameter.screw - s.screw.bore) * per_si::millimetre));
  if (s.roller.end_diameter > *m.pitch_diameter.roller)
    warnings.push_back(fmt::format(
        "the roller's ends ({:g} mm) are thicker than its thread ({:g} mm)",
        s.roller.end_diameter * per_si::millimetre, *m.pitch_diameter.roller * per_si::millimetre));
}

/// A face of the nut that looks the way that the load pushes the nut can only be pulled.
void warn_of_pulled_faces(const Conditions& c, std::span<const LoadCase> loads,
                          std::vector<std::string>& warnings) {
  if (!c.structure || c.model.bodies == ModelOptions::Bodies::bars) return;
  const Structure::Nut& nut = c.structure->nut;
  for (const Direction d : {Direction::tension, Direction::compression}) {
    const auto carries = [&](const LoadCase& load) { return load.direction == d; };
    const auto& section = d == Direction::tension ? nut.thrust.tension : nut.thrust.compression;
    if (!section || std::ranges::none_of(loads, carries)) continue;
    const auto [before, behind] = nut_diameters_at(nut, *section);
    if (before == behind || (before > behind) == (d == Direction::compression)) continue;
    warnings.push_back(
        fmt::format("{} lifts the nut off the face at {:g} mm: it holds with a bolted flange, not "
                    "against a housing that only pushes",
                    name(d), *section * per_si::millimetre));
  }
}

}  // namespace

std::vector<std::string> geometry_warnings(const Conditions& c, const Contacts& contacts,
                                           std::span<const LoadCase> loads) {
  std::vector<std::string> warnings = contacts.warnings;
  warn_of_pitch_cylinders(contacts.threads, warnings);
  warn_of_proportions(c, contacts.mechanism, warnings);
  warn_of_pulled_faces(c, loads, warnings);
  return warnings;
}

}  // namespace prs
