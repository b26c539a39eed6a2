#pragma once

namespace contact {

/// Plain bearing of a journal in a full circular hole.
struct JournalBearing {
  double length = 0.0;            ///< L [m]
  double diameter = 0.0;          ///< D [m]
  double radial_clearance = 0.0;  ///< c, the largest eccentricity [m]
};

/// The answer of one journal bearing to a load.
struct JournalBearingState {
  /// e/c, 0 without load; a heavier load than any film carries rounds to 1, as does any at rest.
  double eccentricity_ratio = 0.0;
  double torque = 0.0;  ///< On the journal, resisting, >= 0 [N m]
};

/// Equilibrium of a journal that turns at `speed` [rad/s] (in either sense) under the radial load
/// W [N] >= 0 in a lubricant of constant viscosity eta [Pa s] > 0. With the surface speed
/// U = |speed| D/2 and the eccentricity ratio eps = e/c, the film's pressure
///
///     p = 3 eta U/(D/2 c^2) (L^2/4 - z^2) eps sin(theta)/(1 + eps cos(theta))^3,
///
/// 0 < theta < pi from the widest gap on, zero beyond (half Sommerfeld), carries
///
///     W = eta U L^3/(4 c^2) eps/(1 - eps^2)^2 sqrt(16 eps^2 + pi^2 (1 - eps^2))
///
/// at the attitude angle tan(phi) = pi sqrt(1 - eps^2)/(4 eps), which determines eps. The torque on
/// the journal is that of the shear flow all around (that of Petroff for eps = 0), as if the
/// cavitated half were full, and of the pressure flow,
///
///     M = eta U L D^2/(4 c) 2 pi/sqrt(1 - eps^2) + 1/2 W e sin(phi);
///
/// the hole feels M less W e sin(phi). Valid for thin isothermal laminar films, c << D, smooth
/// surfaces, aligned axes, and L/D <= 1: the axial flow is taken to outweigh the one around.
/// Against Raimondi and Boyd 1958, who keep both, W of a given eps is too large by 2 % (eps = 0.1)
/// to 17 % (0.8) for L/D = 1/4, by 9 % to 66 % for 1/2 and by 34 % to a factor of 3.2 for 1.
/// Contact of rough surfaces near eps = 1 is not part of it.
///
/// Source: Ocvirk 1952, NACA TN 2808; DuBois and Ocvirk 1953, NACA Report 1157 (their capacity
/// number is eta N/P (D/2c)^2 (L/D)^2 with P = W/(L D) and N revolutions per second). The ratio eps
/// is exact to about 1e-15, and so is 1 - eps^2 within the torque, for any load.
JournalBearingState short_bearing(const JournalBearing& bearing, double viscosity, double speed,
                                  double load);

}  // namespace contact
