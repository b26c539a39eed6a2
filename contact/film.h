#pragma once

#include "contact/lubricant.h"

namespace contact {

/// What the film of a lubricated contact knows of its two bodies.
struct FilmContact {
  double normal_load = 0.0;      ///< N, static [N]
  double curvature = 0.0;        ///< rho_x, the larger relative curvature [1/m]
  double contact_modulus = 0.0;  ///< E* [Pa]; the E' of the formulas is 2 E* (Sandu's 2/Sigma).
};

/// Central film of an elastohydrodynamic point contact.
struct Film {
  double speed_number = 0.0;  ///< U = eta_0 |u| rho_x/E'
  double parameter = 0.0;     ///< H_c
  double thickness = 0.0;     ///< h_c [m]
};

/// Simplified Moes-Venner formula for a circular contact (Sandu 2018, (2.37) to (2.39)):
///
///     H_c = 1.7 M^(-1/9) L^(3/4),  h_c = H_c sqrt(U)/rho_x,
///     M = N rho_x^2/(E' U^(3/4)),  L = alpha E' U^(1/4),  U = eta_0 |u| rho_x/E',
///
/// with `rolling_speed` |u| [m/s] the *sum* of the two surface velocities. Smooth surfaces, fully
/// flooded, isothermal, piezoviscous-elastic regime. All zero without rolling.
Film central_film(const Lubricant& lubricant, const FilmContact& contact, double rolling_speed);

/// Factor K [s/m] of the sliding speed in Jacod's friction coefficient (Sandu 2018, (2.27),
/// (2.30)),
///
///     mu_D = tau_0/p_D asinh(eta_bar(p_D) K |v_D|),  K = 2/(5 H_c tau_0) sqrt(eta_0 E' rho_x/|u|).
///
/// Zero without rolling, where the no-slip contact does not slide either.
double sliding_factor(const Lubricant& lubricant, const FilmContact& contact, const Film& film,
                      double rolling_speed);

}  // namespace contact
