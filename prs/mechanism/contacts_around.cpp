#include "prs/mechanism/contacts_around.h"

#include <Eigen/Jacobi>

#include "fe/lu.h"
#include "prs/indices.h"
#include "prs/sector/influence/influence_solver.h"

namespace prs {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Stiffness of a missing roller's contacts, as a share of a present one's.
constexpr double kMissing = 1e-13;

/// Solution x of A x = b, A given by its products, from x = 0; none after this many directions (Saad and Schultz,
/// GMRES, 1986).
template <class Product>
std::optional<VectorXd> gmres(Product product, const VectorXd& b, double tolerance, int most) {
  const double size = b.norm();
  if (size == 0.0) return b;
  const Index directions = std::min<Index>(most, b.size());
  MatrixXd basis(b.size(), directions + 1), r = MatrixXd::Zero(directions + 1, directions);
  VectorXd right = VectorXd::Zero(directions + 1);
  std::vector<Eigen::JacobiRotation<double>> rotations;
  basis.col(0) = b / size;
  right[0] = size;
  for (Index k = 0; k < directions; ++k) {
    VectorXd next = product(basis.col(k));
    auto h = r.col(k);
    for (int twice = 0; twice < 2; ++twice) {
      const VectorXd along = basis.leftCols(k + 1).transpose() * next;
      next.noalias() -= basis.leftCols(k + 1) * along;
      h.head(k + 1) += along;
    }
    h[k + 1] = next.norm();
    basis.col(k + 1) = next / h[k + 1];
    for (Index i = 0; i < k; ++i) h.applyOnTheLeft(i, i + 1, item_at(rotations, i).adjoint());
    rotations.emplace_back().makeGivens(h[k], h[k + 1]);
    h.applyOnTheLeft(k, k + 1, rotations.back().adjoint());
    right.applyOnTheLeft(k, k + 1, rotations.back().adjoint());
    if (std::abs(right[k + 1]) > tolerance * size) continue;
    const VectorXd shares = r.topLeftCorner(k + 1, k + 1).triangularView<Eigen::Upper>().solve(right.head(k + 1));
    return VectorXd(basis.leftCols(k + 1) * shares);
  }
  return std::nullopt;
}

/// The problem in units of the given force and length, with the workspace of a solve.
class Around {
 public:
  Around(const ContactsAround& given, const ContactsAroundOptions& options)
      : given_(given),
        options_(options),
        contacts_(given.gap.rows()),
        rollers_(given.gap.cols()),
        shapes_(rollers_, static_cast<Index>(given.waves.size())) {
    const double unit = options.force / options.length;
    for (const ContactsAround::Mode& m : given.modes) {
      modes_.push_back(m);
      modes_.back().flexibility *= unit;
      modes_.back().rigid.rightCols(m.reactions) *= unit;
      modes_.back().support.bottomRightCorner(m.reactions, m.reactions) *= unit;
      const Index of_motions = m.rigid.cols() - m.reactions;
      modes_.back().support.topLeftCorner(of_motions, of_motions) /= unit;
    }
    for (const auto w : indices(given.waves)) {
      shapes_.col(static_cast<Index>(w)) = given.waves[w].shape;
      first_.push_back(motions_);
      motions_ += mode_of(w).rigid.cols();
    }
    load_.resize(motions_);
    for (const auto w : indices(given.waves))
      motions(load_, w) = given.waves[w].load.cwiseQuotient(units(w, options.force, options.length));
    hertz_ = MatrixXd::Zero(contacts_, rollers_);
    for (Index j = 0; j < rollers_; ++j)
      if (item_at(given.present, j))
        hertz_.col(j) = given.hertz_constant * std::pow(options.length, 1.5) / options.force;
    gap_ = given.gap / options.length * shapes_;
  }

  struct State {
    MatrixXd y;              ///< One column for each roller.
    VectorXd motion;         ///< V, wave after wave.
    MatrixXd load, slope;    ///< N and dN/dy.
    MatrixXd approach_left;  ///< Residual of the first equation, one column for each wave.
    VectorXd force_left;     ///< Residual of the second equation.

    double largest() const { return std::max(approach_left.cwiseAbs().maxCoeff(), force_left.cwiseAbs().maxCoeff()); }
    double square() const { return approach_left.squaredNorm() + force_left.squaredNorm(); }
  };

  /// First state: linear contacts of equal stiffness.
  State first_state() {
    State s;
    take(MatrixXd::Zero(contacts_, rollers_), 1.0);
    auto [y, motion] = step(gap_, -load_, options_.step_tolerance);
    s.y = -y;
    s.motion = -motion;
    return s;
  }
  State state_of(const ContactsAroundSolution& s) const {
    State state;
    state.y = s.y / options_.length;
    state.motion.resize(motions_);
    for (const auto w : indices(s.motion))
      motions(state.motion, w) = s.motion[w].cwiseQuotient(units(w, options_.length, options_.force));
    return state;
  }
  void evaluate(State& s) const {
    const Eigen::ArrayXXd closed = s.y.array().max(0.0), root = closed.sqrt();
    s.load = hertz_.array() * closed * root;
    s.slope = 1.5 * hertz_.array() * root;
    const MatrixXd load = s.load * shapes_;
    s.approach_left = s.y * shapes_ + gap_;
    s.force_left = -load_;
    for (const auto w : indices(first_)) {
      const ContactsAround::Mode& m = mode_of(w);
      const auto v = motions(s.motion, w);
      const auto at = static_cast<Index>(w);
      s.approach_left.col(at).noalias() += m.flexibility * load.col(at);
      s.approach_left.col(at).noalias() -= m.rigid * v;
      motions(s.force_left, w) += m.rigid.transpose() * load.col(at) + m.support * v;
    }
  }

  /// Whether rounding of the sums alone can leave this residual: half an eps for each term of a sum of their sizes
  /// (Higham, Accuracy and Stability of Numerical Algorithms, 2002, (3.5)).
  bool left_is_rounding(const State& s) const {
    const MatrixXd shapes = shapes_.cwiseAbs(), load = s.load * shapes;
    const MatrixXd approach = s.y.cwiseAbs() * shapes + gap_.cwiseAbs();
    const double share =
        0.5 * std::numeric_limits<double>::epsilon() * static_cast<double>(contacts_ + rollers_ + motions_);
    for (const auto w : indices(first_)) {
      const ContactsAround::Mode& m = mode_of(w);
      const VectorXd v = motions(s.motion, w).cwiseAbs();
      const MatrixXd rigid = m.rigid.cwiseAbs();
      const auto at = static_cast<Index>(w);
      const VectorXd approaches = approach.col(at) + m.flexibility.cwiseAbs() * load.col(at) + rigid * v;
      const VectorXd forces =
          motions(load_, w).cwiseAbs() + rigid.transpose() * load.col(at) + m.support.cwiseAbs() * v;
      if ((s.approach_left.col(at).cwiseAbs() - share * approaches).maxCoeff() > 0.0 ||
          (motions(s.force_left, w).cwiseAbs() - share * forces).maxCoeff() > 0.0)
        return false;
    }
    return true;
  }

  /// Sets the slopes for the next steps; for present rollers at least `least` times the first stiffness.
  void take(const MatrixXd& slope, double least) {
    const MatrixXd counted = slope.cwiseMax(
        stiffness() * (hertz_.array() > 0.0).select(MatrixXd::Constant(contacts_, rollers_, least), kMissing));
    const VectorXd mean = counted.rowwise().mean();
    apart_ = counted.array().colwise() / mean.array() - 1.0;
    alike_ = apart_.cwiseAbs().maxCoeff() < 1e-14;
    inverse_.clear();
    for (const ContactsAround::Mode& m : modes_) {
      const Index of_motions = m.rigid.cols();
      MatrixXd matrix(contacts_ + of_motions, contacts_ + of_motions);
      matrix << m.flexibility * mean.asDiagonal(), -m.rigid, m.rigid.transpose() * mean.asDiagonal(), m.support;
      matrix.diagonal().head(contacts_).array() += 1.0;
      inverse_.push_back(matrix.partialPivLu().inverse());
    }
  }
  /// Changes of y and V that remove the residual.
  std::pair<MatrixXd, VectorXd> step(const MatrixXd& approach_left, const VectorXd& force_left,
                                     double tolerance) const {
    MatrixXd waves(contacts_, shapes_.cols());
    VectorXd motion(motions_);
    for (const auto w : indices(first_)) {
      VectorXd both(contacts_ + mode_of(w).rigid.cols());
      both << approach_left.col(static_cast<Index>(w)), motions(force_left, w);
      both = inverse_[given_.waves[w].mode] * both;
      waves.col(static_cast<Index>(w)) = both.head(contacts_);
      motions(motion, w) = both.tail(both.size() - contacts_);
    }
    const MatrixXd alike = waves * shapes_.transpose();
    if (alike_) return {alike, motion};
    const MatrixXd y = unlike(alike, tolerance);
    const MatrixXd more = apart_.cwiseProduct(y) * shapes_;
    for (const auto w : indices(first_))
      motions(motion, w) += inverse_[given_.waves[w].mode].bottomLeftCorner(mode_of(w).rigid.cols(), contacts_) *
                            more.col(static_cast<Index>(w));
    return {y, motion};
  }

  ContactsAroundSolution solution(const State& s) const {
    ContactsAroundSolution solution;
    solution.y = s.y * options_.length;
    solution.normal_load = s.load * options_.force;
    for (const auto w : indices(first_))
      solution.motion.push_back(motions(s.motion, w).cwiseProduct(units(w, options_.length, options_.force)));
    return solution;
  }
  Index first_of(const WaveMotion& m) const { return first_[m.wave] + m.motion; }
  Index motion_count() const { return motions_; }
  MatrixXd no_approach() const { return MatrixXd::Zero(contacts_, shapes_.cols()); }

 private:
  const ContactsAround::Mode& mode_of(std::size_t wave) const { return modes_[given_.waves[wave].mode]; }
  template <class Vector>
  Eigen::VectorBlock<Vector> motions(Vector& all, std::size_t wave) const {
    return all.segment(first_[wave], mode_of(wave).rigid.cols());
  }
  /// Units of V, or of its loads, in a wave.
  VectorXd units(std::size_t wave, double of_motions, double of_reactions) const {
    const ContactsAround::Mode& m = mode_of(wave);
    VectorXd units = VectorXd::Constant(m.rigid.cols(), of_motions);
    units.tail(m.reactions).setConstant(of_reactions);
    return units;
  }
  double stiffness() const { return options_.stiffness * options_.length / options_.force; }

  /// Product of W, `y` and the differences of the slopes from their mean.
  MatrixXd by_slopes(const MatrixXd& y) const {
    const MatrixXd apart = apart_.cwiseProduct(y) * shapes_;
    MatrixXd waves = apart;
    for (Index w = 0; w < apart.cols();) {
      // Cosine and sine of one order are neighbours.
      const std::size_t mode = item_at(given_.waves, w).mode;
      Index end = w + 1;
      while (end < apart.cols() && item_at(given_.waves, end).mode == mode) ++end;
      waves.middleCols(w, end - w).noalias() -=
          inverse_[mode].topLeftCorner(contacts_, contacts_) * apart.middleCols(w, end - w);
      w = end;
    }
    return waves * shapes_.transpose();
  }
  MatrixXd unlike(const MatrixXd& alike, double tolerance) const {
    const auto as_rollers = [this](const auto& column) {
      return MatrixXd(Eigen::Map<const MatrixXd>(column.data(), contacts_, rollers_));
    };
    const auto product = [&](const auto& column) {
      const MatrixXd y = as_rollers(column);
      return VectorXd((y + by_slopes(y)).reshaped());
    };
    const VectorXd right = alike.reshaped();
    if (const auto found = gmres(product, right, tolerance, options_.most_directions)) return as_rollers(*found);
    MatrixXd dense(right.size(), right.size());
    for (Index k = 0; k < right.size(); ++k) dense.col(k) = product(VectorXd(VectorXd::Unit(right.size(), k)));
    return as_rollers(VectorXd(dense.partialPivLu().solve(right)));
  }

  const ContactsAround& given_;
  const ContactsAroundOptions& options_;
  Index contacts_, rollers_, motions_ = 0;
  MatrixXd shapes_;  ///< One column for each wave.
  std::vector<ContactsAround::Mode> modes_;
  std::vector<Index> first_;  ///< Index of the first motion of each wave.
  MatrixXd hertz_, gap_;      ///< k_0 of each contact, 0 for a missing roller's; g of each wave.
  VectorXd load_;
  MatrixXd apart_;  ///< S/S_m - 1
  bool alike_ = true;
  std::vector<MatrixXd> inverse_;  ///< M^-1 of each mode.
};

}  // namespace

ContactsAroundSolution solve(const ContactsAround& contacts, const ContactsAroundOptions& options,
                             const ContactsAroundSolution* from) {
  Around around(contacts, options);
  Around::State at = from ? around.state_of(*from) : around.first_state();
  around.evaluate(at);
  fe::NewtonSummary summary;
  for (;;) {
    summary.relative_residual = at.largest();
    if (summary.relative_residual <= options.tolerance) {
      summary.status = fe::NewtonStatus::converged;
      break;
    }
    if (summary.iterations() == options.max_iterations) break;
    around.take(at.slope, options.least_tangent);
    const auto step = around.step(at.approach_left, at.force_left, options.step_tolerance);
    summary.history.push_back(contact_iteration());
    if (!step.first.allFinite() || !step.second.allFinite()) {
      summary.status = fe::NewtonStatus::not_positive_definite;
      break;
    }
    const double before = at.square();
    Around::State trial;
    double share = 1.0;
    int halvings = 0;
    for (; halvings <= options.max_halvings; ++halvings, share *= 0.5) {
      trial.y = at.y - share * step.first;
      trial.motion = at.motion - share * step.second;
      around.evaluate(trial);
      if (trial.square() <= (1.0 - 1e-4 * share) * before) break;
    }
    if (halvings > options.max_halvings) {
      summary.status = around.left_is_rounding(at) ? fe::NewtonStatus::converged : fe::NewtonStatus::line_search_failed;
      break;
    }
    at = std::move(trial);
    summary.history.back() = contact_iteration(at.largest(), share);
  }
  ContactsAroundSolution solution = around.solution(at);
  static_cast<fe::NewtonSummary&>(solution) = std::move(summary);
  return solution;
}

MatrixXd compliance(const ContactsAround& contacts, const ContactsAroundSolution& solution,
                    const ContactsAroundOptions& options, const std::vector<WaveMotion>& motions) {
  Around around(contacts, options);
  Around::State at = around.state_of(solution);
  around.evaluate(at);
  around.take(at.slope, kMissing);
  const auto count = static_cast<Index>(motions.size());
  MatrixXd rates(count, count);
  for (Index j = 0; j < count; ++j) {
    const auto rate =
        around.step(around.no_approach(), VectorXd::Unit(around.motion_count(), around.first_of(item_at(motions, j))),
                    options.tolerance);
    for (Index i = 0; i < count; ++i) rates(i, j) = rate.second[around.first_of(item_at(motions, i))];
  }
  return options.length / options.force * rates;
}

}  // namespace prs
