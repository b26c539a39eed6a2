#include "fe/equations.h"

#include <gtest/gtest.h>

#include <random>

#include "support/allocations.h"
#include "support/tangent.h"

namespace fe {
namespace {

/// Bars, shear-flexible beams, elastic supports and gapped springs with arms in both directions.
Model mixed_model() {
  Model m;
  std::vector<int> bar, beam;
  for (int i = 0; i < 5; ++i) bar.push_back(m.add_node());
  for (int i = 0; i < 5; ++i) beam.push_back(m.add_node());
  for (std::size_t i = 1; i < 5; ++i) {
    m.bars.push_back({bar[i - 1], bar[i], {3e3, 1.5}});
    m.beams.push_back({beam[i - 1], beam[i], {2e3, 40.0, 5e3, 1.1}});
  }
  for (std::size_t i = 0; i < 5; ++i)
    m.springs.push_back(
        {{bar[i], 0.1, 0.4}, {beam[i], -0.2, -0.6}, 0.8, 0.6, {5e3, 0.05 * static_cast<double>(i) - 0.1, 1e-5}});
  m.fixed_supports.push_back({beam[0], Dof::v});
  m.fixed_supports.push_back({beam[4], Dof::u});
  m.elastic_supports.push_back({beam[4], Dof::v, 700.0});
  m.elastic_supports.push_back({beam[2], Dof::theta, 90.0});
  return m;
}

Eigen::VectorXd random_state(int n, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-0.3, 0.3);
  return Eigen::VectorXd::NullaryExpr(n, [&] { return uniform(random); });
}

Eigen::MatrixXd dense(const SparseSymmetric& a) {
  Eigen::MatrixXd d(a.size(), a.size());
  d.setZero();
  for (int j = 0; j < a.size(); ++j)
    for (int k = a.column_start[static_cast<std::size_t>(j)]; k < a.column_start[static_cast<std::size_t>(j) + 1];
         ++k) {
      const auto slot = static_cast<std::size_t>(k);
      d(a.row[slot], j) = d(j, a.row[slot]) = a.value[slot];
    }
  return d;
}

TEST(Equations, LeaveOutFixedAndUnstiffenedFreedoms) {
  const Equations equations(mixed_model());
  EXPECT_EQ(equations.size(), 5 + 15 - 2);
  EXPECT_EQ(equations.number(0, Dof::v), -1);
  EXPECT_EQ(equations.number(5, Dof::v), -1);
  EXPECT_GE(equations.number(5, Dof::theta), 0);
}

TEST(Equations, ResidualIsGradientOfEnergy) {
  const Equations equations(mixed_model());
  std::mt19937 random(7);
  Eigen::VectorXd r(equations.size()), unused(equations.size());
  for (int sample = 0; sample < 20; ++sample) {
    const Eigen::VectorXd q = random_state(equations.size(), random);
    const Eigen::VectorXd f = random_state(equations.size(), random) * 1e3;
    const Eigen::VectorXd d = random_state(equations.size(), random);
    equations.energy_and_residual(q, f, r);
    const double h = 1e-5;
    const double slope = (equations.energy_and_residual(State(q + h * d), f, unused) -
                          equations.energy_and_residual(State(q - h * d), f, unused)) /
                         (2.0 * h);
    EXPECT_NEAR(slope, r.dot(d), 1e-6 * r.norm() * d.norm());
  }
}

TEST(Equations, TangentIsGradientOfResidual) {
  const Equations equations(mixed_model());
  std::mt19937 random(8);
  SparseSymmetric tangent = equations.linear_stiffness();
  Eigen::VectorXd plus(equations.size()), minus(equations.size());
  const Eigen::VectorXd f = Eigen::VectorXd::Zero(equations.size());
  for (int sample = 0; sample < 20; ++sample) {
    const Eigen::VectorXd q = random_state(equations.size(), random);
    const Eigen::VectorXd d = random_state(equations.size(), random);
    test::set_tangent(equations, q, tangent);
    const double h = 1e-6;
    equations.energy_and_residual(State(q + h * d), f, plus);
    equations.energy_and_residual(State(q - h * d), f, minus);
    const Eigen::VectorXd product = dense(tangent) * d;
    EXPECT_LT(((plus - minus) / (2.0 * h) - product).norm(), 1e-6 * product.norm());
  }
}

TEST(Equations, ArmsTurnRotationIntoDisplacement) {
  Model m;
  const int a = m.add_node(), b = m.add_node();
  m.beams.push_back({a, b, {1.0, 1.0, 0.0, 1.0}});
  m.springs.push_back({{a, 0.3, 0.5}, {b, -0.2, 0.7}, 0.6, 0.8, {}});
  const Equations equations(m);
  const double u[2] = {0.11, -0.07}, v[2] = {0.05, 0.21}, t[2] = {0.3, -0.4};
  Eigen::VectorXd q(equations.size());
  for (int n = 0; n < 2; ++n) {
    q[equations.number(n, Dof::u)] = u[n];
    q[equations.number(n, Dof::v)] = v[n];
    q[equations.number(n, Dof::theta)] = t[n];
  }
  const double du = (u[0] - t[0] * 0.5) - (u[1] - t[1] * 0.7);
  const double dv = (v[0] + t[0] * 0.3) - (v[1] + t[1] * -0.2);
  EXPECT_NEAR(equations.springs()[0].approach(q), 0.6 * du + 0.8 * dv, 1e-15);
}

TEST(Equations, RefillAllocatesNothing) {
  const Equations equations(mixed_model());
  std::mt19937 random(9);
  const State q = random_state(equations.size(), random);
  const Eigen::VectorXd f = Eigen::VectorXd::Zero(equations.size());
  Eigen::VectorXd r(equations.size());
  SparseSymmetric tangent = equations.linear_stiffness();
  const std::vector<double> springs(equations.springs().size(), 1e6);
  equations.secant_stiffness(springs, tangent);
  const std::size_t before = test::allocations();
  for (int i = 0; i < 10; ++i) {
    equations.energy_and_residual(q, f, r);
    equations.secant_stiffness(springs, tangent);
  }
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace fe
