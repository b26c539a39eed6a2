#include "prs/sector/influence/contact_problem.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace prs {
namespace {

using Eigen::Index;

/// N(y) and its slope.
struct Loads {
  Eigen::VectorXd value;
  Eigen::VectorXd slope;
};

Loads loads_at(const ContactProblem& p, const Eigen::VectorXd& y) {
  const Eigen::ArrayXd closed = y.array().max(0.0), root = closed.sqrt();
  return {(p.hertz_constant.array() * closed * root).matrix(),
          (1.5 * p.hertz_constant.array() * root).matrix()};
}

/// Unknowns and what the conditions lack there.
struct Trial {
  Eigen::VectorXd y;
  Eigen::Vector2d motion;
  Loads loads;
  Eigen::VectorXd residual;  ///< Relative: compatibility, then equilibrium.
};

}  // namespace

ContactProblem contact_problem(const Eigen::MatrixXd& flexibility,
                               const PerInterface<ContactLaw>& laws,
                               const PerInterface<std::vector<double>>& gaps) {
  const auto n = static_cast<Index>(gaps.screw.size());
  ContactProblem p;
  p.flexibility = flexibility;
  p.flexibility.diagonal().head(n).array() += laws.screw.compliance;
  p.flexibility.diagonal().tail(n).array() += laws.nut.compliance;
  p.rigid = Eigen::MatrixXd::Zero(2 * n, 2);
  p.hertz_constant.resize(2 * n);
  p.gap.resize(2 * n);
  p.rigid.col(0).head(n).setConstant(std::cos(laws.screw.normal_angle));
  p.rigid.col(1).head(n).setConstant(-std::cos(laws.screw.normal_angle));
  p.rigid.col(1).tail(n).setConstant(std::cos(laws.nut.normal_angle));
  p.hertz_constant.head(n).setConstant(laws.screw.hertz_constant);
  p.hertz_constant.tail(n).setConstant(laws.nut.hertz_constant);
  p.gap << Eigen::Map<const Eigen::VectorXd>(gaps.screw.data(), n),
      Eigen::Map<const Eigen::VectorXd>(gaps.nut.data(), n);
  return p;
}

Eigen::MatrixXd joined_flexibility(const Flexibility& screw, const Flexibility& nut,
                                   const Flexibility& roller) {
  const Index n = screw.matrix.rows();
  Eigen::MatrixXd c = roller.matrix;
  c.topLeftCorner(n, n) += screw.matrix;
  c.bottomRightCorner(n, n) += nut.matrix;
  return c;
}

ContactSolution solve(const ContactProblem& p, double force, const ContactSolveOptions& options) {
  const Index n = p.gap.size();
  const Eigen::Vector2d load(force, 0.0);

  // Rigid bodies, equal shares: the largest gap closed as well.
  const auto half = static_cast<double>(p.contacts());
  Trial at;
  at.y.resize(n);
  for (Index i = 0; i < n; ++i) {
    const double cosine = std::abs(p.rigid(i, 1));
    at.y[i] = std::pow(force / (half * cosine * p.hertz_constant[i]), 2.0 / 3.0);
  }
  const double length = at.y.mean();
  const Index first_nut = n / 2;
  at.motion[1] = (at.y[first_nut] + p.gap.tail(n / 2).maxCoeff()) / p.rigid(first_nut, 1);
  at.motion[0] = at.motion[1] + (at.y[0] + p.gap.head(n / 2).maxCoeff()) / p.rigid(0, 0);

  const auto evaluate = [&](Trial& t) {
    t.loads = loads_at(p, t.y);
    t.residual.resize(n + 2);
    t.residual.head(n) =
        (t.y + p.gap - p.rigid * t.motion + p.flexibility * t.loads.value) / length;
    t.residual.tail<2>() = (p.rigid.transpose() * t.loads.value - load) / force;
  };
  evaluate(at);

  ContactSolution s;
  Eigen::MatrixXd jacobian(n + 2, n + 2);
  Eigen::PartialPivLU<Eigen::MatrixXd> lu(n + 2);
  const auto factorize = [&] {
    jacobian.topLeftCorner(n, n) = p.flexibility * at.loads.slope.asDiagonal();
    jacobian.topLeftCorner(n, n).diagonal().array() += 1.0;
    jacobian.topLeftCorner(n, n) /= length;
    jacobian.topRightCorner(n, 2) = -p.rigid / length;
    jacobian.bottomLeftCorner(2, n) = p.rigid.transpose() * at.loads.slope.asDiagonal() / force;
    jacobian.bottomRightCorner<2, 2>().setZero();
    lu.compute(jacobian);
  };
  for (;;) {
    s.residual = at.residual.cwiseAbs().maxCoeff();
    if (s.residual <= options.tolerance) {
      s.status = ContactSolveStatus::converged;
      break;
    }
    if (s.iterations() == options.max_iterations) break;
    factorize();
    const Eigen::VectorXd step = lu.solve(at.residual);
    s.history.push_back({});
    if (!step.allFinite()) {
      s.status = ContactSolveStatus::singular;
      break;
    }
    const double before = at.residual.squaredNorm();
    Trial trial;
    double share = 1.0;
    int halvings = 0;
    for (; halvings <= options.max_halvings; ++halvings, share *= 0.5) {
      trial.y = at.y - share * step.head(n);
      trial.motion = at.motion - share * step.tail<2>();
      evaluate(trial);
      if (trial.residual.squaredNorm() <= (1.0 - 1e-4 * share) * before) break;
    }
    if (halvings > options.max_halvings) {
      s.status = ContactSolveStatus::line_search_failed;
      break;
    }
    at = std::move(trial);
    s.history.back() = {at.residual.cwiseAbs().maxCoeff(), share};
  }
  s.normal_load = at.loads.value;
  s.approach = at.y.cwiseMax(0.0);
  s.screw_motion = at.motion[0];
  s.roller_motion = at.motion[1];
  if (s.converged()) {
    factorize();
    Eigen::VectorXd rate = Eigen::VectorXd::Zero(n + 2);
    rate[n] = 1.0 / force;  // a unit of force, in relative equilibrium
    s.tangent_stiffness = 1.0 / lu.solve(rate)[n];
  }
  return s;
}

}  // namespace prs
