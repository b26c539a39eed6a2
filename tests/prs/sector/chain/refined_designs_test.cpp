#include "prs/sector/chain/design_solvers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "prs/sector/chain/chain_solver.h"
#include "prs/sector/chain/solves.h"
#include "support/count.h"

namespace prs {
namespace {

using test::SectorCase;

/// Model as in studies: before `work_out`.
SectorModel numbers_of(const SectorCase& c) {
  SectorModel s;
  set_sector_model(s, c.mechanism, c.structure, c.materials, c.options, c.laws, c.direction, c.position, c.deviations);
  return s;
}

struct Refined {
  std::vector<SectorModel> sectors;
  std::vector<double> forces;
  std::vector<SectorCase> cases;

  /// Adds a case unless it has no place among the columns.
  void add(SectorCase c, double force) {
    c.options.bodies = &kRefined;
    SectorModel s = numbers_of(c);
    if (!RefinedDesignSolver::takes(s)) return;
    sectors.push_back(std::move(s));
    forces.push_back(force);
    cases.push_back(std::move(c));
  }
  std::vector<LoadDistribution> solve(InstructionSet set) const {
    std::vector<LoadDistribution> results(forces.size());
    RefinedDesignSolver(set).solve(sectors, forces, results);
    return results;
  }
};

/// Random designs of 4 to 20 threads, some of them with nuts of one shape.
Refined random_designs(int count) {
  std::mt19937_64 random(31);
  Refined designs;
  for (int k = 0; k < count; ++k) {
    SectorCase c = test::random_sector(random);
    if (k % 3 > 0) c = test::refined(c, random);
    if (k % 2 > 0) c.mechanism.contacts_per_roller = 4 + k % 5;
    designs.add(c, test::random_force(c, random));
    for (int i = 0; i < k % 3; ++i) {
      c.structure.nut.outer_diameter *= 1.01;
      c.materials.nut.youngs_modulus *= 0.99;
      designs.add(c, test::random_force(c, random));
    }
  }
  return designs;
}

double largest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

/// Largest difference of loads, relative to the largest load, of displacement and of tangent stiffness.
double difference(const LoadDistribution& a, const LoadDistribution& b) {
  double worst = std::max(std::abs(a.axial_displacement / b.axial_displacement - 1.0),
                          std::abs(*a.tangent_stiffness / *b.tangent_stiffness - 1.0));
  for (const Interface i : kInterfaces)
    for (std::size_t k = 0; k < a.normal_load[i].size(); ++k)
      worst = std::max({worst, std::abs(a.normal_load[i][k] - b.normal_load[i][k]) / largest(b.normal_load[i]),
                        std::abs(a.approach[i][k] - b.approach[i][k]) / largest(b.approach[i])});
  return worst;
}

/// Result of a solve: by the chain, or by the sparse solver if rounding stops the chain. Columns that rounding stops
/// are left to that solver too. On slender rollers Newton's tolerance can leave 1e-10 in a thread's load; elsewhere
/// 1e-11 is required.
TEST(RefinedDesigns, AgreeWithSolvesOneAfterTheOther) {
  const Refined designs = random_designs(test::count(300, 20'000));
  ASSERT_GT(designs.forces.size(), 100u);
  std::vector<LoadDistribution> expected;
  for (std::size_t k = 0; k < designs.forces.size(); ++k)
    expected.push_back(FallbackSolver(designs.cases[k].model()).solve(designs.forces[k]));
  double worst = 0.0;
  std::size_t stopped = 0, beyond = 0;
  for (const InstructionSet set : test::instruction_sets()) {
    const std::vector<LoadDistribution> results = designs.solve(set);
    for (std::size_t k = 0; k < results.size(); ++k) {
      if (!FallbackSolver::complete(results[k])) {
        ++stopped;
        continue;
      }
      ASSERT_TRUE(FallbackSolver::complete(expected[k])) << name(set) << ' ' << k;
      const double now = difference(results[k], expected[k]);
      EXPECT_LE(now, 1e-9) << name(set) << ' ' << k;
      worst = std::max(worst, now);
      if (now > 1e-11) ++beyond;
    }
  }
  std::printf("%zu designs, %zu times stopped by rounding, %zu beyond 1e-11, at most %.1e\n", designs.forces.size(),
              stopped, beyond, worst);
  EXPECT_LE(stopped, designs.forces.size() / 1000);
  EXPECT_LE(beyond, designs.forces.size() / 1000);
}

TEST(RefinedDesigns, AgreeWithSparseSolverOnSpecialCases) {
  Refined designs;
  for (const test::NamedCase& c : test::special_cases())
    if (c.sector.structure.nut.thrust.tension != c.sector.structure.nut.thrust.compression)
      for (const double force : {1e-3, 45e3}) designs.add(c.sector, force);
  ASSERT_GT(designs.forces.size(), 10u);
  std::vector<LoadDistribution> expected;
  for (std::size_t k = 0; k < designs.forces.size(); ++k)
    expected.push_back(test::sparse(designs.cases[k].build(), designs.forces[k]));
  for (const InstructionSet set : test::instruction_sets()) {
    const std::vector<LoadDistribution> results = designs.solve(set);
    for (std::size_t k = 0; k < results.size(); ++k)
      test::expect_same(expected[k], results[k], std::string(name(set)) + ' ' + std::to_string(k));
  }
}

TEST(RefinedDesigns, ResultsDoNotDependOnTheDesignsBeside) {
  const Refined designs = random_designs(30);
  const std::size_t count = designs.sectors.size();
  const auto from = [&](std::size_t k) { return count - 1 - k; };
  Refined turned;
  for (std::size_t k = 0; k < count; ++k) {
    turned.sectors.push_back(designs.sectors[from(k)]);
    turned.forces.push_back(designs.forces[from(k)]);
  }
  for (const InstructionSet set : test::instruction_sets()) {
    const auto together = designs.solve(set), elsewhere = turned.solve(set);
    for (std::size_t k = 0; k < count; ++k) {
      test::expect_identical(together[from(k)], elsewhere[k]);
      LoadDistribution single;
      RefinedDesignSolver(set).solve({&designs.sectors[k], 1}, {&designs.forces[k], 1}, {&single, 1});
      test::expect_identical(together[k], single);
    }
  }
}

TEST(RefinedDesigns, OneThatFailsLeavesTheOthersAlone) {
  Refined designs;
  for (int k = 0; k < 8; ++k) designs.add(test::abevi(), 5e3 * (k + 1));
  for (const InstructionSet set : test::instruction_sets()) {
    const std::vector<LoadDistribution> expected = designs.solve(set);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Refined bad = designs;
    bad.sectors[1].screw_rigidity = nan;
    bad.sectors[2].hertz_constant.nut = nan;
    bad.sectors[3].bodies.numbers.material.nut.youngs_modulus = nan;
    bad.forces[6] = nan;
    const std::vector<LoadDistribution> results = bad.solve(set);
    for (const std::size_t k : {1u, 2u, 3u, 6u}) EXPECT_FALSE(results[k].solve.converged()) << name(set) << ' ' << k;
    for (const std::size_t k : {0u, 4u, 5u, 7u}) test::expect_identical(expected[k], results[k]);
  }
}

TEST(RefinedDesigns, RepeatedSolvesAllocateNothing) {
  Refined designs;
  for (int k = 0; k < 20; ++k) designs.add(test::abevi(), 2e3 * (k + 1));
  test::expect_repeated_solves_allocate_nothing<RefinedDesignSolver>(designs);
}

}  // namespace
}  // namespace prs
