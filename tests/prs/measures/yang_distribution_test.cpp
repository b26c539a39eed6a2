#include "prs/measures/stiffness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "prs/sector/sector.h"
#include "support/count.h"
#include "support/sectors.h"
#include "support/sum.h"

namespace prs {
namespace {

using test::sum;

std::vector<ThreadGap> same_side(std::size_t threads, double screw, double nut) {
  return std::vector<ThreadGap>(threads - 1, {screw, 0.0, nut});
}

std::vector<ThreadGap> opposite_side(std::size_t threads, double screw, double nut) {
  return std::vector<ThreadGap>(threads - 1, {screw, nut, 0.0});
}

/// Largest error of w_k - w_(k+1) = S_(k+1) (c_S + c_N behind) - P_k c_N before over the largest
/// approach.
double equation_error(const std::vector<double>& loads, double h, const std::vector<ThreadGap>& gaps) {
  const auto approach = [&](double load) { return h * std::pow(load, 2.0 / 3.0); };
  const double force = sum(loads);
  const double largest = approach(*std::max_element(loads.begin(), loads.end()));
  double error = 0.0, before = 0.0;
  for (std::size_t k = 0; k + 1 < loads.size(); ++k) {
    before += loads[k];
    const double behind = force - before;
    const double stretch = behind * (gaps[k].screw + gaps[k].nut_behind_thrust) - before * gaps[k].nut_before_thrust;
    const double difference = approach(loads[k]) - approach(loads[k + 1]);
    error = std::max(error, std::abs(difference - stretch) / largest);
  }
  return error;
}

TEST(YangDistribution, TwoThreadsHaveTheCompliancesThatTheirLoadsAskFor) {
  const double h = 3e-8, first = 700.0, second = 450.0;
  const double difference = h * (std::pow(first, 2.0 / 3.0) - std::pow(second, 2.0 / 3.0));
  const auto same = yang_distribution(first + second, h, same_side(2, difference / second, 0.0));
  EXPECT_NEAR(same.at(0) / first, 1.0, 1e-13);
  EXPECT_NEAR(same.at(1) / second, 1.0, 1e-13);
  // The nut's stretch in front of the thrust section unloads the first thread.
  const double nut = 0.4 * difference / first;
  const double screw = (difference + first * nut) / second;
  const auto opposite = yang_distribution(first + second, h, opposite_side(2, screw, nut));
  EXPECT_NEAR(opposite.at(0) / first, 1.0, 1e-13);
  EXPECT_NEAR(opposite.at(1) / second, 1.0, 1e-13);
}

TEST(YangDistribution, RigidShaftsShareEqually) {
  for (const double load : yang_distribution(3e3, 2e-8, same_side(20, 0.0, 0.0))) EXPECT_NEAR(load, 150.0, 1e-10);
}

TEST(YangDistribution, OneThreadCarriesEverything) {
  const auto loads = yang_distribution(3e3, 2e-8, {});
  ASSERT_EQ(loads.size(), 1U);
  EXPECT_NEAR(loads[0], 3e3, 1e-9);
}

TEST(YangDistribution, SmallLoadsDifferAsTheCubeRootOfTheLoad) {
  // To first order h 2/3 f^(-1/3) (F_k - F_(k+1)) = c (n - k) f with f = F/n.
  const double h = 2e-8, c = 5e-10;
  const std::size_t n = 8;
  for (const double force : {1e-6, 8e-6}) {
    const double mean = force / static_cast<double>(n);
    const auto loads = yang_distribution(force, h, same_side(n, c, 0.0));
    for (std::size_t k = 0; k + 1 < n; ++k) {
      const double first_order = 1.5 * c / h * std::cbrt(mean) * static_cast<double>(n - 1 - k) * mean;
      EXPECT_NEAR((loads[k] - loads[k + 1]) / first_order, 1.0, 0.01) << k;
    }
  }
}

TEST(YangDistribution, EqualShaftsAndOppositeThrustLoadBothEndsAlike) {
  const auto loads = yang_distribution(4e3, 2e-8, opposite_side(15, 4e-10, 4e-10));
  for (std::size_t k = 0; k < 15; ++k) EXPECT_NEAR(loads[k] / loads[14 - k], 1.0, 1e-11) << k;
  EXPECT_GT(loads.front(), 1.05 * loads[7]);
}

TEST(YangDistribution, OppositeThrustIsMoreEvenThanSameSide) {
  const auto same = yang_distribution(4e3, 2e-8, same_side(15, 4e-10, 2e-10));
  const auto opposite = yang_distribution(4e3, 2e-8, opposite_side(15, 4e-10, 2e-10));
  EXPECT_GT(same.front(), opposite.front());
  for (std::size_t k = 0; k + 1 < same.size(); ++k) EXPECT_GT(same[k], same[k + 1]);
}

TEST(YangDistribution, RandomScrewsObeyTheEquationAndSumToTheForce) {
  std::mt19937_64 random(7);
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  for (int sample = 0; sample < test::count(500, 50'000); ++sample) {
    std::vector<ThreadGap> gaps(static_cast<std::size_t>(uniform(1.0, 60.0)));
    const auto threads = static_cast<double>(gaps.size());
    const double screw = std::exp(uniform(std::log(1e-12), std::log(2e-9)));
    const double nut = screw * uniform(0.2, 2.0), thrust = uniform(-0.2, 1.2) * threads;
    for (std::size_t k = 0; k < gaps.size(); ++k) {
      const double before = std::clamp(thrust - static_cast<double>(k), 0.0, 1.0);
      gaps[k] = {screw, before * nut, (1.0 - before) * nut};
    }
    const double force = std::exp(uniform(std::log(10.0), std::log(5e3)));
    const auto loads = yang_distribution(force, 5e-7, gaps);
    ASSERT_FALSE(loads.empty()) << sample;
    EXPECT_NEAR(sum(loads) / force, 1.0, 1e-9);
    EXPECT_LT(equation_error(loads, 5e-7, gaps), 1e-9);
    EXPECT_GT(*std::min_element(loads.begin(), loads.end()), 0.0);
  }
}

TEST(YangDistribution, WhatRoundingCannotResolveIsRefused) {
  for (const double compliance : {1e-8, 1e-6, 1e-4, 1e-2}) {
    for (const auto& gaps : {same_side(200, compliance, compliance), opposite_side(200, compliance, compliance)}) {
      const auto loads = yang_distribution(1e5, 2e-8, gaps);
      if (loads.empty()) continue;
      EXPECT_NEAR(sum(loads) / 1e5, 1.0, 1e-9) << compliance;
    }
  }
}

/// The sector model with a roller that does not bend and whose core carries nothing.
std::vector<double> sector_loads(test::SectorCase c, double force, Interface i) {
  c.options.roller = ModelOptions::Roller::rigid_bending;
  c.materials.roller.youngs_modulus *= 1e-9;
  SectorSolver solver(c.build());
  const LoadDistribution r = solver.solve(force);
  EXPECT_TRUE(r.solve.converged());
  std::vector<double> loads;
  for (const double n : r.normal_load[i]) loads.push_back(n * std::cos(c.laws[i].normal_angle));
  return loads;
}

std::vector<double> yang_loads(const test::SectorCase& c, double force) {
  double h = 0.0;
  for (const Interface i : kInterfaces) h += axial_hertz_coefficient(c.laws[i].hertz_constant, c.laws[i].normal_angle);
  const Structure::Thrust& t = c.structure.nut.thrust;
  return yang_distribution(force / c.mechanism.rollers, h,
                           thread_gaps(c.mechanism, c.structure, c.materials,
                                       c.direction == Direction::tension ? *t.tension : *t.compression, c.position));
}

TEST(YangDistribution, IsTheSectorModelWhoseRollerTeethAreBalls) {
  // At both ends of the nut, in its middle, and with threads inside a flange or about the thrust
  // section.
  for (const double position : {1e-3, 4e-3, 29.1666667e-3, 54.3333333e-3})
    for (const double thrust : {0.0, 10e-3, 45e-3, 80e-3, 90e-3})
      for (const Direction direction : {Direction::tension, Direction::compression}) {
        test::SectorCase c = test::abevi();
        c.position = position;
        c.direction = direction;
        c.structure.nut.thrust = {.tension = thrust, .compression = thrust};
        const auto yang = yang_loads(c, 45e3);
        ASSERT_EQ(yang.size(), 20U);
        for (const Interface i : kInterfaces) {
          const auto sector = sector_loads(c, 45e3, i);
          for (std::size_t k = 0; k < yang.size(); ++k)
            EXPECT_NEAR(sector[k] / yang[k], 1.0, 1e-8) << position << ' ' << thrust << ' ' << k;
        }
      }
}

}  // namespace
}  // namespace prs
