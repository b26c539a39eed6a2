#include "contact/film.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

#include "tests/support/plain_slip.h"

namespace contact {
namespace {

const Lubricant kGrease{0.1665, 30e-9, 12e6};
const FilmContact kContact{197.5, 350.0, 115.385e9};

TEST(Lubricant, ViscosityGrowsByRoelands) {
  EXPECT_DOUBLE_EQ(roelands_viscosity_ratio(0.1665, 0.0), 1.0);
  // Small pressures: d ln(ratio)/dp = z (ln eta_0 + 9.67)/p_0, the coefficient of Barus.
  const double p = 1.0;
  EXPECT_NEAR(std::log(roelands_viscosity_ratio(0.1665, p)) / p, 0.6 * (std::log(0.1665) + 9.67) / 0.198e9,
              1e-6 * 2.4e-8);
  // (1 + p/p_0)^0.6 = 2 at p = p_0 (2^(1/0.6) - 1): the ratio is eta_0/(6.315e-5 Pa s).
  const double doubled = 0.198e9 * (std::pow(2.0, 1.0 / 0.6) - 1.0);
  EXPECT_NEAR(roelands_viscosity_ratio(0.1665, doubled) / (0.1665 * std::exp(9.67)), 1.0, 1e-13);
}

TEST(SanduFilm, FollowsThePowersOfItsFormula) {
  const double h = sandu_film(kGrease, kContact, 0.5).thickness;
  // h_c = 1.7 alpha^(3/4) (eta_0 |u|)^(37/48) (N rho^2/E')^(-1/9) ...: exponents from (2.37) to
  // (2.39).
  for (const double t : {0.01, 3.0, 100.0}) {
    EXPECT_NEAR(sandu_film(kGrease, kContact, 0.5 * t).thickness / h, std::pow(t, 1.0 / 12.0 + 3.0 / 16.0 + 0.5),
                1e-12 * std::pow(t, 0.78));
    FilmContact heavier = kContact;
    heavier.normal_load *= t;
    EXPECT_NEAR(sandu_film(kGrease, heavier, 0.5).thickness / h, std::pow(t, -1.0 / 9.0), 1e-12);
    Lubricant stiffer = kGrease;
    stiffer.pressure_viscosity *= t;
    EXPECT_NEAR(sandu_film(stiffer, kContact, 0.5).thickness / h, std::pow(t, 0.75), 1e-12 * std::pow(t, 0.75));
  }
}

/// Units of length, force and time that differ by a, b and c change the film by the factor a only: it depends on U, M,
/// L and lambda alone, and on viscosity and speed by their product.
TEST(Film, DoesNotDependOnUnits) {
  const FilmContact contact{197.5, 350.0, 115.385e9, 0.7};
  const double a = 3.7, b = 0.2, c = 11.0;
  const Lubricant oil{kGrease.viscosity * b * c / (a * a), kGrease.pressure_viscosity * a * a / b,
                      kGrease.eyring_stress * b / (a * a)};
  const FilmContact same{contact.normal_load * b, contact.curvature / a, contact.contact_modulus * b / (a * a),
                         contact.curvature_ratio};
  const MoesNumbers numbers = moes_numbers(kGrease, contact, 0.5);
  const MoesNumbers scaled = moes_numbers(oil, same, 0.5 * a / c);
  EXPECT_NEAR(scaled.speed / numbers.speed, 1.0, 1e-14);
  EXPECT_NEAR(scaled.load / numbers.load, 1.0, 1e-14);
  EXPECT_NEAR(scaled.lubricant / numbers.lubricant, 1.0, 1e-14);
  for (const auto film : {sandu_film, nijenbanning_film})
    EXPECT_NEAR(film(oil, same, 0.5 * a / c).thickness / film(kGrease, contact, 0.5).thickness, a, 1e-13);
}

/// Sandu's reference example, computed independently to four digits.
TEST(NijenbanningFilm, OfTheReferenceExample) {
  struct Example {
    double load, lubricant, ratio, curvature, thickness;
  };
  for (const Example& e :
       {Example{969.4, 22.53, 0.800, 197.60, 372.2e-9}, Example{798.9, 21.64, 0.655, 169.17, 406.2e-9}}) {
    // L = alpha E' U^(1/4), and from U the speed; from M the load.
    const double modulus = 2.0 * kContact.contact_modulus;
    const double u = std::pow(e.lubricant / (kGrease.pressure_viscosity * modulus), 4.0);
    const double load = e.load * modulus * std::pow(u, 0.75) / (e.curvature * e.curvature);
    const double speed = u * modulus / (kGrease.viscosity * e.curvature);
    const FilmContact contact{load, e.curvature, kContact.contact_modulus, e.ratio};
    // Half a unit in the last digit of L is 5e-4 of the film.
    EXPECT_NEAR(nijenbanning_film(kGrease, contact, speed).thickness, e.thickness, 0.2e-9);
  }
}

/// Far into a regime its power law remains, for a circle and for a wide ellipse.
TEST(NijenbanningFilm, TendsToTheFilmOfEachRegime) {
  for (const double ratio : {1.0, 0.1}) {
    const double k = 1.0 + 0.006 * std::log(ratio) + 0.63 * std::pow(ratio, 4.0 / 7.0);
    const auto film = [&](double m, double l) {
      return film_parameter(film_regimes(MoesNumbers{.speed = 1e-11, .load = m, .lubricant = l}, ratio));
    };
    const double rigid_isoviscous = 145.0 / std::pow(1.0 + 0.796 * std::pow(ratio, 14.0 / 15.0), 15.0 / 7.0) / ratio;
    const double elastic_isoviscous = 3.18 / (std::pow(k, 0.56) * std::pow(ratio, 1.0 / 15.0));
    const double rigid_piezoviscous = 1.29 / std::cbrt(std::pow(1.0 + 0.691 * ratio, 2.0));
    const double elastic_piezoviscous = 1.48 / (std::pow(k, 0.35) * std::pow(ratio, 1.0 / 24.0));
    EXPECT_NEAR(film(1e-9, 1e-9) / (rigid_isoviscous * 1e18), 1.0, 1e-12);
    EXPECT_NEAR(film(1e60, 1e-60) / (elastic_isoviscous * 1e-8), 1.0, 1e-12);
    EXPECT_NEAR(film(1e12, 1e60) / (rigid_piezoviscous * 1e40), 1.0, 1e-12);
    EXPECT_NEAR(film(1e48, 1e24) / (elastic_piezoviscous * 1e14), 1.0, 1e-12);
  }
}

/// Eighth powers of films of 1e+-60 are beyond double: comparison with the formula as printed, in long double.
TEST(NijenbanningFilm, IsTheFormulaAtAnyLoadAndLubricant) {
  for (const double ratio : {1e-6, 0.05, 0.3, 0.8, 1.0})
    for (int log_m = -60; log_m <= 60; log_m += 3)
      for (int log_l = -60; log_l <= 60; log_l += 3) {
        const double m = std::pow(10.0, log_m), l = std::pow(10.0, log_l);
        const auto printed = static_cast<double>(plain::full_film_number(m, l, ratio));
        const double h = film_parameter(film_regimes(MoesNumbers{1e-11, m, l}, ratio));
        EXPECT_NEAR(h / printed, 1.0, 1e-13) << ratio << ' ' << m << ' ' << l;
      }
}

FilmContact along_rolling(double curvature, double ratio) {
  return {kContact.normal_load, curvature, kContact.contact_modulus, ratio, FilmDirection::rolling};
}

/// Central film of Hamrock and Dowson (1977), for rolling along the minor axis.
double hamrock_dowson(const FilmContact& c, double rolling_speed) {
  const double modulus = 2.0 * c.contact_modulus;
  const double u = 0.5 * kGrease.viscosity * rolling_speed * c.curvature / modulus;
  const double w = c.normal_load * c.curvature * c.curvature / modulus;
  const double k = 1.0339 * std::pow(1.0 / c.curvature_ratio, 0.636);
  return 2.69 / c.curvature * std::pow(u, 0.67) * std::pow(kGrease.pressure_viscosity * modulus, 0.53) *
         std::pow(w, -0.067) * (1.0 - 0.61 * std::exp(-0.73 * k));
}

/// Another fit of the same solutions: up to ellipses 8 times as long as wide both are within 7 %.
TEST(ChittendenFilm, AlongTheMinorAxisIsThatOfHamrockAndDowson) {
  for (const double ratio : {1.0, 0.8, 0.655, 0.5, 0.2, 0.1, 0.04}) {
    const FilmContact contact = along_rolling(350.0, ratio);
    EXPECT_NEAR(chittenden_film(kGrease, contact, 0.5, 0.0) / hamrock_dowson(contact, 0.5), 1.0, 0.07) << ratio;
  }
}

/// Computed independently, at 30 deg to the minor axis.
TEST(ChittendenFilm, OfOneContact) {
  EXPECT_NEAR(chittenden_film(kGrease, along_rolling(350.0, 0.5), 0.5, 0.25) / 177.409503421e-9, 1.0, 1e-9);
}

/// Along the major axis the two radii are exchanged; a circle has no direction.
TEST(ChittendenFilm, KnowsTheAxesByTheirRadiiAlone) {
  const double along_major = chittenden_film(kGrease, along_rolling(350.0, 0.4), 0.5, 1.0);
  EXPECT_NEAR(chittenden_film(kGrease, along_rolling(350.0 * 0.4, 1.0 / 0.4), 0.5, 0.0) / along_major, 1.0, 1e-14);
  EXPECT_LT(along_major, chittenden_film(kGrease, along_rolling(350.0, 0.4), 0.5, 0.0));
  const FilmContact circle = along_rolling(350.0, 1.0);
  for (const double share : {0.2, 0.7, 1.0})
    EXPECT_NEAR(chittenden_film(kGrease, circle, 0.5, share) / chittenden_film(kGrease, circle, 0.5, 0.0), 1.0, 1e-14);
  EXPECT_NEAR(rolling_radius_ratio(along_rolling(350.0, 0.4), 0.0), 1.0 / 0.4, 1e-14);
  EXPECT_NEAR(rolling_radius_ratio(along_rolling(350.0, 0.4), 1.0), 0.4, 1e-14);
}

TEST(ChittendenFilm, IsSteadyInTheAngle) {
  const FilmContact contact = along_rolling(350.0, 0.3);
  double last = chittenden_film(kGrease, contact, 0.5, 0.0);
  for (int k = 1; k <= 1000; ++k) {
    const double film = chittenden_film(kGrease, contact, 0.5, 1e-3 * k);
    EXPECT_NEAR(film / last, 1.0, 1e-3);
    last = film;
  }
}

TEST(CentralFilm, IsThatOfTheDirectionThatIsAskedFor) {
  const FilmContact rolling = along_rolling(350.0, 0.6);
  FilmContact minor = rolling;
  minor.direction = FilmDirection::minor_axis;
  EXPECT_EQ(central_film(kGrease, rolling, 0.5, 0.8), chittenden_film(kGrease, rolling, 0.5, 0.8));
  EXPECT_EQ(central_film(kGrease, minor, 0.5, 0.8), nijenbanning_film(kGrease, minor, 0.5).thickness);
  EXPECT_EQ(central_film(kGrease, rolling, 0.0, 0.8), 0.0);
}

TEST(Film, IsGoneWithoutRolling) {
  for (const auto film : {sandu_film, nijenbanning_film}) EXPECT_EQ(film(kGrease, kContact, 0.0).thickness, 0.0);
  EXPECT_EQ(sliding_factor(kGrease, kContact, sandu_film(kGrease, kContact, 0.0), 0.0), 0.0);
}

/// Oil that the shear at the inlet warms.
FilmContact warmed(double starvation, double conductivity) {
  FilmContact contact = kContact;
  contact.thinning = {starvation, conductivity};
  return contact;
}

TEST(FilmFactor, IsOneOfAFullColdInlet) {
  EXPECT_EQ(film_factor(kGrease, kContact, 2e9, 1.0, 0.3), 1.0);
  EXPECT_EQ(film_factor(kGrease, warmed(0.7, 0.0), 2e9, 1.0, 0.3), 0.7);
  EXPECT_EQ(film_factor(kGrease, warmed(0.7, 0.14), 2e9, 0.0, 0.0), 0.7);  // at rest
}

/// L = 0.04 0.1665 0.5^2/0.14 = 0.0118929, S = 0.6, p_0/E' = 1e9/230.77e9 by hand:
/// (1 - 13.2 0.00433332 0.155572)/(1 + 0.213 (1 + 2.23 0.654410) 0.0586711).
TEST(FilmFactor, FollowsItsFormula) {
  Lubricant oil = kGrease;
  oil.temperature_coefficient = 0.04;
  const double loading = 0.04 * 0.1665 * 0.25 / 0.14;
  const double expected = (1.0 - 13.2 * 1e9 / 230.77e9 * std::pow(loading, 0.42)) /
                          (1.0 + 0.213 * (1.0 + 2.23 * std::pow(0.6, 0.83)) * std::pow(loading, 0.64));
  EXPECT_NEAR(film_factor(oil, warmed(1.0, 0.14), 1e9, 1.0, 0.3), expected, 1e-14);
  EXPECT_NEAR(film_factor(oil, warmed(0.5, 0.14), 1e9, 1.0, 0.3), 0.5 * expected, 1e-14);
  // The numerator has the lower bound 0.05.
  const double hot = 0.04 * 0.1665 * 50.0 * 50.0 / 0.14;
  EXPECT_NEAR(film_factor(oil, warmed(1.0, 0.14), 3e9, 100.0, 0.0), 0.05 / (1.0 + 0.213 * std::pow(hot, 0.64)), 1e-14);
}

}  // namespace
}  // namespace contact
