#include "contact/film.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

#include "contact/lubricant.h"

namespace contact {
namespace {

const Lubricant kGrease{0.1665, 30e-9, 12e6};
const FilmContact kContact{197.5, 350.0, 115.385e9};

TEST(Lubricant, ViscosityGrowsByRoelands) {
  EXPECT_DOUBLE_EQ(roelands_viscosity_ratio(0.1665, 0.0), 1.0);
  // Small pressures: d ln(ratio)/dp = z (ln eta_0 + 9.67)/p_0, the coefficient of Barus.
  const double p = 1.0;
  EXPECT_NEAR(std::log(roelands_viscosity_ratio(0.1665, p)) / p,
              0.6 * (std::log(0.1665) + 9.67) / 0.198e9, 1e-6 * 2.4e-8);
  // (1 + p/p_0)^0.6 = 2 at p = p_0 (2^(1/0.6) - 1): the ratio is eta_0/(6.315e-5 Pa s).
  const double doubled = 0.198e9 * (std::pow(2.0, 1.0 / 0.6) - 1.0);
  EXPECT_NEAR(roelands_viscosity_ratio(0.1665, doubled) / (0.1665 * std::exp(9.67)), 1.0, 1e-13);
}

TEST(Film, FollowsThePowersOfItsFormula) {
  const double h = central_film(kGrease, kContact, 0.5).thickness;
  // h_c = 1.7 alpha^(3/4) (eta_0 |u|)^(37/48) (N rho^2/E')^(-1/9) ...: exponents from (2.37) to
  // (2.39).
  for (const double t : {0.01, 3.0, 100.0}) {
    EXPECT_NEAR(central_film(kGrease, kContact, 0.5 * t).thickness / h,
                std::pow(t, 1.0 / 12.0 + 3.0 / 16.0 + 0.5), 1e-12 * std::pow(t, 0.78));
    FilmContact heavier = kContact;
    heavier.normal_load *= t;
    EXPECT_NEAR(central_film(kGrease, heavier, 0.5).thickness / h, std::pow(t, -1.0 / 9.0), 1e-12);
    Lubricant stiffer = kGrease;
    stiffer.pressure_viscosity *= t;
    EXPECT_NEAR(central_film(stiffer, kContact, 0.5).thickness / h, std::pow(t, 0.75),
                1e-12 * std::pow(t, 0.75));
  }
}

TEST(Film, ScalesWithTheGeometry) {
  // Lengths t times as long at equal pressure: N t^2, rho/t, |u| t leave U, M, L as they are.
  const Film film = central_film(kGrease, kContact, 0.5);
  const double t = 3.7;
  const FilmContact large{kContact.normal_load * t * t, kContact.curvature / t,
                          kContact.contact_modulus};
  const Film scaled = central_film(kGrease, large, 0.5 * t);
  EXPECT_NEAR(scaled.speed_number / film.speed_number, 1.0, 1e-14);
  EXPECT_NEAR(scaled.parameter / film.parameter, 1.0, 1e-14);
  EXPECT_NEAR(scaled.thickness / film.thickness, t, 1e-13);
}

TEST(Film, IsGoneWithoutRolling) {
  const Film film = central_film(kGrease, kContact, 0.0);
  EXPECT_EQ(film.thickness, 0.0);
  EXPECT_EQ(sliding_factor(kGrease, kContact, film, 0.0), 0.0);
}

}  // namespace
}  // namespace contact
