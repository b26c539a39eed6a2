#include "contact/journal_bearing.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace contact {

namespace {

constexpr double pi = std::numbers::pi;

/// 4 c^2 W/(eta U L^3) over s = eps/sqrt(1 - eps^2), 0 <= s < infinity: in terms of s it is a sum
/// of positive terms, exact for the lightest and the heaviest load.
double load_number(double s) { return s * (1.0 + s * s) * std::hypot(4.0 * s, pi); }

/// The inverse of `load_number`.
double eccentricity_parameter(double load) {
  if (load < 1e-8) return load / pi;  // To s^2 against 1.
  // The load number exceeds both pi s and 4 s^4, so that each gives an upper bound of s. At the
  // lower of the two bounds it is less than 2.9 times the load (most where they cross), and it
  // grows at least in proportion to s: a third of the bound is a lower bound.
  const double greatest = std::min(load / pi, std::sqrt(std::sqrt(load / 4.0)));
  std::uintmax_t iterations = 100;
  const auto [below, above] = boost::math::tools::toms748_solve(
      [load](double s) { return load_number(s) / load - 1.0; }, greatest / 3.0, 1.001 * greatest,
      boost::math::tools::eps_tolerance<double>(), iterations);
  return 0.5 * (below + above);
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
