#pragma once

#include <cstdint>
#include <limits>

#include "simd/dual.h"

namespace contact {

/// Oil, or base oil of a grease, at operating temperature. SI units.
template <class Real>
struct LubricantOf {
  Real viscosity{};                ///< eta_0, dynamic, at ambient pressure [Pa s]
  Real pressure_viscosity{};       ///< alpha, at ambient pressure [1/Pa]
  Real eyring_stress{};            ///< tau_0, shear stress where thinning begins [Pa]
  Real temperature_coefficient{};  ///< beta = -(d eta_0/dT)/eta_0 [1/K]; 0 if not known.
  Real temperature{};              ///< [K]; NaN where not known.
};
using Lubricant = LubricantOf<double>;

/// eta_p of Roelands' law [Pa s], ln eta_p = -9.67: only a thicker lubricant stiffens with
/// pressure.
inline constexpr double kRoelandsViscosity = 6.315e-5;

/// Viscosity under pressure over that at ambient pressure by Roelands (Sandu 2018, (2.29)),
///
///     exp((ln(eta_0/(Pa s)) + 9.67) ((1 + p/p_0)^z - 1)),  p_0 = 0.198 GPa,  z = 0.6.
///
/// `Real` may be a batch of pressures [Pa] >= 0.
template <class Real>
Real roelands_viscosity_ratio(double viscosity, const Real& pressure) {
  using std::exp, std::log1p, std::expm1;
  constexpr double kPressure = 0.198e9, kExponent = 0.6;
  return exp((std::log(viscosity) + 9.67) * expm1(kExponent * log1p(pressure / kPressure)));
}

// The formulas are written for numbers, batches with one contact per lane, and either with a slope along the rolling
// speed: `Number` is the type of values that depend on the speed.

/// Assumed direction of rolling of a contact for its central film: along the minor axis of its ellipse, or the real
/// one.
enum class FilmDirection : std::int64_t { minor_axis, rolling };

/// Effects that thin a film besides load and speed.
template <class Real>
struct FilmThinningOf {
  Real starvation = 1.0;  ///< phi_s, for a starved inlet.
  Real conductivity{};    ///< k of the oil [W/(m K)]; 0: the inlet stays cold.
};
using FilmThinning = FilmThinningOf<double>;

/// Inputs of the film formulas for one lubricated contact of two bodies.
template <class Real>
struct FilmContactOf {
  Real normal_load{};          ///< N, static [N]
  Real curvature{};            ///< rho_x, the larger relative curvature [1/m]
  Real contact_modulus{};      ///< E* [Pa]; the E' of the formulas is 2 E* (Sandu's 2/Sigma).
  Real curvature_ratio = 1.0;  ///< lambda, smaller over larger relative curvature, above 0 to 1.
  simd::EnumOf<FilmDirection, Real> direction = FilmDirection::minor_axis;  ///< Direction for `central_film`.
  FilmThinningOf<Real> thinning{};

  Real film_modulus() const { return 2.0 * contact_modulus; }  ///< E' [Pa]
};
using FilmContact = FilmContactOf<double>;

/// Dimensionless speed, load and lubricant of Moes, with `rolling_speed` |u| [m/s] the *sum* of the
/// two surface velocities (Sandu 2018, (2.38)):
///
///     U = eta_0 |u| rho_x/E',   M = N rho_x^2/(E' U^(3/4)),   L = alpha E' U^(1/4)
///
/// They define a film where |u| > 0.
template <class Number>
struct MoesNumbersOf {
  Number speed{};      ///< U
  Number load{};       ///< M
  Number lubricant{};  ///< L
};
using MoesNumbers = MoesNumbersOf<double>;

template <class Number, class Real>
MoesNumbersOf<Number> moes_numbers(const LubricantOf<Real>& lubricant, const FilmContactOf<Real>& contact,
                                   const Number& rolling_speed) {
  using simd::power;
  const Real e = contact.film_modulus();
  const Number u = lubricant.viscosity * rolling_speed * contact.curvature / e;
  return {u, contact.normal_load * contact.curvature * contact.curvature / (e * power(u, Real(0.75))),
          lubricant.pressure_viscosity * e * power(u, Real(0.25))};
}

/// Film parameter H of `sandu_film`.
template <class Number>
Number sandu_parameter(const MoesNumbersOf<Number>& moes) {
  using Real = simd::ValueOf<Number>;
  using simd::power;
  return 1.7 * power(moes.load, Real(-1.0 / 9.0)) * power(moes.lubricant, Real(0.75));
}

/// Central film of an elastohydrodynamic point contact.
struct Film {
  double parameter = 0.0;  ///< H
  double thickness = 0.0;  ///< h = H sqrt(U)/rho_x [m]
};

/// h = H sqrt(U)/rho_x.
template <class Number, class Real>
Number film_thickness(const Number& parameter, const Number& speed_number, const FilmContactOf<Real>& contact) {
  using simd::sqrt;
  return parameter * sqrt(speed_number) / contact.curvature;
}

/// Moes and Venner's formula for a circular contact as Sandu simplifies it (2018, (2.37), (2.39)):
///
///     H = 1.7 M^(-1/9) L^(3/4)
///
/// Smooth surfaces, fully flooded, isothermal, piezoviscous-elastic regime. It lies 15 to 18 %
/// above the full fit at Sandu's reference example. All zero without rolling.
Film sandu_film(const Lubricant& lubricant, const FilmContact& contact, double rolling_speed);

/// Film parameters H in each regime (Nijenbanning, Venner, Moes, Wear 176 (1994) 217), with lambda the ratio of the
/// relative curvatures, k = 1 + 0.006 ln lambda + 0.63 lambda^(4/7):
///
///     H_RI = 145 (1 + 0.796 lambda^(14/15))^(-15/7) lambda^-1 M^-2     rigid, isoviscous
///     H_EI = 3.18 k^(-14/25) lambda^(-1/15) M^(-2/15)                  elastic, isoviscous
///     H_RP = 1.29 (1 + 0.691 lambda)^(-2/3) L^(2/3)                    rigid, piezoviscous
///     H_EP = 1.48 k^(-7/20) lambda^(-1/24) M^(-1/12) L^(3/4)           elastic, piezoviscous
///     H_00 = 1.80 lambda^(-5/7)            bound of the elastic, isoviscous film at small loads
template <class Number>
struct FilmRegimesOf {
  Number rigid_isoviscous{}, elastic_isoviscous{}, rigid_piezoviscous{}, elastic_piezoviscous{};
  simd::ValueOf<Number> small_load{};
};
using FilmRegimes = FilmRegimesOf<double>;

template <class Number, class Real>
FilmRegimesOf<Number> film_regimes(const MoesNumbersOf<Number>& moes, const Real& ratio) {
  using simd::log, simd::power;
  const auto to = [](const auto& x, double p) { return power(x, Real(p)); };
  const Number &m = moes.load, &l = moes.lubricant;
  const Real k = 1.0 + 0.006 * log(ratio) + 0.63 * to(ratio, 4.0 / 7.0);
  return {145.0 * to(Real(1.0 + 0.796 * to(ratio, 14.0 / 15.0)), -15.0 / 7.0) / ratio * to(m, -2.0),
          3.18 * to(k, -14.0 / 25.0) * to(ratio, -1.0 / 15.0) * to(m, -2.0 / 15.0),
          1.29 * to(Real(1.0 + 0.691 * ratio), -2.0 / 3.0) * to(l, 2.0 / 3.0),
          1.48 * to(k, -7.0 / 20.0) * to(ratio, -1.0 / 24.0) * to(m, -1.0 / 12.0) * to(l, 0.75),
          1.80 * to(ratio, -5.0 / 7.0)};
}

/// (a^p + b^p)^(1/p) for a, b >= 0 and a p of either sign, without powers of large numbers: the dominant one is
/// factored out, the larger one for p > 0, the smaller one for p < 0.
template <class Number, class Power>
Number power_sum(const Number& a, const Number& b, const Power& p) {
  using simd::power, simd::select, simd::value;
  using Real = simd::ValueOf<Number>;
  const auto a_rules = (value(p) > Real(0.0)) == (value(a) > value(b));
  const Number ruling = select(a_rules, a, b), other = select(a_rules, b, a);
  const Number found = ruling * power(1.0 + power(other / ruling, p), 1.0 / p);
  const auto alone = value(ruling) == Real(0.0) || value(ruling) == Real(std::numeric_limits<double>::infinity());
  return select(alone, ruling, found);
}

/// H of the full fit through all regimes (Nijenbanning, Venner, Moes 1994),
///
///     H = [(H_RI^(3/2) + (H_EI^-4 + H_00^-4)^(-3/8))^(2s/3) + (H_RP^-8 + H_EP^-8)^(-s/8)]^(1/s),
///     s = 1.5 (1 + exp(-1.2 H_EI/H_EP))
template <class Number>
Number film_parameter(const FilmRegimesOf<Number>& h) {
  using Real = simd::ValueOf<Number>;
  using simd::exp;
  const Number isoviscous =
      power_sum(h.rigid_isoviscous, power_sum(h.elastic_isoviscous, Number(h.small_load), Real(-4.0)), Real(1.5));
  const Number piezoviscous = power_sum(h.rigid_piezoviscous, h.elastic_piezoviscous, Real(-8.0));
  const Number s = 1.5 * (1.0 + exp(Number(-1.2 * h.elastic_isoviscous / h.elastic_piezoviscous)));
  return power_sum(isoviscous, piezoviscous, s);
}

/// Central film by the full fit, for elliptical contacts that roll along the minor axis: lambda is
/// 1 for a circle, the film of a wide ellipse is thicker. Smooth surfaces, fully flooded,
/// isothermal, Newtonian, viscosity exponential in pressure. Dimensionless numbers as above. All
/// zero without rolling.
Film nijenbanning_film(const Lubricant& lubricant, const FilmContact& contact, double rolling_speed);

/// Curvatures along the rolling and across it at the share `along_major` s of |u|^2 along the major
/// axis:
///
///     1/R_e = rho_x (1 - s + lambda s),   1/R_s = rho_x (s + lambda (1 - s))
template <class Number>
struct RollingCurvatures {
  Number along, across;
};
template <class Number, class Real>
RollingCurvatures<Number> rolling_curvatures(const FilmContactOf<Real>& contact, const Number& along_major) {
  const Number turned = (1.0 - contact.curvature_ratio) * along_major;
  return {contact.curvature * (1.0 - turned), contact.curvature * (contact.curvature_ratio + turned)};
}

/// Radius of the relative curvature across the rolling over that along it, R_s/R_e.
double rolling_radius_ratio(const FilmContact& contact, double along_major);

/// Range of R_s/R_e in which `chittenden_film` gives no warning. At its upper end ellipses are 8 times as long as wide,
/// as in the solutions of Hamrock and Dowson (J. Lubr. Technol. 99 (1977) 264) that it extends; at its lower end side
/// leakage removes three quarters of the film.
inline constexpr double kLeastRollingRatio = 0.1, kGreatestRollingRatio = 25.0;

/// Central film [m] at any angle between rolling and the axes of the ellipse (Chittenden, Dowson,
/// Dunn, Taylor, Proc. R. Soc. Lond. A 397 (1985) 245 and 271), elastic and piezoviscous,
///
///     h = 4.31 R_e U^0.68 G^0.49 W^-0.073 (1 - exp(-1.23 (R_s/R_e)^(2/3))),
///     U = eta_0 |u|/(2 E' R_e),   G = alpha E',   W = N/(E' R_e^2)
///
/// with |u| the sum of both velocities, R_e and R_s as in `rolling_radius_ratio`. Smooth surfaces,
/// fully flooded, isothermal, Newtonian. 0 without rolling.
double chittenden_film(const Lubricant& lubricant, const FilmContact& contact, double rolling_speed,
                       double along_major);

/// `chittenden_film` without the check that the contact rolls: `rolling_speed` > 0.
template <class Number, class Real>
Number chittenden_thickness(const LubricantOf<Real>& lubricant, const FilmContactOf<Real>& contact,
                            const Number& rolling_speed, const Number& along_major) {
  using simd::exp, simd::power;
  const Real e = contact.film_modulus();
  const RollingCurvatures<Number> rho = rolling_curvatures(contact, along_major);
  const Number u = 0.5 * lubricant.viscosity * rolling_speed * rho.along / e;
  const Number w = contact.normal_load * rho.along * rho.along / e;
  const Number ratio = power(Number(rho.along / rho.across), Real(2.0 / 3.0));
  return 4.31 * power(Real(lubricant.pressure_viscosity * e), Real(0.49)) * power(u, Real(0.68)) *
         power(w, Real(-0.073)) * (1.0 - exp(Number(-1.23 * ratio))) / rho.along;
}

/// Film for the direction of the contact: `nijenbanning_film` or `chittenden_film` [m].
double central_film(const Lubricant& lubricant, const FilmContact& contact, double rolling_speed, double along_major);

/// `central_film` without the check that the contact rolls: `rolling_speed` > 0.
template <class Number, class Real>
Number central_thickness(const LubricantOf<Real>& lubricant, const FilmContactOf<Real>& contact,
                         const MoesNumbersOf<Number>& moes, const Number& rolling_speed, const Number& along_major) {
  const Number along_minor =
      film_thickness(film_parameter(film_regimes(moes, contact.curvature_ratio)), moes.speed, contact);
  using simd::any, simd::select;
  const auto follows = contact.direction == FilmDirection::rolling;
  if (!any(follows)) return along_minor;
  return select(follows, chittenden_thickness(lubricant, contact, rolling_speed, along_major), along_minor);
}

/// phi = phi_s phi_T, a film over that of a full and isothermal inlet, with phi_T that of shear
/// heating at the inlet (Gupta, Cheng, Zhu, Forster, Krauter, ASME J. Tribology 114 (1992) 296):
///
///     phi_T = (1 - 13.2 (p_0/E') L^0.42)/(1 + 0.213 (1 + 2.23 S^0.83) L^0.64),
///     L = beta eta_0 u_m^2/k,   S = v/u_m
///
/// the numerator not below 0.05; u_m half of the sum velocity, v the sliding speed at the centre.
/// `rolling_speed`: the sum |u|; without rolling phi_T is 1.
template <class Number, class Real>
Number film_factor(const LubricantOf<Real>& lubricant, const FilmContactOf<Real>& contact, const Real& peak_pressure,
                   const Number& rolling_speed, const Number& sliding_speed) {
  using simd::any, simd::power, simd::select, simd::value;
  const FilmThinningOf<Real>& t = contact.thinning;
  const Number cold(t.starvation), none(Real(0.0)), least(Real(0.05));
  const auto warms = t.conductivity > Real(0.0) && value(rolling_speed) > Real(0.0);
  if (!any(warms)) return cold;
  const Number mean = 0.5 * rolling_speed;
  const Number loading = lubricant.temperature_coefficient * lubricant.viscosity / t.conductivity * (mean * mean);
  const auto slides = value(sliding_speed) > Real(0.0);
  const Number slip = select(slides, power(Number(sliding_speed / mean), Real(0.83)), none);
  const Number pressure = 1.0 - 13.2 * peak_pressure / contact.film_modulus() * power(loading, Real(0.42));
  const Number thermal =
      select(pressure < least, least, pressure) / (1.0 + 0.213 * (1.0 + 2.23 * slip) * power(loading, Real(0.64)));
  return select(warms, t.starvation * thermal, cold);
}

/// Share of the load on flanks that touch through a film of Lambda times their composite Rq,
/// (1 + Lambda)^-exponent, with an exponent of 2 after Olver and Spikes (Proc. Instn Mech. Engrs J
/// 212, 1998, 321): 1 without film, 0.25 where the film is as thick as the roughness.
template <class Number, class Real>
Number boundary_share(const Number& film_ratio, const Real& exponent) {
  using simd::power;
  return power(Number(1.0 + film_ratio), Real(-exponent));
}

/// Factor K [s/m] of the sliding speed in Jacod's friction coefficient (Sandu 2018, (2.27),
/// (2.30)),
///
///     mu_D = tau_0/p_D asinh(eta_bar(p_D) K |v_D|),  K = 2/(5 H_c tau_0) sqrt(eta_0 E' rho_x/|u|),
///
/// with Sandu's film. Zero without rolling, where the no-slip contact does not slide either.
double sliding_factor(const Lubricant& lubricant, const FilmContact& contact, const Film& film, double rolling_speed);

/// `sliding_factor` for the film parameter H_c; `rolling_speed` > 0.
template <class Number, class Real>
Number sliding_factor_of(const LubricantOf<Real>& lubricant, const FilmContactOf<Real>& contact,
                         const Number& parameter, const Number& rolling_speed) {
  using simd::sqrt;
  return 2.0 / (5.0 * parameter * lubricant.eyring_stress) *
         sqrt(Number(lubricant.viscosity * contact.film_modulus() * contact.curvature / rolling_speed));
}

/// Kinematic viscosity of an oil against temperature (Walther 1931; ASTM D341):
///
///     log10 log10(nu/(mm^2/s) + 0.7) = intercept - slope log10(T/K).
///
/// Valid between 2 mm^2/s and 2e7 mm^2/s for mineral and most synthetic oils, above their cloud
/// point and below their boiling point. Below 2 mm^2/s the standard adds terms that are left out
/// here; the line then still falls with temperature, towards 0.3 mm^2/s, which it never reaches.
struct WaltherLine {
  double intercept = 0.0;  ///< A
  double slope = 0.0;      ///< B, > 0
};

/// Bounds, both excluded, within which the line may pass through a point and be evaluated [m^2/s].
inline constexpr double kLeastKinematicViscosity = 0.3e-6;
inline constexpr double kGreatestKinematicViscosity = 20.0;

/// Density of a mineral oil near 40 degC [kg/m^3], for uses where only the shape of the Walther
/// line depends on it.
inline constexpr double kTypicalOilDensity = 870.0;

/// The line through two points: absolute temperatures [K], different, and kinematic viscosities
/// [m^2/s], both above 0.3 mm^2/s so that the logarithms exist:
///
///     slope = (y_1 - y_2)/log10(T_2/T_1),  y = log10 log10(nu/(mm^2/s) + 0.7).
WaltherLine walther_line(double temperature_1, double viscosity_1, double temperature_2, double viscosity_2);

/// Kinematic viscosity [m^2/s] at an absolute temperature [K]:
///
///     nu/(mm^2/s) = 10^(10^(intercept - slope log10(T/K))) - 0.7.
///
/// Infinite where that exceeds the numbers.
double kinematic_viscosity(const WaltherLine& line, double temperature);

/// beta = -(d nu/dT)/nu of the line at an absolute temperature [1/K]:
///
///     beta = slope/T (1 + 0.7 mm^2/s/nu) ln(nu/(mm^2/s) + 0.7).
double temperature_coefficient(const WaltherLine& line, double temperature);

/// Kind of an oil, as far as its viscosity under pressure depends on it.
enum class BaseOil { mineral, polyalphaolefin, ester };

/// Estimate of the pressure-viscosity coefficient [1/Pa] from the kinematic viscosity at the same
/// temperature [m^2/s],
///
///     alpha = s (nu/(mm^2/s))^t 1e-9/Pa,
///
/// with s = 9.904, t = 0.139 for mineral oils, 7.382, 0.1335 for polyalphaolefins and 6.605, 0.136
/// for esters (Gold, Schmidt, Dicke, Loos, Assmann, J. Synth. Lubr. 18, 2001, 51). For paraffinic
/// mineral oils this lies up to 30 % below what high-pressure viscometers give.
double gold_pressure_viscosity(BaseOil oil, double kinematic_viscosity);

}  // namespace contact
