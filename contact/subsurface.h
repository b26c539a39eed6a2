#pragma once

#include "contact/hertz.h"

namespace contact {

/// Stresses on the normal through the centre of a contact ellipse, over its peak pressure,
/// compression negative; the three are principal there.
struct AxisStress {
  double along_major = 0.0;
  double along_minor = 0.0;
  double along_normal = 0.0;

  double largest_shear() const;  ///< Half the largest difference of two of them.
};

/// Frictionless elliptic Hertz contact, at the depth z below the centre. Over p_0, with
/// A^2 = a^2 + z^2, B^2 = b^2 + z^2 and I_a = int_{z^2}^inf dw/((a^2 + w) sqrt((a^2 + w)(b^2 + w)
/// w)):
///
///     sigma_z = -a b/(A B),
///     sigma_x = a b ((1 - nu) z I_a - nu z I_z - (1 - 2 nu)/(A (A + B))),
///     sigma_y = a b ((1 - nu) z I_b - nu z I_z - (1 - 2 nu)/(B (A + B))),
///     z (I_a + I_b + I_z) = 2/(A B),
///
/// x along the major axis: Boussinesq's potentials of a semi-ellipsoidal pressure (Thomas & Hoersch
/// 1930; Johnson 1985, section 3.4) in a form that holds through the circle. Only ratios matter, so
/// depth and axes may be in any one unit.
AxisStress stress_on_axis(double semi_major, double semi_minor, double depth, double poisson_ratio);

/// The largest shear stress on that normal and where it acts.
struct SubsurfaceShear {
  double shear_over_pressure = 0.0;    ///< tau_max/p_0 [-]
  double depth_over_semi_minor = 0.0;  ///< z/b [-]
};

/// Largest shear on the normal through the centre of an ellipse b/a = `ellipticity`. For nu = 0.3:
/// 0.310 p_0 at 0.48 b in a circular contact, 0.300 p_0 at 0.79 b in a line contact, up to 0.325
/// in between. For nu below about 0.2 long
/// ellipses have it near the surface.
SubsurfaceShear largest_subsurface_shear(double ellipticity, double poisson_ratio);

}  // namespace contact
