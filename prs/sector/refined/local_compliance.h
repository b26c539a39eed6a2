#pragma once

#include <numbers>

#include "contact/hertz.h"

/// Formulas for a number or a batch of numbers: one sector per lane.
namespace prs {

/// Distances at which the displacement by a line of force along the axis, without its smooth part, is zero: normal u =
/// 2 (1 - nu^2) q/(pi E) ln(L_n/rho), tangential (along the line) u = q/(pi G) ln(L_t/rho), at the small distance rho.
/// [m]
template <class Real>
struct LineReachOf {
  Real normal{};      ///< L_n
  Real tangential{};  ///< L_t
};

/// Distances for equal rows at equal distances around a cylinder of radius r, without the mean around it: sum of (N/n)
/// cos(n theta), n = N, 2 N, .., is -ln|2 sin(N theta/2)|, hence both lengths r/N.
template <class Real>
LineReachOf<Real> rows_around(const Real& radius, const Real& rows) {
  return {radius / rows, radius / rows};
}

/// Distances for two rows opposite each other on a solid cylinder. Normal: a disc pressed along its diameter (Johnson,
/// Contact Mechanics, 1985, (5.57)), L_n = 2 r/e. Tangential: two opposed lines of shear, without the rotation of the
/// sections, which a beam has: L_t = 2 r/e^2.
template <class Real>
LineReachOf<Real> opposite_rows(const Real& radius) {
  constexpr double kE = std::numbers::e;
  return {2.0 / kE * radius, 2.0 / (kE * kE) * radius};
}

/// Additional compliance of a contact along its normal over that of the same load spread along its row, without its own
/// half-space part, which is in the exact Hertz law [m/N]. Contacts of a row are at the pitch p on a half-space:
///
///     c = sin^2(psi) 2 (1 - nu^2)/(pi E p) (ln(L_n/(2 p)) + gamma)
///       + cos^2(psi) 1/(pi G p) (ln(L_t/(2 p)) + gamma),
///
/// gamma Euler's constant; normal and tangential loads of a straight row are uncoupled. Usually negative: spread loads
/// have a part of the half-space's deflection too. Valid for rows further apart than p.
template <class Real>
Real concentration_compliance(const LineReachOf<Real>& reach, const contact::ElasticityOf<Real>& m, const Real& pitch,
                              const Real& sine, const Real& cosine) {
  using simd::log;
  constexpr double kPi = std::numbers::pi, kEulerGamma = std::numbers::egamma;
  const Real shear_modulus = m.youngs_modulus / (2.0 * (1.0 + m.poisson_ratio));
  const auto row = [&](const Real& length) { return log(0.5 * length / pitch) + kEulerGamma; };
  return sine * sine * 2.0 * (1.0 - m.poisson_ratio * m.poisson_ratio) / (kPi * m.youngs_modulus * pitch) *
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
Real pressure_factor(const Real& modulus, const Real& rollers, const Real& pitch, const Real& sine) {
  constexpr double kTwoPi = 2.0 * std::numbers::pi;
  return rollers * sine * sine / (kTwoPi * pitch * modulus);
}

/// Radial displacement of a cylinder's surface by the normal loads of N rollers in rows of pitch p,
/// spread into the pressure q = N sin(psi)/(2 pi r p) [m/N, along the normal]. Lame's solution:
///
///     c = N sin^2(psi)/(2 pi p E) [(r^2 + b^2)/(r^2 - b^2) - nu],   b the radius of the bore.
template <class Real>
Real cylinder_compliance(const Real& radius, const Real& bore, const contact::ElasticityOf<Real>& m,
                         const Real& rollers, const Real& pitch, const Real& sine) {
  return pressure_factor(m.youngs_modulus, rollers, pitch, sine) * (lame_ratio(radius, bore) - m.poisson_ratio);
}

/// artanh(x)/x - 1 for 0 < x < 1, exact also for small x: ln(R/r) is 2 x times one more, with x = (R - r)/(R + r).
template <class Real>
Real artanh_excess(const Real& x) {
  using simd::log, simd::select;
  const Real square = x * x;
  Real series(0.0);
  for (int power = 17; power >= 3; power -= 2) series = square * (series + 1.0 / power);
  return select(x < 0.1, series, log((1.0 + x) / (1.0 - x)) / (2.0 * x) - 1.0);
}

/// Radial displacement of the inner surface of a tube from r to R, less that of its shell, whose
/// wall keeps its thickness:
///
///     c = N sin^2(psi)/(2 pi p E) [(R^2 + r^2)/(R^2 - r^2) + nu - 1/ln(R/r)].
///
/// Of a thin wall both (R^2 + r^2)/(R^2 - r^2) and 1/ln(R/r) are large, but not their difference.
template <class Real>
Real wall_compliance(const Real& inner, const Real& outer, const contact::ElasticityOf<Real>& m, const Real& rollers,
                     const Real& pitch, const Real& sine) {
  const Real x = (outer - inner) / (outer + inner), excess = artanh_excess(x);
  return pressure_factor(m.youngs_modulus, rollers, pitch, sine) *
         (0.5 * (x + excess / (x * (1.0 + excess))) + m.poisson_ratio);
}

/// b [1/m] for a band of pressure that ends half a pitch beyond the first and the last contact. For long waves a
/// cylinder is a beam on an elastic foundation, 1/(1 + k^4/(4 b^4)), so that an end at the distance x reduces the
/// displacement under an endless band by the share
///
///     exp(-b x) cos(b x)/2,
///
/// b^4 = 24 (1 + nu)/r^4 for a solid cylinder (series of Lur'e's solution, Three-dimensional Problems of the Theory of
/// Elasticity, 1964, chapter 7), 3 (1 - nu^2)/(r_m h)^2 for a thin tube; the larger b of the two is used.
template <class Real>
Real band_decay(const Real& radius, const Real& bore, const Real& nu) {
  using simd::max, simd::sqrt;
  const Real solid = sqrt(sqrt(24.0 * (1.0 + nu))) / radius;
  const Real mean_radius = 0.5 * (radius + bore);
  const Real tube = sqrt(sqrt(3.0 * (1.0 - nu * nu))) / sqrt(mean_radius * (radius - bore));
  return max(solid, tube);
}

/// Share by which an end of the band at the distance `x` reduces the displacement.
template <class Real>
Real taken_by_end(const Real& decay, const Real& x) {
  using simd::exp, simd::sincos;
  return 0.5 * exp(-decay * x) * sincos(Real(decay * x)).second;
}

/// Displacement of the loaded section per axial force on the sector by Poisson's effect in the
/// screw, s = -1 in tension, +1 in compression [m/N]. A section that carries the axial force T
/// shrinks radially by nu r T/(E A), away from the rollers or towards them, and the radial loads
/// stretch it in turn. With radial loads tan(psi) times the axial ones, the coupling energy
/// tan(psi) nu r/(E A) int T T' dx is that of its ends only: an offset, the same for all threads,
///
///     -s nu tan(psi) r/(E A).
inline double poisson_offset(double sense, double radius, double bore_radius, const contact::Elasticity& material,
                             int rollers, double normal_angle) {
  const double area = std::numbers::pi * (radius * radius - bore_radius * bore_radius) / rollers;
  return -sense * material.poisson_ratio * std::tan(normal_angle) * radius / (material.youngs_modulus * area);
}

}  // namespace prs
