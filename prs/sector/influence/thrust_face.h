#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace prs {

/// A body that rests with nodes of a plane face on a rigid shoulder without friction. With R the
/// axial reactions, P the loads and U the axial rigid motion,
///
///     u_nodes = G_nn R + G_nl P + U 1,   u_loads = G_ln R + G_ll P + a U,   1'R + a'P = 0,
///
/// where the flexibilities G hold against one node of the face and a are the axial resultants of
/// unit loads. Nodes that touch have u = 0. [m/N]
struct ThrustFace {
  Eigen::MatrixXd nodes;       ///< G_nn; row and column of the reference node are zero.
  Eigen::MatrixXd coupling;    ///< G_nl
  Eigen::MatrixXd loads;       ///< G_ll
  Eigen::VectorXd resultants;  ///< a [-]

  /// Nodes of the face that touch the shoulder.
  using Touching = std::vector<Eigen::Index>;

  Touching all() const;
  /// Load vector of 1 N on each of the first `contacts` loads.
  Eigen::VectorXd equal_loads(int contacts) const {
    Eigen::VectorXd p = Eigen::VectorXd::Zero(loads.rows());
    p.head(contacts).setOnes();
    return p;
  }
  /// Flexibility at the loads while the given nodes touch.
  Eigen::MatrixXd flexibility(const Touching& touching) const;
  /// Nodes that touch under loads P if the shoulder can only push, found from a first guess by removing nodes that pull
  /// and adding those that would penetrate. The shoulder pushes against a'P. None if that does not converge.
  std::optional<Touching> touching_under(const Eigen::VectorXd& loads, Touching guess) const;
};

}  // namespace prs
