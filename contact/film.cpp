#include "contact/film.h"

#include "contact/film_formulas.h"

namespace contact {
namespace {

LubricantNumbers<double> numbers(const Lubricant& l) {
  return {l.viscosity, l.pressure_viscosity, l.eyring_stress};
}
MoesNumbersOf<double> numbers(const MoesNumbers& m) { return {m.speed, m.load, m.lubricant}; }

Film film_of(double parameter, const MoesNumbers& moes, const FilmContact& contact) {
  return {parameter, film_thickness(parameter, moes.speed, numbers_of(contact))};
}

}  // namespace

FilmContactNumbers<double> numbers_of(const FilmContact& c) {
  return {c.normal_load, c.curvature, c.contact_modulus, c.curvature_ratio,
          c.direction == FilmDirection::rolling ? 1.0 : 0.0};
}

MoesNumbers moes_numbers(const Lubricant& lubricant, const FilmContact& contact,
                         double rolling_speed) {
  const auto [speed, load, of_lubricant] =
      moes_numbers_of(numbers(lubricant), numbers_of(contact), rolling_speed);
  return {speed, load, of_lubricant};
}

Film sandu_film(const Lubricant& lubricant, const FilmContact& contact, double rolling_speed) {
  if (rolling_speed <= 0.0) return {};
  const MoesNumbers moes = moes_numbers(lubricant, contact, rolling_speed);
  return film_of(sandu_parameter(numbers(moes)), moes, contact);
}

FilmRegimes film_regimes(const MoesNumbers& moes, double curvature_ratio) {
  const FilmRegimesOf<double> h = film_regimes_of(numbers(moes), curvature_ratio);
  return {h.rigid_isoviscous, h.elastic_isoviscous, h.rigid_piezoviscous, h.elastic_piezoviscous,
          h.small_load};
}

double film_parameter(const FilmRegimes& h) {
  return full_fit_parameter(FilmRegimesOf<double>{h.rigid_isoviscous, h.elastic_isoviscous,
                                                  h.rigid_piezoviscous, h.elastic_piezoviscous,
                                                  h.small_load});
}

Film nijenbanning_film(const Lubricant& lubricant, const FilmContact& contact,
                       double rolling_speed) {
  if (rolling_speed <= 0.0) return {};
  const MoesNumbers moes = moes_numbers(lubricant, contact, rolling_speed);
  return film_of(film_parameter(film_regimes(moes, contact.curvature_ratio)), moes, contact);
}

double rolling_radius_ratio(const FilmContact& contact, double along_major) {
  const auto [along, across] = rolling_curvatures(numbers_of(contact), along_major);
  return along / across;
}

double chittenden_film(const Lubricant& lubricant, const FilmContact& contact, double rolling_speed,
                       double along_major) {
  if (rolling_speed <= 0.0) return 0.0;
  return chittenden_thickness(numbers(lubricant), numbers_of(contact), rolling_speed, along_major);
}

double central_film(const Lubricant& lubricant, const FilmContact& contact, double rolling_speed,
                    double along_major) {
  return contact.direction == FilmDirection::rolling
             ? chittenden_film(lubricant, contact, rolling_speed, along_major)
             : nijenbanning_film(lubricant, contact, rolling_speed).thickness;
}

double boundary_share(double film_ratio, double exponent) {
  return boundary_share_of(film_ratio, exponent);
}

double sliding_factor(const Lubricant& lubricant, const FilmContact& contact, const Film& film,
                      double rolling_speed) {
  if (film.parameter <= 0.0) return 0.0;
  return sliding_factor_of(numbers(lubricant), numbers_of(contact), film.parameter, rolling_speed);
}

}  // namespace contact
