#include "contact/journal_bearing.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>
#include <numbers>

namespace contact {
namespace {

using std::numbers::pi;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kViscosity = 0.08, kSpeed = 120.0;
constexpr JournalBearing kHead{0.004, 0.008, 20e-6};

/// Surface speed, and the load and torque used as units of the results.
double surface_speed(const JournalBearing& b) { return 0.5 * kSpeed * b.diameter; }
double load_unit(const JournalBearing& b) {
  return kViscosity * surface_speed(b) * std::pow(b.length, 3) / (4.0 * std::pow(b.radial_clearance, 2));
}
double petroff(const JournalBearing& b) {
  return pi * kViscosity * surface_speed(b) * b.length * b.diameter * b.diameter / (2.0 * b.radial_clearance);
}

double integral(const auto& f, double from, double to) {
  return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(f, from, to, 8, 1e-12);
}

/// Film at a given eccentricity: its pressure and shear stress integrated over the journal's surface, with the pressure
/// field as the only formula.
struct JournalFilm {
  double along = 0.0, across = 0.0;  ///< Load along the line of centres and across it.
  double torque = 0.0;
};

JournalFilm integrated_film(const JournalBearing& b, double eps) {
  const double radius = 0.5 * b.diameter, c = b.radial_clearance, u = surface_speed(b);
  const auto gap = [&](double theta) { return c * (1.0 + eps * std::cos(theta)); };
  // Integral over the length of (L^2/4 - z^2), and the rest of the pressure.
  const double over_length =
      integral([&](double z) { return 0.25 * b.length * b.length - z * z; }, -0.5 * b.length, 0.5 * b.length);
  const auto pressure = [&](double theta) {
    return 3.0 * kViscosity * u * eps * c * std::sin(theta) * over_length / (radius * std::pow(gap(theta), 3));
  };
  const auto pressure_slope = [&](double theta) {
    const double x = 1.0 + eps * std::cos(theta);
    return 3.0 * kViscosity * u * eps * over_length / (radius * c * c) *
           (std::cos(theta) / std::pow(x, 3) + 3.0 * eps * std::pow(std::sin(theta), 2) / std::pow(x, 4));
  };
  JournalFilm film;
  film.along = -radius * integral([&](double t) { return pressure(t) * std::cos(t); }, 0.0, pi);
  film.across = radius * integral([&](double t) { return pressure(t) * std::sin(t); }, 0.0, pi);
  film.torque =
      radius * radius * b.length * integral([&](double t) { return kViscosity * u / gap(t); }, 0.0, 2.0 * pi) +
      radius * integral([&](double t) { return 0.5 * gap(t) * pressure_slope(t); }, 0.0, pi);
  return film;
}

TEST(ShortBearing, IsTheIntegralOfItsPressureField) {
  for (const JournalBearing& b : {kHead, JournalBearing{0.02, 0.02, 1e-4}})
    for (const double eps : {1e-3, 0.1, 0.3, 0.5, 0.7, 0.9, 0.97, 0.99}) {
      const JournalFilm film = integrated_film(b, eps);
      const double load = std::hypot(film.along, film.across);
      EXPECT_NEAR(film.across / film.along, pi * std::sqrt(1 - eps * eps) / (4 * eps),
                  1e-10 * film.across / film.along);
      const JournalBearingState state = short_bearing(b, kViscosity, kSpeed, load);
      EXPECT_NEAR(state.eccentricity_ratio, eps, 1e-11);
      EXPECT_NEAR(state.torque / film.torque, 1.0, 1e-10) << eps;
    }
}

TEST(ShortBearing, WithoutLoadIsPetroffs) {
  const JournalBearingState state = short_bearing(kHead, kViscosity, kSpeed, 0.0);
  EXPECT_EQ(state.eccentricity_ratio, 0.0);
  EXPECT_NEAR(state.torque / petroff(kHead), 1.0, 1e-15);
}

TEST(ShortBearing, EccentricityAnswersTheLoad) {
  const double unit = load_unit(kHead);
  for (double load = 1e-18; load < 1e18; load *= 1.7) {
    const double eps = short_bearing(kHead, kViscosity, kSpeed, load * unit).eccentricity_ratio;
    if (load > 1e6) break;  // Beyond this load 1 - eps has lost its digits, but not the torque.
    const double free = (1.0 - eps) * (1.0 + eps);
    const double carried = eps / (free * free) * std::sqrt(16 * eps * eps + pi * pi * free);
    // 1 - eps has a rounding error of 1e-16, and `free` a correspondingly larger relative one.
    EXPECT_NEAR(carried / load, 1.0, 1e-14 + 1e-15 / free) << load;
  }
}

TEST(ShortBearing, LightAndHeavyLoadsAreTheAsymptotes) {
  const double unit = load_unit(kHead);
  // eps = load number/pi; the torque is Petroff's to eps^2.
  for (const double load : {1e-300, 1e-20, 1e-9, 1e-8, 1.01e-8, 1e-6}) {
    const JournalBearingState state = short_bearing(kHead, kViscosity, kSpeed, load * unit);
    EXPECT_NEAR(state.eccentricity_ratio / (load / pi), 1.0, 1e-12) << load;
    EXPECT_NEAR(state.torque / petroff(kHead), 1.0, 1e-12) << load;
  }
  // s = 1/sqrt(1 - eps^2) = (load number/4)^(1/4) and torque = Petroff s (1 + (L s/2 D)^2).
  for (const double load : {1e26, 1e40, 1e100, 1e200}) {
    const JournalBearingState state = short_bearing(kHead, kViscosity, kSpeed, load * unit);
    const double s = std::pow(load / 4.0, 0.25), ratio = kHead.length * s / (2.0 * kHead.diameter);
    EXPECT_NEAR(state.eccentricity_ratio, 1.0, 1e-12);
    EXPECT_NEAR(state.torque / (petroff(kHead) * s * (1.0 + ratio * ratio)), 1.0, 1e-12) << load;
  }
}

TEST(ShortBearing, AgreesWithTheTableOfRaimondiAndBoyd) {
  // Raimondi and Boyd 1958, part III, full bearing, L/D = 1/4: eps, Sommerfeld number S = eta N/P (D/2c)^2, friction
  // variable f D/2c. They include the flow around, with which a film of this length carries 2 to 7 % less up to eps =
  // 0.6.
  struct Row {
    double eps, sommerfeld, friction;
  };
  const JournalBearing b{0.01, 0.04, 4e-5};
  const double per_second = kSpeed / (2.0 * pi), wedge = 0.5 * b.diameter / b.radial_clearance;
  for (const Row& row : {Row{0.1, 16.2, 322.0}, Row{0.2, 7.57, 153.0}, Row{0.4, 2.83, 61.1}, Row{0.6, 1.07, 26.7}}) {
    const double pressure = kViscosity * per_second * wedge * wedge / row.sommerfeld;
    const double load = pressure * b.length * b.diameter;
    const JournalBearingState state = short_bearing(b, kViscosity, kSpeed, load);
    EXPECT_NEAR(state.eccentricity_ratio / row.eps, 1.0, 0.03) << row.eps;
    EXPECT_LT(state.eccentricity_ratio, row.eps);
    EXPECT_NEAR(state.torque / (0.5 * load * b.diameter) * wedge / row.friction, 1.0, 0.03) << row.eps;
  }
}

TEST(ShortBearing, TheSenseOfRotationDoesNotMatter) {
  const JournalBearingState a = short_bearing(kHead, kViscosity, kSpeed, 50.0);
  const JournalBearingState b = short_bearing(kHead, kViscosity, -kSpeed, 50.0);
  EXPECT_EQ(a.eccentricity_ratio, b.eccentricity_ratio);
  EXPECT_EQ(a.torque, b.torque);
  EXPECT_GT(a.torque, 0.0);
}

/// Shear in a tight clearance and pressure in a wide one: the least friction for L = D lies at the root of
/// 4 s/(4 + s^2) = 1/s + 16 s/(16 s^2 + pi^2), eps = s/sqrt(1 + s^2) = 0.880.
TEST(ShortBearing, FrictionIsLeastAtOneEccentricityWhateverTheLoad) {
  for (const double load : {50.0, 500.0}) {
    JournalBearing b{6e-3, 6e-3, 1e-6};
    JournalBearingState least{0.0, kInfinity};
    std::vector<double> torques;
    for (; b.radial_clearance < 1e-3; b.radial_clearance *= 1.01) {
      const JournalBearingState state = short_bearing(b, kViscosity, kSpeed, load);
      torques.push_back(state.torque);
      if (state.torque < least.torque) least = state;
    }
    EXPECT_NEAR(least.eccentricity_ratio, 0.880, 2e-3);
    EXPECT_LT(least.torque, 0.9 * torques.front());
    EXPECT_LT(least.torque, 0.9 * torques.back());
  }
}

TEST(ShortBearing, AtRestNothingResists) {
  EXPECT_EQ(short_bearing(kHead, kViscosity, 0.0, 0.0).torque, 0.0);
  EXPECT_EQ(short_bearing(kHead, kViscosity, 0.0, 0.0).eccentricity_ratio, 0.0);
  EXPECT_EQ(short_bearing(kHead, kViscosity, 0.0, 50.0).torque, 0.0);
  EXPECT_EQ(short_bearing(kHead, kViscosity, 0.0, 50.0).eccentricity_ratio, 1.0);
  // Limit of a slow journal.
  double before = kInfinity;
  for (double speed = 1.0; speed > 1e-12; speed *= 0.1) {
    const JournalBearingState state = short_bearing(kHead, kViscosity, speed, 50.0);
    EXPECT_LT(state.torque, before);
    before = state.torque;
  }
  EXPECT_LT(before, 1e-3 * short_bearing(kHead, kViscosity, 1.0, 50.0).torque);
}

}  // namespace
}  // namespace contact
