#pragma once

#include <optional>
#include <string_view>

#include "prs/threads/contacts.h"
#include "prs/model/units.h"

namespace prs {

/// A number of one interface's contact, as documents show it: key with unit, shown = SI * factor.
/// Absent where the contact does not define it.
struct ContactQuantity {
  std::string_view key;
  std::optional<double> (*value)(const InterfaceContact&);
  double factor;
};

template <auto member>
std::optional<double> point_member(const InterfaceContact& c) {
  return c.geometry.point.*member;
}

template <auto member>
std::optional<double> hertz_member(const InterfaceContact& c) {
  return c.hertz.ok() ? std::optional(c.hertz.*member) : std::nullopt;
}

template <auto member>
std::optional<double> shear_member(const InterfaceContact& c) {
  return c.shear ? std::optional((*c.shear).*member) : std::nullopt;
}

template <auto member>
std::optional<double> clearance_member(const InterfaceContact& c) {
  return c.clearance ? std::optional<double>((*c.clearance).*member) : std::nullopt;
}

/// Where the threads touch and, as Yao has it, how far apart they stand centred in their grooves.
inline constexpr ContactQuantity kContactPointQuantities[] = {
    {"radius_on_body_mm", point_member<&contact::ContactPoint::radius_on_body>, per_si::millimetre},
    {"radius_on_roller_mm", point_member<&contact::ContactPoint::radius_on_roller>,
     per_si::millimetre},
    {"angle_on_body_deg", point_member<&contact::ContactPoint::angle_on_body>, per_si::degree},
    {"angle_on_roller_deg", point_member<&contact::ContactPoint::angle_on_roller>, per_si::degree},
    {"flank_clearance_mm", clearance_member<&ThreadClearance::flank>, per_si::millimetre},
    {"body_crest_clearance_mm", clearance_member<&ThreadClearance::body_crest>, per_si::millimetre},
    {"roller_crest_clearance_mm", clearance_member<&ThreadClearance::roller_crest>,
     per_si::millimetre},
};

/// A number of one part's thread, likewise.
struct WidthQuantity {
  std::string_view key;
  std::optional<double> (*value)(const contact::Thread&);
  double factor;
};

template <auto member>
std::optional<double> width_member(const contact::Thread& thread) {
  const std::optional<ThreadWidths> widths = thread_widths(thread);
  return widths ? (*widths).*member : std::nullopt;
}

inline constexpr WidthQuantity kWidthQuantities[] = {
    {"crest_width_mm", width_member<&ThreadWidths::crest>, per_si::millimetre},
    {"root_width_mm", width_member<&ThreadWidths::root>, per_si::millimetre},
};

inline constexpr ContactQuantity kCurvatureQuantities[] = {
    {"curvature_sum_per_mm",
     [](const InterfaceContact& c) { return std::optional(c.geometry.curvature_sum()); },
     per_si::per_millimetre},
    {"equivalent_radius_mm",
     [](const InterfaceContact& c) { return std::optional(1.0 / c.geometry.curvature_sum()); },
     per_si::millimetre},
    {"first_directions_angle_deg",
     [](const InterfaceContact& c) { return std::optional(c.geometry.first_directions_angle()); },
     per_si::degree},
    {"normal_angle_deg",
     [](const InterfaceContact& c) { return std::optional(c.geometry.point.normal_angle()); },
     per_si::degree},
};

/// Defined where both threads have the same pitch.
inline constexpr ContactQuantity kBacklash = {
    "backlash_mm", point_member<&contact::ContactPoint::backlash>, per_si::millimetre};

inline constexpr ContactQuantity kHertzQuantities[] = {
    {"hertz_constant_N_per_mm1_5", hertz_member<&contact::HertzConstants::hertz_constant>,
     per_si::newton_per_millimetre1_5},
    {"ellipticity", hertz_member<&contact::HertzConstants::ellipticity>, 1.0},
    {"semi_major_mm_per_N1_3", hertz_member<&contact::HertzConstants::semi_major_per_cbrt_load>,
     per_si::millimetre},
    {"semi_minor_mm_per_N1_3", hertz_member<&contact::HertzConstants::semi_minor_per_cbrt_load>,
     per_si::millimetre},
    {"max_shear_over_peak_pressure", shear_member<&contact::SubsurfaceShear::shear_over_pressure>,
     1.0},
    {"max_shear_depth_over_semi_minor",
     shear_member<&contact::SubsurfaceShear::depth_over_semi_minor>, 1.0},
};

}  // namespace prs
