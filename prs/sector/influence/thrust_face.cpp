#include "prs/sector/influence/thrust_face.h"

#include <Eigen/LU>
#include <numeric>
#include <utility>

#include "prs/indices.h"

namespace prs {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

using Eigen::Index;

/// Rounding allowed in the reaction of a touching node or the gap of a free one, over the largest.
constexpr double kRounding = 1e-10;
constexpr int kMostChanges = 100;

/// Reactions of the touching nodes and, last, the rigid motion; one column for each right-hand side
/// in `gaps` (u of the nodes without reactions) and `forces` (their axial resultants).
MatrixXd reactions(const MatrixXd& nodes, const ThrustFace::Touching& touching, const MatrixXd& gaps,
                   const Eigen::RowVectorXd& forces) {
  const auto count = static_cast<Index>(touching.size());
  MatrixXd k = MatrixXd::Zero(count + 1, count + 1);
  // Flexibilities are about 1e-9 m/N: equilibrium is scaled alike.
  const double scale = nodes.diagonal().maxCoeff() > 0.0 ? nodes.diagonal().maxCoeff() : 1.0;
  k.topLeftCorner(count, count) = nodes(touching, touching);
  k.topRightCorner(count, 1).setConstant(scale);
  k.bottomLeftCorner(1, count).setConstant(scale);
  MatrixXd right(count + 1, gaps.cols());
  right.topRows(count) = -gaps(touching, Eigen::all);
  right.bottomRows(1) = -scale * forces;
  MatrixXd solution = k.partialPivLu().solve(right);
  solution.bottomRows(1) *= scale;
  return solution;
}

}  // namespace

ThrustFace::Touching ThrustFace::all() const {
  Touching every(static_cast<std::size_t>(nodes.rows()));
  std::iota(every.begin(), every.end(), Index{0});
  return every;
}

MatrixXd ThrustFace::flexibility(const Touching& touching) const {
  const MatrixXd s = reactions(nodes, touching, coupling, resultants.transpose());
  const auto count = static_cast<Index>(touching.size());
  MatrixXd c = loads + coupling(touching, Eigen::all).transpose() * s.topRows(count) + resultants * s.bottomRows(1);
  return 0.5 * (c + c.transpose());
}

std::optional<ThrustFace::Touching> ThrustFace::touching_under(const VectorXd& p, Touching guess) const {
  const VectorXd without = coupling * p;
  const double sense = resultants.dot(p) > 0.0 ? 1.0 : -1.0;  // sense in which the body is pushed
  Touching touching = std::move(guess);
  for (int change = 0; change < kMostChanges; ++change) {
    const VectorXd s = reactions(nodes, touching, without, Eigen::RowVectorXd::Constant(1, resultants.dot(p)));
    const auto count = static_cast<Index>(touching.size());
    const VectorXd push = -sense * s.head(count);
    const VectorXd u =
        nodes(Eigen::all, touching) * s.head(count) + without + VectorXd::Constant(nodes.rows(), s[count]);
    const double depth = u.cwiseAbs().maxCoeff();
    Touching next;
    for (Index n = 0, k = 0; n < nodes.rows(); ++n) {
      const bool touches = k < count && item_at(touching, k) == n;
      if (touches ? push[k] > -kRounding * push.cwiseAbs().maxCoeff() : sense * u[n] > kRounding * depth)
        next.push_back(n);
      if (touches) ++k;
    }
    if (next == touching) return touching;
    if (next.empty()) break;
    touching = std::move(next);
  }
  return std::nullopt;
}

}  // namespace prs
