#pragma once

#include <string>
#include <string_view>

#include "prs/figures/figure.h"
#include "prs/model/part.h"
#include "prs/loads/result.h"

namespace prs {

/// Pale inside, dark outline: the parts as in P. Tol's "high contrast" scheme, the roller green.
struct PartColours {
  std::string_view fill;
  std::string_view outline;
};
inline constexpr PerPart<PartColours> kPartColours = {
    {"#c9dbee", "#004488"}, {"#d4ead0", "#117733"}, {"#f2d4d9", "#bb5566"}};

inline constexpr LineStyle kContactMark = points_of("#000000", 7, 1.6);
inline constexpr LineStyle kAxisLine = {"#555555", 4, 0, 1.0};

/// Sandu's name of the contact point.
constexpr std::string_view letter(Interface i) { return i == Interface::screw ? "I" : "J"; }

constexpr std::string_view title(Part part) {
  return part == Part::screw ? "screw" : part == Part::roller ? "roller" : "nut";
}

inline bool has_contact_points(const Contacts& contacts) {
  return contacts.interfaces.screw.geometry.ok() && contacts.interfaces.nut.geometry.ok();
}

/// A number with a typographic minus, as the axes have it.
std::string number(double value, int decimals);

/// What the picture is of: `inverted screw 21 × 5 mm`.
std::string mechanism_title(const Contacts& contacts);

}  // namespace prs
