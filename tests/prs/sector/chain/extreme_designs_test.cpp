#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "prs/sector/chain/chain_solver.h"
#include "prs/sector/chain/design_solvers.h"
#include "prs/sector/sector.h"
#include "support/count.h"
#include "support/sanitized.h"
#include "support/sectors.h"

namespace prs {
namespace {

using test::SectorCase;

constexpr double kAgreement = 1e-9;  ///< Agreement as in docs/studies.md.

/// Differences of two results: loads relative to the largest of an interface, other values relative to themselves.
struct Differences {
  double load = 0.0;
  double displacement = 0.0;
  double tangent = 0.0;

  static Differences between(const LoadDistribution& a, const LoadDistribution& b) {
    Differences d;
    for (const Interface i : kInterfaces) {
      const double largest = *std::max_element(a.normal_load[i].begin(), a.normal_load[i].end());
      for (std::size_t k = 0; k < a.normal_load[i].size(); ++k)
        d.load = std::max(d.load, std::abs(a.normal_load[i][k] - b.normal_load[i][k]) / largest);
    }
    d.displacement = std::abs(b.axial_displacement / a.axial_displacement - 1.0);
    d.tangent = std::abs(*b.tangent_stiffness / *a.tangent_stiffness - 1.0);
    return d;
  }
  void widen(const Differences& d) {
    load = std::max(load, d.load);
    displacement = std::max(displacement, d.displacement);
    tangent = std::max(tangent, d.tangent);
  }
};

void expect_agreement(const LoadDistribution& solve, const LoadDistribution& study, const std::string& what,
                      Differences& worst) {
  ASSERT_EQ(fe::name(solve.solve.status), fe::name(study.solve.status)) << what;
  ASSERT_TRUE(solve.solve.converged()) << what;
  ASSERT_EQ(solve.tangent_stiffness.has_value(), study.tangent_stiffness.has_value()) << what;
  ASSERT_TRUE(solve.tangent_stiffness.has_value()) << what;
  const Differences d = Differences::between(solve, study);
  worst.widen(d);
  EXPECT_LE(d.load, kAgreement) << what;
  EXPECT_LE(d.displacement, kAgreement) << what;
  EXPECT_LE(d.tangent, kAgreement) << what;
}

/// Result of a study for one design.
LoadDistribution study(const SectorCase& c, const Sector& sector, double force) {
  const SectorModel numbers = c.model();
  LoadDistribution result;
  BarDesignSolver().solve({&numbers, 1}, {&force, 1}, {&result, 1});
  return FallbackSolver::complete(result) ? result : FallbackSolver(sector).solve(force);
}

TEST(ExtremeDesigns, StudiesAgreeWithSolves) {
  std::mt19937_64 random(47);
  Differences worst;
  for (int k = 0; k < test::samples(100, 4000); ++k) {
    const SectorCase c = test::extreme_sector(random);
    const double force = test::extreme_force(random);
    const Sector sector = c.build();
    expect_agreement(SectorSolver(sector).solve(force), study(c, sector, force), "design " + std::to_string(k), worst);
  }
  RecordProperty("worst_differences", fmt::format("load {:.1e}, displacement {:.1e}, tangent {:.1e}", worst.load,
                                                  worst.displacement, worst.tangent));
}

TEST(ExtremeDesigns, SoftRingsConverge) {
  Differences worst;
  for (const double ring : {1e-6, 1e-3, 1.0, 1e3})
    for (const double force : {1e-3, 45e3}) {
      SectorCase c = test::abevi();
      c.structure.roller.guidance = {Guidance::Kind::ring, ring};
      const Sector sector = c.build();
      expect_agreement(SectorSolver(sector).solve(force), study(c, sector, force), "ring " + std::to_string(ring),
                       worst);
    }
}

/// Both contacts of a thread push the roller radially; the rings carry the difference.
TEST(ExtremeDesigns, SoftRingsCarryWhatTheFlankAnglesDifferBy) {
  SectorCase c = test::abevi();
  c.structure.roller.guidance = {Guidance::Kind::ring, 1e-6};
  const LoadDistribution r = SectorSolver(c.build()).solve(45e3);
  ASSERT_TRUE(r.solve.converged());
  const double screw = std::tan(c.laws.screw.normal_angle);
  const double nut = std::tan(c.laws.nut.normal_angle);
  // The wedge between the flanks: F/4k (tan - tan)^2 per roller, other contributions are small.
  const double wedge = 45e3 / 11 / 4e-6 * (screw - nut) * (screw - nut);
  EXPECT_NEAR(r.axial_displacement / wedge, 1.0, 1e-7);
  EXPECT_NEAR(*r.tangent_stiffness / (45e3 / wedge), 1.0, 1e-7);
}

TEST(ExtremeDesigns, ThousandsOfThreadsConverge) {
  SKIP_UNDER_SANITIZERS();
  SectorCase c = test::abevi();
  c.mechanism.contacts_per_roller = test::count(2000, 10000);
  c.structure.nut = {20.0, 46e-3, {}, {.tension = 10e-3, .compression = 19.99}};
  Differences worst;
  for (const Direction direction : {Direction::tension, Direction::compression})
    for (const double force : {1.0, 45e3, 1e7}) {
      c.direction = direction;
      const Sector sector = c.build();
      expect_agreement(SectorSolver(sector).solve(force), study(c, sector, force), std::to_string(force), worst);
    }
}

TEST(ExtremeDesigns, ALoadedSectionAtTheFirstContactIsThatContact) {
  SectorCase at = test::abevi(), beside = test::abevi(), apart = test::abevi();
  at.structure.screw.free_length = 0.0;
  beside.structure.screw.free_length = 0.9e-9 * beside.structure.nut.length;
  apart.structure.screw.free_length = 1.1e-9 * apart.structure.nut.length;
  EXPECT_EQ(beside.build().loaded_node, beside.build().screw_nodes.front());
  EXPECT_NE(apart.build().loaded_node, apart.build().screw_nodes.front());
  const LoadDistribution expected = SectorSolver(at.build()).solve(45e3);
  for (const LoadDistribution& r : {SectorSolver(beside.build()).solve(45e3), study(beside, beside.build(), 45e3)}) {
    ASSERT_TRUE(r.solve.converged());
    EXPECT_NEAR(r.axial_displacement / expected.axial_displacement, 1.0, 1e-12);
  }
  const LoadDistribution far = SectorSolver(apart.build()).solve(45e3);
  ASSERT_TRUE(far.solve.converged());
  EXPECT_NEAR(far.axial_displacement / expected.axial_displacement, 1.0, 1e-8);
}

}  // namespace
}  // namespace prs
