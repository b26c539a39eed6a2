#pragma once

#include "prs/threads/contacts.h"

namespace prs {

/// Largest speed times pitch diameter that makers allow [m rad/s]: n d of 150,000 mm/min.
inline constexpr double kGreatestSpeedTimesDiameter = 150.0 * std::numbers::pi / 30.0;

/// Warnings on geometry that is possible but unusual: first on the contacts, then on the bodies around them, the faces
/// that hold the nut, and the speed that the geometry allows. Warnings on single values are in input/echo.cpp.
std::vector<Warning> geometry_warnings(const Conditions& c, const Contacts& contacts, std::span<const LoadCase> loads);

}  // namespace prs
