#include "prs/configurations/standard_screw.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "prs/configurations/roller_spacing.h"
#include "prs/model/groove.h"

namespace prs {
namespace {

constexpr Material kCatalogueSteel{210e9, 0.3, 7800.0};

Mechanism standard_mechanism(const StandardScrew& s) {
  const double pitch = std::abs(s.lead) / s.starts;
  const double roller_diameter = s.screw_diameter / (s.starts - 2);
  const double centre_distance = 0.5 * (s.screw_diameter + roller_diameter);
  const double flank_angle = 0.25 * std::numbers::pi;
  const ThreadHeight height{kCrestHeight * pitch, kMeshedRootDepth * pitch};

  Mechanism m;
  m.type = Mechanism::Type::standard;
  m.geometry = Mechanism::Geometry::design;
  m.lead = s.lead;
  m.starts = {s.starts, 1};
  m.flank_angle = {flank_angle, flank_angle, flank_angle};
  m.pitch_diameter.screw = s.screw_diameter;
  m.profile.roller = {Profile::Shape::convex, s.roller_profile_radius.value_or(
                                                  0.5 * roller_diameter / std::sin(flank_angle))};
  m.thread = {height, height, height};
  m.rollers = most_rollers(centre_distance, 0.5 * roller_diameter + height.addendum, 0.5 * pitch);
  m.contacts_per_roller =
      std::max(1, static_cast<int>(std::lround(kThreadedShare * s.nut_length / pitch)));
  return m;
}

}  // namespace

Case standard_screw_case(const StandardScrew& s) {
  Case c;
  c.mechanism = standard_mechanism(s);
  const double threaded = c.mechanism.contacts_per_roller * axial_pitch(c.mechanism);
  Structure& structure = c.structure.emplace();
  structure.roller.end_length = 0.25 * std::max(0.0, s.nut_length - threaded);
  structure.roller.end_diameter = 0.7 * s.screw_diameter / (s.starts - 2);
  structure.nut.length = s.nut_length;
  structure.nut.outer_diameter = s.nut_diameter;
  structure.nut.thrust = {0.0, s.nut_length};
  c.materials = Materials{kCatalogueSteel, kCatalogueSteel, kCatalogueSteel};
  return c;
}

}  // namespace prs
