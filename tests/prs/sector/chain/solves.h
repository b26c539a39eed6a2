#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "prs/sector/chain/design_solvers.h"
#include "prs/sector/sector.h"
#include "support/allocations.h"
#include "support/sectors.h"

namespace test {

/// Every way to run a chain kernel that this processor has.
inline std::vector<prs::InstructionSet> instruction_sets() {
  using enum prs::InstructionSet;
  std::vector<prs::InstructionSet> sets;
  for (const prs::InstructionSet set : {scalar, baseline, avx2, avx512})
    if (prs::available(set)) sets.push_back(set);
  return sets;
}

/// Solves like SectorSolver::solve, then continues towards the rounding of its state.
inline prs::LoadDistribution sparse(const prs::Sector& sector, double force) {
  prs::SectorSolver solver(sector);
  const fe::Equations& equations = solver.equations();
  prs::LoadDistribution r = solver.solve(force);
  const Eigen::VectorXd load = force / sector.rollers * solver.unit_load();
  fe::NewtonOptions options = solver.newton_options(force);
  fe::NewtonSolver newton(equations);
  fe::State q = solver.equal_shares(force);
  newton.solve(load, options, q);
  options.residual_tolerance = 1e-15;
  options.max_iterations = 3;
  fe::State further = q;
  const fe::NewtonSummary tight = newton.solve(load, options, further);
  if (tight.relative_residual < r.solve.relative_residual) q = further;
  for (const prs::Interface i : prs::kInterfaces)
    for (int k = 0; k < sector.contacts(); ++k) {
      const auto place = static_cast<std::size_t>(k);
      const fe::PowerLawSpring& law = sector.model.springs[static_cast<std::size_t>(sector.spring(i, k))].law;
      const auto spring = static_cast<std::size_t>(sector.spring(i, k));
      const double w = equations.springs()[spring].approach(q);
      r.normal_load[i][place] = fe::evaluate(law, w).force;
      r.approach[i][place] = fe::law_approach(law, w);
    }
  r.axial_displacement = solver.unit_load().dot(q.head) + sector.offset_compliance * force / sector.rollers;
  return r;
}

/// Thread loads to 1e-10 of the largest, displacement to 1e-10, tangent stiffness to `tangent`: it
/// is that of one solve without refinement.
inline void expect_same(const prs::LoadDistribution& expected, const prs::LoadDistribution& r, const std::string& what,
                        double tangent = 1e-8) {
  ASSERT_TRUE(expected.solve.converged()) << what;
  ASSERT_TRUE(r.solve.converged()) << what << ' ' << fe::name(r.solve.status) << ' ' << r.solve.relative_residual;
  for (const prs::Interface i : prs::kInterfaces) {
    const std::vector<double>&a = expected.normal_load[i], &b = r.normal_load[i];
    ASSERT_EQ(a.size(), b.size()) << what;
    const double largest = *std::max_element(a.begin(), a.end());
    const double deepest = *std::max_element(expected.approach[i].begin(), expected.approach[i].end());
    for (std::size_t k = 0; k < a.size(); ++k) {
      EXPECT_NEAR(a[k], b[k], 1e-10 * largest) << what << " thread " << k;
      EXPECT_NEAR(expected.approach[i][k], r.approach[i][k], 1e-10 * deepest) << what << " thread " << k;
    }
  }
  EXPECT_NEAR(r.axial_displacement / expected.axial_displacement, 1.0, 1e-10) << what;
  EXPECT_NEAR(r.solve.energy / expected.solve.energy, 1.0, 1e-10) << what;
  ASSERT_TRUE(r.tangent_stiffness.has_value()) << what;
  EXPECT_NEAR(*r.tangent_stiffness / *expected.tangent_stiffness, 1.0, tangent) << what;
}

/// Checks equality bit by bit.
inline void expect_identical(const prs::LoadDistribution& a, const prs::LoadDistribution& b) {
  EXPECT_EQ(a.solve.status, b.solve.status);
  EXPECT_EQ(a.solve.iterations(), b.solve.iterations());
  EXPECT_EQ(a.solve.relative_residual, b.solve.relative_residual);
  EXPECT_EQ(a.solve.energy, b.solve.energy);
  EXPECT_EQ(a.axial_displacement, b.axial_displacement);
  EXPECT_EQ(a.tangent_stiffness, b.tangent_stiffness);
  for (const prs::Interface i : prs::kInterfaces) {
    EXPECT_EQ(a.normal_load[i], b.normal_load[i]);
    EXPECT_EQ(a.approach[i], b.approach[i]);
  }
}

struct NamedCase {
  std::string name;
  SectorCase sector;
};

/// Special positions on Abevi's screw, and every option of the model.
inline std::vector<NamedCase> special_cases() {
  using prs::Direction, prs::Guidance, prs::ModelOptions;
  std::vector<NamedCase> cases;
  const auto add = [&](const std::string& name, auto change) {
    for (const Direction direction : {Direction::tension, Direction::compression}) {
      NamedCase c{name + ' ' + std::string(prs::name(direction)), abevi()};
      c.sector.direction = direction;
      change(c.sector);
      cases.push_back(c);
    }
  };
  for (const double position : {54.3333333e-3, 29.1666667e-3, 4e-3})
    add("position " + std::to_string(position), [&](SectorCase& c) { c.position = position; });
  add("outer node", [](SectorCase& c) { c.structure.roller.guidance.kind = Guidance::Kind::outer_node; });
  for (const double ring : {1e4, 2e7, 1e15})
    add("ring", [&](SectorCase& c) { c.structure.roller.guidance = {Guidance::Kind::ring, ring}; });
  add("rigid bending", [](SectorCase& c) { c.options.roller = ModelOptions::Roller::rigid_bending; });
  add("shear", [](SectorCase& c) { c.options.roller_shear = true; });
  add("no free length", [](SectorCase& c) { c.structure.screw.free_length = 0.0; });
  add("thrust at the first contact", [](SectorCase& c) { c.position = 10e-3; });
  add("thrust at the last contact", [](SectorCase& c) { c.position = 80e-3 - 19 * axial_pitch(c.mechanism); });
  for (const double beside : {-1e-6, 1e-9, 3e-4})
    add("thrust beside a contact", [&](SectorCase& c) {
      c.structure.nut.thrust = {c.position + 7 * axial_pitch(c.mechanism) + beside,
                                c.position + 7 * axial_pitch(c.mechanism) + beside};
    });
  add("thrust at a contact", [](SectorCase& c) {
    c.structure.nut.thrust = {c.position + 7 * axial_pitch(c.mechanism), c.position + 12 * axial_pitch(c.mechanism)};
  });
  add("thrust at the nut's ends",
      [](SectorCase& c) { c.structure.nut.thrust = {.tension = 0.0, .compression = 90e-3}; });
  add("flanges over contacts", [](SectorCase& c) {
    c.structure.nut.flanges = {{0.0, 31e-3, 62e-3}, {31e-3, 33e-3, 50e-3}, {40e-3, 80e-3, 70e-3}};
  });
  add("collars with hardly a wall", [](SectorCase& c) {
    c.structure.nut.flanges = {{0.0, 10e-3, 62e-3}, {35e-3, 38e-3, 35.4e-3}, {80e-3, 90e-3, 62e-3}};
  });
  add("no flanges", [](SectorCase& c) { c.structure.nut.flanges.clear(); });
  for (const int contacts : {1, 2, 5, 40})
    add(std::to_string(contacts) + " threads", [&](SectorCase& c) {
      c.mechanism.contacts_per_roller = contacts;
      c.position = 15e-3;
    });
  add("pitch error", [](SectorCase& c) { c.mechanism.pitch.roller = axial_pitch(c.mechanism) + 1e-6; });
  add("crowning and relief", [](SectorCase& c) {
    c.deviations.crowning = 6e-6;
    c.deviations.end_relief = {4e-6, 3};
    c.deviations.pitch_error.nut.periodic = {2e-6, 7.0, 0.4};
  });
  add("tooth compliance", [](SectorCase& c) {
    c.laws.screw.compliance = 2e-9;
    c.laws.nut.compliance = 5e-10;
  });
  return cases;
}

/// The case with refined bodies, each effect on or off.
inline SectorCase refined(SectorCase c, std::mt19937_64& random) {
  using Contacts = prs::ModelOptions::RollerContacts;
  const auto mostly = [&] { return std::uniform_int_distribution(0, 3)(random) > 0; };
  c.options.bodies = &prs::kRefined;
  c.options.refined = {mostly(), mostly(), mostly(), mostly(), mostly(), mostly(), mostly()};
  c.options.roller_contacts = mostly() && mostly() ? Contacts::opposite : Contacts::half_pitch_apart;
  return c;
}

/// Checks a solver that has solved the same designs before.
template <class Solver, class Designs>
void expect_repeated_solves_allocate_nothing(const Designs& designs) {
  std::vector<prs::LoadDistribution> results(designs.forces.size());
  Solver solver;
  solver.solve(designs.sectors, designs.forces, results);
  const std::size_t before = allocations();
  solver.solve(designs.sectors, designs.forces, results);
  EXPECT_EQ(allocations(), before);
}

}  // namespace test
