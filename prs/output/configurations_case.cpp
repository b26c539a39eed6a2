#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "prs/configurations/roller_spacing.h"
#include "prs/input/units.h"
#include "prs/output/configurations_files.h"
#include "prs/quantities/configurations_json.h"

namespace prs {
namespace {

std::string length(double si) { return input::format_quantity(si, input::unit::length); }

double to_two_digits(double value) {
  const double digit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return std::round(value / digit) * digit;
}

/// A proposal to two significant digits.
std::string proposed(double si) { return fmt::format("{:.6g} mm", to_two_digits(si * 1e3)); }

std::string heading(const Configuration& c) {
  const Mechanism& m = c.mechanism;
  const bool standard = m.type == Mechanism::Type::standard;
  std::string text = fmt::format(
      "# {} planetary roller screw, {} starts on screw and nut, {} on the rollers.\n"
      "#\n"
      "# Rollers {}-handed, {} in pitch diameter; they keep their place on the {} whose diameter\n"
      "# is {:.6g} times theirs. Nut {}, screw {}, centre distance {}\n"
      "# without backlash. Up to {} rollers fit between sharp crests, and any number of them "
      "meshes\n"
      "# at equal spacing. From one place to the next a roller goes in turned by {:.6g} deg "
      "against\n"
      "# the carrier, in the sense in which the places are counted.\n",
      standard ? "A standard" : "An inverted", m.starts.screw, m.starts.roller,
      c.lead.roller > 0.0 ? "right" : "left", length(c.rolling_diameter.roller),
      standard ? "nut" : "screw", 1.0 / c.gear_ratio,
      fmt::format("{:.4f} mm", c.pitch_diameter.nut * 1e3),
      fmt::format("{:.4f} mm", c.pitch_diameter.screw * 1e3),
      fmt::format("{:.4f} mm", c.centre_distance * 1e3), c.most_rollers,
      indexing_angle(m.type, m.starts, m.rollers) * 180.0 / std::numbers::pi);
  if (!c.gears.empty())
    text += fmt::format("# Gears: {} teeth on the rollers, {} on the {}, module {:.4g} mm.\n",
                        c.gears.front().roller_teeth, c.gears.front().body_teeth,
                        standard ? "nut's rings" : "screw", c.gears.front().module * 1e3);
  return text;
}

std::string mechanism_text(const Mechanism& m) {
  return fmt::format(
      "\nmechanism:\n"
      "  type: {}\n"
      "  lead: {}\n"
      "  starts: {{screw: {}, roller: {}}}\n"
      "  flank_angle: {}\n"
      "  geometry: design  # roller, nut and centre distance follow\n"
      "  pitch_diameter: {{screw: {}}}\n"
      "  backlash: {{screw: 0 mm, nut: 0 mm}}\n"
      "  profile: {{screw: straight, roller: {{convex: {}}}, nut: straight}}\n"
      "  rollers: {}\n"
      "  contacts_per_roller: {}  # a proposal\n",
      type_name(m.type), length(m.lead), m.starts.screw, m.starts.roller,
      input::format_quantity(m.flank_angle.screw, input::unit::angle),
      length(*m.pitch_diameter.screw), length(m.profile.roller.radius), m.rollers,
      m.contacts_per_roller);
}

/// Proportions of the starting cases of `prs new`: wall, flange, ends of the rollers.
std::string structure_text(const Configuration& c) {
  const Mechanism& m = c.mechanism;
  const double contact_length = (m.contacts_per_roller - 1) * axial_pitch(m);
  const double end = 0.75 * c.rolling_diameter.roller;
  const double nut = c.pitch_diameter.nut;
  const double flange = 0.3 * nut;
  const double margin = std::max(2.0 * end, 1.1 * flange);
  return fmt::format(
      "\n# Proposals, to be replaced.\n"
      "structure:\n"
      "  screw: {{free_length: {}}}\n"
      "  roller: {{end_length: {}, end_diameter: {}}}\n"
      "  nut:\n"
      "    length: {}\n"
      "    outer_diameter: {}\n"
      "    flanges: [{{from: 0 mm, to: {}, outer_diameter: {}}}]\n"
      "    thrust: {{tension: {}, compression: 0 mm}}\n"
      "\n"
      "materials: {{youngs_modulus: {}, poisson_ratio: {:g}}}\n"
      "\n"
      "load_cases:  # {:g} GPa with equal shares\n"
      "  - {{axial_force: {:.6g} kN, direction: tension, position: {}}}\n",
      proposed(0.5 * *m.pitch_diameter.screw), proposed(end),
      proposed(0.7 * c.rolling_diameter.roller), proposed(1.05 * (contact_length + 2.0 * margin)),
      proposed(1.3 * nut), proposed(flange), proposed(1.8 * nut), proposed(flange),
      fmt::format("{:g} GPa", kSteel.youngs_modulus * 1e-9), kSteel.poisson_ratio,
      kModeratePressure * 1e-9, to_two_digits(c.moderate_force * 1e-3), proposed(margin));
}

}  // namespace

std::string configuration_case(const Configuration& c) {
  return heading(c) + mechanism_text(c.mechanism) + structure_text(c);
}

}  // namespace prs
