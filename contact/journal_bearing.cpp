#include "contact/journal_bearing.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace contact {

namespace {

constexpr double pi = std::numbers::pi;

/// The eccentricity as s = eps/sqrt(1 - eps^2), 0 <= s < infinity, of the load number
///
///     4 c^2 W/(eta U L^3) = s (1 + s^2) sqrt(16 s^2 + pi^2),
///
/// a sum of positive terms in s, exact for the lightest and the heaviest load.
double eccentricity_parameter(double load) {
  if (load < 1e-8) return load / pi;  // To s^2 against 1.
  // The load number exceeds both pi s and 4 s^4, so that each gives an upper bound of s. It is
  // convex: Newton's method comes down from there until rounding ends it.
  double s = std::min(load / pi, std::sqrt(std::sqrt(load / 4.0)));
  for (int iteration = 0; iteration < 100; ++iteration) {
    const double square = s * s, under_root = 16.0 * square + pi * pi;
    const double number = s * (1.0 + square) * std::sqrt(under_root);
    const double growth = 1.0 / s + 2.0 * s / (1.0 + square) + 16.0 * s / under_root;
    const double next = s - (1.0 - load / number) / growth;
    if (!(next < s)) break;
    s = next;
  }
  return s;
}

}  // namespace

JournalBearingState short_bearing(const JournalBearing& bearing, double viscosity, double speed,
                                  double load) {
  const auto& [length, diameter, clearance] = bearing;
  assert(length > 0.0 && diameter > 0.0 && clearance > 0.0);
  assert(viscosity > 0.0 && load >= 0.0);
  if (speed == 0.0) return {load > 0.0 ? 1.0 : 0.0, 0.0};

  const double drag = viscosity * 0.5 * std::abs(speed) * diameter * length;  // eta U L [N]
  const double slenderness = length / clearance;
  const double s = eccentricity_parameter(4.0 * load / (drag * slenderness * slenderness));
  const double root = std::hypot(1.0, s);  // 1/sqrt(1 - eps^2)
  JournalBearingState state;
  state.eccentricity_ratio = s / root;
  // W e sin(phi) = pi eta U L^3/(4 c) s^2 root.
  state.torque =
      pi * drag / clearance * root * (0.5 * diameter * diameter + 0.125 * length * length * s * s);
  return state;
}

}  // namespace contact
