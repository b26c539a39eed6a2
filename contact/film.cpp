#include "contact/film.h"

#include <cassert>
#include <numbers>

namespace contact {
namespace {

Film film_of(double parameter, const MoesNumbers& moes, const FilmContact& contact) {
  return {parameter, film_thickness(parameter, moes.speed, contact)};
}

constexpr double kSquareMillimetre = 1e-6;
constexpr double kLn10 = std::numbers::ln10;

/// log10 log10(nu/(mm^2/s) + 0.7), without loss of digits where the sum is near 1.
double ordinate(double viscosity) {
  return std::log10(std::log1p((viscosity - kLeastKinematicViscosity) / kSquareMillimetre) / kLn10);
}

}  // namespace

Film sandu_film(const Lubricant& lubricant, const FilmContact& contact, double rolling_speed) {
  if (rolling_speed <= 0.0) return {};
  const MoesNumbers moes = moes_numbers(lubricant, contact, rolling_speed);
  return film_of(sandu_parameter(moes), moes, contact);
}

Film nijenbanning_film(const Lubricant& lubricant, const FilmContact& contact, double rolling_speed) {
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

double central_film(const Lubricant& lubricant, const FilmContact& contact, double rolling_speed, double along_major) {
  return contact.direction == FilmDirection::rolling ? chittenden_film(lubricant, contact, rolling_speed, along_major)
                                                     : nijenbanning_film(lubricant, contact, rolling_speed).thickness;
}

double sliding_factor(const Lubricant& lubricant, const FilmContact& contact, const Film& film, double rolling_speed) {
  if (film.parameter <= 0.0) return 0.0;
  return sliding_factor_of(lubricant, contact, film.parameter, rolling_speed);
}

WaltherLine walther_line(double temperature_1, double viscosity_1, double temperature_2, double viscosity_2) {
  assert(temperature_1 > 0.0 && temperature_2 > 0.0 && temperature_1 != temperature_2);
  assert(viscosity_1 > kLeastKinematicViscosity && viscosity_2 > kLeastKinematicViscosity);
  const double y_1 = ordinate(viscosity_1), y_2 = ordinate(viscosity_2);
  WaltherLine line;
  line.slope = (y_1 - y_2) / std::log10(temperature_2 / temperature_1);
  line.intercept = y_1 + line.slope * std::log10(temperature_1);
  return line;
}

double kinematic_viscosity(const WaltherLine& line, double temperature) {
  assert(temperature > 0.0);
  const double y = line.intercept - line.slope * std::log10(temperature);
  return kLeastKinematicViscosity + kSquareMillimetre * std::expm1(kLn10 * std::pow(10.0, y));
}

double temperature_coefficient(const WaltherLine& line, double temperature) {
  const double shifted = kinematic_viscosity(line, temperature) / kSquareMillimetre + 0.7;
  return line.slope / temperature * shifted / (shifted - 0.7) * std::log(shifted);
}

double gold_pressure_viscosity(BaseOil oil, double kinematic_viscosity) {
  assert(kinematic_viscosity > 0.0);
  const auto law = [&](double factor, double exponent) {
    return 1e-9 * factor * std::pow(kinematic_viscosity / kSquareMillimetre, exponent);
  };
  switch (oil) {
    case BaseOil::mineral:
      return law(9.904, 0.139);
    case BaseOil::polyalphaolefin:
      return law(7.382, 0.1335);
    case BaseOil::ester:
      break;
  }
  return law(6.605, 0.136);
}

}  // namespace contact
