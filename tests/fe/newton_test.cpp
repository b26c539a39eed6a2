#include "fe/newton.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fe {
namespace {

/// A node pushed against the ground through `laws` in parallel.
Model pushed_node(const std::vector<PowerLawSpring>& laws) {
  Model m;
  const int node = m.add_node(), ground = m.add_node(), other = m.add_node();
  m.bars.push_back({node, other, {1.0, 1.0}});
  m.fixed_supports.push_back({ground, Dof::u});
  for (const PowerLawSpring& law : laws) m.springs.push_back({{node}, {ground}, 1.0, 0.0, law});
  return m;
}

NewtonSummary push(const Model& model, double force, double start, double& u,
                   NewtonOptions options = {}) {
  const Equations equations(model);
  NewtonSolver solver(equations);
  State q(Eigen::VectorXd::Constant(equations.size(), start));
  options.force_scale = std::abs(force);
  const NewtonSummary summary =
      solver.solve(equations.load_vector({{0, Dof::u, force}}), options, q);
  u = equations.displacement(q, 0, Dof::u);
  return summary;
}

TEST(Newton, FindsClosedFormOfOneHertzSpring) {
  const Model m = pushed_node({{2e10, 1.5, 3e-6, 0.0}});
  for (const double force : {1e-3, 1.0, 1e3, 1e6}) {
    double u = 0.0;
    const NewtonSummary summary = push(m, force, 4e-6, u);
    ASSERT_TRUE(summary.converged()) << force;
    EXPECT_NEAR(u, 3e-6 + std::pow(force / 2e10, 2.0 / 3.0), 1e-11 * u);
    EXPECT_LE(summary.relative_residual, 1e-12);
  }
}

TEST(Newton, StartsWhereTheTangentIsSingular) {
  const Model m = pushed_node({{2e10, 1.5, 0.0, 0.0}, {5e9, 1.5, 1e-5, 0.0}});
  double u = 0.0;
  const NewtonSummary summary = push(m, 500.0, 0.0, u);
  ASSERT_TRUE(summary.converged()) << name(summary.status);
  EXPECT_GT(summary.history.front().shift, 0.0);
  EXPECT_EQ(summary.history.back().shift, 0.0);
  EXPECT_NEAR(u, std::pow(500.0 / 2e10, 2.0 / 3.0), 1e-10 * u);
}

TEST(Newton, EnergyNeverRises) {
  const Model m = pushed_node({{2e10, 1.5, 0.0, 0.0}, {9e12, 1.5, 2e-6, 0.0}});
  double u = 0.0;
  const NewtonSummary summary = push(m, 4e3, 1e-9, u);
  ASSERT_TRUE(summary.converged());
  for (std::size_t i = 1; i < summary.history.size(); ++i)
    EXPECT_LE(summary.history[i].energy,
              summary.history[i - 1].energy + 1e-13 * std::abs(summary.energy));
}

TEST(Newton, TailIsQuadratic) {
  const Model m = pushed_node({{2e10, 1.5, 0.0, 0.0}, {1e10, 1.5, 2e-6, 0.0}});
  NewtonOptions options;
  options.reuse_factorization_below = 0.0;
  double u = 0.0;
  const NewtonSummary summary = push(m, 4e3, 1e-4, u, options);
  ASSERT_TRUE(summary.converged());
  int checked = 0;
  for (std::size_t i = 1; i < summary.history.size(); ++i) {
    const double before = summary.history[i - 1].relative_residual;
    const double after = summary.history[i].relative_residual;
    if (before > 1e-2 || before < 1e-7) continue;
    EXPECT_LT(after, before * before + 1e-13);
    ++checked;
  }
  EXPECT_GE(checked, 1);
}

TEST(Newton, ReportsIterationLimit) {
  NewtonOptions options;
  options.max_iterations = 1;
  double u = 0.0;
  const NewtonSummary summary = push(pushed_node({{2e10, 1.5, 0.0, 0.0}}), 1e3, 1e-3, u, options);
  EXPECT_EQ(summary.status, NewtonStatus::iteration_limit);
  EXPECT_EQ(summary.iterations(), 1);
  EXPECT_GT(summary.relative_residual, 1e-12);
}

TEST(Newton, NothingHoldsAPulledContact) {
  double u = 0.0;
  const NewtonSummary summary = push(pushed_node({{2e10, 1.5, 0.0, 0.0}}), -1e3, 1e-6, u);
  EXPECT_FALSE(summary.converged());
  EXPECT_GE(summary.relative_residual, 0.5);
}

TEST(Newton, SummaryIsBornFailed) { EXPECT_FALSE(NewtonSummary{}.converged()); }

}  // namespace
}  // namespace fe
