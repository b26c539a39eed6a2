#include "prs/sector/influence/contact_problem.h"

#include <algorithm>

#include "fe/lu.h"

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

/// The conditions under a force, as Newton's method sees them.
class Equilibrium {
 public:
  Equilibrium(const ContactProblem& p, double force)
      : p_(p), n_(p.gap.size()), force_(force), jacobian_(n_ + 2, n_ + 2), lu_(n_ + 2) {}

  /// Rigid bodies, equal shares: the largest gap closed as well.
  Trial start() {
    const auto contacts = static_cast<double>(p_.contacts());
    const Index first_nut = n_ / 2;
    Trial t;
    t.y.resize(n_);
    for (Index i = 0; i < n_; ++i) {
      const double cosine = std::abs(p_.rigid(i, 1));
      t.y[i] = std::pow(force_ / (contacts * cosine * p_.hertz_constant[i]), 2.0 / 3.0);
    }
    length_ = t.y.mean();
    t.motion[1] = (t.y[first_nut] + p_.gap.tail(n_ / 2).maxCoeff()) / p_.rigid(first_nut, 1);
    t.motion[0] = t.motion[1] + (t.y[0] + p_.gap.head(n_ / 2).maxCoeff()) / p_.rigid(0, 0);
    evaluate(t);
    return t;
  }

  /// Newton's step from here, to be subtracted.
  Eigen::VectorXd step(const Trial& at) {
    factorize(at);
    return lu_.solve(at.residual);
  }

  Trial moved(const Trial& at, const Eigen::VectorXd& step, double share) const {
    Trial t;
    t.y = at.y - share * step.head(n_);
    t.motion = at.motion - share * step.tail<2>();
    evaluate(t);
    return t;
  }

  double tangent_stiffness(const Trial& at) {
    factorize(at);
    Eigen::VectorXd rate = Eigen::VectorXd::Zero(n_ + 2);
    rate[n_] = 1.0 / force_;  // a unit of force, in relative equilibrium
    return 1.0 / lu_.solve(rate)[n_];
  }

 private:
  void evaluate(Trial& t) const {
    t.loads = loads_at(p_, t.y);
    t.residual.resize(n_ + 2);
    t.residual.head(n_) =
        (t.y + p_.gap - p_.rigid * t.motion + p_.flexibility * t.loads.value) / length_;
    t.residual.tail<2>() =
        (p_.balance.transpose() * t.loads.value - Eigen::Vector2d(force_, 0.0)) / force_;
  }

  void factorize(const Trial& at) {
    jacobian_.topLeftCorner(n_, n_) = p_.flexibility * at.loads.slope.asDiagonal();
    jacobian_.topLeftCorner(n_, n_).diagonal().array() += 1.0;
    jacobian_.topLeftCorner(n_, n_) /= length_;
    jacobian_.topRightCorner(n_, 2) = -p_.rigid / length_;
    jacobian_.bottomLeftCorner(2, n_) =
        p_.balance.transpose() * at.loads.slope.asDiagonal() / force_;
    jacobian_.bottomRightCorner<2, 2>().setZero();
    lu_.compute(jacobian_);
  }

  const ContactProblem& p_;
  Index n_;
  double force_;
  double length_ = 0.0;  ///< A typical approach.
  Eigen::MatrixXd jacobian_;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
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
  p.balance = p.rigid;
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
  Equilibrium equilibrium(p, force);
  Trial at = equilibrium.start();
  ContactSolution s;
  for (;;) {
    s.residual = at.residual.cwiseAbs().maxCoeff();
    if (s.residual <= options.tolerance) {
      s.status = ContactSolveStatus::converged;
      break;
    }
    if (s.iterations() == options.max_iterations) break;
    const Eigen::VectorXd step = equilibrium.step(at);
    s.history.push_back({});
    if (!step.allFinite()) {
      s.status = ContactSolveStatus::singular;
      break;
    }
    const double before = at.residual.squaredNorm();
    double share = 1.0;
    Trial trial = equilibrium.moved(at, step, share);
    int halvings = 0;
    while (!(trial.residual.squaredNorm() <= (1.0 - 1e-4 * share) * before) &&
           halvings++ < options.max_halvings)
      trial = equilibrium.moved(at, step, share *= 0.5);
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
  if (s.converged()) s.tangent_stiffness = equilibrium.tangent_stiffness(at);
  return s;
}

double tangent_stiffness(const ContactProblem& p, double force, const Eigen::VectorXd& y) {
  Equilibrium equilibrium(p, force);
  Trial at = equilibrium.start();
  at.loads = loads_at(p, y);
  return equilibrium.tangent_stiffness(at);
}

}  // namespace prs
