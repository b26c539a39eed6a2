#include "contact/film.h"

#include <cmath>

namespace contact {

Film central_film(const Lubricant& lubricant, const FilmContact& contact, double rolling_speed) {
  if (rolling_speed <= 0.0) return {};
  const double modulus = 2.0 * contact.contact_modulus;
  const double u = lubricant.viscosity * rolling_speed * contact.curvature / modulus;
  const double m =
      contact.normal_load * contact.curvature * contact.curvature / (modulus * std::pow(u, 0.75));
  const double l = lubricant.pressure_viscosity * modulus * std::pow(u, 0.25);
  const double h = 1.7 * std::pow(m, -1.0 / 9.0) * std::pow(l, 0.75);
  return {u, h, h * std::sqrt(u) / contact.curvature};
}

double sliding_factor(const Lubricant& lubricant, const FilmContact& contact, const Film& film,
                      double rolling_speed) {
  if (film.parameter <= 0.0) return 0.0;
  const double modulus = 2.0 * contact.contact_modulus;
  return 2.0 / (5.0 * film.parameter * lubricant.eyring_stress) *
         std::sqrt(lubricant.viscosity * modulus * contact.curvature / rolling_speed);
}

}  // namespace contact
