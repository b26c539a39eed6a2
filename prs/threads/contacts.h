#pragma once

#include "prs/model/case.h"
#include "prs/model/problems.h"
#include "prs/threads/contact_law.h"
#include "prs/threads/threads.h"

namespace prs {

/// Reason why an interface has no contact point, or no Hertz contact at it: the input to fix, the surface, the limit,
/// by how much.
Problem why_no_contact(const contact::MechanismGeometry& threads, const contact::InterfaceGeometry& geometry,
                       contact::HertzStatus hertz, Interface interface);

/// "roller-screw" or "roller-nut".
const char* label(Interface interface);

/// Pair of threads of an interface.
contact::ThreadPair pair_of(const contact::MechanismGeometry& threads, Interface interface);

/// Contact of one interface from the thread geometry, for tension (I1J2), with its Hertz contact.
/// In compression the other two faces touch, mirrored: curvatures, angles and constants are the
/// same.
struct InterfaceContact {
  contact::InterfaceGeometry geometry;
  contact::HertzConstants hertz;  ///< Hertz contact; `not_computed` without materials.
  /// Largest shear below the centre of the ellipse; absent without Hertz contact and with Detail::numbers.
  std::optional<contact::SubsurfaceShear> shear;
  /// Largest von Mises stress below the centre; absent as above.
  std::optional<contact::SubsurfaceVonMises> von_mises;
  double contact_modulus = 0.0;  ///< E* [Pa], 0 without materials.
  /// Peak pressure at rest [Pa], `static_pressure_limit` of the materials; absent if none is known.
  std::optional<double> pressure_limit = kStaticPressureLimit;
  std::optional<ThreadClearance> clearance;  ///< Clearance; absent without contact or thread heights.

  bool has_hertz() const { return geometry.ok() && hertz.ok(); }
  double normal_angle() const { return geometry.point.normal_angle(); }
};

/// A peak pressure and the largest one that its contact may have at rest [Pa]; absent where none is known.
struct ContactPressure {
  Interface at = Interface::screw;
  double value = 0.0;
  std::optional<double> limit = {};

  /// Share of the limit; without one as if it were just met.
  double share() const { return limit ? value / *limit : 1.0; }
};

/// Contacts of a mechanism from its thread geometry, before any load.
struct Contacts {
  /// The mechanism with all pitch diameters and the centre distance, on which analyses compute.
  Mechanism mechanism;
  contact::MechanismGeometry threads;
  PerPart<std::optional<Problem>> bad_threads;  ///< Reasons why threads are impossible.
  PerInterface<InterfaceContact> interfaces;
  std::vector<Warning> warnings;
};

/// Largest difference of the gear ratios by diameters and by leads that is due to rounding of diameters to 1 um.
inline constexpr double kGearRatioTolerance = 1e-4;
/// Whether the pitch diameters have the ratio of the gears' teeth within the tolerance (Sandu 2018, (2.14)).
bool has_gear_ratio(const Contacts& contacts);

/// Resolves the mechanism, finds the contact points of both interfaces and, if materials are given, their Hertz
/// contacts. An interface without contact is a result with its reason. Throws CaseError if a design has no solution or
/// a thread is thicker than its pitch.
Contacts find_contacts(const Mechanism& mechanism, const std::optional<Materials>& materials,
                       Detail detail = Detail::complete);

/// The thread of a part.
const contact::Thread& thread_of(const contact::MechanismGeometry& threads, Part part);

/// Reason why there is no contact or no Hertz contact.
Problem failure(const Contacts& contacts, Interface interface);

/// Throws CaseError if an interface has no contact or, with materials, no Hertz contact: both interfaces in one
/// message.
void require_contacts(const Conditions& c, const Contacts& contacts);

/// Force law of an interface that has a Hertz contact, or overrides for all of it; without teeth.
ContactLaw contact_law(const ContactOverrides& overrides, const InterfaceContact& contact, Interface interface);

/// Force laws of both interfaces in the load distribution. The case's overrides come before the geometry; the
/// compliance of the teeth is added if the case asks for it. Throws CaseError for interfaces whose geometry gives no
/// Hertz contact and that are not overridden.
PerInterface<ContactLaw> contact_laws(const Conditions& c, const Contacts& contacts);

/// Section of one thread tooth through the axis.
struct ToothSection {
  double root_width = 0.0;   ///< a [m]
  double pitch_width = 0.0;  ///< b, width at the pitch line, where it is loaded [m].
  double height = 0.0;       ///< c, height from the root to the pitch line [m].
  double flank_angle = 0.0;  ///< beta, angle between flank and radial plane [rad].
  double pitch = 0.0;        ///< p [m]
};

/// Axial deflections of a tooth under an axial load of 1 N/m along its thread [m^2/N].
struct ToothDeflection {
  double bending = 0.0;
  double shear = 0.0;
  double root_inclination = 0.0;
  double root_shear = 0.0;
  double radial = 0.0;

  double total() const { return bending + shear + root_inclination + root_shear + radial; }
};

/// Yamamoto's deflections of a thread tooth (Theory and Calculation of Screw Threads, 1980; Jung
/// 2017, (3.4) to (3.17), where several are misprinted), with f = 1 N/m and cot beta = 1/tan beta:
///
///     bending           (1 - nu^2) 3 f/(4 E) {[1 - (2 - b/a)^2 + 2 ln(a/b)] cot^3 beta
///                                             - 4 (c/a)^2 tan beta}
///     shear             (1 + nu) 6 f/(5 E) cot beta ln(a/b)
///     root inclination  (1 - nu^2) 12 f c/(pi E a^2) (c - b/2 tan beta)
///     root shear        (1 - nu^2) 2 f/(pi E) {p/a ln[(p + a/2)/(p - a/2)]
///                                              + 1/2 ln(4 p^2/a^2 - 1)}
///     radial            f/(2 E) d/p tan^2 beta (1 - nu), external thread,
///                       f/(2 E) d/p tan^2 beta [(D^2 + d^2)/(D^2 - d^2) + nu], nut,
///
/// d the pitch diameter, D the nut's outer diameter (0 for an external thread).
ToothDeflection yamamoto_deflection(const ToothSection& tooth, const Material& material, double pitch_diameter,
                                    double nut_outer_diameter = 0.0);

/// Tooth of a part: as thick as stated or half a pitch at the pitch line, its root at the dedendum, with the default
/// heights of the influence model if the mechanism states none.
ToothSection tooth_section(const Mechanism& mechanism, Part part);

/// Compliance of both teeth of an interface along the contact normal [m/N] after Yamamoto, each loaded over `width` of
/// thread. The theory does not give the width of a point contact. In addition to exact Hertz the same deflection is
/// counted twice: for comparison only.
PerInterface<double> yamamoto_compliance(const Mechanism& mechanism, const Structure& structure,
                                         const Materials& materials, const PerInterface<double>& normal_angle,
                                         double width);

}  // namespace prs
