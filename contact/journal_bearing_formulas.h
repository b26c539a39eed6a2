#pragma once

#include <numbers>

#include "simd/dual.h"

/// Formulas of journal_bearing.h for numbers, batches with one bearing per lane, and either with a
/// slope.
namespace contact {

/// See `JournalBearing`.
template <class Real>
struct JournalBearingNumbers {
  Real length, diameter, radial_clearance;
};

/// See `JournalBearingState`.
template <class Number>
struct JournalBearingStateOf {
  Number eccentricity_ratio{}, torque{};
};

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
  // The load number exceeds both pi s and 4 s^4, so that each gives an upper bound of s. It is
  // convex: Newton's method comes down from there until rounding ends it.
  const auto heavy = load >= Real(1e-8);  // Lighter, s is load/pi to s^2 against 1.
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
    return select(heavy, Number(s, Real(load_number.slope / (number * growth))),
                  Number(load_number / Real(pi)));
}

/// See `short_bearing`; `speed` >= 0.
template <class Number, class Real>
JournalBearingStateOf<Number> short_bearing_of(const JournalBearingNumbers<Real>& bearing,
                                               const Real& viscosity, const Number& speed,
                                               const Number& load) {
  using simd::select, simd::sqrt, simd::value;
  const auto& [length, diameter, clearance] = bearing;
  const Number drag = viscosity * 0.5 * speed * diameter * length;  // eta U L [N]
  const Real slenderness = length / clearance;
  const Number s =
      eccentricity_parameter(Number(4.0 * load / (drag * (slenderness * slenderness))));
  const Number square = s * s, root = sqrt(Number(1.0 + square));  // 1/sqrt(1 - eps^2)
  const auto turns = value(speed) > Real(0.0);
  const Number at_rest = select(value(load) > Real(0.0), Number(Real(1.0)), Number(Real(0.0)));
  // W e sin(phi) = pi eta U L^3/(4 c) s^2 root.
  return {select(turns, s / root, at_rest),
          select(turns,
                 std::numbers::pi * drag / clearance * root *
                     (0.5 * diameter * diameter + 0.125 * length * length * square),
                 Number(Real(0.0)))};
}

}  // namespace contact
