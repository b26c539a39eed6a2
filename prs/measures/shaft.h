#pragma once

#include "prs/model/materials.h"
#include "prs/model/measure_options.h"
#include "prs/model/mechanism.h"
#include "prs/model/structure.h"

namespace prs {

/// Round shaft, solid or bored, of one section.
struct ShaftSection {
  double diameter = 0.0;  ///< [m]
  double bore = 0.0;      ///< [m]
};

/// The screw between its bore and the roots of its thread, `mechanism.thread` or
/// `default_root_depth` below the pitch line.
ShaftSection core_section(const Mechanism& mechanism, const Structure::Screw& screw);

/// Radius of gyration [m], sqrt(I/A) = sqrt(d^2 + d_b^2)/4.
double radius_of_gyration(const ShaftSection& section);

/// Effective over real length of a column, L_e = K L: 2, 1, 0.69916 (pi/q, tan q = q) and 1/2.
double effective_length_factor(MeasureOptions::Ends ends);

/// Load [N] at which a straight column buckles:
///
///     F = pi^2 E I/(K L)^2                            (Euler)
///     F = A s_y (1 - s_y lambda^2/(4 pi^2 E))         (Johnson),   lambda = K L/sqrt(I/A)
///
/// Johnson's parabola touches Euler's hyperbola at s_y/2 and holds below the slenderness
/// sqrt(2 pi^2 E/s_y); without the yield strength s_y [Pa] the load is Euler's at any length, too
/// high for stocky shafts. No eccentricity, no safety factor.
double buckling_load(const ShaftSection& section, double youngs_modulus,
                     const MeasureOptions::Shaft& shaft, std::optional<double> yield_strength);

/// First bending frequency [rad/s] of the shaft as a uniform slender beam, its critical speed:
///
///     omega = (beta L)^2 sqrt(E I/(rho A L^4)),   beta L = 1.87510, pi, 3.92660, 4.73004
///
/// `density` rho [kg/m^3]. The roots are those of cos(x) cosh(x) = -1, sin(x) = 0,
/// tan(x) = tanh(x) and cos(x) cosh(x) = 1. Axial load, gyroscopic effect, the nut's support and
/// the margin of catalogues (80 %) are left out. Shear and rotary
/// inertia, too: up to 1 % for L > 20 diameters.
double critical_speed(const ShaftSection& section, double youngs_modulus, double density,
                      const MeasureOptions::Shaft& shaft);

}  // namespace prs
