#pragma once

#include "prs/model/mechanism.h"
#include "prs/model/warning.h"

namespace prs {

/// Range of a number that theory does not determine.
struct Interval {
  double least = 0.0;
  double greatest = 0.0;
};

/// Diameter of the rolling element at a contact [m]: of the ball equivalent to a roller's thread of pitch p on the
/// roller's pitch diameter d_r,
///
///     D_c = sqrt(2.5 p sqrt(2) d_r)
///
/// Lemor, in Jung 2017, (6.2) and (8.27). Made for crowned threads with flanks of 45 deg.
double rolling_element_diameter(double pitch, double roller_diameter);

/// Ratios of diameters for which the geometry factor is known.
inline constexpr Interval kFactorRatios = {0.01, 0.30};

/// Geometry factor f_c over the ratio of diameters, Jung 2017 (6.3): a polynomial through the
/// values that ISO 281 gives for thrust ball bearings of 45 deg contact angle, within 0.35 % of
/// them. For forces in N and lengths in mm. Absent outside 0.01 .. 0.30, where the standard has no
/// values and the polynomial, printed without bounds, turns negative at 0.36 (erratum).
std::optional<double> geometry_factor(double ratio);

/// Largest deviation of (6.3) from the values of ISO 281.
inline constexpr double kFactorFit = 0.0035;

/// Effect of the diameter D_c of the rolling element [m] on its capacity (ISO 281), D_c in mm:
///
///     D_c^1.8 up to 25.4 mm,   3.647 D_c^1.4 beyond
double size_factor(double element_diameter);

/// Dynamic load capacity C_a [N] of all contacts together, which in 90 % of many mechanisms lasts a
/// million revolutions of the screw against the nut:
///
///     C_a = f_c cos(alpha)^0.86 N_c^(2/3) D_c^1.8 tan(alpha) cos(beta)^(1/3)     [N, mm]
///
/// Lemor, in Jung 2017, (6.1), (5.5), (8.26); beyond 25.4 mm `size_factor` in place of D_c^1.8.
/// `contact_angle` alpha is that of bearings, from the radial plane to the contact normal [rad];
/// `contacts` N_c are those of all rollers at one interface; `element_diameter` D_c [m];
/// `helix_angle` beta of the screw [rad], at its own value: Jung's table 7.1 has it fixed at 6.056
/// deg (erratum).
double lemor_capacity(double factor, double contact_angle, int contacts, double element_diameter, double helix_angle);

/// Inputs of Lemor's formula. SI units.
struct LemorGeometry {
  double pitch = 0.0;            ///< p, axial [m]
  double roller_diameter = 0.0;  ///< d_r, pitch diameter of the roller [m].
  double nut_diameter = 0.0;     ///< d_n, pitch diameter of the nut [m].
  double pitch_circle = 0.0;     ///< Diameter of the circle of the rollers' axes, 2 c [m].
  double contact_angle = 0.0;    ///< alpha, measured from the radial plane [rad].
  double helix_angle = 0.0;      ///< beta of the screw [rad]
  int contacts = 0;              ///< N_c
};

/// Contact angle of bearings [rad], measured from the radial plane: a right angle less the mean angle between the
/// contact normals and the axis.
double contact_angle(const PerInterface<double>& normal_angle);

/// Inputs of Lemor's formula from a mechanism with all pitch diameters and the centre distance.
LemorGeometry lemor_geometry(const Mechanism& mechanism, double contact_angle);

/// Lemor's capacity with the range of its factor.
struct LemorCapacity {
  double ratio = 0.0;             ///< d_r cos(alpha)/d_n
  double factor = 0.0;            ///< f_c at this ratio.
  Interval factor_range;          ///< Range by different readings of the ratio and by the fit.
  double element_diameter = 0.0;  ///< D_c [m]
  double capacity = 0.0;          ///< C_a [N]
  Interval capacity_range;        ///< Range of the capacity for the same readings [N].
};

/// Ratio of Jung 2017, section 5.1: d_r cos(alpha)/d_n.
double factor_ratio(const LemorGeometry& g);

/// C_a of a mechanism. Its value uses the ratio of Jung, d_r cos(alpha)/d_n. The factor belongs to ISO 281's ratio of
/// rolling element to pitch circle, which Jung replaces by these diameters, so the range spans the ratios d_r
/// cos(alpha)/d_n, d_r cos(alpha)/(2 c) and D_c cos(alpha)/(2 c), widened by the error of the fit; a ratio beyond 0.30
/// counts as 0.30 there. The uncertainty of Lemor's exponents and of the quality of steel and threads is not included:
/// see `kCapacityOverMakers`. Absent if Jung's ratio is outside 0.01 .. 0.30.
std::optional<LemorCapacity> lemor_capacity(const LemorGeometry& g);

/// Ratio of Lemor's C_a to that of a maker for standard screws of 8 to 120 mm, see validation/standard_screws.
inline constexpr Interval kCapacityOverMakers = {0.69, 1.26};
/// Pitch diameter [m]; that of a screw of 8 mm is a little less.
inline constexpr double kLeastComparedDiameter = 7.5e-3;

/// Warnings if the contact angle [rad] differs from 45 deg, for which Lemor's factor is known, or if the screw is
/// thinner [m] than those of `kCapacityOverMakers`.
std::vector<Warning> beside_lemor_range(double contact_angle, double screw_diameter);

/// A warning if a load [N] exceeds the range of the life formula, half of the dynamic capacity [N] (ISO 281).
std::optional<Warning> beyond_life_formula(double load, double dynamic_capacity);

/// Normal load [N] that gives a contact the peak pressure p_0 [Pa]: with the semi-axes a = a' N^1/3
/// and b = b' N^1/3,
///
///     p_0 = 3 N/(2 pi a b)   =>   N = (2 pi a' b' p_0/3)^3     (Sandu 2018, (1.83)).
double load_at_pressure(const contact::HertzConstants& hertz, double peak_pressure);

/// Exponent p of load in the life of a point contact (Lundberg & Palmgren 1947; ISO 281).
inline constexpr double kLifeExponent = 3.0;
/// Weibull slope e of point contacts (ISO 281): the share that survives L is 0.9^((L/L10)^e).
inline constexpr double kWeibullSlope = 10.0 / 9.0;

/// A load on the mechanism, > 0 in tension [N], and the revolutions of the screw against the nut
/// under it.
struct LoadStep {
  double axial_force = 0.0;
  double revolutions = 0.0;
  double driven_by_load = 0.0;  ///< Revolutions driven by the load.
};

/// L10 [revolutions] at the dynamic capacity C [N] under the load F [N]:
///
///     L10 = 10^6 (C/F)^3
///
/// Jung 2017, (8.25), whose L10 counts millions. Infinite without load.
double rating_life(double capacity, double load);

/// Life that a share S of many reaches over L10, a1 of ISO 281:2007, table 12: 1 at 90 %, 0.64 at
/// 95 %, 0.55, 0.47, 0.37 and 0.25 at 99 %; between them ln a1 is linear in ln ln(1/S), as it is
/// for a Weibull distribution. 0.90 <= S <= 0.99.
double reliability_factor(double reliability);

/// Life modification factor a_ISO of ISO 281:2007, 9.3.3 for radial ball bearings, whose point contacts
/// are those of threads:
///
///     a_ISO = 0.1 (1 - (2.5671 - A/kappa^B)^0.83 (e_C C_u/P)^(1/3))^-9.3 <= 50
///
/// A, B = 2.2649, 0.054381 for 0.1 <= kappa < 0.4; 1.9987, 0.19087 below 1; 1.9987, 0.071739 up to 4. Above 4
/// kappa counts as 4, below 0.1, beyond the standard, a_ISO is 0.1. `viscosity_ratio` kappa, `contamination` e_C,
/// `load_ratio` C_u/P, the fatigue limit load over the load.
double modification_factor(double viscosity_ratio, double contamination, double load_ratio);

/// Equivalent load [N] over revolutions, cubic mean of the magnitudes (Jung 2017, (8.28)):
///
///     F_m = (sum |F_j|^3 n_j / sum n_j)^(1/3)
///
/// (8.28) weights by strokes; revolutions are strokes over the lead. 0 without revolutions.
double mean_load(std::span<const LoadStep> steps);

/// Axial load of a rigidly preloaded bearing of balls under an external load F [N], by the rule of makers,
///
///     F_res = F_V (1 + F/(2.83 F_V))^1.5   while F <= 2.83 F_V, the load that takes the preload F_V off; else F
double preloaded_bearing_load(double load, double preload);

/// Life at which 90 % survive of a system that fails with its first part, from the lives of its parts at the same
/// reliability (product law of Weibull): L = (sum L_i^-e)^(-1/e), e = 10/9. Infinite if no part is loaded.
double combined_life(std::span<const double> lives);

/// Shares w of screw and nut in the failures of a mechanism with equal thread loads, sum 1. ISO/TS 16281 splits the
/// capacity of a thrust ball bearing between its rings in the same way, for equal conformity at both:
///
///     w_screw = 1/(1 + lambda^(10/3)),   w_nut = 1 - w_screw,
///     lambda = Q_screw/Q_nut = ((1 - gamma)/(1 + gamma))^1.72,   gamma = d_r cos(alpha)/(2 c).
///
/// The screw, convex against the rollers, fails first. 0 <= gamma < 1.
PerInterface<double> failure_shares(double gamma);

/// Share of the rollers in the failures of an interface of a full mechanism, if all contacts carry equally; the rest is
/// that of the thread of screw or nut. By Lundberg and Palmgren, both bodies of a contact have the same stress and
/// depth, so that they differ only in cycles u and stressed volume V, u^e V. Their tracks have the lengths pi d, and
/// roll the same distance s on each other:
///
///     rollers/body = N d_R (s/d_R)^e / (d (N s/d)^e) = (N d_R/d)^(1 - e)
///
/// N the number of rollers, d_R their pitch diameter and d that of screw or nut, e = 10/9.
double roller_failure_share(int rollers, double roller_diameter, double body_diameter);

/// L10 [revolutions] of one thread at one interface, of all rollers together, under its equivalent load. With C the
/// mechanism's capacity, w the share of the interface and N the threads of a roller,
///
///     L10 = (N/w)^(1/e) 10^6 (C/F_eq)^3
///
/// `equivalent_load` F_eq [N] is the cubic mean of N times the axial load of the thread of all rollers: the mechanism's
/// load at which this thread would carry as much with equal shares. With equal shares `combined_life` of all threads of
/// both interfaces is `rating_life(C, F)`. The idea is from ISO/TS 16281, with threads in place of slices.
double thread_life(double capacity, double equivalent_load, double failure_share, int threads);

}  // namespace prs
