#include "prs/life/rating_life.h"

#include <gtest/gtest.h>

#include <cmath>

namespace prs {
namespace {

TEST(RatingLife, IsAMillionAtTheCapacity) {
  EXPECT_EQ(rating_life(60e3, 60e3), 1e6);
  EXPECT_EQ(rating_life(60e3, 30e3), 8e6);
  EXPECT_TRUE(std::isinf(rating_life(60e3, 0.0)));
}

TEST(MeanLoad, IsTheCubicMeanOverRevolutions) {
  const LoadStep same[] = {{5e3, 2.0}, {-5e3, 7.0}};
  EXPECT_NEAR(mean_load(same), 5e3, 1e-9);
  // Half of the way at 2, half without load: the cube is halved.
  const LoadStep half[] = {{2.0, 10.0}, {0.0, 10.0}};
  EXPECT_NEAR(mean_load(half), 2.0 / std::cbrt(2.0), 1e-14);
  const LoadStep still[] = {{3.0, 1.0}, {100.0, 0.0}};
  EXPECT_NEAR(mean_load(still), 3.0, 1e-14);
  EXPECT_EQ(mean_load({}), 0.0);
}

TEST(MeanLoad, GivesTheLifeOfMinersSum) {
  const LoadStep steps[] = {{10e3, 0.2}, {25e3, 0.5}, {-4e3, 0.3}};
  double damage = 0.0;
  for (const LoadStep& s : steps) damage += s.revolutions / rating_life(60e3, std::abs(s.axial_force));
  EXPECT_NEAR(rating_life(60e3, mean_load(steps)) * damage, 1.0, 1e-14);
}

/// Share that survives `revolutions` at the life L10.
double survival(double revolutions, double life) { return std::pow(0.9, std::pow(revolutions / life, kWeibullSlope)); }

TEST(CombinedLife, IsWhereNineOfTenHaveNoFailedPart) {
  const double lives[] = {3e6, 8e6, 8e6, 50e6};
  const double all = combined_life(lives);
  double survived = 1.0;
  for (const double life : lives) survived *= survival(all, life);
  EXPECT_NEAR(survived, 0.9, 1e-15);
}

TEST(CombinedLife, LeavesOutWhatIsNotLoaded) {
  const double lives[] = {HUGE_VAL, 3e6};
  EXPECT_NEAR(combined_life(lives), 3e6, 1e-9);
  const double none[] = {HUGE_VAL, HUGE_VAL};
  EXPECT_TRUE(std::isinf(combined_life(none)));
  EXPECT_TRUE(std::isinf(combined_life({})));
}

TEST(PreloadedBearingLoad, IsTheRuleOfMakers) {
  // 50 kN of capacity, preloaded with 5 kN; the digits are those of the definition.
  EXPECT_NEAR(preloaded_bearing_load(10e3, 5e3), 11148.3616, 5e-5);
  EXPECT_EQ(preloaded_bearing_load(20e3, 5e3), 20e3);
  EXPECT_NEAR(preloaded_bearing_load(2e3, 5e3), 6096.6903, 5e-5);
  EXPECT_EQ(preloaded_bearing_load(0.0, 5e3), 5e3);
  EXPECT_EQ(preloaded_bearing_load(7e3, 0.0), 7e3);
  EXPECT_EQ(preloaded_bearing_load(0.0, 0.0), 0.0);
}

TEST(FailureShares, AreThoseOfTheRingsOfAThrustBallBearing) {
  EXPECT_EQ(failure_shares(0.0).screw, 0.5);
  const double gamma = 0.18;
  const PerInterface<double> shares = failure_shares(gamma);
  EXPECT_EQ(shares.screw + shares.nut, 1.0);
  // ISO/TS 16281: Q_ci = C_a/(Z sin) (1 + x^(10/3))^(3/10), Q_ce = C_a/(Z sin) (1 +
  // x^(-10/3))^(3/10); a ring's share in the failures is (Q_c sin Z/C_a)^(-10/3).
  const double x = std::pow((1 - gamma) / (1 + gamma), 1.72);
  const double inner = std::pow(1 + std::pow(x, 10.0 / 3), 0.3);
  const double outer = std::pow(1 + std::pow(x, -10.0 / 3), 0.3);
  EXPECT_NEAR(shares.screw, std::pow(inner, -10.0 / 3), 1e-15);
  EXPECT_NEAR(shares.nut, std::pow(outer, -10.0 / 3), 1e-15);
}

/// Table 12 of ISO 281:2007.
TEST(ReliabilityFactor, IsThatOfTheStandard) {
  const std::pair<double, double> table[] = {{0.90, 1.0},  {0.95, 0.64}, {0.96, 0.55},
                                             {0.97, 0.47}, {0.98, 0.37}, {0.99, 0.25}};
  for (const auto& [reliability, factor] : table) EXPECT_NEAR(reliability_factor(reliability), factor, 1e-15);
}

TEST(ReliabilityFactor, FollowsAWeibullLineBetween) {
  // ln a1 = ln(0.64) t with t from 0 at 90 % to 1 at 95 %, in ln ln(1/S).
  const auto place = [](double s) { return std::log(std::log(1.0 / s)); };
  for (const double s : {0.91, 0.925, 0.94}) {
    const double t = (place(s) - place(0.90)) / (place(0.95) - place(0.90));
    EXPECT_NEAR(reliability_factor(s), std::exp(t * std::log(0.64)), 1e-14);
  }
  const double t = (place(0.985) - place(0.98)) / (place(0.99) - place(0.98));
  EXPECT_NEAR(reliability_factor(0.985), 0.37 * std::pow(0.25 / 0.37, t), 1e-14);
}

/// u^e V of both bodies by their numbers: 9 rollers of 7 mm that roll 1 m on a screw of 21 mm.
TEST(RollerFailureShare, CountsCyclesAndTracks) {
  constexpr double kTurn = 3.141592653589793;
  const double way = 1.0, screw = kTurn * 21e-3, roller = kTurn * 7e-3;
  const double of_rollers = 9 * roller * std::pow(way / roller, 10.0 / 9);
  const double of_screw = screw * std::pow(9 * way / screw, 10.0 / 9);
  EXPECT_NEAR(roller_failure_share(9, 7e-3, 21e-3), of_rollers / (of_rollers + of_screw), 1e-14);
}

TEST(ThreadLife, OfEqualThreadsCombinesToTheRatingLife) {
  for (const int threads : {1, 7, 40})
    for (const double gamma : {0.0, 0.1, 0.25}) {
      const PerInterface<double> shares = failure_shares(gamma);
      std::vector<double> lives;
      for (const Interface i : kInterfaces)
        for (int k = 0; k < threads; ++k) lives.push_back(thread_life(64e3, 11e3, shares[i], threads));
      EXPECT_NEAR(combined_life(lives) / rating_life(64e3, 11e3), 1.0, 1e-13);
    }
}

/// The three pieces of the standard meet at 0.4 and at 1; without cleanliness a tenth is left; at kappa = 1 and
/// e_C C_u/P = 0.1 by hand: 0.1 (1 - 0.5684^0.83 0.1^(1/3))^-9.3 = 2.43.
TEST(ModificationFactor, IsThatOfIso281) {
  EXPECT_NEAR(modification_factor(1.0, 1.0, 0.1), 2.43, 5e-3);
  for (const double joint : {0.4, 1.0})
    EXPECT_NEAR(modification_factor(joint * (1.0 - 1e-12), 0.5, 0.3) / modification_factor(joint, 0.5, 0.3), 1.0, 1e-3);
  EXPECT_NEAR(modification_factor(2.0, 0.0, 1.0), 0.1, 1e-12);
  EXPECT_EQ(modification_factor(4.0, 1.0, 3.0), 50.0);
  EXPECT_EQ(modification_factor(9.0, 0.5, 0.1), modification_factor(4.0, 0.5, 0.1));
  EXPECT_EQ(modification_factor(0.05, 1.0, 1.0), 0.1);
}

}  // namespace
}  // namespace prs
