#pragma once

#include <numbers>

#include "simd/lanes.h"

/// Formulas of local_compliance.h for a number or a batch of numbers.
namespace prs {

template <class Real>
struct ElasticNumbers {
  Real modulus{};  ///< E [Pa]
  Real poisson{};  ///< nu
};

/// As `LineReach`.
template <class Real>
struct LineReachOf {
  Real normal{};
  Real tangential{};
};

template <class Real>
LineReachOf<Real> reach_around(const Real& radius, const Real& rows) {
  return {radius / rows, radius / rows};
}

template <class Real>
LineReachOf<Real> reach_of_opposite(const Real& radius) {
  constexpr double kE = std::numbers::e;
  return {2.0 / kE * radius, 2.0 / (kE * kE) * radius};
}

template <class Real>
Real concentration(const LineReachOf<Real>& reach, const ElasticNumbers<Real>& m, const Real& pitch,
                   const Real& sine, const Real& cosine) {
  using simd::log;
  constexpr double kPi = std::numbers::pi, kEulerGamma = std::numbers::egamma;
  const Real shear_modulus = m.modulus / (2.0 * (1.0 + m.poisson));
  const auto row = [&](const Real& length) { return log(0.5 * length / pitch) + kEulerGamma; };
  return sine * sine * 2.0 * (1.0 - m.poisson * m.poisson) / (kPi * m.modulus * pitch) *
             row(reach.normal) +
         cosine * cosine / (kPi * shear_modulus * pitch) * row(reach.tangential);
}

/// (R^2 + r^2)/(R^2 - r^2) of Lame's solution.
template <class Real>
Real lame_ratio(const Real& outer, const Real& inner) {
  return (outer * outer + inner * inner) / (outer * outer - inner * inner);
}

/// Radial pressure times its radius per normal load, projected back on the normal, over E [m/N].
template <class Real>
Real pressure_factor(const Real& modulus, const Real& rollers, const Real& pitch,
                     const Real& sine) {
  constexpr double kTwoPi = 2.0 * std::numbers::pi;
  return rollers * sine * sine / (kTwoPi * pitch * modulus);
}

template <class Real>
Real of_cylinder(const Real& radius, const Real& bore, const ElasticNumbers<Real>& m,
                 const Real& rollers, const Real& pitch, const Real& sine) {
  return pressure_factor(m.modulus, rollers, pitch, sine) * (lame_ratio(radius, bore) - m.poisson);
}

/// artanh(x)/x - 1 for 0 < x < 1, exact also where x is small: ln(R/r) is 2 x times one more, with
/// x = (R - r)/(R + r).
template <class Real>
Real artanh_excess(const Real& x) {
  using simd::log, simd::select;
  const Real square = x * x;
  Real series(0.0);
  for (int power = 17; power >= 3; power -= 2) series = square * (series + 1.0 / power);
  return select(x < 0.1, series, log((1.0 + x) / (1.0 - x)) / (2.0 * x) - 1.0);
}

/// Of a thin wall both (R^2 + r^2)/(R^2 - r^2) and 1/ln(R/r) are large, but not their difference.
template <class Real>
Real of_wall(const Real& inner, const Real& outer, const ElasticNumbers<Real>& m,
             const Real& rollers, const Real& pitch, const Real& sine) {
  const Real x = (outer - inner) / (outer + inner), excess = artanh_excess(x);
  return pressure_factor(m.modulus, rollers, pitch, sine) *
         (0.5 * (x + excess / (x * (1.0 + excess))) + m.poisson);
}

/// b of `band_shares` [1/m].
template <class Real>
Real band_decay(const Real& radius, const Real& bore, const Real& nu) {
  using simd::max, simd::sqrt;
  const Real solid = sqrt(sqrt(24.0 * (1.0 + nu))) / radius;
  const Real mean_radius = 0.5 * (radius + bore);
  const Real tube = sqrt(sqrt(3.0 * (1.0 - nu * nu))) / sqrt(mean_radius * (radius - bore));
  return max(solid, tube);
}

/// What an end of the band at the distance `x` takes away.
template <class Real>
Real taken_by_end(const Real& decay, const Real& x) {
  using simd::exp, simd::sincos;
  return 0.5 * exp(-decay * x) * sincos(Real(decay * x)).second;
}

}  // namespace prs
