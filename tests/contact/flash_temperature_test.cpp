#include "contact/patch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace contact {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kPower = 2.0;  // [W]

HertzContact ellipse(double a, double b) {
  HertzContact e;
  e.semi_major = a;
  e.semi_minor = b;
  return e;
}

HeatedBody steel(double along_major, double along_minor) { return {45.0, 7810.0, 460.0, along_major, along_minor}; }

double peak_flux(const HertzContact& e) { return 3.0 * kPower / (2.0 * kPi * e.semi_major * e.semi_minor); }

/// Temperature at the centre of a source at rest, q_0 sqrt(1 - r^2/R(phi)^2) over 2 pi k r: q_0/(8 k) times the
/// integral of R over the azimuth.
TEST(FlashTemperature, SlowContactsAreThoseAtRest) {
  for (const double b : {0.4e-3, 0.2e-3, 0.03e-3}) {
    const HertzContact e = ellipse(0.4e-3, b);
    double sum = 0.0;
    const int n = 4000;
    for (int k = 0; k < n; ++k) {
      const double phi = 2.0 * kPi * (k + 0.5) / n;
      sum += 1.0 / std::hypot(std::cos(phi) / e.semi_major, std::sin(phi) / e.semi_minor);
    }
    const double at_rest = peak_flux(e) / (8.0 * 45.0) * sum * 2.0 * kPi / n;
    EXPECT_NEAR(surface_rise(e, steel(0.0, 0.0), kPower) / at_rest, 1.0, 1e-12);
    EXPECT_NEAR(surface_rise(e, steel(1e-9, 1e-9), kPower) / at_rest, 1.0, 1e-6);
  }
}

/// A body that passes quickly is heated as a half space by the flux q(t) at one of its points, integral of q(s)/sqrt(pi
/// k rho c (t - s)).
TEST(FlashTemperature, FastContactsAreMovingBands) {
  const auto integral = [](double x) {
    const int n = 400;  // s = x - (1 + x) sin^2(u)
    double sum = 0.0;
    for (int k = 0; k < n; ++k) {
      const double u = 0.5 * kPi * (k + 0.5) / n, s = x - (1.0 + x) * std::pow(std::sin(u), 2);
      sum += 2.0 * std::sqrt((1.0 - s * s) * (1.0 + x)) * std::cos(u);
    }
    return sum * 0.5 * kPi / n;
  };
  double most = 0.0;
  for (double x = 0.6; x < 0.7; x += 1e-4) most = std::max(most, integral(x));
  const HertzContact e = ellipse(0.4e-3, 0.1e-3);
  const double speed = 1e9;
  const auto band = [&](double half_length) {
    return peak_flux(e) * most * std::sqrt(half_length / (kPi * 45.0 * 7810.0 * 460.0 * speed));
  };
  EXPECT_NEAR(surface_rise(e, steel(speed, 0.0), kPower) / band(0.4e-3), 1.0, 1e-8);
  EXPECT_NEAR(surface_rise(e, steel(0.0, speed), kPower) / band(0.1e-3), 1.0, 1e-8);
  const double along = 1.0 / std::hypot(std::sqrt(0.5) / 0.4e-3, std::sqrt(0.5) / 0.1e-3);
  EXPECT_NEAR(surface_rise(e, steel(speed * std::sqrt(0.5), speed * std::sqrt(0.5)), kPower) / band(along), 1.0, 1e-8);
}

/// Tian and Kennedy, ASME J. Tribology 116 (1994) 167, circle under Hertz's distribution: at high
/// Peclet numbers 2.32 q a/(k sqrt(pi Pe)), q the mean flux, Pe = V a rho c/(2 k).
TEST(FlashTemperature, FastCircleHasPrintedFactor) {
  const HertzContact e = ellipse(0.3e-3, 0.3e-3);
  const double speed = 1e8, peclet = speed * 0.3e-3 * 7810.0 * 460.0 / (2.0 * 45.0);
  const double printed = 2.32 * 2.0 / 3.0 * peak_flux(e) * 0.3e-3 / (45.0 * std::sqrt(kPi * peclet));
  EXPECT_NEAR(surface_rise(e, steel(speed, 0.0), kPower) / printed, 1.0, 1e-3);
}

TEST(FlashTemperature, EqualBodiesTakeHalfOfTheHeat) {
  const HertzContact e = ellipse(0.4e-3, 0.1e-3);
  EXPECT_NEAR(
      flash_temperature(e, {steel(3.0, 1.0), steel(3.0, 1.0)}, kPower) / surface_rise(e, steel(3.0, 1.0), kPower), 0.5,
      1e-14);
  EXPECT_EQ(flash_temperature(e, {steel(3.0, 1.0), steel(3.0, 1.0)}, 0.0), 0.0);
}

/// The faster body takes more heat and cools the contact.
TEST(FlashTemperature, FallsWithSpeed) {
  const HertzContact e = ellipse(0.4e-3, 0.1e-3);
  double before = 1e9;
  for (const double speed : {0.0, 0.01, 0.1, 1.0, 10.0}) {
    const double now = flash_temperature(e, {steel(0.1, 0.0), steel(0.0, speed)}, kPower);
    EXPECT_LT(now, before) << speed;
    before = now;
  }
}

}  // namespace
}  // namespace contact
