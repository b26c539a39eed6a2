#pragma once

#include <fmt/format.h>
#include <array>

#include <cmath>
#include <string>

#include "prs/model/units.h"
#include "prs/record/figure_parts.h"

namespace prs {

// Pictures of the contacts are drawings to scale in configuration I1J2 (Sandu 2018, section 1.3):
// frame of the screw, z along its axis, x towards the axis of the first roller.

constexpr Style kContactMark = points_of(Colour::ink, Mark::circle);
constexpr Style kAxisLine = line_of(Colour::reference, Dash::dash_dotted, Weight::thin);

/// Sandu's name of the contact point.
constexpr const char* letter(Interface i) { return i == Interface::screw ? "I" : "J"; }

inline bool has_contact_points(const Contacts& contacts) {
  return contacts.interfaces.screw.geometry.ok() && contacts.interfaces.nut.geometry.ok();
}

/// What the picture is of: `inverted screw 21 × 5 mm`.
inline std::string mechanism_title(const Contacts& contacts) {
  const contact::MechanismGeometry& threads = contacts.threads;
  return fmt::format("{}{} screw {:.4g} × {:.4g} mm",
                     threads.screw.lead < 0.0 ? "left-handed " : "",
                     threads.type == contact::MechanismType::standard ? "standard" : "inverted",
                     2.0 * threads.screw.pitch_radius * per_si::millimetre,
                     std::abs(threads.screw.lead) * per_si::millimetre);
}

/// A range about its middle [m], shown in mm.
inline Axis axis_about(std::string label, double middle, double half) {
  return {std::move(label), "mm", (middle - half) * per_si::millimetre,
          (middle + half) * per_si::millimetre};
}

/// A point of a drawing [mm], from its coordinates [m].
inline std::array<double, 2> point_mm(double x, double y) {
  return {x * per_si::millimetre, y * per_si::millimetre};
}

}  // namespace prs
