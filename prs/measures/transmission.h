#pragma once

#include "prs/model/mechanism.h"

namespace prs {

/// Travel of the screw against the nut per angle [m/rad], |l|/(2 pi). Jung 2017, (8.30), has a
/// factor d_s/d_r that does not belong there (erratum).
double velocity_ratio(double lead);

/// Speeds of rollers and carrier over that of the screw, nut at rest, > 0 in the screw's sense.
struct PlanetaryRatios {
  double roller = 0.0;   ///< omega_R/omega_S
  double carrier = 0.0;  ///< omega_C/omega_S
};

/// Rollers that roll without slip, at the gears as on the other part, all on pitch circles (Sandu
/// 2018, (2.4) and (2.21)); with matched pitch diameters
///
///     omega_C/omega_S = d_S/(2 (d_S + d_R)),   omega_R/omega_S = -d_S/(2 d_R)
///
/// Jung 2017, (2.27), is inverted and (2.9) to (2.13) are the carrier's view (errata). `gear_ratio`
/// Gamma = |l_R/l_S| > 0, below 1 for standard mechanisms. `SlipResult` has the ratio with
/// friction.
PlanetaryRatios planetary_ratios(Mechanism::Type type, double gear_ratio);

/// Speeds against the frame over that of the part that turns (`against_frame`, `turning_speed` of
/// kinematics.h): x -> 1 - x for the inverted mechanism, whose nut turns.
PlanetaryRatios ratios_to_frame(Mechanism::Type type, const PlanetaryRatios& nut_at_rest);

/// Efficiency of turning rotation into travel (Jung 2017, (8.29)), with the friction angle of one
/// equivalent thread on the screw's pitch diameter:
///
///     eta = 1/(1 + pi d_S mu/l)
///
/// `friction_coefficient` mu is that of the whole mechanism, as catalogues state it, not that of a
/// sliding contact. Small mu and no preload.
double efficiency(double lead, double screw_diameter, double friction_coefficient);

/// Efficiency of turning travel into rotation, 1 - pi d_S mu/l = 2 - 1/eta, by the same argument.
/// Absent where it is not positive: the screw is self-locking. A rough estimate: where the screw
/// itself drives at 0.77 to 0.89, it misses a maker's values by -0.07 to +0.01 and those of slip by
/// -0.06 to -0.03, as rolling and spinning contacts lose about the same share of the power both
/// ways.
std::optional<double> back_driving_efficiency(double lead, double screw_diameter,
                                              double friction_coefficient);

/// Torque [N m] that moves a load F [N] against its direction: F |l|/(2 pi eta).
double drive_torque(double force, double lead, double efficiency);

/// Inertia [kg m^2] of N_r rollers seen at the part that turns, their spin and their orbit:
///
///     N_r (I_R (omega_R/omega)^2 + M_R c^2 (omega_C/omega)^2)
///
/// `mass` M_R [kg] and `inertia` I_R [kg m^2] of one roller, speeds against the frame. Jung 2017,
/// (8.33), has d_S/(2 d_N) in place of d_S/(2 d_R) and no orbit (erratum).
double roller_inertia(int rollers, double mass, double inertia, double centre_distance,
                      const PlanetaryRatios& to_frame);

/// Inertia [kg m^2] of a travelling mass [kg] seen at the part that turns: M (l/(2 pi))^2, Jung
/// 2017, (8.32) in its right form (erratum).
double travel_inertia(double mass, double lead);

}  // namespace prs
