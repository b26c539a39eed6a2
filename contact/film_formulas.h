#pragma once

#include <limits>

#include "simd/dual.h"

/// Formulas of film.h for numbers, batches with one contact per lane, and either with a slope along
/// the rolling speed: `Number` is that of what follows the speed.
namespace contact {

/// See `Lubricant`.
template <class Real>
struct LubricantNumbers {
  Real viscosity, pressure_viscosity, eyring_stress;
};

/// See `FilmContact`.
template <class Real>
struct FilmContactNumbers {
  Real normal_load, curvature, contact_modulus, curvature_ratio;
  Real follows_rolling{};  ///< 1: FilmDirection::rolling, else 0.
};

struct FilmContact;
FilmContactNumbers<double> numbers_of(const FilmContact& contact);

/// See `MoesNumbers`.
template <class Number>
struct MoesNumbersOf {
  Number speed, load, lubricant;
};

template <class Real>
Real film_modulus(const FilmContactNumbers<Real>& contact) {
  return 2.0 * contact.contact_modulus;
}

/// `rolling_speed` > 0.
template <class Number, class Real>
MoesNumbersOf<Number> moes_numbers_of(const LubricantNumbers<Real>& lubricant,
                                      const FilmContactNumbers<Real>& contact,
                                      const Number& rolling_speed) {
  using simd::power;
  const Real e = film_modulus(contact);
  const Number u = lubricant.viscosity * rolling_speed * contact.curvature / e;
  return {u,
          contact.normal_load * contact.curvature * contact.curvature / (e * power(u, Real(0.75))),
          lubricant.pressure_viscosity * e * power(u, Real(0.25))};
}

/// H of `sandu_film`.
template <class Number>
Number sandu_parameter(const MoesNumbersOf<Number>& moes) {
  using Real = simd::ValueOf<Number>;
  using simd::power;
  return 1.7 * power(moes.load, Real(-1.0 / 9.0)) * power(moes.lubricant, Real(0.75));
}

/// h = H sqrt(U)/rho_x.
template <class Number, class Real>
Number film_thickness(const Number& parameter, const Number& speed_number,
                      const FilmContactNumbers<Real>& contact) {
  using simd::sqrt;
  return parameter * sqrt(speed_number) / contact.curvature;
}

/// See `FilmRegimes`.
template <class Number>
struct FilmRegimesOf {
  Number rigid_isoviscous, elastic_isoviscous, rigid_piezoviscous, elastic_piezoviscous;
  simd::ValueOf<Number> small_load;
};

template <class Number, class Real>
FilmRegimesOf<Number> film_regimes_of(const MoesNumbersOf<Number>& moes, const Real& ratio) {
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

/// (a^p + b^p)^(1/p) of a, b >= 0 for a p of either sign, without powers of large numbers: what
/// rules is taken out, the larger one where p > 0, the smaller one where p < 0.
template <class Number, class Power>
Number power_sum(const Number& a, const Number& b, const Power& p) {
  using simd::power, simd::select, simd::value;
  using Real = simd::ValueOf<Number>;
  const auto a_rules = (value(p) > Real(0.0)) == (value(a) > value(b));
  const Number ruling = select(a_rules, a, b), other = select(a_rules, b, a);
  const Number found = ruling * power(1.0 + power(other / ruling, p), 1.0 / p);
  const auto alone =
      value(ruling) == Real(0.0) || value(ruling) == Real(std::numeric_limits<double>::infinity());
  return select(alone, ruling, found);
}

/// H of the full fit.
template <class Number>
Number full_fit_parameter(const FilmRegimesOf<Number>& h) {
  using Real = simd::ValueOf<Number>;
  using simd::exp;
  const Number isoviscous =
      power_sum(h.rigid_isoviscous,
                power_sum(h.elastic_isoviscous, Number(h.small_load), Real(-4.0)), Real(1.5));
  const Number piezoviscous = power_sum(h.rigid_piezoviscous, h.elastic_piezoviscous, Real(-8.0));
  const Number s = 1.5 * (1.0 + exp(Number(-1.2 * h.elastic_isoviscous / h.elastic_piezoviscous)));
  return power_sum(isoviscous, piezoviscous, s);
}

/// 1/R_e and 1/R_s, see `rolling_radius_ratio`.
template <class Number>
struct RollingCurvatures {
  Number along, across;
};
template <class Number, class Real>
RollingCurvatures<Number> rolling_curvatures(const FilmContactNumbers<Real>& contact,
                                             const Number& along_major) {
  const Number turned = (1.0 - contact.curvature_ratio) * along_major;
  return {contact.curvature * (1.0 - turned),
          contact.curvature * (contact.curvature_ratio + turned)};
}

/// h of `chittenden_film`; `rolling_speed` > 0.
template <class Number, class Real>
Number chittenden_thickness(const LubricantNumbers<Real>& lubricant,
                            const FilmContactNumbers<Real>& contact, const Number& rolling_speed,
                            const Number& along_major) {
  using simd::exp, simd::power;
  const Real e = film_modulus(contact);
  const RollingCurvatures<Number> rho = rolling_curvatures(contact, along_major);
  const Number u = 0.5 * lubricant.viscosity * rolling_speed * rho.along / e;
  const Number w = contact.normal_load * rho.along * rho.along / e;
  const Number ratio = power(Number(rho.along / rho.across), Real(2.0 / 3.0));
  return 4.31 * power(Real(lubricant.pressure_viscosity * e), Real(0.49)) * power(u, Real(0.68)) *
         power(w, Real(-0.073)) * (1.0 - exp(Number(-1.23 * ratio))) / rho.along;
}

/// h of `central_film`; `rolling_speed` > 0.
template <class Number, class Real>
Number central_thickness(const LubricantNumbers<Real>& lubricant,
                         const FilmContactNumbers<Real>& contact, const MoesNumbersOf<Number>& moes,
                         const Number& rolling_speed, const Number& along_major) {
  const Number along_minor = film_thickness(
      full_fit_parameter(film_regimes_of(moes, contact.curvature_ratio)), moes.speed, contact);
  using simd::any, simd::select;
  const auto follows = contact.follows_rolling > Real(0.0);
  if (!any(follows)) return along_minor;
  return select(follows, chittenden_thickness(lubricant, contact, rolling_speed, along_major),
                along_minor);
}

/// See `boundary_share`.
template <class Number, class Real>
Number boundary_share_of(const Number& film_ratio, const Real& exponent) {
  using simd::power;
  return power(Number(1.0 + film_ratio), Real(-exponent));
}

/// K of `sliding_factor` for the film parameter H_c; `rolling_speed` > 0.
template <class Number, class Real>
Number sliding_factor_of(const LubricantNumbers<Real>& lubricant,
                         const FilmContactNumbers<Real>& contact, const Number& parameter,
                         const Number& rolling_speed) {
  using simd::sqrt;
  return 2.0 / (5.0 * parameter * lubricant.eyring_stress) *
         sqrt(Number(lubricant.viscosity * film_modulus(contact) * contact.curvature /
                     rolling_speed));
}

}  // namespace contact
