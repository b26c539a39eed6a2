#include "prs/life/static_limits.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/hertz.h"

namespace prs {
namespace {

TEST(PermanentDeformation, GrowsWithTheSquareOfTheLoad) {
  const double load = load_at_permanent_deformation(10e-3, 20.0, 300.0);
  EXPECT_NEAR(1.3e-19 * load * load / 10e-3 * 20.0 * 300.0 / 10e-3, 1e-4, 1e-17);
  EXPECT_NEAR(load_at_permanent_deformation(10e-3, 20.0, 300.0, 4e-4) / load, 2.0, 1e-14);
}

/// Inner raceway of a ball bearing: gamma = D cos(alpha)/d_m, f the groove's radius over D.
struct Raceway {
  double kappa_1;
  double kappa_2;
};
Raceway inner_raceway(double diameter, double gamma, double conformity) {
  return {2.0 / diameter - 1.0 / (conformity * diameter), 2.0 / diameter / (1.0 - gamma)};
}

TEST(PermanentDeformation, IsHarrisFormOfABallOnItsInnerRaceway) {
  // Harris: 5.25e-7 Q^2/D^3 (1 + gamma/(1 - gamma)) (1 - 1/(2 f)) [mm, N], rounded from 4 x 1.3e-7.
  const double diameter = 12.0, load = 5e3, gamma = 0.18, f = 0.53;
  const double harris = 5.25e-7 * load * load / std::pow(diameter, 3) * (1.0 + gamma / (1.0 - gamma)) * (1.0 - 0.5 / f);
  const Raceway r = inner_raceway(diameter * 1e-3, gamma, f);
  const double found = load_at_permanent_deformation(diameter * 1e-3, r.kappa_1, r.kappa_2, harris / diameter);
  EXPECT_NEAR(found / load, 1.0, 0.005);
}

TEST(PermanentDeformation, TheLimitIsAroundThePressureOfIso76ForBallBearings) {
  // ISO 76 gives one rounded figure for all ball bearings, 4200 MPa. Palmgren's formula is a fit
  // and depends on the groove: from the tightest groove of the largest bearing to the widest one of
  // the smallest it gives 3821 to 4298 MPa (Johnson's formulas, see `plain::hertz_constant`), with
  // 4200 MPa between.
  const double modulus = contact::contact_modulus({207e9, 0.3}, {207e9, 0.3});
  const auto pressure = [&](double gamma, double f) {
    const Raceway r = inner_raceway(10e-3, gamma, f);
    const double load = load_at_permanent_deformation(10e-3, r.kappa_1, r.kappa_2);
    const auto hertz = contact::hertz_constants(r.kappa_1, r.kappa_2, modulus);
    return contact::at_load(hertz, load).peak_pressure;
  };
  EXPECT_NEAR(pressure(0.05, 0.515), 3.8213e9, 0.5e5);
  EXPECT_NEAR(pressure(0.2, 0.52), 4.0648e9, 0.5e5);
  EXPECT_NEAR(pressure(0.3, 0.53), 4.2981e9, 0.5e5);
}

TEST(StaticRating, IsTheMakersOrThatOfThePressure) {
  EXPECT_FALSE(static_rating({}, {}));
  EXPECT_EQ(static_rating(3.0, {})->limit, StaticLimit::pressure);
  EXPECT_EQ(static_rating(3.0, 8.0)->limit, StaticLimit::given);
  EXPECT_EQ(static_rating(3.0, 8.0)->force, 8.0);
  const auto screw = static_rating(3.0, {}), nut = static_rating(2.0, {});
  EXPECT_EQ(smaller(screw, nut)->force, 2.0);
  EXPECT_EQ(smaller(screw, std::nullopt)->force, 3.0);
}

TEST(StaticLimits, NotesSayWhatMakersDoNotBuild) {
  EXPECT_FALSE(dynamic_above_static(98e3, 130e3, true));
  EXPECT_TRUE(dynamic_above_static(131e3, 130e3, true));
  EXPECT_FALSE(beyond_static_rating(130e3, {130e3, StaticLimit::pressure}));
  EXPECT_NE(beyond_static_rating(131e3, {130e3, StaticLimit::pressure})->what.find("contact pressure at its limit"),
            std::string::npos);
}

TEST(PermanentDeformation, OnlyAConvexFlankHasARollingElement) {
  contact::Thread roller;
  roller.profile_curvature = 1.0 / 5e-3;
  EXPECT_NEAR(*flank_element_diameter(roller), 10e-3, 1e-17);
  roller.profile_curvature = 0.0;
  EXPECT_FALSE(flank_element_diameter(roller));
  roller.profile_curvature = -100.0;
  EXPECT_FALSE(flank_element_diameter(roller));
}

}  // namespace
}  // namespace prs
