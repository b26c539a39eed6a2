#include "prs/life/contact_loads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "prs/sector/sector.h"
#include "support/count.h"
#include "support/sectors.h"

namespace prs {
namespace {

using Shares = std::vector<double>;

/// Largest deviation of the curve from the interpolated function, at random loads, for shares and cubes.
double deviation(const ShareCurve& curve, const ShareCurve::Solve& solve, double least, double greatest, int loads) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> position(std::log(least), std::log(greatest));
  double largest = 0.0;
  for (int n = 0; n < loads; ++n) {
    const double force = std::exp(position(random));
    const Shares solved = *solve(force);
    Shares shares(solved.size());
    curve.shares_at(force, shares);
    const ShareCurve::Place place = curve.place(force);
    for (std::size_t k = 0; k < solved.size(); ++k) {
      double cube = 0.0;
      for (std::size_t j = 0; j < ShareCurve::kNodes; ++j)
        cube += place.weights[j] * std::pow(curve.shares(place.first + j)[k], 3);
      largest = std::max({largest, std::abs(shares[k] - solved[k]), std::abs(cube - std::pow(solved[k], 3))});
    }
  }
  return largest;
}

TEST(ShareCurve, ReproducesPolynomialsOfTheCubeRoot) {
  const ShareCurve::Solve solve = [](double force) -> std::optional<Shares> {
    const double x = std::cbrt(force / 8e3);
    return Shares{1.0 + 0.3 * x, 1.0 - 0.3 * x * x};
  };
  const ShareCurve curve(solve, 1.0, 8e3);
  EXPECT_EQ(curve.solves(), 9 + 4);
  EXPECT_LT(deviation(curve, solve, 1.0, 8e3, 500), 1e-13);
}

TEST(ShareCurve, PilesPanelsUpOnAKink) {
  const ShareCurve::Solve solve = [](double force) -> std::optional<Shares> {
    const double open = std::pow(std::max(0.0, force / 3e3 - 1.0), 1.5);
    return Shares{2.0 - open / (1.0 + open), open / (1.0 + open)};
  };
  const ShareCurve curve(solve, 0.1, 20e3);
  EXPECT_LE(curve.error(), ShareCurve::kTolerance);
  EXPECT_LT(deviation(curve, solve, 0.1, 20e3, 20'000), 20 * ShareCurve::kTolerance);
}

TEST(ShareCurve, OfASingleLoadIsThatLoad) {
  int solves = 0;
  const ShareCurve::Solve solve = [&](double force) -> std::optional<Shares> {
    ++solves;
    return Shares{force};
  };
  const ShareCurve curve(solve, 5.0, 5.0);
  EXPECT_EQ(solves, 1);
  Shares shares(1);
  curve.shares_at(5.0, shares);
  EXPECT_NEAR(shares[0], 5.0, 1e-14);
}

TEST(ShareCurve, HoldsItsEndsBeyondThem) {
  const ShareCurve::Solve solve = [](double force) -> std::optional<Shares> { return Shares{std::cbrt(force)}; };
  const ShareCurve curve(solve, 1.0, 1e3);
  Shares shares(1);
  curve.shares_at(1e-6, shares);
  EXPECT_NEAR(shares[0], 1.0, 1e-13);
  curve.shares_at(1e3, shares);
  EXPECT_NEAR(shares[0], 10.0, 1e-13);
}

TEST(ShareCurve, SaysWhereASolveFailed) {
  const ShareCurve::Solve solve = [](double force) -> std::optional<Shares> {
    return force < 500.0 ? std::optional(Shares{1.0}) : std::nullopt;
  };
  const ShareCurve curve(solve, 1.0, 1e3);
  ASSERT_TRUE(curve.failed_at());
  EXPECT_GE(*curve.failed_at(), 500.0);
}

/// Shares in equilibrium, times the threads of a roller.
ShareCurve::Solve sector_shares(SectorSolver& solver) {
  return [&solver](double force) -> std::optional<Shares> {
    const LoadDistribution loads = solver.solve(force);
    if (!loads.solve.converged()) return std::nullopt;
    const Sector& s = solver.sector();
    Shares shares;
    for (const Interface i : kInterfaces)
      for (const double n : loads.normal_load[i]) shares.push_back(n * s.cosine[i] * s.contacts() * s.rollers / force);
    return shares;
  };
}

TEST(ShareCurve, AgreesWithTheLoadDistribution) {
  SectorSolver solver(test::abevi().build());
  const ShareCurve::Solve solve = sector_shares(solver);
  const ShareCurve curve(solve, 0.45, 45e3);
  EXPECT_LE(curve.solves(), 200);
  EXPECT_LT(deviation(curve, solve, 0.45, 45e3, test::count(300, 20'000)), 1e-7);
}

TEST(ShareCurve, AgreesWithTheLoadDistributionWhereThreadsOpen) {
  test::SectorCase c = test::short_screw();
  c.deviations.crowning = 4e-6;
  SectorSolver solver(c.build());
  const ShareCurve::Solve solve = sector_shares(solver);
  const ShareCurve curve(solve, 0.2, 20e3);
  ASSERT_FALSE(curve.failed_at());
  EXPECT_LT(deviation(curve, solve, 0.2, 20e3, test::count(300, 20'000)), 1e-6);
}

}  // namespace
}  // namespace prs
