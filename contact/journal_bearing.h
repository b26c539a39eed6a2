#pragma once

#include <cassert>
#include <numbers>

#include "simd/dual.h"

/// Formulas for numbers, batches with one bearing per lane, and either with a slope.
namespace contact {

/// Plain bearing of a journal in a full circular hole.
template <class Real>
struct JournalBearingOf {
  Real length{};            ///< L [m]
  Real diameter{};          ///< D [m]
  Real radial_clearance{};  ///< c, the largest eccentricity [m]
};
using JournalBearing = JournalBearingOf<double>;

/// Result for one journal bearing under a load.
template <class Number>
struct JournalBearingStateOf {
  /// e/c, 0 without load; a load too heavy for any film rounds to 1, as does any load at rest.
  Number eccentricity_ratio{};
  Number torque{};  ///< Resisting torque on the journal, >= 0 [N m].
};
using JournalBearingState = JournalBearingStateOf<double>;

/// The eccentricity as s = eps/sqrt(1 - eps^2), 0 <= s < infinity, of the load number
///
///     4 c^2 W/(eta U L^3) = s (1 + s^2) sqrt(16 s^2 + pi^2),
///
/// a sum of positive terms in s, exact for the lightest and the heaviest load.
template <class Number>
Number eccentricity_parameter(const Number& load_number) {
  using Real = simd::ValueOf<Number>;
  using simd::any, simd::min, simd::select, simd::sqrt, simd::value;
  constexpr double pi = std::numbers::pi;
  const Real load = value(load_number);
  // The load number exceeds both pi s and 4 s^4, so that each gives an upper bound of s. It is convex: Newton's method
  // descends from there until rounding ends it.
  const auto heavy = load >= Real(1e-8);  // For a lighter load s is load/pi, to s^2 relative to 1.
  Real s = min(Real(load / pi), Real(sqrt(Real(sqrt(Real(load / 4.0))))));
  Real number = load, growth = Real(1.0);
  auto active = heavy;
  for (int iteration = 0; iteration < 100 && any(active); ++iteration) {
    const Real square = s * s, under_root = 16.0 * square + pi * pi;
    number = s * (1.0 + square) * sqrt(under_root);
    growth = 1.0 / s + 2.0 * s / (1.0 + square) + 16.0 * s / under_root;
    const Real next = s - (1.0 - load / number) / growth;
    active = active && next < s;
    s = select(active, next, s);
  }
  if constexpr (std::is_same_v<Number, Real>)
    return select(heavy, s, Real(load / pi));
  else
    return select(heavy, Number(s, Real(load_number.slope / (number * growth))), Number(load_number / Real(pi)));
}

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
template <class Number, class Real>
JournalBearingStateOf<Number> short_bearing(const JournalBearingOf<Real>& bearing, const Real& viscosity,
                                            const Number& speed, const Number& load) {
  using simd::abs, simd::select, simd::sqrt, simd::value;
  const auto& [length, diameter, clearance] = bearing;
  if constexpr (std::is_same_v<Number, double>) {
    assert(length > 0.0 && diameter > 0.0 && clearance > 0.0);
    assert(viscosity > 0.0 && load >= 0.0);
  }
  const Number drag = viscosity * 0.5 * abs(speed) * diameter * length;  // eta U L [N]
  const Real slenderness = length / clearance;
  const Number s = eccentricity_parameter(Number(4.0 * load / (drag * (slenderness * slenderness))));
  const Number square = s * s, root = sqrt(Number(1.0 + square));  // 1/sqrt(1 - eps^2)
  const auto turns = value(speed) != Real(0.0);
  const Number at_rest = select(value(load) > Real(0.0), Number(Real(1.0)), Number(Real(0.0)));
  // W e sin(phi) = pi eta U L^3/(4 c) s^2 root.
  return {select(turns, s / root, at_rest), select(turns,
                                                   std::numbers::pi * drag / clearance * root *
                                                       (0.5 * diameter * diameter + 0.125 * length * length * square),
                                                   Number(Real(0.0)))};
}

}  // namespace contact
