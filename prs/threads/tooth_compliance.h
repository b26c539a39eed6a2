#pragma once

#include "prs/model/materials.h"
#include "prs/model/mechanism.h"
#include "prs/model/structure.h"

namespace prs {

/// Section of one thread tooth through the axis.
struct ToothSection {
  double root_width = 0.0;   ///< a [m]
  double pitch_width = 0.0;  ///< b, at the pitch line, where it is loaded [m]
  double height = 0.0;       ///< c, from the root to the pitch line [m]
  double flank_angle = 0.0;  ///< beta, between flank and radial plane [rad]
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
ToothDeflection yamamoto_deflection(const ToothSection& tooth, const Material& material,
                                    double pitch_diameter, double nut_outer_diameter = 0.0);

/// The tooth of a part: as thick as stated or half a pitch at the pitch line, its root at the
/// dedendum, with the default heights of the influence model where the mechanism states none.
ToothSection tooth_section(const Mechanism& mechanism, Part part);

/// Compliance of both teeth of an interface along the contact normal [m/N] after Yamamoto, each
/// loaded over `width` of thread. What a point contact's width is, the theory does not say. On top
/// of exact Hertz the same deflection is counted twice: for comparison only.
PerInterface<double> yamamoto_compliance(const Mechanism& mechanism, const Structure& structure,
                                         const Materials& materials,
                                         const PerInterface<double>& normal_angle, double width);

}  // namespace prs
