#include "contact/film.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace contact {
namespace {

constexpr double mm2_per_s = 1e-6;

TEST(Walther, LineGoesThroughItsPoints) {
  for (const double hot : {0.3000001, 0.35, 0.9, 5.4, 30.0})
    for (const double cold : {31.0, 320.0, 1e5}) {
      const WaltherLine line = walther_line(313.15, cold * mm2_per_s, 373.15, hot * mm2_per_s);
      // Relative to the distance from 0.3 mm^2/s, which is small at the hot point.
      EXPECT_NEAR(kinematic_viscosity(line, 313.15) / mm2_per_s / cold, 1.0, 1e-12);
      EXPECT_NEAR(kinematic_viscosity(line, 373.15) / mm2_per_s / hot, 1.0, 1e-12) << hot;
      EXPECT_GT(line.slope, 0.0);
    }
}

TEST(Walther, PointsMayComeInAnyOrder) {
  const WaltherLine a = walther_line(313.15, 46e-6, 373.15, 6.8e-6);
  const WaltherLine b = walther_line(373.15, 6.8e-6, 313.15, 46e-6);
  EXPECT_NEAR(a.slope, b.slope, 1e-14);
  EXPECT_NEAR(a.intercept, b.intercept, 1e-13);
}

TEST(Walther, IsTheEquationOfTheStandard) {
  const WaltherLine line{9.5, 3.7};
  for (const double temperature : {253.15, 293.15, 353.15, 423.15}) {
    const double y = std::log10(std::log10(kinematic_viscosity(line, temperature) * 1e6 + 0.7));
    EXPECT_NEAR(y, 9.5 - 3.7 * std::log10(temperature), 1e-13);
  }
}

TEST(Walther, ReproducesAWorkedExample) {
  // A published worksheet of ASTM D341, with 273 K for 0 degC: 32 cSt at 40 degC and 5.4 cSt at
  // 100 degC give A = 9.5259, B = 3.7449 and 8.5 cSt at 80 degC.
  const WaltherLine line = walther_line(313.0, 32e-6, 373.0, 5.4e-6);
  EXPECT_NEAR(line.intercept, 9.5259, 5e-5);
  EXPECT_NEAR(line.slope, 3.7449, 5e-5);
  EXPECT_NEAR(kinematic_viscosity(line, 353.0) / mm2_per_s, 8.5, 0.05);
}

TEST(Walther, FallsWithTemperatureAndKeepsAboveItsLimit) {
  const WaltherLine line = walther_line(313.15, 100e-6, 373.15, 11e-6);
  double before = std::numeric_limits<double>::infinity();
  for (double temperature = 230.0; temperature < 800.0; temperature += 5.0) {
    const double viscosity = kinematic_viscosity(line, temperature);
    EXPECT_LT(viscosity, before) << temperature;
    EXPECT_GT(viscosity, kLeastKinematicViscosity) << temperature;
    before = viscosity;
  }
}

/// Viscosity [mPa s] and pressure-viscosity coefficient [1/GPa] at 30, 60 and 100 degC.
struct MeasuredOil {
  double viscosity[3];
  double coefficient[3];
};

TEST(PressureViscosity, OfParaffinicOilsLiesUpTo30PercentBelowTheHandbook) {
  // Stachowiak and Batchelor, Engineering Tribology, table 2.3, oils of high viscosity index.
  const MeasuredOil oils[] = {{{38, 12.1, 5.3}, {0, 18.4, 13.4}},
                              {{153, 34, 9.1}, {23.7, 20.5, 15.8}},
                              {{250, 50.5, 12.6}, {25.0, 21.3, 17.6}},
                              {{810, 135, 26.8}, {34, 28, 22}}};
  for (const MeasuredOil& oil : oils)
    for (int i = 0; i < 3; ++i) {
      if (oil.coefficient[i] == 0) continue;
      const double kinematic = 1e-3 * oil.viscosity[i] / kTypicalOilDensity;
      EXPECT_NEAR(gold_pressure_viscosity(BaseOil::mineral, kinematic) * 1e9 / oil.coefficient[i], 0.85, 0.15)
          << oil.viscosity[i];
    }
}

TEST(Walther, TemperatureCoefficientIsTheSlopeOfItsLine) {
  const WaltherLine line = walther_line(313.15, 100e-6, 373.15, 11.2e-6);
  for (const double t : {293.15, 333.15, 393.15}) {
    const double h = 1e-3;
    const double slope =
        (std::log(kinematic_viscosity(line, t + h)) - std::log(kinematic_viscosity(line, t - h))) / (2.0 * h);
    EXPECT_NEAR(temperature_coefficient(line, t), -slope, 1e-9);
  }
}

}  // namespace
}  // namespace contact
