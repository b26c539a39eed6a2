#include "contact/film.h"

#include <algorithm>
#include <cmath>

namespace contact {
namespace {

double modulus(const FilmContact& contact) { return 2.0 * contact.contact_modulus; }

Film film_of(double parameter, double speed_number, const FilmContact& contact) {
  return {parameter, parameter * std::sqrt(speed_number) / contact.curvature};
}

/// (a^p + b^p)^(1/p) of a, b >= 0 for a p of either sign, without powers of large numbers: what
/// rules is taken out, the larger one where p > 0, the smaller one where p < 0.
double power_sum(double a, double b, double p) {
  const auto [least, greatest] = std::minmax(a, b);
  const double ruling = p > 0.0 ? greatest : least, other = p > 0.0 ? least : greatest;
  if (ruling == 0.0 || std::isinf(ruling)) return ruling;
  return ruling * std::pow(1.0 + std::pow(other / ruling, p), 1.0 / p);
}

}  // namespace

MoesNumbers moes_numbers(const Lubricant& lubricant, const FilmContact& contact,
                         double rolling_speed) {
  const double e = modulus(contact);
  const double u = lubricant.viscosity * rolling_speed * contact.curvature / e;
  return {
      .speed = u,
      .load = contact.normal_load * contact.curvature * contact.curvature / (e * std::pow(u, 0.75)),
      .lubricant = lubricant.pressure_viscosity * e * std::pow(u, 0.25)};
}

Film sandu_film(const Lubricant& lubricant, const FilmContact& contact, double rolling_speed) {
  if (rolling_speed <= 0.0) return {};
  const auto [u, m, l] = moes_numbers(lubricant, contact, rolling_speed);
  return film_of(1.7 * std::pow(m, -1.0 / 9.0) * std::pow(l, 0.75), u, contact);
}

FilmRegimes film_regimes(const MoesNumbers& numbers, double curvature_ratio) {
  using std::pow;
  const double m = numbers.load, l = numbers.lubricant, ratio = curvature_ratio;
  const double k = 1.0 + 0.006 * std::log(ratio) + 0.63 * pow(ratio, 4.0 / 7.0);
  return {.rigid_isoviscous = 145.0 * pow(1.0 + 0.796 * pow(ratio, 14.0 / 15.0), -15.0 / 7.0) /
                              ratio * pow(m, -2.0),
          .elastic_isoviscous =
              3.18 * pow(k, -14.0 / 25.0) * pow(ratio, -1.0 / 15.0) * pow(m, -2.0 / 15.0),
          .rigid_piezoviscous = 1.29 * pow(1.0 + 0.691 * ratio, -2.0 / 3.0) * pow(l, 2.0 / 3.0),
          .elastic_piezoviscous = 1.48 * pow(k, -7.0 / 20.0) * pow(ratio, -1.0 / 24.0) *
                                  pow(m, -1.0 / 12.0) * pow(l, 0.75),
          .small_load = 1.80 * pow(ratio, -5.0 / 7.0)};
}

double film_parameter(const FilmRegimes& h) {
  const double isoviscous =
      power_sum(h.rigid_isoviscous, power_sum(h.elastic_isoviscous, h.small_load, -4.0), 1.5);
  const double piezoviscous = power_sum(h.rigid_piezoviscous, h.elastic_piezoviscous, -8.0);
  const double s = 1.5 * (1.0 + std::exp(-1.2 * h.elastic_isoviscous / h.elastic_piezoviscous));
  return power_sum(isoviscous, piezoviscous, s);
}

Film nijenbanning_film(const Lubricant& lubricant, const FilmContact& contact,
                       double rolling_speed) {
  if (rolling_speed <= 0.0) return {};
  const MoesNumbers numbers = moes_numbers(lubricant, contact, rolling_speed);
  return film_of(film_parameter(film_regimes(numbers, contact.curvature_ratio)), numbers.speed,
                 contact);
}

double sliding_factor(const Lubricant& lubricant, const FilmContact& contact, const Film& film,
                      double rolling_speed) {
  if (film.parameter <= 0.0) return 0.0;
  return 2.0 / (5.0 * film.parameter * lubricant.eyring_stress) *
         std::sqrt(lubricant.viscosity * modulus(contact) * contact.curvature / rolling_speed);
}

}  // namespace contact
