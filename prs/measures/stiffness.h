#pragma once

#include <span>

#include "prs/model/load_case.h"
#include "prs/model/model_options.h"

namespace prs {

/// Round shaft of one section, solid or bored.
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
double buckling_load(const ShaftSection& section, double youngs_modulus, const MeasureOptions::Shaft& shaft,
                     std::optional<double> yield_strength);

/// First bending frequency [rad/s] of the shaft as a uniform slender beam, its critical speed:
///
///     omega = (beta L)^2 sqrt(E I/(rho A L^4)),   beta L = 1.87510, pi, 3.92660, 4.73004
///
/// `density` rho [kg/m^3]. The roots are those of cos(x) cosh(x) = -1, sin(x) = 0, tan(x) = tanh(x) and cos(x) cosh(x)
/// = 1. Axial load, gyroscopic effect, the nut's support and the margin of catalogues (80 %) are left out, as are shear
/// and rotary inertia: up to 1 % for L > 20 diameters.
double critical_speed(const ShaftSection& section, double youngs_modulus, double density,
                      const MeasureOptions::Shaft& shaft);

/// Axial stiffness of the sections of a mechanism between two threads [N/m], with the sections of
/// the sector model: screw from bore to pitch diameter, nut from pitch diameter to outer diameter
/// between the flanges, N_r rollers of their pitch diameter side by side:
///
///     k_S = E A_S/p (3.2),   k_N = E A_N/p (3.1),   k_R = N_r E A_R/(2 p) (3.3)
///
/// Jung 2017, section 3.1. (3.3) takes two pitches without a reason; the sector model has E A_R/p.
PerPart<double> section_stiffness(const Mechanism& mechanism, const Structure& structure, const Materials& materials);

/// Axial stiffness of a part's tooth at one contact [N/m]: the width w of thread loaded by a contact [m] over
/// Yamamoto's deflection under 1 N/m, see `yamamoto_deflection`. The theory does not give w; together with Hertz's
/// approach part of the deflection is counted twice.
double tooth_stiffness(const Mechanism& mechanism, const Structure& structure, const Materials& materials, Part part,
                       double width);

/// Coefficient h [m/N^(2/3)] of the axial approach h F^(2/3) of roller and body under the axial load F of a thread,
/// without radial motion. With N = F/cos(psi) = k_0 delta^(3/2) and delta = u cos(psi),
///
///     h = 1/(k_0^(2/3) cos(psi)^(5/3))
///
/// `hertz_constant` k_0 [N/m^1.5], `normal_angle` psi between contact normal and axis [rad].
double axial_hertz_coefficient(double hertz_constant, double normal_angle);

/// Secant stiffness F/u [N/m] of `threads` n contacts side by side that share F [N] > 0 equally,
/// each with the axial approach h f^(2/3) + c f under its load f = F/n; `tooth_compliance` c [m/N]:
///
///     k = n/(h f^(-1/3) + c)
///
/// Jung 2017, (3.45), (3.46), for all threads in place of one.
double thread_stiffness(double force, int threads, double coefficient, double tooth_compliance);

/// Axial stiffness of an axis, and the compliances of its parts.
struct SystemStiffness {
  struct Contribution {
    double stiffness = 0.0;  ///< [N/m]
    double share = 0.0;      ///< Share of the total compliance; all sum to 1.
  };
  struct Contributions {
    std::optional<Contribution> mechanism, shaft, wind_up, support_bearing, housing;
  };
  double total = 0.0;  ///< [N/m]
  Contributions contributions;
};

/// Stiffness in series, 1/k = sum 1/k_i, with
///
///     shaft    L/(E A) to one bearing, x (L - x)/(L E A) between two,
///     wind_up  (l/(2 pi))^2 L_t/(G J),   G = E/(2 (1 + nu)),
///     A = pi/4 (d^2 - b^2),   J = pi/32 (d^4 - b^4).
///
/// `mechanism`: the secant stiffness of the screw at rest [N/m]; `section`, `material`, `lead` l [m]: of the screw, d
/// its pitch diameter. Without friction.
SystemStiffness system_stiffness(double mechanism, const MeasureOptions::System& system, const ShaftSection& section,
                                 const Material& material, double lead);

/// Bodies between two neighbouring threads: axial compliances [m/N] of screw and nut under the loads of one roller,
/// which shares their sections with the others (p N_r/(E A)).
struct ThreadGap {
  double screw = 0.0;
  /// Compliance of the nut, on the side of the thrust section that faces the loaded end of the screw [m/N].
  double nut_before_thrust = 0.0;
  double nut_behind_thrust = 0.0;
};

/// Bodies between the threads as bars of the sector model: screw from bore to pitch diameter, nut from pitch diameter
/// to its outer diameter or that of its flanges.
std::vector<ThreadGap> thread_gaps(const Mechanism& mechanism, const Structure& structure, const Materials& materials,
                                   double thrust, double position);

/// Axial loads F_k [N] of the threads of one roller, thread 1 first, of sum F, after Yang (Jung 2017, (4.1) and (8.20),
/// both misprinted). Each tooth of the roller is a ball between screw and nut: it passes its load on, so that both
/// interfaces have the same loads, and no load goes along the roller. The axial approaches w_k = h F_k^(2/3) of both
/// contacts together, h the sum of `axial_hertz_coefficient`, then differ by the stretch of screw and nut between two
/// threads. With S_k = sum F_j over j >= k, which the screw carries in front of thread k, and P_k = F - S_(k+1), which
/// the nut carries in front of the thrust section, in the direction of the load
///
///     w_k - w_(k+1) = S_(k+1) (c_S + c_N behind) - P_k c_N before.
///
/// With the thrust section at the loaded end ("same side") this is h (F_(i-1)^(2/3) - F_i^(2/3)) = p N_r (1/(E A_S) +
/// 1/(E A_N)) sum_(j >= i) F_j; at the other end ("opposite side") the nut's term is -sum_(j < i) F_j. It is the sector
/// model without bending in the limit of a roller whose core has no axial stiffness; with a rigid core the interfaces
/// would be independent. The real roller lies between. Friction, teeth, deviations and Poisson's ratio are left out; a
/// thread without approach is open.
///
/// All w_k follow from w_n, with which their sum of loads grows: one root, bracketed, found to rounding. Empty if
/// rounding makes the sum miss F by more than 1e-9 F: loads that differ by many orders between the ends.
std::vector<double> yang_distribution(double roller_force, double coefficient, std::span<const ThreadGap> gaps);

}  // namespace prs
