#pragma once

#include "prs/life/capacity.h"

namespace prs {

/// Exponent p of load in the life of a point contact (Lundberg & Palmgren 1947; ISO 281).
inline constexpr double kLifeExponent = 3.0;
/// Weibull slope e of point contacts (ISO 281): the share that survives L is 0.9^((L/L10)^e).
inline constexpr double kWeibullSlope = 10.0 / 9.0;

/// A load on the mechanism, > 0 in tension [N], and the revolutions of the screw against the nut
/// under it.
struct LoadStep {
  double axial_force = 0.0;
  double revolutions = 0.0;
  double driven_by_load = 0.0;  ///< Those of them that the load drives.
};

/// L10 [revolutions] of what has the dynamic capacity C [N] under the load F [N]:
///
///     L10 = 10^6 (C/F)^3
///
/// Jung 2017, (8.25), whose L10 counts millions. Infinite without load.
double rating_life(double capacity, double load);

/// Life that a share S of many reaches over L10, a1 of ISO 281:2007, table 12: 1 at 90 %, 0.64 at
/// 95 %, 0.55, 0.47, 0.37 and 0.25 at 99 %; between them ln a1 is linear in ln ln(1/S), as it is
/// for a Weibull distribution. 0.90 <= S <= 0.99.
double reliability_factor(double reliability);

/// Equivalent load [N] over revolutions, cubic mean of the magnitudes (Jung 2017, (8.28)):
///
///     F_m = (sum |F_j|^3 n_j / sum n_j)^(1/3)
///
/// (8.28) weights by strokes; revolutions are strokes over the lead. 0 without revolutions.
double mean_load(std::span<const LoadStep> steps);

/// Life at which 90 % survive of what fails with its first part, from the lives of its parts at the
/// same reliability (product law of Weibull): L = (sum L_i^-e)^(-1/e), e = 10/9. Infinite where no
/// part is loaded.
double combined_life(std::span<const double> lives);

/// Shares w of screw and nut in the failures of a mechanism with equal thread loads, sum 1. As
/// ISO/TS 16281 splits the capacity of a thrust ball bearing between its rings, for equal
/// conformity at both:
///
///     w_screw = 1/(1 + lambda^(10/3)),   w_nut = 1 - w_screw,
///     lambda = Q_screw/Q_nut = ((1 - gamma)/(1 + gamma))^1.72,   gamma = d_r cos(alpha)/(2 c).
///
/// The screw, convex against the rollers, fails first. 0 <= gamma < 1.
PerInterface<double> failure_shares(double gamma);

/// Part of the rollers in the failures of an interface of a full mechanism, where all contacts
/// carry alike; the rest is that of the thread of screw or nut. By Lundberg and Palmgren, both
/// bodies of a contact have its stress and its depth, so that only cycles u and stressed volume V
/// tell them apart, u^e V. Their tracks have the lengths pi d, and roll the same way s on each
/// other:
///
///     rollers/body = N d_R (s/d_R)^e / (d (N s/d)^e) = (N d_R/d)^(1 - e)
///
/// N the rollers, d_R their pitch diameter and d that of screw or nut, e = 10/9.
double roller_failure_share(int rollers, double roller_diameter, double body_diameter);

/// L10 [revolutions] of one thread at one interface, that of all rollers together, under its
/// equivalent load. With C the mechanism's capacity, w the share of the interface and N the threads
/// of a roller,
///
///     L10 = (N/w)^(1/e) 10^6 (C/F_eq)^3
///
/// `equivalent_load` F_eq [N] is the cubic mean of N times the axial load of the thread of all
/// rollers: the mechanism's load at which this thread would carry as much with equal shares. With
/// equal shares `combined_life` of all threads of both interfaces is `rating_life(C, F)`. After the
/// idea of ISO/TS 16281, whose slices the threads are.
double thread_life(double capacity, double equivalent_load, double failure_share, int threads);

}  // namespace prs
