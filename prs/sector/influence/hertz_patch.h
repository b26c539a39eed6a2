#pragma once

#include "prs/model/materials.h"

namespace prs {

/// Contact ellipse on a flank: semi-axes along the meridian profile and around the axis [m].
struct HertzPatch {
  double along_profile = 0.0;        ///< a_s
  double along_circumference = 0.0;  ///< a_t
};

/// Amplitude p_n of cos(n theta) in the pressure of one patch that carries 1 N, centred at
/// theta = 0 on a circle of radius r, at the distance s from its centre along the profile
/// [Pa/N = 1/m^2]:
///
///     p = p_0 sqrt(1 - (s/a_s)^2 - (r theta/a_t)^2) = sum p_n cos(n theta),   p_0 = 3/(2 pi a_s
///     a_t), p_n = e_n p_0 A^2/(a_t r) J_1(x)/x,   A = a_t sqrt(1 - (s/a_s)^2),   x = n A/r,
///
/// e_0 = 1/2 and e_n = 1 (Fourier transform of a half-ellipse, Bracewell, table of pairs). The
/// circumference is unrolled at the local radius, so that the series carries exactly 1 N.
double pressure_amplitude(const HertzPatch& patch, int harmonic, double s, double r);

/// Pressure-weighted mean displacement <u>/P of a half-space under the patch [m/N]:
///
///     6/5 K(m) (1 - nu^2)/(pi a E),   m = 1 - (b/a)^2,
///
/// 4/5 of the body's share of the approach delta. Equals
/// (delta/2 - rho_s a_s^2/20 - rho_t a_t^2/20)/P for two equal materials, since
/// rho_s a_s^2 + rho_t a_t^2 = 2 delta.
double half_space_compliance(const HertzPatch& patch, const Material& material);

/// Part of `half_space_compliance` per wave number k around the axis [m^2/N]: the compliance is the
/// integral of h(k) over all k, positive and negative. With the spectrum 3 j_1(q)/q of the patch,
/// q^2 = (a_t k)^2 + (a_s l)^2, and 2 (1 - nu^2)/(E |k|) of the half-space:
///
///     h(k) = (1 - nu^2)/(2 pi^2 E) int (3 j_1(q)/q)^2/sqrt(k^2 + l^2) dl.
///
/// A series of harmonics of period N in theta on a circle of radius r has N/r h(n/r) in its terms.
double half_space_spectrum(const HertzPatch& patch, const Material& material, double wave_number);

/// What wave numbers beyond |k| > `wave_number` add to `half_space_compliance` [m/N].
double half_space_remainder(const HertzPatch& patch, const Material& material, double wave_number);

}  // namespace prs
