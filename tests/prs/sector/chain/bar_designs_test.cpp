#include "prs/sector/chain/design_solvers.h"

#include <gtest/gtest.h>

#include <limits>

#include "prs/sector/chain/chain_solver.h"
#include "prs/sector/chain/solves.h"
#include "support/count.h"

namespace prs {
namespace {

using test::SectorCase;

struct Designs {
  std::vector<SectorModel> sectors;
  std::vector<double> forces;
  std::vector<std::string> names;

  void add(const SectorCase& c, double force, const std::string& name) {
    sectors.push_back(c.model());
    forces.push_back(force);
    names.push_back(name);
  }
  std::vector<LoadDistribution> solve(InstructionSet set) const {
    std::vector<LoadDistribution> results(forces.size());
    BarDesignSolver(set).solve(sectors, forces, results);
    return results;
  }
};

TEST(BarDesigns, AgreeWithSparseSolverOnSpecialCases) {
  Designs designs;
  std::vector<LoadDistribution> expected;
  for (const test::NamedCase& c : test::special_cases()) {
    for (const double force : {1e-3, 50.0, 45e3, 1e7}) {
      designs.add(c.sector, force, c.name + ' ' + std::to_string(force));
      expected.push_back(test::sparse(c.sector.build(), force));
    }
  }
  for (const InstructionSet set : test::instruction_sets()) {
    const std::vector<LoadDistribution> results = designs.solve(set);
    for (std::size_t k = 0; k < results.size(); ++k)
      test::expect_same(expected[k], results[k], std::string(name(set)) + ' ' + designs.names[k]);
  }
}

TEST(BarDesigns, AgreeWithSparseSolverOnRandomSectors) {
  std::mt19937_64 random(23);
  Designs designs;
  std::vector<LoadDistribution> expected;
  for (int k = 0; k < test::samples(200, 5000); ++k) {
    const SectorCase c = test::random_sector(random);
    designs.add(c, test::random_force(c, random), std::to_string(k));
    expected.push_back(test::sparse(c.build(), designs.forces.back()));
  }
  for (const InstructionSet set : test::instruction_sets()) {
    const std::vector<LoadDistribution> results = designs.solve(set);
    for (std::size_t k = 0; k < results.size(); ++k)
      test::expect_same(expected[k], results[k], std::string(name(set)) + ' ' + designs.names[k]);
  }
}

/// Sectors of one thread count, easy and hard ones, in batches with different neighbours.
TEST(BarDesigns, ResultsDoNotDependOnTheDesignsBeside) {
  std::mt19937_64 random(29);
  Designs designs;
  for (int k = 0; k < 40; ++k) {
    SectorCase c = test::random_sector(random);
    c.mechanism.contacts_per_roller = 4;
    if (k % 3 == 0) c.mechanism.pitch.roller = axial_pitch(c.mechanism) + 3e-6;
    designs.add(c, test::random_force(c, random), "");
  }
  Designs turned;
  for (std::size_t k = 0; k < designs.sectors.size(); ++k) {
    const std::size_t from = (k * 7 + 3) % designs.sectors.size();
    turned.sectors.push_back(designs.sectors[from]);
    turned.forces.push_back(designs.forces[from]);
  }
  for (const InstructionSet set : test::instruction_sets()) {
    const auto together = designs.solve(set), elsewhere = turned.solve(set);
    BarDesignSolver alone(set);
    for (std::size_t k = 0; k < together.size(); ++k) {
      const std::size_t from = (k * 7 + 3) % together.size();
      test::expect_identical(together[from], elsewhere[k]);
      LoadDistribution single;
      alone.solve({&designs.sectors[k], 1}, {&designs.forces[k], 1}, {&single, 1});
      test::expect_identical(together[k], single);
    }
  }
}

TEST(BarDesigns, OneThatFailsLeavesTheOthersAlone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Designs designs;
  for (int k = 0; k < 8; ++k) designs.add(test::abevi(), 5e3 * (k + 1), "");
  for (const InstructionSet set : test::instruction_sets()) {
    const std::vector<LoadDistribution> expected = designs.solve(set);
    Designs bad = designs;
    bad.sectors[1].screw_rigidity = nan;
    bad.sectors[2].hertz_constant.nut = nan;
    bad.sectors[3].position = nan;
    bad.sectors[4].gaps.screw.assign(20, nan);
    bad.forces[6] = nan;
    const std::vector<LoadDistribution> results = bad.solve(set);
    for (const std::size_t k : {1u, 2u, 3u, 4u, 6u})
      EXPECT_FALSE(results[k].solve.converged()) << name(set) << ' ' << k;
    for (const std::size_t k : {0u, 5u, 7u}) test::expect_identical(expected[k], results[k]);
  }
}

TEST(BarDesigns, IterationLimitIsAStatusOfEachDesign) {
  Designs designs;
  designs.add(test::abevi(), 45e3, "");
  SectorCase rigid = test::abevi();  // in equilibrium from the start
  for (const Part p : kParts) rigid.materials[p].youngs_modulus = 209e22;
  rigid.options.roller = ModelOptions::Roller::rigid_bending;
  designs.add(rigid, 45e3, "");
  BarDesignSolver solver;
  solver.options.max_iterations = 2;
  std::vector<LoadDistribution> results(2);
  solver.solve(designs.sectors, designs.forces, results);
  EXPECT_EQ(results[0].solve.status, fe::NewtonStatus::iteration_limit);
  EXPECT_EQ(results[0].solve.iterations(), 2);
  EXPECT_TRUE(results[1].solve.converged());
}

TEST(BarDesigns, RepeatedSolvesAllocateNothing) {
  Designs designs;
  for (int k = 0; k < 20; ++k) designs.add(test::abevi(), 2e3 * (k + 1), "");
  test::expect_repeated_solves_allocate_nothing<BarDesignSolver>(designs);
}

}  // namespace
}  // namespace prs
