#pragma once

#include "fe/chain_station.h"
#include "simd/inlined.h"

namespace fe {

/// N = k_0 <w - g>^1.5, the PowerLawSpring of chains; one constant for contact 0 of all stations, one for contact 1.
template <class Real>
struct ChainHertz {
  Real stiffness[2];  ///< k_0 [N/m^1.5]

  PRS_INLINED ChainResponse<Real> evaluate(int i, int, const Real& net_approach) const {
    const Real d = select(net_approach <= 0.0, Real(0.0), net_approach);
    const Real root = stiffness[i] * sqrt(d);
    const Real force = root * d;
    return {0.4 * force * d, force, 1.5 * root};
  }

  /// Deflection of the power law alone [m].
  Real law_approach(int, int, const Real& net_approach) const {
    return select(net_approach <= 0.0, Real(0.0), net_approach);
  }
};

/// ChainHertz with a linear compliance c of either sign in series, N = k_0 <w - g - c N>^1.5. Once a
/// c < 0 takes back half of what the power law adds, the force grows along its tangent (see
/// PowerLawSpring).
template <class Real>
struct ChainHertzInSeries {
  Real stiffness[2];
  const Real* compliance[2];  ///< c of each station [m/N].

  ChainResponse<Real> evaluate(int i, int k, const Real& net_approach) const {
    constexpr int kMostIterations = 100;
    constexpr double kLastStep = 1e-9;  // Relative; the next step is about its square, below rounding.
    constexpr double kNoLimit = 1e100;
    const Real& k0 = stiffness[i];
    const Real& c = compliance[i][k];
    const Real a = c * k0;
    // In x = sqrt(d), d the approach of the power law: x^2 (1 + a x) = total, up to largest x.
    const Real largest_x = select(a < 0.0, -1.0 / (3.0 * a), Real(kNoLimit));
    const Real largest_total = largest_x * largest_x * (1.0 + a * largest_x);
    const Lanes<Real> open = net_approach <= 0.0;
    const Real closed = select(open, Real(1.0), net_approach);
    const Lanes<Real> linear = (a < 0.0) & (closed > largest_total);
    const Real total = select(linear, largest_total, closed);
    Real x = sqrt(total);
    Lanes<Real> searching = x > 0.0;
    for (int iteration = 0; iteration < kMostIterations && any(searching); ++iteration) {
      const Real step = (x * x * (1.0 + a * x) - total) / (x * (2.0 + 3.0 * a * x));
      x = select(searching, x - step, x);
      searching = searching & (abs(step) > kLastStep * x);
    }
    x = select(linear, largest_x, x);
    const Real force = k0 * x * x * x;
    const Real power_law_tangent = 1.5 * k0 * x;
    const Real tangent = power_law_tangent / (1.0 + c * power_law_tangent);
    const Real beyond = select(linear, closed - largest_total, Real(0.0));
    const Real energy = force * (0.4 * x * x + 0.5 * c * force) + beyond * (force + 0.5 * tangent * beyond);
    const Real none(0.0);
    return {select(open, none, energy), select(open, none, force + tangent * beyond), select(open, none, tangent)};
  }

  Real law_approach(int i, int k, const Real& net_approach) const {
    const Real root = cbrt(evaluate(i, k, net_approach).force / stiffness[i]);
    return root * root;
  }
};

}  // namespace fe
