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

NewtonSummary push(const Model& model, double force, double start, double& u, NewtonOptions options = {}) {
  const Equations equations(model);
  NewtonSolver solver(equations);
  State q(Eigen::VectorXd::Constant(equations.size(), start));
  options.force_scale = std::abs(force);
  const NewtonSummary summary = solver.solve(equations.load_vector({{0, Dof::u, force}}), options, q);
  u = equations.displacement(q, 0, Dof::u);
  return summary;
}

TEST(Newton, FindsClosedFormOfOneHertzSpring) {
  const Model m = pushed_node({{2e10, 3e-6, 0.0}});
  for (const double force : {1e-3, 1.0, 1e3, 1e6}) {
    double u = 0.0;
    const NewtonSummary summary = push(m, force, 4e-6, u);
    ASSERT_TRUE(summary.converged()) << force;
    EXPECT_NEAR(u, 3e-6 + std::pow(force / 2e10, 2.0 / 3.0), 1e-11 * u);
    EXPECT_LE(summary.relative_residual, 1e-12);
  }
}

TEST(Newton, StartsWhereTheTangentIsSingular) {
  const Model m = pushed_node({{2e10, 0.0, 0.0}, {5e9, 1e-5, 0.0}});
  double u = 0.0;
  const NewtonSummary summary = push(m, 500.0, 0.0, u);
  ASSERT_TRUE(summary.converged()) << name(summary.status);
  EXPECT_GT(summary.history.front().shift, 0.0);
  EXPECT_EQ(summary.history.back().shift, 0.0);
  EXPECT_NEAR(u, std::pow(500.0 / 2e10, 2.0 / 3.0), 1e-10 * u);
}

TEST(Newton, EnergyNeverRises) {
  const Model m = pushed_node({{2e10, 0.0, 0.0}, {9e12, 2e-6, 0.0}});
  double u = 0.0;
  const NewtonSummary summary = push(m, 4e3, 1e-9, u);
  ASSERT_TRUE(summary.converged());
  for (std::size_t i = 1; i < summary.history.size(); ++i)
    EXPECT_LE(summary.history[i].energy, summary.history[i - 1].energy + 1e-13 * std::abs(summary.energy));
}

TEST(Newton, TailIsQuadratic) {
  const Model m = pushed_node({{2e10, 0.0, 0.0}, {1e10, 2e-6, 0.0}});
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

/// Plain Newton's method leaves a third of the approach in each step.
TEST(Newton, OpensWhatNothingLoadsInFewSteps) {
  Model m = pushed_node({{2e10, 0.0, 0.0}});
  const int idle = m.add_node(), ground = m.add_node();
  m.fixed_supports.push_back({ground, Dof::u});
  m.springs.push_back({{idle}, {ground}, 1.0, 0.0, {2e10, 0.0, 0.0}});
  NewtonOptions options;
  options.least_tangent = 1.0;
  double u = 0.0;
  const NewtonSummary summary = push(m, 1e3, 1e-4, u, options);
  ASSERT_TRUE(summary.converged());
  EXPECT_NEAR(u, std::pow(1e3 / 2e10, 2.0 / 3.0), 1e-11 * u);
  EXPECT_LE(summary.iterations(), 8);
}

TEST(Newton, ReportsIterationLimit) {
  NewtonOptions options;
  options.max_iterations = 1;
  double u = 0.0;
  const NewtonSummary summary = push(pushed_node({{2e10, 0.0, 0.0}}), 1e3, 1e-3, u, options);
  EXPECT_EQ(summary.status, NewtonStatus::iteration_limit);
  EXPECT_EQ(summary.iterations(), 1);
  EXPECT_GT(summary.relative_residual, 1e-12);
}

TEST(Newton, NothingHoldsAPulledContact) {
  double u = 0.0;
  const NewtonSummary summary = push(pushed_node({{2e10, 0.0, 0.0}}), -1e3, 1e-6, u);
  EXPECT_FALSE(summary.converged());
  EXPECT_GE(summary.relative_residual, 0.5);
}

/// A stiff beam on two soft springs, pushed in its middle through a contact: the beam's assembled
/// stiffness rounds to more than the springs have.
struct SoftlyHeldBeam {
  static constexpr double kSupport = 1e-3, kHertz = 1e10;
  Model model;

  SoftlyHeldBeam() {
    const Beam half{1e10, 1e6, 0.0, 0.01};
    int last = model.add_node();
    model.fixed_supports.push_back({last, Dof::u});
    model.elastic_supports.push_back({last, Dof::v, kSupport});
    for (int k = 0; k < 20; ++k) {
      const int next = model.add_node();
      model.beams.push_back({last, next, half});
      last = next;
    }
    model.elastic_supports.push_back({last, Dof::v, kSupport});
    const int pusher = model.add_node();
    model.elastic_supports.push_back({pusher, Dof::v, kSupport});
    model.springs.push_back({{pusher}, {10}, 0.0, 1.0, {kHertz, 0.0, 0.0}});
  }
  int pusher() const { return model.nodes - 1; }
};

TEST(Newton, SoftestStiffnessKeepsItsDigits) {
  const SoftlyHeldBeam beam;
  const Equations equations(beam.model);
  NewtonSolver solver(equations);
  const Eigen::VectorXd load = equations.load_vector({{beam.pusher(), Dof::v, 1.0}});
  State q(Eigen::VectorXd::Zero(equations.size()));
  for (int i = 0; i < equations.size(); ++i)
    if (equations.kind(i) == Dof::v) q.head[i] = 100.0;
  q.head[equations.number(beam.pusher(), Dof::v)] += 1e-6;
  const NewtonSummary summary = solver.solve(load, {}, q);
  ASSERT_TRUE(summary.converged()) << name(summary.status);
  const double u = equations.displacement(q, beam.pusher(), Dof::v);
  EXPECT_NEAR(u * 3.0 * beam.kSupport, 1.0, 1e-9);
  // The contact carries what the beam's springs take, though its approach is 1e-10 of u.
  EXPECT_NEAR(equations.response(q, 0).force * 1.5, 1.0, 1e-9);
  Eigen::VectorXd rate(equations.size());
  ASSERT_TRUE(solver.solve_tangent(q, load, rate));
  EXPECT_NEAR(load.dot(rate) * 3.0 * beam.kSupport, 1.0, 1e-9);
}

/// Seat, ring and roller: each follows the previous one, and only the last is pushed by a contact.
TEST(Newton, FollowsWhatFollows) {
  constexpr double kBar = 1e7, kHertz = 1e10, kForce = 100.0, kAhead = -1e-6;
  Model m;
  const int ground = m.add_node(), seat = m.add_node(), ring = m.add_node(), roller = m.add_node(),
            pusher = m.add_node();
  m.fixed_supports.push_back({ground, Dof::u});
  m.bars.push_back({ground, seat, {kBar, 1.0}});
  m.constraints.push_back({ring, Dof::u, {{seat, Dof::u, 2.0}}, kAhead});
  m.constraints.push_back({roller, Dof::u, {{ring, Dof::u, 1.5}}, 0.0});
  m.springs.push_back({{pusher}, {roller}, 1.0, 0.0, {kHertz, 0.0, 0.0}});

  const Equations equations(m);
  ASSERT_EQ(equations.size(), 2);  // Seat and pusher.
  NewtonSolver solver(equations);
  NewtonOptions options;
  options.force_scale = kForce;
  State q(Eigen::VectorXd::Zero(equations.size()));
  ASSERT_TRUE(solver.solve(equations.load_vector({{pusher, Dof::u, kForce}}), options, q).converged());
  // The roller moves three times as far as the seat, which a lever of three loads in turn.
  const double seat_moves = 3.0 * kForce / kBar;
  const double roller_moves = 3.0 * seat_moves + 1.5 * kAhead;
  EXPECT_NEAR(equations.displacement(q, seat, Dof::u) / seat_moves, 1.0, 1e-10);
  EXPECT_NEAR(equations.displacement(q, ring, Dof::u) / (2.0 * seat_moves + kAhead), 1.0, 1e-10);
  EXPECT_NEAR(equations.displacement(q, roller, Dof::u) / roller_moves, 1.0, 1e-10);
  const double approach = std::pow(kForce / kHertz, 2.0 / 3.0);
  EXPECT_NEAR(equations.displacement(q, pusher, Dof::u) / (roller_moves + approach), 1.0, 1e-10);
}

/// Along a long thread contacts open one after the other.
TEST(Newton, LongThreadsMayTakeMoreIterations) {
  const NewtonOptions options;
  EXPECT_EQ(options.iteration_limit(40), options.max_iterations);
  EXPECT_EQ(options.iteration_limit(20000), options.max_iterations + 990);
}

TEST(Newton, SummaryIsBornFailed) { EXPECT_FALSE(NewtonSummary{}.converged()); }

}  // namespace
}  // namespace fe
