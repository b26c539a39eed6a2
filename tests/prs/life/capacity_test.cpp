#include "prs/life/rating_life.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace prs {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// ISO 281:1990, table 4, thrust ball bearings, contact angle 45 deg: D_w cos(alpha)/D_pw and f_c.
constexpr double kStandardFactors[][2] = {{0.01, 42.1}, {0.02, 51.7}, {0.03, 58.2}, {0.04, 63.3}, {0.05, 67.3},
                                          {0.06, 70.7}, {0.07, 73.5}, {0.08, 75.9}, {0.09, 78.0}, {0.10, 79.7},
                                          {0.12, 82.3}, {0.14, 84.1}, {0.16, 85.1}, {0.18, 85.5}, {0.20, 85.4},
                                          {0.22, 84.9}, {0.24, 84.0}, {0.26, 82.8}, {0.28, 81.3}, {0.30, 79.6}};

TEST(GeometryFactor, IsThatOfThrustBallBearings) {
  for (const auto& [ratio, factor] : kStandardFactors)
    EXPECT_NEAR(*geometry_factor(ratio) / factor, 1.0, kFactorFit) << ratio;
}

TEST(GeometryFactor, IsRefusedWhereTheStandardEnds) {
  EXPECT_FALSE(geometry_factor(0.00999));
  EXPECT_FALSE(geometry_factor(0.30001));
  EXPECT_FALSE(geometry_factor(0.36));
  EXPECT_FALSE(geometry_factor(std::nan("")));
}

/// Jung 2017, table 7.1: screw and roller diameter [mm], load capacity [kN], with p = 2 mm, N_c = 500 and the helix
/// angle 6.056 deg. The print deviates by up to 0.7 of its last digit.
constexpr double kJung[][3] = {{27, 9, 165.082},  {28.5, 10, 182.095}, {30, 11, 198.900}, {31.5, 12, 215.518},
                               {33, 13, 231.969}, {34.5, 14, 248.268}, {36, 15, 264.429}, {37.5, 16, 280.464},
                               {39, 17, 296.382}, {40.5, 18, 312.192}};

TEST(LemorCapacity, IsThatOfJungsTable) {
  for (const auto& [screw, roller, capacity] : kJung) {
    LemorGeometry g;
    g.pitch = 2e-3;
    g.roller_diameter = roller * 1e-3;
    g.nut_diameter = (screw + 2 * roller) * 1e-3;
    g.pitch_circle = (screw + roller) * 1e-3;
    g.contact_angle = 45 * kDegree;
    g.helix_angle = 6.056 * kDegree;
    g.contacts = 500;
    EXPECT_NEAR(lemor_capacity(g)->capacity * 1e-3, capacity, 0.7e-3) << roller;
  }
}

TEST(LemorCapacity, GrowsWithContactsAndDiameterAsItsPowers) {
  const double one = lemor_capacity(80.0, 45 * kDegree, 100, 6e-3, 5 * kDegree);
  EXPECT_NEAR(lemor_capacity(80.0, 45 * kDegree, 800, 6e-3, 5 * kDegree) / one, 4.0, 1e-14);
  EXPECT_NEAR(lemor_capacity(80.0, 45 * kDegree, 100, 12e-3, 5 * kDegree) / one, std::pow(2.0, 1.8), 1e-14);
  // One ball of 1 mm, 45 deg, no helix: f_c cos(45 deg)^0.86.
  EXPECT_NEAR(lemor_capacity(1.0, 45 * kDegree, 1, 1e-3, 0.0), std::pow(2.0, -0.43), 1e-14);
}

/// ISO 281: a ball's share of its capacity up to 25.4 mm and beyond, where both powers meet.
TEST(LemorCapacity, LargeElementsCountLess) {
  EXPECT_NEAR(size_factor(25.4e-3 * (1.0 + 1e-12)) / size_factor(25.4e-3), 1.0, 1e-4);
  EXPECT_NEAR(size_factor(60e-3) / size_factor(30e-3), std::pow(2.0, 1.4), 1e-12);
  EXPECT_NEAR(size_factor(30e-3), 3.647 * std::pow(30.0, 1.4), 1e-10);
  EXPECT_NEAR(lemor_capacity(80.0, 45 * kDegree, 100, 60e-3, 5 * kDegree) /
                  lemor_capacity(80.0, 45 * kDegree, 100, 30e-3, 5 * kDegree),
              std::pow(2.0, 1.4), 1e-12);
}

LemorGeometry abevi() {
  LemorGeometry g;
  g.pitch = 5e-3 / 3;
  g.roller_diameter = 7e-3;
  g.nut_diameter = 35e-3;
  g.pitch_circle = 28e-3;
  g.contact_angle = 45 * kDegree;
  g.helix_angle = std::atan(5.0 / (std::numbers::pi * 21.0));
  g.contacts = 220;
  return g;
}

TEST(LemorCapacity, CarriesTheRangeOfItsFactor) {
  const LemorCapacity c = *lemor_capacity(abevi());
  EXPECT_LT(c.factor_range.least, c.factor);
  EXPECT_GT(c.factor_range.greatest, c.factor);
  EXPECT_NEAR(c.capacity_range.least / c.capacity, c.factor_range.least / c.factor, 1e-14);
  EXPECT_NEAR(c.capacity_range.greatest / c.capacity, c.factor_range.greatest / c.factor, 1e-14);
  // The second of the three readings, 0.1414, 0.1768 and 0.1622, is next to the maximum of f_c.
  EXPECT_NEAR(c.ratio, std::sqrt(0.5) / 5, 1e-14);
  EXPECT_NEAR(c.factor_range.greatest, *geometry_factor(std::sqrt(0.5) / 4) * (1.0 + kFactorFit), 1e-12);
  EXPECT_NEAR(c.element_diameter, std::sqrt(2.5 * 5e-3 / 3 * std::numbers::sqrt2 * 7e-3), 1e-16);
}

TEST(LemorCapacity, IsAbsentWithoutFactor) {
  LemorGeometry g = abevi();
  g.roller_diameter = 15e-3;  // 0.303
  EXPECT_FALSE(lemor_capacity(g));
}

TEST(LoadAtPressure, IsTheHertzContactBackwards) {
  const contact::HertzConstants hertz = contact::hertz_constants(40.0, 310.0, 115e9);
  ASSERT_TRUE(hertz.ok());
  for (const double pressure : {0.5e9, 2.0e9, 4.0e9}) {
    const double load = load_at_pressure(hertz, pressure);
    EXPECT_NEAR(contact::at_load(hertz, load).peak_pressure / pressure, 1.0, 1e-14);
  }
}

}  // namespace
}  // namespace prs
