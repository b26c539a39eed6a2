#include "prs/sector/chain/chain_solver.h"

#include <gtest/gtest.h>

#include <limits>

#include "prs/sector/chain/solves.h"
#include "support/allocations.h"
#include "support/count.h"

namespace prs {
namespace {

using test::NamedCase, test::SectorCase;

TEST(ChainSolver, AgreesWithSparseSolverOnSpecialCases) {
  for (const NamedCase& c : test::special_cases()) {
    const Sector sector = c.sector.build();
    ChainSolver chain(sector);
    for (const double force : {1e-3, 50.0, 45e3, 1e7})
      test::expect_same(test::sparse(sector, force), chain.solve(force), c.name + ' ' + std::to_string(force));
  }
}

TEST(ChainSolver, AgreesWithSparseSolverOnRefinedCases) {
  for (const NamedCase& c : test::special_cases()) {
    if (c.sector.structure.nut.thrust.tension == c.sector.structure.nut.thrust.compression)
      continue;  // no ring to lean on inside the nut
    for (const auto contacts :
         {ModelOptions::RollerContacts::opposite, ModelOptions::RollerContacts::half_pitch_apart}) {
      SectorCase refined = c.sector;
      refined.options.bodies = &kRefined;
      refined.options.roller_contacts = contacts;
      const Sector sector = refined.build();
      ChainSolver chain(sector);
      for (const double force : {1e-3, 45e3})
        test::expect_same(test::sparse(sector, force), chain.solve(force), c.name + ' ' + std::to_string(force));
    }
  }
}

TEST(ChainSolver, AgreesWithSparseSolverForSingleEffects) {
  for (int effect = 0; effect < 7; ++effect)
    for (const bool others : {false, true}) {
      SectorCase c = test::abevi();
      c.options.bodies = &kRefined;
      bool on[7];
      std::fill(std::begin(on), std::end(on), others);
      on[effect] = !others;
      c.options.refined = {on[0], on[1], on[2], on[3], on[4], on[5], on[6]};
      c.options.roller_contacts =
          others ? ModelOptions::RollerContacts::half_pitch_apart : ModelOptions::RollerContacts::opposite;
      const Sector sector = c.build();
      test::expect_same(test::sparse(sector, 45e3), ChainSolver(sector).solve(45e3),
                        "effect " + std::to_string(effect));
    }
}

void agree_on_random_sectors(int count, bool refined) {
  std::mt19937_64 random(17);
  for (int k = 0; k < count; ++k) {
    SectorCase c = test::random_sector(random);
    if (refined) c = test::refined(c, random);
    const double force = test::random_force(c, random);
    const Sector sector = c.build();
    test::expect_same(test::sparse(sector, force), ChainSolver(sector).solve(force), "sector " + std::to_string(k));
  }
}

TEST(ChainSolver, AgreesWithSparseSolverOnRandomSectors) { agree_on_random_sectors(test::samples(200, 5000), false); }

TEST(ChainSolver, AgreesWithSparseSolverOnRandomRefinedSectors) {
  agree_on_random_sectors(test::samples(60, 2000), true);
}

/// A sector of 89 threads whose residual stays above the tolerance by rounding: the last step's change of a force
/// decides, and its bound by work is twenty times too large.
TEST(ChainSolver, ConvergesWhereRoundingIsAllThatIsLeft) {
  std::mt19937_64 random(17);
  SectorCase c;
  double force = 0.0;
  for (int k = 0; k <= 1336; ++k) {
    c = test::random_sector(random);
    force = test::random_force(c, random);
  }
  const Sector sector = c.build();
  test::expect_same(test::sparse(sector, force), ChainSolver(sector).solve(force), "sector 1336");
}

/// With rigid bodies every thread carries the same, and the displacement is that of two contacts.
TEST(ChainSolver, RigidBodiesShareEqually) {
  SectorCase c = test::abevi();
  for (const Part p : kParts) c.materials[p].youngs_modulus = 209e15;
  c.options.roller = ModelOptions::Roller::rigid_bending;
  const LoadDistribution r = ChainSolver(c.build()).solve(45e3);
  ASSERT_TRUE(r.solve.converged());
  double displacement = 0.0;
  for (const Interface i : kInterfaces) {
    const double cosine = std::cos(c.laws[i].normal_angle), thread = 45e3 / 220 / cosine;
    for (const double load : r.normal_load[i]) EXPECT_NEAR(load / thread, 1.0, 1e-5);
    displacement += std::pow(thread / c.laws[i].hertz_constant, 2.0 / 3.0) / cosine;
  }
  EXPECT_NEAR(r.axial_displacement / displacement, 1.0, 1e-5);
}

/// One thread carries all; screw and nut stretch with it in series.
TEST(ChainSolver, OneThreadIsInSeriesWithScrewAndNut) {
  SectorCase c = test::abevi();
  c.mechanism.contacts_per_roller = 1;
  c.options.roller = ModelOptions::Roller::rigid_bending;
  c.structure.nut.flanges.clear();
  const LoadDistribution r = ChainSolver(c.build()).solve(2e3);
  ASSERT_TRUE(r.solve.converged());
  const double area = std::numbers::pi / 4 * (21e-3 * 21e-3 - 6e-3 * 6e-3);
  const double nut_area = std::numbers::pi / 4 * (46e-3 * 46e-3 - 35e-3 * 35e-3);
  double displacement = 2e3 / 209e9 * (10e-3 / area + (c.position - 10e-3) / nut_area);
  for (const Interface i : kInterfaces) {
    const double cosine = std::cos(c.laws[i].normal_angle);
    EXPECT_NEAR(r.normal_load[i][0] / (2e3 / 11 / cosine), 1.0, 1e-12);
    displacement += std::pow(2e3 / 11 / cosine / c.laws[i].hertz_constant, 2.0 / 3.0) / cosine;
  }
  EXPECT_NEAR(r.axial_displacement / displacement, 1.0, 1e-10);
}

TEST(ChainSolver, RepeatedSolvesAllocateNothing) {
  ChainSolver chain(test::abevi().build());
  LoadDistribution result;
  chain.solve(45e3, result);
  const std::size_t before = test::allocations();
  chain.solve(44e3, result);
  EXPECT_EQ(test::allocations(), before);
}

TEST(ChainSolver, SaysWhyItStopped) {
  ChainSolver chain(test::abevi().build());
  chain.options.max_iterations = 1;
  const LoadDistribution limit = chain.solve(45e3);
  EXPECT_EQ(limit.solve.status, fe::NewtonStatus::iteration_limit);
  EXPECT_EQ(limit.solve.iterations(), 1);
  EXPECT_GT(limit.solve.relative_residual, 1e-12);
  chain.options.max_iterations = 100;
  EXPECT_FALSE(chain.solve(std::numeric_limits<double>::quiet_NaN()).solve.converged());
}

}  // namespace
}  // namespace prs
