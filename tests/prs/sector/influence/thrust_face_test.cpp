#include "prs/sector/influence/thrust_face.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

namespace prs {
namespace {

using Eigen::Index;

/// A rigid plate on `n` springs of compliance c at x = 0, 1, .. (the nodes of the face), loaded at
/// the given places: as a body on a rigid shoulder. Tilting is left to a spring about x = 0.
struct Plate {
  int nodes = 5;
  double compliance = 2e-9;
  double tilt = 1e-9;  ///< Tilt of the body about node 0, per unit moment.

  ThrustFace face(const Eigen::VectorXd& at) const {
    const Index n = nodes, l = at.size();
    Eigen::VectorXd x(n);
    for (Index i = 0; i < n; ++i) x[i] = static_cast<double>(i);
    ThrustFace f;
    // Against node 0: its own spring is in every relative displacement.
    f.nodes = tilt * x * x.transpose();
    f.coupling = tilt * x * at.transpose();
    f.loads = tilt * at * at.transpose();
    for (Index i = 1; i < n; ++i)
      for (Index j = 1; j < n; ++j) f.nodes(i, j) += compliance * (i == j ? 2.0 : 1.0);
    f.coupling.bottomRows(n - 1).array() += compliance;
    f.loads.array() += compliance;
    f.resultants = Eigen::VectorXd::Ones(l);
    return f;
  }
};

TEST(ThrustFace, OneTouchingNodeCarriesAll) {
  const Plate plate;
  const Eigen::VectorXd at = Eigen::Vector2d(1.0, 3.0);
  const ThrustFace f = plate.face(at);
  EXPECT_LT((f.flexibility({0}) - f.loads).norm(), 1e-15 * f.loads.norm());
  // Held at node 2 instead: the lever of each load is measured from there.
  const Eigen::MatrixXd c = f.flexibility({2});
  for (Index i = 0; i < 2; ++i)
    for (Index j = 0; j < 2; ++j)
      EXPECT_NEAR(c(i, j), plate.compliance + plate.tilt * (at[i] - 2.0) * (at[j] - 2.0), 1e-20);
}

TEST(ThrustFace, FlexibilityIsTheDisplacementOfTheConstrainedBody) {
  const ThrustFace f = Plate{}.face(Eigen::Vector3d(0.5, 1.5, 3.5));
  const ThrustFace::Touching touching{0, 1, 3};
  const Eigen::MatrixXd c = f.flexibility(touching);
  EXPECT_LT((c - c.transpose()).norm(), 1e-15 * c.norm());
  // Holding more makes it stiffer.
  const Eigen::MatrixXd softer = f.flexibility({0, 1}) - c;
  EXPECT_GE(softer.diagonal().minCoeff(), -1e-20);
}

TEST(ThrustFace, NodesThatWouldPullAreLetGo) {
  // A load beyond the last node presses there and lifts the first ones.
  const ThrustFace f = Plate{5, 2e-12, 1e-9}.face(Eigen::VectorXd::Constant(1, 6.0));
  const Eigen::VectorXd load = Eigen::VectorXd::Constant(1, 100.0);
  const ThrustFace::Touching touching = *f.touching_under(load, f.all());
  EXPECT_EQ(touching, ThrustFace::Touching{4});
  // Found from any guess, in both senses.
  EXPECT_EQ(f.touching_under(load, {0}), touching);
  EXPECT_EQ(f.touching_under(-load, {0, 2}), touching);
}

TEST(ThrustFace, TouchingNodesPushAndTheOthersAreClear) {
  for (const double at : {0.2, 1.0, 1.7, 2.5, 3.9}) {
    const ThrustFace f = Plate{}.face(Eigen::VectorXd::Constant(1, at));
    const Eigen::VectorXd load = Eigen::VectorXd::Constant(1, 1.0);
    const ThrustFace::Touching touching = *f.touching_under(load, f.all());
    // The state of the touching set, from an independent elimination.
    const auto n = static_cast<Index>(touching.size());
    Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n + 1, n + 1);
    k.topLeftCorner(n, n) = f.nodes(touching, touching) * 1e9;
    k.topRightCorner(n, 1).setOnes();
    k.bottomLeftCorner(1, n).setOnes();
    Eigen::VectorXd right(n + 1);
    right << -f.coupling(touching, 0) * 1e9, -1.0;
    const Eigen::VectorXd s = k.fullPivLu().solve(right);
    EXPECT_LE(s.head(n).maxCoeff(), 1e-9) << at;
    const Eigen::VectorXd u = (f.nodes(Eigen::all, touching) * s.head(n) + f.coupling) * 1e9 +
                              Eigen::VectorXd::Constant(f.nodes.rows(), s[n]);
    EXPECT_LE(u.maxCoeff(), 1e-9) << at;
    EXPECT_LE(f.nodes.rows() - n, 4) << at;
  }
}

}  // namespace
}  // namespace prs
