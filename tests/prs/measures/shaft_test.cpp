#include "prs/measures/stiffness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "prs/model/groove.h"

namespace prs {
namespace {

using Ends = MeasureOptions::Ends;
using std::numbers::pi;

constexpr double kModulus = 209e9, kYield = 800e6, kDensity = 7850.0;
const ShaftSection kCore{18e-3, 6e-3};
const double kArea = pi / 4.0 * (18e-3 * 18e-3 - 6e-3 * 6e-3);
const double kInertia = pi / 64.0 * (std::pow(18e-3, 4) - std::pow(6e-3, 4));

/// Dimensions printed with one decimal.
struct CatalogueScrew {
  double diameter, lead;  ///< [mm]
  int starts;
  double outer_diameter, root_diameter;  ///< [mm]
};

/// Standard screws of a maker's series SRS-C whose threads are printed, by a public configurator:
/// github.com/vdimichele-helix/email-roller-screw-configuration, commit beed04e3, srsCTechnicalData.jsx.
constexpr CatalogueScrew kCatalogue[] = {{12, 5, 5, 12.3, 11.5},  {18, 5, 5, 18.3, 17.5},  {21, 5, 5, 21.3, 20.5},
                                         {21, 10, 5, 21.6, 20.0}, {24, 12, 6, 24.6, 23.0}, {24, 5, 5, 24.3, 23.5},
                                         {30, 10, 5, 30.6, 29.0}, {36, 9, 6, 36.5, 35.3},  {39, 5, 5, 39.4, 38.5},
                                         {44, 12, 6, 44.7, 43.0}, {48, 5, 5, 48.4, 47.5},  {60, 20, 5, 61.3, 58.0},
                                         {75, 10, 5, 75.7, 74.1}};

TEST(CoreSection, HasTheRootDiameterOfACatalogue) {
  int to_the_last_digit = 0;
  for (const CatalogueScrew& s : kCatalogue) {
    Mechanism m;
    m.lead = 1e-3 * s.lead;
    m.starts.screw = s.starts;
    m.pitch_diameter.screw = 1e-3 * s.diameter;
    const double root = 1e3 * core_section(m, {2e-3, 0.0}).diameter;
    // Half of the last digit, and one more where the nominal diameter is not quite the pitch's.
    const double off = std::abs(root - s.root_diameter);
    EXPECT_LE(off, 0.1 + 1e-9) << s.diameter << 'x' << s.lead;
    to_the_last_digit += off <= 0.05 + 1e-9;
    EXPECT_NEAR(s.diameter + 2.0 * kCrestHeight * s.lead / s.starts, s.outer_diameter, 0.1 + 1e-9);
  }
  EXPECT_EQ(to_the_last_digit, 12);  // all but 75 x 10, printed 74.1
}

TEST(CoreSection, TakesTheStatedRoot) {
  Mechanism m;
  m.lead = 5e-3;
  m.starts.screw = 5;
  m.pitch_diameter.screw = 20e-3;
  m.thread.screw = ThreadHeight{0.1e-3, 0.2e-3};
  const ShaftSection core = core_section(m, {6e-3, 0.0});
  EXPECT_DOUBLE_EQ(core.diameter, 19.6e-3);
  EXPECT_EQ(core.bore, 6e-3);
}

TEST(ShaftSection, RadiusOfGyrationIsThatOfARing) {
  EXPECT_NEAR(radius_of_gyration(kCore), std::sqrt(kInertia / kArea), 1e-17);
}

TEST(Buckling, SlenderShaftsAreEulers) {
  const double euler = pi * pi * kModulus * kInertia / 4.0;  // L = 2 m
  const auto load = [&](Ends ends) { return buckling_load(kCore, kModulus, {2.0, ends}, kYield); };
  EXPECT_NEAR(load(Ends::supported_supported) / euler, 1.0, 1e-13);
  EXPECT_NEAR(load(Ends::fixed_free) / euler, 0.25, 1e-13);
  EXPECT_NEAR(load(Ends::fixed_fixed) / euler, 4.0, 1e-13);
  // k L of a column fixed at one end and supported at the other obeys tan(k L) = k L.
  const double k_l = pi * std::sqrt(load(Ends::fixed_supported) / euler);
  EXPECT_NEAR(std::tan(k_l) / k_l, 1.0, 1e-11);
  EXPECT_NEAR(k_l, 4.4934, 1e-4);
}

TEST(Buckling, JohnsonTouchesEulerAtHalfTheYieldStrength) {
  const double slenderness = std::sqrt(2.0 * pi * pi * kModulus / kYield);
  const double limit = slenderness * radius_of_gyration(kCore);
  const auto load = [&](double length, std::optional<double> yield) {
    return buckling_load(kCore, kModulus, {length, Ends::supported_supported}, yield);
  };
  EXPECT_NEAR(load(limit, kYield) / (0.5 * kArea * kYield), 1.0, 1e-13);
  EXPECT_NEAR(load(limit, {}) / (0.5 * kArea * kYield), 1.0, 1e-13);
  // Equal slopes on both sides: the parabola leaves the hyperbola by second order only.
  const double step = 1e-4;
  const double apart = load(limit * (1.0 - step), {}) / load(limit * (1.0 - step), kYield) - 1.0;
  EXPECT_GT(apart, 0.0);
  EXPECT_LT(apart, 10.0 * step * step);
  EXPECT_NEAR(load(1e-6, kYield) / (kArea * kYield), 1.0, 1e-9);
  EXPECT_LT(load(0.5 * limit, kYield), load(0.5 * limit, {}));
}

TEST(CriticalSpeed, RootsAreThoseOfTheBeamsEquations) {
  // x = beta L from omega = x^2/L^2 sqrt(E I/(rho A)).
  const auto root = [&](Ends ends) {
    const double length = 1.3;
    const double speed = critical_speed(kCore, kModulus, kDensity, {length, ends});
    return length * std::sqrt(speed / std::sqrt(kModulus * kInertia / (kDensity * kArea)));
  };
  const double free = root(Ends::fixed_free), supported = root(Ends::fixed_supported), fixed = root(Ends::fixed_fixed);
  EXPECT_NEAR(std::cos(free) * std::cosh(free), -1.0, 1e-13);
  EXPECT_NEAR(root(Ends::supported_supported), pi, 1e-14);
  EXPECT_NEAR(std::tan(supported), std::tanh(supported), 1e-13);
  EXPECT_NEAR(std::cos(fixed) * std::cosh(fixed), 1.0, 1e-11);
  // The first roots, not later ones.
  EXPECT_LT(free, pi);
  EXPECT_LT(supported, 1.5 * pi);
  EXPECT_LT(fixed, 1.6 * pi);
}

TEST(CriticalSpeed, FallsWithTheSquareOfTheLength) {
  const auto speed = [&](double length) {
    return critical_speed(kCore, kModulus, kDensity, {length, Ends::fixed_supported});
  };
  EXPECT_NEAR(speed(0.5) / speed(1.0), 4.0, 1e-13);
}

}  // namespace
}  // namespace prs
