#pragma once

#include "contact/lubricant.h"

namespace contact {

/// Which way a contact is taken to roll for its central film: along the minor axis of its ellipse,
/// or as it does.
enum class FilmDirection { minor_axis, rolling };

/// Inputs of the film formulas for one lubricated contact of two bodies.
struct FilmContact {
  double normal_load = 0.0;      ///< N, static [N]
  double curvature = 0.0;        ///< rho_x, the larger relative curvature [1/m]
  double contact_modulus = 0.0;  ///< E* [Pa]; the E' of the formulas is 2 E* (Sandu's 2/Sigma).
  double curvature_ratio = 1.0;  ///< lambda, smaller over larger relative curvature, above 0 to 1.
  FilmDirection direction = FilmDirection::minor_axis;  ///< Formula of `central_film`.
};

/// Dimensionless speed, load and lubricant of Moes, with `rolling_speed` |u| [m/s] the *sum* of the
/// two surface velocities (Sandu 2018, (2.38)):
///
///     U = eta_0 |u| rho_x/E',   M = N rho_x^2/(E' U^(3/4)),   L = alpha E' U^(1/4)
///
/// They define a film where |u| > 0.
struct MoesNumbers {
  double speed = 0.0;      ///< U
  double load = 0.0;       ///< M
  double lubricant = 0.0;  ///< L
};
MoesNumbers moes_numbers(const Lubricant& lubricant, const FilmContact& contact,
                         double rolling_speed);

/// Central film of an elastohydrodynamic point contact.
struct Film {
  double parameter = 0.0;  ///< H
  double thickness = 0.0;  ///< h = H sqrt(U)/rho_x [m]
};

/// Moes and Venner's formula for a circular contact as Sandu simplifies it (2018, (2.37), (2.39)):
///
///     H = 1.7 M^(-1/9) L^(3/4)
///
/// Smooth surfaces, fully flooded, isothermal, piezoviscous-elastic regime. It lies 15 to 18 %
/// above the full fit at Sandu's reference example. All zero without rolling.
Film sandu_film(const Lubricant& lubricant, const FilmContact& contact, double rolling_speed);

/// Film parameters H where one regime rules (Nijenbanning, Venner, Moes, Wear 176 (1994) 217), with
/// lambda the ratio of the relative curvatures, k = 1 + 0.006 ln lambda + 0.63 lambda^(4/7):
///
///     H_RI = 145 (1 + 0.796 lambda^(14/15))^(-15/7) lambda^-1 M^-2     rigid, isoviscous
///     H_EI = 3.18 k^(-14/25) lambda^(-1/15) M^(-2/15)                  elastic, isoviscous
///     H_RP = 1.29 (1 + 0.691 lambda)^(-2/3) L^(2/3)                    rigid, piezoviscous
///     H_EP = 1.48 k^(-7/20) lambda^(-1/24) M^(-1/12) L^(3/4)           elastic, piezoviscous
///     H_00 = 1.80 lambda^(-5/7)            bound of the elastic, isoviscous film at small loads
struct FilmRegimes {
  double rigid_isoviscous = 0.0;
  double elastic_isoviscous = 0.0;
  double rigid_piezoviscous = 0.0;
  double elastic_piezoviscous = 0.0;
  double small_load = 0.0;
};
FilmRegimes film_regimes(const MoesNumbers& numbers, double curvature_ratio);

/// H of the full fit through all regimes (Nijenbanning, Venner, Moes 1994),
///
///     H = [(H_RI^(3/2) + (H_EI^-4 + H_00^-4)^(-3/8))^(2s/3) + (H_RP^-8 + H_EP^-8)^(-s/8)]^(1/s),
///     s = 1.5 (1 + exp(-1.2 H_EI/H_EP))
double film_parameter(const FilmRegimes& regimes);

/// Central film by the full fit, for elliptical contacts that roll along the minor axis: lambda is
/// 1 for a circle, the film of a wide ellipse is thicker. Smooth surfaces, fully flooded,
/// isothermal, Newtonian, viscosity exponential in pressure. Dimensionless numbers as above. All
/// zero without rolling.
Film nijenbanning_film(const Lubricant& lubricant, const FilmContact& contact,
                       double rolling_speed);

/// Radius of the relative curvature across the rolling over that along it, R_s/R_e, at the share
/// `along_major` s of |u|^2 along the major axis:
///
///     1/R_e = rho_x (1 - s + lambda s),   1/R_s = rho_x (s + lambda (1 - s))
double rolling_radius_ratio(const FilmContact& contact, double along_major);

/// Range of R_s/R_e in which `chittenden_film` is taken without a warning. At its upper end
/// ellipses are 8 times as long as wide, as in the solutions of Hamrock and Dowson (J. Lubr.
/// Technol. 99 (1977) 264) that it goes on from; at its lower end side leakage takes three quarters
/// of the film.
inline constexpr double kLeastRollingRatio = 0.1, kGreatestRollingRatio = 25.0;

/// Central film [m] at any angle between rolling and the axes of the ellipse (Chittenden, Dowson,
/// Dunn, Taylor, Proc. R. Soc. Lond. A 397 (1985) 245 and 271), elastic and piezoviscous,
///
///     h = 4.31 R_e U^0.68 G^0.49 W^-0.073 (1 - exp(-1.23 (R_s/R_e)^(2/3))),
///     U = eta_0 |u|/(2 E' R_e),   G = alpha E',   W = N/(E' R_e^2)
///
/// with |u| the sum of both velocities, R_e and R_s as in `rolling_radius_ratio`. Smooth surfaces,
/// fully flooded, isothermal, Newtonian. 0 without rolling.
double chittenden_film(const Lubricant& lubricant, const FilmContact& contact, double rolling_speed,
                       double along_major);

/// The film by the direction that the contact has: `nijenbanning_film` or `chittenden_film` [m].
double central_film(const Lubricant& lubricant, const FilmContact& contact, double rolling_speed,
                    double along_major);

/// Share of the load on flanks that touch through a film of Lambda times their composite Rq,
/// (1 + Lambda)^-exponent, with an exponent of 2 after Olver and Spikes (Proc. Instn Mech. Engrs J
/// 212, 1998, 321): 1 without film, 0.25 where the film is as thick as the roughness.
double boundary_share(double film_ratio, double exponent);

/// Factor K [s/m] of the sliding speed in Jacod's friction coefficient (Sandu 2018, (2.27),
/// (2.30)),
///
///     mu_D = tau_0/p_D asinh(eta_bar(p_D) K |v_D|),  K = 2/(5 H_c tau_0) sqrt(eta_0 E' rho_x/|u|),
///
/// with Sandu's film. Zero without rolling, where the no-slip contact does not slide either.
double sliding_factor(const Lubricant& lubricant, const FilmContact& contact, const Film& film,
                      double rolling_speed);

}  // namespace contact
