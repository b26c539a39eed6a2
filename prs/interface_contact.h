#pragma once

#include <optional>
#include <string>

#include "contact/hertz.h"
#include "contact/interface_geometry.h"
#include "prs/materials.h"
#include "prs/mechanism.h"

namespace prs {

/// What the thread geometry says of one interface, for tension (I1J2), with its Hertz contact. In
/// compression the other two faces touch, mirrored: curvatures, angles and constants are the same.
struct InterfaceContact {
  contact::InterfaceGeometry geometry;
  contact::HertzConstants hertz;  ///< `not_computed` without materials.

  bool has_hertz() const { return geometry.ok() && hertz.ok(); }
  double normal_angle() const { return geometry.point.normal_angle(); }
};

/// Contact points and curvatures of both interfaces of a `resolved` mechanism, and their Hertz
/// contacts where materials are given.
PerInterface<InterfaceContact> interface_contacts(const Mechanism& resolved,
                                                  const std::optional<Materials>& materials);

/// Why there is no Hertz contact: which surface, which limit, by how much.
std::string failure(const InterfaceContact& contact, Interface interface);

/// "roller-screw" or "roller-nut".
const char* label(Interface interface);

}  // namespace prs
