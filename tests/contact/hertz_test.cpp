#include "contact/hertz.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "contact/hertz_formulas.h"
#include "tests/contact/units.h"

namespace contact {
namespace {

using Multiprecision = boost::multiprecision::cpp_bin_float_50;
using std::numbers::pi;
constexpr double kModulus = 115e9;

struct HighPrecisionIntegrals {
  Multiprecision first, second;
};

HighPrecisionIntegrals high_precision_integrals(const Multiprecision& axis_ratio) {
  const Multiprecision modulus = sqrt(Multiprecision(1 - axis_ratio * axis_ratio));
  return {boost::math::ellint_1(modulus), boost::math::ellint_2(modulus)};
}

Multiprecision high_precision_curvature_ratio(const Multiprecision& k) {
  const auto [first, second] = high_precision_integrals(k);
  return k * k * (first - second) / (second - k * k * first);
}

/// Ratios q = kappa_2/kappa_1 from the circle to the line, dense near the circle.
std::vector<double> curvature_ratios(double largest) {
  std::vector<double> q;
  for (double excess = 1e-14; excess < 1.0; excess *= 10.0) q.push_back(1.0 + excess);
  for (double x = 0.02; x <= std::log10(largest); x += 0.02) q.push_back(std::pow(10.0, x));
  q.push_back(largest);
  return q;
}

/// Displacement of the surface of an elastic half-space under a contact's pressure (Boussinesq), sum of both bodies, at
/// a point inside the ellipse: 1/(pi E*) int int p/rho dA. Along a chord the pressure is a semi-ellipse, so only the
/// periodic integral over the chord's direction remains: the trapezoidal rule converges exponentially.
double boussinesq_displacement(const HertzContact& c, double modulus, double x, double y) {
  const int directions = 4000;
  double sum = 0.0;
  for (int i = 0; i < directions; ++i) {
    const double phi = pi * (i + 0.5) / directions;
    const double ux = std::cos(phi) / c.semi_major, uy = std::sin(phi) / c.semi_minor;
    const double px = x / c.semi_major, py = y / c.semi_minor;
    const double uu = ux * ux + uy * uy, up = ux * px + uy * py, pp = px * px + py * py;
    const double height2 = 1.0 - pp + up * up / uu;  // (peak of the chord / p_0)^2
    sum += 0.5 * pi * c.peak_pressure * height2 / std::sqrt(uu);
  }
  return sum * (pi / directions) / (pi * modulus);
}

TEST(EllipticIntegrals, AgreeWithBoostInFiftyDigits) {
  for (const double k : {1.0, 1.0 - 1e-15, 1.0 - 1e-8, 0.999, 0.9, 0.5, 0.1, 1e-2, 1e-4, 1e-8}) {
    const EllipticIntegrals e = complete_elliptic_integrals(k);
    const auto [first, second] = high_precision_integrals(k);
    EXPECT_NEAR(e.first / static_cast<double>(first), 1.0, 4e-15) << k;
    EXPECT_NEAR(e.second / static_cast<double>(second), 1.0, 2e-14) << k;
    if (k == 1.0) continue;
    const Multiprecision m = 1 - Multiprecision(k) * k;
    const Multiprecision d = (first - second) / m, b = first - d, c = (d - b) / m;
    EXPECT_NEAR(e.d / static_cast<double>(d), 1.0, 4e-15) << k;
    EXPECT_NEAR(e.b / static_cast<double>(b), 1.0, 2e-14) << k;
    EXPECT_NEAR(e.c / static_cast<double>(c), 1.0, 1e-14) << k;
  }
}

TEST(Hertz, EllipticityIsExactForCurvatureRatiosFromOneToAMillion) {
  double worst = 0.0;
  for (const double q : curvature_ratios(1e6)) {
    const double k = ellipticity(1.0 / q);
    if (k == 1.0) {
      EXPECT_LE(q, 1.0 + 1e-15);
      continue;
    }
    // d ln(ratio) / d ln(k) lies between 1.5 and 2, so this bounds the error of k.
    const Multiprecision error = high_precision_curvature_ratio(k) / Multiprecision(1.0 / q) - 1;
    worst = std::max(worst, std::abs(static_cast<double>(error)) / 1.5);
  }
  EXPECT_LT(worst, 2e-15);
  EXPECT_EQ(ellipticity(1.0), 1.0);
}

TEST(Hertz, EllipticityStaysExactFarTowardsTheLine) {
  for (const double q : {1e7, 1e9, 1e12, 1e16, 1e20}) {
    const Multiprecision error = high_precision_curvature_ratio(ellipticity(1.0 / q)) / Multiprecision(1.0 / q) - 1;
    EXPECT_LT(std::abs(static_cast<double>(error)), 1e-14) << q;
  }
}

TEST(Hertz, CurvatureRatioFollowsTheLinesAsymptote) {
  // kappa_1/kappa_2 = k^2 (ln(4/k) - 1) + O(k^4 ln k).
  for (const double q : {1e6, 1e10, 1e14}) {
    const double k = ellipticity(1.0 / q);
    EXPECT_NEAR(q * k * k * (std::log(4.0 / k) - 1.0), 1.0, 50.0 * k * k + 1e-14);
  }
}

TEST(Hertz, SphereOnSphereIsTheClosedForm) {
  const double radius_1 = 7 * mm, radius_2 = 11 * mm, load = 250.0;
  const double radius = 1.0 / (1.0 / radius_1 + 1.0 / radius_2);
  const double kappa = 1.0 / radius_1 + 1.0 / radius_2;
  const HertzConstants h = hertz_constants(kappa, kappa, kModulus);
  ASSERT_TRUE(h.ok());
  EXPECT_NEAR(h.hertz_constant / (4.0 / 3.0 * kModulus * std::sqrt(radius)), 1.0, 2e-15);

  const HertzContact c = at_load(h, load);
  const double a = std::cbrt(0.75 * load * radius / kModulus);
  EXPECT_NEAR(c.semi_major / a, 1.0, 2e-15);
  EXPECT_NEAR(c.semi_minor / a, 1.0, 2e-15);
  EXPECT_NEAR(c.approach * radius / (a * a), 1.0, 4e-15);
  EXPECT_NEAR(c.peak_pressure / (1.5 * load / (pi * a * a)), 1.0, 4e-15);
}

TEST(Hertz, CylinderLimitIsTheLineContact) {
  // A barrel of transverse radius 1/kappa_2 whose length radius grows: under the local line load
  // w = 2 a p_0 .. at its middle, (pi/2) b p_0, the half width is that of the line contact,
  // b^2 = 4 w/(pi kappa_2 E*).
  const double kappa_2 = 1.0 / (5 * mm);
  for (const double q : {1e6, 1e10, 1e14}) {
    const HertzContact c = at_load(hertz_constants(kappa_2 / q, kappa_2, kModulus), 100.0);
    const double line_load = 0.5 * pi * c.semi_minor * c.peak_pressure;
    const double k = c.semi_minor / c.semi_major;
    EXPECT_NEAR(c.semi_minor * c.semi_minor * pi * kappa_2 * kModulus / (4.0 * line_load), 1.0,
                20.0 * k * k * std::log(4.0 / k) + 1e-13);
  }
}

TEST(Hertz, OrderOfTheCurvaturesDoesNotMatter) {
  const HertzConstants a = hertz_constants(30.0, 700.0, kModulus);
  const HertzConstants b = hertz_constants(700.0, 30.0, kModulus);
  EXPECT_EQ(a.hertz_constant, b.hertz_constant);
  EXPECT_EQ(a.semi_major_per_cbrt_load, b.semi_major_per_cbrt_load);
  EXPECT_EQ(a.semi_minor_per_cbrt_load, b.semi_minor_per_cbrt_load);
}

TEST(Hertz, SurfacesTouchEverywhereInsideTheEllipse) {
  // The displacement under the pressure must be delta - kappa_1 x^2/2 - kappa_2 y^2/2.
  for (const double q : {1.0, 1.3, 4.0, 50.0}) {
    const double kappa_1 = 40.0, kappa_2 = q * kappa_1;
    const HertzContact c = at_load(hertz_constants(kappa_1, kappa_2, kModulus), 300.0);
    for (const auto& [u, v] : {std::array{0.0, 0.0}, {0.9, 0.0}, {0.0, 0.9}, {0.5, -0.6}}) {
      const double x = u * c.semi_major, y = v * c.semi_minor;
      const double gap = c.approach - 0.5 * (kappa_1 * x * x + kappa_2 * y * y);
      EXPECT_NEAR(boussinesq_displacement(c, kModulus, x, y) / gap, 1.0, 1e-12) << q << ' ' << u;
    }
  }
}

TEST(Hertz, PressureIntegratesToTheLoad) {
  const HertzContact c = at_load(hertz_constants(60.0, 400.0, kModulus), 412.0);
  // Polar midpoint rule with r = sin(t): smooth, so it converges quickly.
  const int n = 400;
  double load = 0.0;
  for (int i = 0; i < n; ++i) {
    const double t = 0.5 * pi * (i + 0.5) / n;
    for (int j = 0; j < 16; ++j) {
      const double phi = 2.0 * pi * (j + 0.5) / 16;
      const double r = std::sin(t);
      const double x = r * std::cos(phi), y = r * std::sin(phi);
      load += c.peak_pressure * std::sqrt(1.0 - x * x - y * y) * r * std::cos(t);
    }
  }
  load *= c.semi_major * c.semi_minor * (0.5 * pi / n) * (2.0 * pi / 16);
  EXPECT_NEAR(load / c.normal_load, 1.0, 1e-5);
  EXPECT_NEAR(2.0 / 3.0 * c.peak_pressure * pi * c.semi_major * c.semi_minor / c.normal_load, 1.0, 1e-15);
}

TEST(Hertz, LoadIsTheDerivativeOfTheStrainEnergy) {
  // Energy of the pressure on the displacement it makes, 1/2 int p u dA, must be 2/5 N delta: for
  // u = delta - kappa_1 x^2/2 - kappa_2 y^2/2 the moments of the semi-ellipsoid give a^2/5, b^2/5.
  const double kappa_1 = 55.0, kappa_2 = 310.0;
  const HertzConstants h = hertz_constants(kappa_1, kappa_2, kModulus);
  const HertzContact c = at_load(h, 500.0);
  const double a2 = c.semi_major * c.semi_major, b2 = c.semi_minor * c.semi_minor;
  const double from_pressure = 0.5 * c.normal_load * (c.approach - 0.1 * (kappa_1 * a2 + kappa_2 * b2));
  const double from_law = 0.4 * h.hertz_constant * std::pow(c.approach, 2.5);
  EXPECT_NEAR(from_pressure / from_law, 1.0, 1e-14);
}

TEST(Hertz, LoadFollowsApproachToThePowerOfThreeHalves) {
  const HertzConstants h = hertz_constants(55.0, 310.0, kModulus);
  for (const double load : {1e-6, 1.0, 1e4}) {
    const HertzContact c = at_load(h, load);
    EXPECT_NEAR(h.hertz_constant * std::pow(c.approach, 1.5) / load, 1.0, 1e-14);
    EXPECT_NEAR(c.semi_minor / c.semi_major / h.ellipticity, 1.0, 1e-15);
  }
  EXPECT_EQ(at_load(h, 0.0).semi_major, 0.0);
  EXPECT_EQ(at_load(h, -1.0).approach, 0.0);
  EXPECT_EQ(at_load(h, 0.0).peak_pressure, 0.0);
}

TEST(Hertz, BadInputIsNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(hertz_constants(0.0, 5.0, kModulus).status, HertzStatus::no_point_contact);
  EXPECT_EQ(hertz_constants(5.0, -1e-9, kModulus).status, HertzStatus::conforming_surface);
  EXPECT_EQ(hertz_constants(nan, 5.0, kModulus).status, HertzStatus::not_finite);
  EXPECT_EQ(hertz_constants(1.0, 5.0, 0.0).status, HertzStatus::no_stiffness);
  EXPECT_EQ(HertzConstants{}.status, HertzStatus::not_computed);
  EXPECT_EQ(hertz_constants(0.0, 5.0, kModulus).hertz_constant, 0.0);
}

TEST(Hertz, ModulusIsTheSumOfPlaneStrainCompliances) {
  // Sandu 2018 (1.79): E' = 2 E* = 230.77 GPa for steel on steel.
  EXPECT_NEAR(2.0 * contact_modulus({210 * GPa, 0.3}, {210 * GPa, 0.3}), 230.77 * GPa, 0.005 * GPa);
  EXPECT_NEAR(1.0 / contact_modulus({210 * GPa, 0.3}, {70 * GPa, 0.33}), 0.91 / (210 * GPa) + 0.8911 / (70 * GPa),
              1e-25);
}

TEST(EllipticityApproximations, MissTheExactValueAsFarAsTheyDo) {
  // Sandu 2018, table 1.5, against the exact ellipticity: a/b by the fit over a/b exact, less 1.
  struct Row {
    double q, hamrock_dowson, hamrock_brewe, johnson;
  };
  for (const Row& row : {Row{1.0, 0.030, 0.0, 0.0}, Row{1.5, 0.0191, -0.0119, 0.0002},
                         Row{10.0, -0.0007, -0.0374, 0.0316}, Row{1000.0, 0.2622, 0.1972, 0.4734}}) {
    const double exact = 1.0 / ellipticity(1.0 / row.q);
    EXPECT_NEAR(hamrock_dowson_ellipticity(row.q) / exact - 1.0, row.hamrock_dowson, 6e-5) << row.q;
    EXPECT_NEAR(hamrock_brewe_ellipticity(row.q) / exact - 1.0, row.hamrock_brewe, 6e-5) << row.q;
    EXPECT_NEAR(johnson_ellipticity(row.q) / exact - 1.0, row.johnson, 6e-5) << row.q;
  }
}

TEST(EllipticityApproximations, AntoineIsWithinSixMillionthsUpToRatiosOfAMillion) {
  for (const double q : curvature_ratios(1e6)) {
    EXPECT_NEAR(antoine_ellipticity(q) * ellipticity(1.0 / q), 1.0, 6e-6) << q;
  }
}

}  // namespace
}  // namespace contact
