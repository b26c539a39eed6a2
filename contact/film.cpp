#include "contact/film.h"

namespace contact {
namespace {

Film film_of(double parameter, const MoesNumbers& moes, const FilmContact& contact) {
  return {parameter, film_thickness(parameter, moes.speed, contact)};
}

}  // namespace

Film sandu_film(const Lubricant& lubricant, const FilmContact& contact, double rolling_speed) {
  if (rolling_speed <= 0.0) return {};
  const MoesNumbers moes = moes_numbers(lubricant, contact, rolling_speed);
  return film_of(sandu_parameter(moes), moes, contact);
}

Film nijenbanning_film(const Lubricant& lubricant, const FilmContact& contact,
                       double rolling_speed) {
  if (rolling_speed <= 0.0) return {};
  const MoesNumbers moes = moes_numbers(lubricant, contact, rolling_speed);
  return film_of(film_parameter(film_regimes(moes, contact.curvature_ratio)), moes, contact);
}

double rolling_radius_ratio(const FilmContact& contact, double along_major) {
  const auto [along, across] = rolling_curvatures(contact, along_major);
  return along / across;
}

double chittenden_film(const Lubricant& lubricant, const FilmContact& contact, double rolling_speed,
                       double along_major) {
  if (rolling_speed <= 0.0) return 0.0;
  return chittenden_thickness(lubricant, contact, rolling_speed, along_major);
}

double central_film(const Lubricant& lubricant, const FilmContact& contact, double rolling_speed,
                    double along_major) {
  return contact.direction == FilmDirection::rolling
             ? chittenden_film(lubricant, contact, rolling_speed, along_major)
             : nijenbanning_film(lubricant, contact, rolling_speed).thickness;
}

double sliding_factor(const Lubricant& lubricant, const FilmContact& contact, const Film& film,
                      double rolling_speed) {
  if (film.parameter <= 0.0) return 0.0;
  return sliding_factor_of(lubricant, contact, film.parameter, rolling_speed);
}

}  // namespace contact
