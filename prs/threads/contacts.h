#pragma once

#include "contact/subsurface.h"
#include "prs/model/detail.h"
#include "prs/model/materials.h"
#include "prs/model/mechanism.h"
#include "prs/model/warning.h"
#include "prs/threads/contact_failure.h"
#include "prs/threads/thread_clearance.h"

namespace prs {

/// Contact of one interface from the thread geometry, for tension (I1J2), with its Hertz contact.
/// In compression the other two faces touch, mirrored: curvatures, angles and constants are the
/// same.
struct InterfaceContact {
  contact::InterfaceGeometry geometry;
  contact::HertzConstants hertz;  ///< `not_computed` without materials.
  /// Below the centre of the ellipse; absent without Hertz contact and with Detail::numbers.
  std::optional<contact::SubsurfaceShear> shear;
  double contact_modulus = 0.0;              ///< E* [Pa], 0 without materials.
  std::optional<ThreadClearance> clearance;  ///< Absent without contact or thread heights.

  bool has_hertz() const { return geometry.ok() && hertz.ok(); }
  double normal_angle() const { return geometry.point.normal_angle(); }
};

/// Contacts of a mechanism from its thread geometry, before any load.
struct Contacts {
  /// With all pitch diameters and the centre distance: the one that analyses compute on.
  Mechanism mechanism;
  contact::MechanismGeometry threads;
  PerPart<std::optional<Problem>> bad_threads;  ///< Threads that cannot be, and why.
  PerInterface<InterfaceContact> interfaces;
  std::vector<Warning> warnings;
};

/// Gear ratios by diameters and by leads that differ by less are those of a sound mechanism whose
/// diameters were rounded to 1 um.
inline constexpr double kGearRatioTolerance = 1e-4;

/// Resolves the mechanism, finds the contact points of both interfaces and, where materials are
/// given, their Hertz contacts. An interface without contact is a result that says why. Throws
/// CaseError where a design has no solution or a thread is thicker than its pitch.
Contacts find_contacts(const Mechanism& mechanism, const std::optional<Materials>& materials,
                       Detail detail = Detail::complete);

/// The thread of a part.
const contact::Thread& thread_of(const contact::MechanismGeometry& threads, Part part);

/// Why there is no contact or no Hertz contact.
Problem failure(const Contacts& contacts, Interface interface);

}  // namespace prs
