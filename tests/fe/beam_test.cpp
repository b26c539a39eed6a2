#include "fe/beam.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "fe/newton.h"

namespace fe {
namespace {

constexpr double kEA = 8e6, kEI = 24.0, kGA = 2.5e6;

/// Cantilever of `elements` beams, transverse force P and moment M at the free end.
struct Cantilever {
  Model model;
  int tip = 0;

  Cantilever(double length, int elements, double shear_rigidity) {
    tip = model.add_node();
    for (const Dof dof : {Dof::u, Dof::v, Dof::theta}) model.fixed_supports.push_back({tip, dof});
    for (int i = 0; i < elements; ++i) {
      const int next = model.add_node();
      model.beams.push_back({tip, next, {kEA, kEI, shear_rigidity, length / elements}});
      tip = next;
    }
  }

  Eigen::Vector3d tip_displacement(double axial, double transverse, double moment) const {
    const Equations equations(model);
    NewtonSolver solver(equations);
    State q(Eigen::VectorXd::Zero(equations.size()));
    const Eigen::VectorXd f =
        equations.load_vector({{tip, Dof::u, axial}, {tip, Dof::v, transverse}, {tip, Dof::theta, moment}});
    NewtonOptions options;
    options.force_scale = 100.0;
    EXPECT_TRUE(solver.solve(f, options, q).converged());
    return {equations.displacement(q, tip, Dof::u), equations.displacement(q, tip, Dof::v),
            equations.displacement(q, tip, Dof::theta)};
  }
};

TEST(Beam, CantileverBendsAsEulerBernoulli) {
  const double l = 0.04, p = 100.0, m = 3.0;
  for (const int elements : {1, 2, 7}) {
    const Eigen::Vector3d d = Cantilever(l, elements, 0.0).tip_displacement(50.0, p, m);
    EXPECT_NEAR(d[0] / (50.0 * l / kEA), 1.0, 1e-12);
    EXPECT_NEAR(d[1] / (p * l * l * l / (3 * kEI) + m * l * l / (2 * kEI)), 1.0, 1e-11);
    EXPECT_NEAR(d[2] / (p * l * l / (2 * kEI) + m * l / kEI), 1.0, 1e-11);
  }
}

TEST(Beam, CantileverBendsAsTimoshenko) {
  const double l = 0.012, p = 100.0, m = 3.0;
  for (const int elements : {1, 2, 7}) {
    const Eigen::Vector3d d = Cantilever(l, elements, kGA).tip_displacement(0.0, p, m);
    const double bending = p * l * l * l / (3 * kEI) + m * l * l / (2 * kEI);
    EXPECT_NEAR(d[1] / (bending + p * l / kGA), 1.0, 1e-11);
    EXPECT_NEAR(d[2] / (p * l * l / (2 * kEI) + m * l / kEI), 1.0, 1e-11);
  }
}

TEST(Beam, RigidMotionsStoreNoEnergy) {
  const double l = 0.01;
  for (const double shear : {0.0, kGA}) {
    const auto k = stiffness_matrix(Beam{kEA, kEI, shear, l});
    Eigen::Matrix<double, 6, 3> rigid;
    rigid.col(0) << 1, 0, 0, 1, 0, 0;
    rigid.col(1) << 0, 1, 0, 0, 1, 0;
    rigid.col(2) << 0, 0, 1, 0, l, 1;
    EXPECT_LT((k * rigid).cwiseAbs().maxCoeff(), 1e-14 * k.cwiseAbs().maxCoeff());
    EXPECT_EQ(k, k.transpose());
    const Eigen::Matrix<double, 6, 1> scale{1, 1, l, 1, 1, l};
    Eigen::FullPivLU<Eigen::MatrixXd> scaled(scale.cwiseInverse().asDiagonal() * k * scale.cwiseInverse().asDiagonal());
    EXPECT_EQ(scaled.setThreshold(1e-6).rank(), 3);
  }
}

TEST(Beam, EndForcesAreStiffnessTimesDisplacements) {
  const BeamVector<double> q{1e-6, -2e-6, 3e-4, 4e-6, 1e-6, -2e-4};
  for (const double shear : {0.0, kGA}) {
    const Beam beam{kEA, kEI, shear, 0.01};
    const BeamVector<double> product = stiffness_matrix(beam) * q;
    const BeamVector<double> forces = end_forces(beam, {q[3] - q[0], q[4] - q[1], q[2], q[5]});
    EXPECT_LT((forces - product).norm(), 1e-13 * product.norm());
  }
}

TEST(Beam, WithoutShearFlexibilityTimoshenkoIsEulerBernoulli) {
  const auto stiff = stiffness_matrix(Beam{kEA, kEI, 1e30, 0.01});
  const auto none = stiffness_matrix(Beam{kEA, kEI, 0.0, 0.01});
  EXPECT_LT((stiff - none).cwiseAbs().maxCoeff(), 1e-14 * none.cwiseAbs().maxCoeff());
}

}  // namespace
}  // namespace fe
