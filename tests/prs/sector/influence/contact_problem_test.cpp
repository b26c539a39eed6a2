#include "prs/sector/influence/influence_solver.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <numeric>

#include "prs/sector/sector.h"
#include "support/sectors.h"

namespace prs {
namespace {

using fe::Dof;
using test::abevi;
using test::SectorCase;

/// Flexibility of the bar model at its contacts, and its rigid motions: the loaded section of the screw and one section
/// of the roller are held axially, all else follows from the model.
Eigen::MatrixXd bar_flexibility(const Sector& sector) {
  fe::Model model = sector.model;
  model.fixed_supports.push_back({sector.loaded_node, Dof::u});
  model.fixed_supports.push_back({sector.roller_nodes.front(), Dof::u});
  const fe::Equations equations(model);
  const fe::SparseSymmetric& k = equations.linear_stiffness();
  const int n = equations.size();
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n, n);
  for (int j = 0; j < n; ++j)
    for (int e = k.column_start[static_cast<std::size_t>(j)]; e < k.column_start[static_cast<std::size_t>(j + 1)];
         ++e) {
      const int i = k.row[static_cast<std::size_t>(e)];
      dense(i, j) = dense(j, i) = k.value[static_cast<std::size_t>(e)];
    }
  // Approach of each contact as a linear form of the displacements.
  Eigen::MatrixXd form = Eigen::MatrixXd::Zero(n, 2 * sector.contacts());
  for (int i = 0; i < n; ++i) {
    fe::State unit(Eigen::VectorXd::Unit(n, i));
    for (int c = 0; c < form.cols(); ++c) form(i, c) = equations.springs()[static_cast<std::size_t>(c)].approach(unit);
  }
  return form.transpose() * dense.llt().solve(form);
}

ContactSolution solve_bars(const SectorCase& c, double force) {
  const Sector sector = c.build();
  return solve(contact_problem(bar_flexibility(sector), c.laws, sector.gaps), force / sector.rollers);
}

double largest_difference(const ContactSolution& s, const LoadDistribution& bars) {
  const auto n = bars.normal_load.screw.size();
  double largest = 0.0;
  for (std::size_t i = 0; i < 2 * n; ++i) {
    const double expected = i < n ? bars.normal_load.screw[i] : bars.normal_load.nut[i - n];
    largest = std::max(largest, std::abs(s.normal_load[static_cast<Eigen::Index>(i)] - expected));
  }
  return largest;
}

TEST(ContactProblem, BarFlexibilityReproducesTheBarModel) {
  for (const double position : {54.3333333e-3, 29.1666667e-3, 4e-3})
    for (const Direction direction : {Direction::tension, Direction::compression}) {
      SectorCase c = abevi();
      c.position = position;
      c.direction = direction;
      for (const double force : {100.0, 45e3}) {
        const LoadDistribution bars = SectorSolver(c.build()).solve(force);
        const ContactSolution s = solve_bars(c, force);
        ASSERT_TRUE(s.converged()) << s.relative_residual;
        EXPECT_LE(s.iterations(), 8);
        EXPECT_LT(largest_difference(s, bars), 1e-10 * force / 11.0);
        EXPECT_NEAR(s.screw_motion / bars.axial_displacement, 1.0, 1e-10);
        EXPECT_NEAR(11.0 * s.tangent_stiffness / *bars.tangent_stiffness, 1.0, 1e-9);
      }
    }
}

TEST(ContactProblem, BarFlexibilityReproducesTheBarModelWithOpenContacts) {
  SectorCase c = abevi();
  c.mechanism.pitch.roller = axial_pitch(c.mechanism) + 2e-6;
  int open = 0;
  for (const double force : {500.0, 5e3, 45e3}) {
    const LoadDistribution bars = SectorSolver(c.build()).solve(force);
    const ContactSolution s = solve_bars(c, force);
    ASSERT_TRUE(s.converged()) << s.relative_residual;
    EXPECT_LT(largest_difference(s, bars), 1e-10 * force / 11.0);
    open += static_cast<int>((s.normal_load.array() == 0.0).count());
  }
  EXPECT_GT(open, 0);
}

TEST(ContactProblem, RigidBodiesShareEqually) {
  const SectorCase c = abevi();
  const Sector sector = c.build();
  const int n = 2 * sector.contacts();
  const ContactSolution s = solve(contact_problem(Eigen::MatrixXd::Zero(n, n), c.laws, sector.gaps), 4e3);
  ASSERT_TRUE(s.converged());
  EXPECT_EQ(s.iterations(), 0);
  const double cosine = std::cos(c.laws.screw.normal_angle);
  EXPECT_NEAR(s.normal_load[3], 4e3 / 20.0 / cosine, 1e-9);
}

}  // namespace
}  // namespace prs
