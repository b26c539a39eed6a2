#include "fe/newton.h"

#include <Eigen/SparseLU>
#include <optional>

#include "fe/cholesky.h"
#include "fe/newton_method.h"
#include "fe/quad.h"

namespace fe {
namespace {

constexpr double kTangentTolerance = 1e-11;
constexpr int kMostRefinements = 10;
/// Relative correction after which the next one would be rounding.
constexpr double kRefined = 1e-8;

/// The tangent in doubles and its factorization, with which steps of Newton's method are solved.
class DoubleTangent {
 public:
  explicit DoubleTangent(const Equations& equations)
      : equations_(&equations), tangent_(equations.linear_stiffness()), cholesky_(tangent_) {}

  /// See Cholesky::factorize.
  double smallest_pivot_ratio = kSmallestPivotRatio;

  void tangent(const State& q, double least) {
    stiffness_.resize(equations_->springs().size());
    for (std::size_t k = 0; k < stiffness_.size(); ++k)
      stiffness_[k] = std::max(equations_->response(q, static_cast<int>(k)).tangent, least);
    secant(stiffness_);
  }
  void secant(const std::vector<double>& stiffness) {
    stiffness_ = stiffness;
    equations_->secant_stiffness(stiffness_, tangent_);
  }
  void shift_by(double change) {
    stiffness_.clear();
    const SparseSymmetric& linear = equations_->linear_stiffness();
    for (int j = 0; j < tangent_.size(); ++j) {
      const int diagonal = at(tangent_.column_start, j + 1) - 1;
      at(tangent_.value, diagonal) += change * at(linear.value, diagonal);
    }
  }
  FactorizationStatus factorize() {
    const FactorizationStatus status = cholesky_.factorize(tangent_, smallest_pivot_ratio);
    factorized_ = status == FactorizationStatus::ok ? stiffness_ : std::vector<double>();
    return status;
  }
  /// Whether no spring's stiffness differs from that in the factorization by more than this share: a solve with the
  /// factorization then leaves at most this share of an error, in energy.
  bool factorized_within(double share) const {
    if (factorized_.empty() || factorized_.size() != stiffness_.size()) return false;
    for (std::size_t k = 0; k < stiffness_.size(); ++k)
      if (!(std::abs(stiffness_[k] - factorized_[k]) <= share * factorized_[k])) return false;
    return true;
  }
  /// Discards the factorization; call it after a change of the linear part.
  void forget() { factorized_.clear(); }
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const { cholesky_.solve(b, x); }
  bool solved(const Eigen::VectorXd& b, const Eigen::VectorXd& x) const {
    Eigen::VectorXd left = b;
    for (int j = 0; j < tangent_.size(); ++j)
      for (int k = at(tangent_.column_start, j); k < at(tangent_.column_start, j + 1); ++k) {
        const int i = at(tangent_.row, k);
        left[i] -= at(tangent_.value, k) * x[j];
        if (i != j) left[j] -= at(tangent_.value, k) * x[i];
      }
    return left.cwiseAbs().maxCoeff() <= 0.1 * b.cwiseAbs().maxCoeff();
  }

  const SparseSymmetric& matrix() const { return tangent_; }
  const Cholesky& cholesky() const { return cholesky_; }

 private:
  const Equations* equations_;
  SparseSymmetric tangent_;
  /// Spring stiffnesses in the matrix, and in its factorization; empty if that is shifted.
  std::vector<double> stiffness_, factorized_;
  Cholesky cholesky_;
};

class DoubleNumbers : public DoubleTangent {
 public:
  static constexpr int kMostStalls = 3;
  static constexpr double kNoGain = 1e-3;
  using Energy = double;
  using State = fe::State;
  using Vector = Eigen::VectorXd;

  explicit DoubleNumbers(const Equations& equations) : DoubleTangent(equations), equations_(&equations) {}

  State zero_state() const { return Vector(Vector::Zero(equations_->size())); }

  double energy_and_residual(const State& q, const Vector& f, Vector& residual) const {
    return equations_->energy_and_residual(q, f, residual);
  }
  /// The factorized secant matrix, kept for later calls: models that differ in gaps and loads share it. Null if it is
  /// singular.
  const Cholesky* start_factor() {
    if (matrix().value != start_value_) {
      start_value_ = matrix().value;
      start_.reset();
      return factorize() == FactorizationStatus::ok ? &cholesky() : nullptr;
    }
    if (!start_) {
      start_ = std::make_unique<Cholesky>(matrix());
      if (start_->factorize(matrix(), smallest_pivot_ratio) != FactorizationStatus::ok) start_.reset();
    }
    return start_.get();
  }
  double force_change(const State& q, const Vector& x) const { return equations_->force_change(q, x); }
  double largest_approach(const State& q) const { return equations_->largest_approach(q); }
  double force_rounding(const State& q) const { return equations_->force_rounding(q); }
  bool residual_is_rounding(const State& q, const Vector& residual) const {
    return (residual.array().abs() <= equations_->rounding_residual(q).array()).all();
  }
  /// Rounding of the energy, a difference of large works.
  static double energy_rounding(const State& q, const Vector& f, double energy) {
    return 64.0 * std::numeric_limits<double>::epsilon() * (std::abs(energy) + std::abs(f.dot(q.head)));
  }
  static void set_to_step(State& to, const State& from, double length, const Vector& step) {
    to.set_to_step(from, length, step);
  }

 private:
  const Equations* equations_;
  std::vector<double> start_value_;
  std::unique_ptr<Cholesky> start_;
};

using Wide = Quad;
using WideVector = Eigen::Matrix<Wide, Eigen::Dynamic, 1>;

/// Smallest pivot over the largest: smaller ones leave no correct digit in the solution.
constexpr double kSmallestWidePivotRatio = 1e-33;

/// First shift as in NewtonOptions: small compared with the softest stiffness of a model.
constexpr double kFirstShift = 1e-26;

/// Displacements as Equations reads them.
struct WideState {
  WideVector value;

  Wide operator[](int i) const { return i < 0 ? Wide(0.0) : value[i]; }
  Wide compensation(int) const { return 0.0; }
  Wide difference(int i, int j) const { return (*this)[j] - (*this)[i]; }
};

WideState to_wide(const State& q) { return {q.head.cast<Wide>() + q.tail.cast<Wide>()}; }

State to_state(const WideState& q) {
  State state(Eigen::VectorXd(q.value.size()));
  for (Eigen::Index i = 0; i < q.value.size(); ++i) {
    state.head[i] = static_cast<double>(q.value[i]);
    state.tail[i] = static_cast<double>(q.value[i] - state.head[i]);
  }
  return state;
}

/// Types of states, forces and energies for both kinds of steps.
struct WideNumbers {
  using Energy = Wide;
  using State = WideState;
  using Vector = WideVector;

  explicit WideNumbers(const Equations& e) : equations(e) {}

  State zero_state() const { return {Vector::Zero(equations.size())}; }

  Wide net_approach(const Equations::Spring& s, const State& q) const {
    Wide w = -s.law.gap;
    for (std::size_t i = 0; i < s.count; ++i) w += s.coefficient[i] * q[s.equation[i]];
    return w;
  }

  /// Response of a spring: the laws have the digits of a double, of the net approach.
  SpringResponse response(const Equations::Spring& s, const State& q) const {
    return evaluate(without_gap(s.law), static_cast<double>(net_approach(s, q)));
  }

  Wide energy_and_residual(const State& q, const Eigen::VectorXd& f, Vector& residual) const {
    Wide energy = Wide(0.5) * equations.linear_forces(q, residual);
    const Vector load = f.cast<Wide>();
    energy += q.value.dot(Wide(0.5) * residual - load);
    residual -= load;
    for (const Equations::Spring& s : equations.springs()) {
      const SpringResponse r = response(s, q);
      energy += r.energy;
      for (std::size_t i = 0; i < s.count; ++i) residual[s.equation[i]] += Wide(r.force) * s.coefficient[i];
    }
    return energy;
  }

  double force_change(const State& q, const Vector& x) const {
    return equations.force_change(to_state(q), x.cast<double>());
  }

  double largest_approach(const State& q) const { return equations.largest_approach(to_state(q)); }
  static double force_rounding(const State&) { return 0.0; }
  /// Whether the residual is rounding: that of the laws remains.
  bool residual_is_rounding(const State& q, const Vector& residual) const {
    Eigen::VectorXd rounding = Eigen::VectorXd::Zero(equations.size());
    for (const Equations::Spring& s : equations.springs()) {
      const double force = response(s, q).force;
      for (std::size_t i = 0; i < s.count; ++i) rounding[s.equation[i]] += force * std::abs(s.coefficient[i]);
    }
    rounding *= 4.0 * std::numeric_limits<double>::epsilon();
    return (residual.cast<double>().array().abs() <= rounding.array()).all();
  }

  /// Rounding of the energy: the laws' energies have the digits of a double.
  double energy_rounding(const State& q, const Eigen::VectorXd&, const Wide&) const {
    double energy = 0.0;
    for (const Equations::Spring& s : equations.springs()) energy += response(s, q).energy;
    return 64.0 * std::numeric_limits<double>::epsilon() * energy;
  }
  static void set_to_step(State& to, const State& from, double length, const Vector& step) {
    to.value = from.value - Wide(length) * step;
  }

  const Equations& equations;
};

/// Steps in doubles.
struct DoubleSteps : WideNumbers {
  static constexpr int kMostStalls = 3;
  static constexpr double kNoGain = 1e-3;

  DoubleSteps(const Equations& e, DoubleTangent& d) : WideNumbers(e), doubles(d) {}

  void tangent(const State& q, double least) { doubles.tangent(to_state(q), least); }
  void shift_by(double change) { doubles.shift_by(change); }
  FactorizationStatus factorize() { return doubles.factorize(); }
  bool factorized_within(double share) const { return doubles.factorized_within(share); }
  void solve(const Vector& b, Vector& x) {
    doubles.solve(b.cast<double>(), step);
    x = step.cast<Wide>();
  }
  bool solved(const Vector& b, const Vector& x) const { return doubles.solved(b.cast<double>(), x.cast<double>()); }

  DoubleTangent& doubles;
  Eigen::VectorXd step;
};

/// L D L' of a symmetric matrix in wide numbers, L row by row.
class WideCholesky {
 public:
  /// `pattern`: of the matrix, in the order of elimination; must outlive this object.
  explicit WideCholesky(const SparseSymmetric& pattern)
      : pattern_(pattern), columns_(size()), below_(size()), diagonal_(size()) {
    std::vector<int> parent(size(), -1), seen_by(size(), -1);
    for (int k = 0; k < pattern.size(); ++k) {
      at(seen_by, k) = k;
      for (int p = at(pattern.column_start, k); p < at(pattern.column_start, k + 1); ++p)
        for (int i = at(pattern.row, p); std::exchange(at(seen_by, i), k) != k; i = at(parent, i)) {
          if (at(parent, i) < 0) at(parent, i) = k;
          at(columns_, k).push_back(i);
        }
      std::ranges::sort(at(columns_, k));
    }
  }

  /// `value`: values of the entries of the pattern.
  FactorizationStatus factorize(const std::vector<Wide>& value) {
    for (auto& entries : below_) entries.clear();
    std::vector<Wide> y(size(), Wide(0.0));
    for (int k = 0; k < pattern_.size(); ++k) {
      for (int p = at(pattern_.column_start, k); p < at(pattern_.column_start, k + 1); ++p)
        at(y, at(pattern_.row, p)) += at(value, p);
      Wide pivot = std::exchange(at(y, k), Wide(0.0));
      for (const int i : at(columns_, k)) {
        const Wide left = std::exchange(at(y, i), Wide(0.0)), entry = left / diagonal_[i];
        for (const auto& [row, above] : at(below_, i)) at(y, row) -= above * left;
        pivot -= entry * left;
        at(below_, i).emplace_back(k, entry);
      }
      if (pivot == Wide(0.0)) return FactorizationStatus::not_positive_definite;
      diagonal_[k] = pivot;
    }
    for (const Wide& pivot : diagonal_)
      if (!(pivot > kSmallestWidePivotRatio * diagonal_.maxCoeff())) return FactorizationStatus::not_positive_definite;
    return FactorizationStatus::ok;
  }

  void solve(const WideVector& b, WideVector& x) const {
    x = b;
    for (int i = 0; i < pattern_.size(); ++i)
      for (const auto& [row, entry] : at(below_, i)) x[row] -= entry * x[i];
    for (int i = pattern_.size() - 1; i >= 0; --i) {
      x[i] /= diagonal_[i];
      for (const auto& [row, entry] : at(below_, i)) x[i] -= entry * x[row];
    }
  }

 private:
  std::size_t size() const { return static_cast<std::size_t>(pattern_.size()); }

  const SparseSymmetric& pattern_;
  std::vector<std::vector<int>> columns_;                 ///< Columns of the entries of each row of L.
  std::vector<std::vector<std::pair<int, Wide>>> below_;  ///< Rows and values of the entries of each column of L.
  WideVector diagonal_;
};

/// Steps in wide numbers.
struct WideSteps : WideNumbers {
  static constexpr int kMostStalls = std::numeric_limits<int>::max();
  static constexpr double kNoGain = 0.0;

  explicit WideSteps(const Equations& e)
      : WideNumbers(e), linear(e.linear_values<Wide>()), value(linear), factor(e.linear_stiffness()) {}

  void tangent(const State& q, double least) {
    value = linear;
    for (const Equations::Spring& s : equations.springs())
      s.for_each_tangent(Wide(std::max(response(s, q).tangent, least)),
                         [&](int slot, const Wide& k) { at(value, slot) += k; });
  }

  void shift_by(double change) {
    for (int j = 0; j < equations.size(); ++j) {
      const int diagonal = at(equations.linear_stiffness().column_start, j + 1) - 1;
      at(value, diagonal) += change * at(linear, diagonal);
    }
  }

  FactorizationStatus factorize() { return factor.factorize(value); }
  void solve(const Vector& b, Vector& x) const { factor.solve(b, x); }
  static bool factorized_within(double) { return false; }
  bool solved(const Vector&, const Vector&) const { return true; }

  std::vector<Wide> linear, value;  ///< Entries of the linear part and of the tangent.
  WideCholesky factor;
};

/// The tangent minus the derivative of the following load: K + (B - P)' t B.
Eigen::SparseMatrix<double> unsymmetric(const SparseSymmetric& tangent, const Equations& equations,
                                        const FollowingLoad& load, const State& q) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < tangent.size(); ++j)
    for (int k = at(tangent.column_start, j); k < at(tangent.column_start, j + 1); ++k) {
      const int i = at(tangent.row, k);
      entries.emplace_back(i, j, at(tangent.value, k));
      if (i != j) entries.emplace_back(j, i, at(tangent.value, k));
    }
  for (std::size_t k = 0; k < load.per_force.size(); ++k) {
    const Equations::Spring& spring = equations.springs()[k];
    const double stiffness = equations.response(q, static_cast<int>(k)).tangent;
    for (const FollowingLoad::Share& share : load.per_force[k])
      for (std::size_t i = 0; i < spring.count; ++i)
        entries.emplace_back(share.equation, spring.equation[i], -stiffness * share.times * spring.coefficient[i]);
  }
  Eigen::SparseMatrix<double> matrix(tangent.size(), tangent.size());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

std::string_view name(NewtonStatus status) {
  constexpr std::string_view kNames[] = {
      "converged", "iteration_limit", "line_search_failed", "not_positive_definite", "no_equilibrium", "mechanism"};
  return kNames[static_cast<std::size_t>(status)];
}

/// Newton's method in numbers of 113 binary digits, for models whose stiffnesses are so far apart that doubles lose the
/// softest of them: stiffnesses 17 decades apart keep 16 digits.
class WideNewton {
 public:
  /// `doubles`: tangent with which steps in doubles are solved.
  WideNewton(const Equations& equations, DoubleTangent& doubles)
      : equations_(equations), by_doubles_(equations, doubles) {}

  /// Solves like NewtonSolver::solve, in at most `limit` linear solves: forces are computed in wide numbers, but steps
  /// in doubles, whose errors the next step corrects. If these are too large, it goes on with a tangent in wide
  /// numbers, a thousand times as slow.
  NewtonSummary solve(const Eigen::VectorXd& f, const NewtonOptions& options, int limit, State& q) {
    WideState wide = to_wide(q);
    NewtonSummary summary = by_doubles_.solve(f, options, limit, kMostShifted, wide);
    if (digits_may_help(summary)) {
      if (!(summary.relative_residual <= kNear)) wide = to_wide(q);
      NewtonOptions wide_options = options;
      wide_options.first_shift = kFirstShift;
      const int left = limit - summary.iterations();
      continue_by(by_wide().solve(f, wide_options, left, left, wide), summary);
      summary.wide = true;
    }
    q = to_state(wide);
    return summary;
  }

  /// See NewtonSolver::solve_tangent.
  bool solve_tangent(const State& q, const Eigen::VectorXd& rate, Eigen::VectorXd& x) {
    WideSteps& numbers = by_wide().numbers();
    numbers.tangent(to_wide(q), 0.0);
    if (numbers.factorize() != FactorizationStatus::ok) return false;
    WideVector wide;
    numbers.solve(rate.cast<Wide>(), wide);
    x = wide.cast<double>();
    return true;
  }

 private:
  NewtonMethod<WideSteps>& by_wide() { return by_wide_ ? *by_wide_ : by_wide_.emplace(equations_); }

  const Equations& equations_;
  NewtonMethod<DoubleSteps> by_doubles_;
  std::optional<NewtonMethod<WideSteps>> by_wide_;
};

struct NewtonSolver::Doubles {
  explicit Doubles(const Equations& equations)
      : method(equations), residual(equations.size()), correction(equations.size()) {}

  NewtonMethod<DoubleNumbers> method;
  Eigen::VectorXd residual, correction;
};

NewtonSolver::NewtonSolver(const Equations& equations, double smallest_pivot_ratio)
    : equations_(&equations), doubles_(std::make_unique<Doubles>(equations)) {
  doubles_->method.numbers().smallest_pivot_ratio = smallest_pivot_ratio;
}
NewtonSolver::~NewtonSolver() = default;
NewtonSolver::NewtonSolver(NewtonSolver&&) noexcept = default;
NewtonSolver& NewtonSolver::operator=(NewtonSolver&&) noexcept = default;

void NewtonSolver::equations_changed() {
  wide_.reset();
  doubles_->method.numbers().forget();
}

WideNewton& NewtonSolver::wide() {
  if (!wide_) wide_ = std::make_unique<WideNewton>(*equations_, doubles_->method.numbers());
  return *wide_;
}

NewtonSummary NewtonSolver::solve(const Eigen::VectorXd& f, const NewtonOptions& options, State& q,
                                  const std::function<bool()>& held) {
  const int limit = options.iteration_limit(static_cast<int>(equations_->springs().size()));
  const State start = q;
  NewtonSummary summary = doubles_->method.solve(f, options, limit, kMostShifted, q);
  if (!digits_may_help(summary)) return summary;
  if (held && !held()) {
    summary.status = NewtonStatus::no_equilibrium;
    return summary;
  }
  if (!(summary.relative_residual <= kNear)) q = start;
  continue_by(wide().solve(f, options, limit - summary.iterations(), q), summary);
  return summary;
}

FollowingLoad::FollowingLoad(const Equations& equations, Eigen::VectorXd unchanged,
                             const std::vector<std::vector<NodalLoad>>& loads)
    : constant(std::move(unchanged)), per_force(loads.size()) {
  for (std::size_t k = 0; k < loads.size(); ++k) {
    per_force[k].reserve(loads[k].size());
    equations.for_each_load(loads[k], [&](int equation, double force) {
      if (force != 0.0) per_force[k].push_back({equation, force});
    });
  }
}

bool NewtonSolver::follow(const FollowingLoad& load, const NewtonOptions& options, State& q) {
  constexpr int kMostSteps = 40, kFullSteps = 10;
  constexpr double kMuchTheSame = 0.05;  // Change of stiffness that friction tolerates less exactly.
  DoubleNumbers& numbers = doubles_->method.numbers();
  Eigen::VectorXd &residual = doubles_->residual, &correction = doubles_->correction;
  const State first = q;
  double left = 0.0;  // Remaining relative residual of the forces.
  const auto left_at = [&](const State& state) {
    equations_->linear_forces(state, residual);
    residual -= load.constant;
    for (std::size_t k = 0; k < load.per_force.size(); ++k) {
      const Equations::Spring& spring = equations_->springs()[k];
      const double force = equations_->response(state, static_cast<int>(k)).force;
      for (std::size_t i = 0; i < spring.count; ++i) residual[spring.equation[i]] += force * spring.coefficient[i];
      for (const FollowingLoad::Share& share : load.per_force[k]) residual[share.equation] -= force * share.times;
    }
    double largest = 0.0;
    for (int i = 0; i < equations_->size(); ++i)
      largest =
          std::max(largest, std::abs(residual[i]) / (equations_->kind(i) == Dof::theta ? options.length_scale : 1.0));
    return largest / options.force_scale;
  };
  numbers.tangent(q, 0.0);
  if (!numbers.factorized_within(kMuchTheSame) && numbers.factorize() != FactorizationStatus::ok) return false;
  Eigen::SparseLU<Eigen::SparseMatrix<double>> lu;
  for (const bool newton : {false, true}) {
    double before = std::numeric_limits<double>::infinity();
    for (int step = 0; step < kMostSteps; ++step, before = left) {
      left = left_at(q);
      const bool fast = left < 0.5 * before;
      const bool small =
          left <= options.rounding_tolerance || (newton && !fast && numbers.residual_is_rounding(q, residual));
      if (newton ? !std::isfinite(left) : !small && !fast) break;
      if (newton) {
        numbers.tangent(q, 0.0);
        lu.compute(unsymmetric(numbers.matrix(), *equations_, load, q));
        if (lu.info() != Eigen::Success) break;
        correction = lu.solve(residual);
      } else {
        numbers.solve(residual, correction);
      }
      // Full steps can cycle if springs open and close in turn.
      q.set_to_step(State(q), step < kFullSteps || fast ? 1.0 : 0.5, correction);
      // This step reduces the error found to a tenth.
      if (left <= options.residual_tolerance || (small && !fast)) return true;
    }
    q = first;
  }
  return false;
}

bool NewtonSolver::start(const Eigen::VectorXd& f, const std::vector<double>& stiffness, State& q) {
  DoubleNumbers& numbers = doubles_->method.numbers();
  Eigen::VectorXd& residual = doubles_->residual;
  q = State(Eigen::VectorXd::Zero(equations_->size()));
  equations_->secant_residual(stiffness, f, residual);
  numbers.secant(stiffness);
  const Cholesky* factor = numbers.start_factor();
  if (!factor) return false;
  factor->solve(residual, doubles_->correction);
  q.set_to_step(q, -1.0, doubles_->correction);
  return true;
}

bool NewtonSolver::solve_linear(const std::vector<double>& stiffness, const std::vector<Eigen::VectorXd>& loads,
                                std::vector<Eigen::VectorXd>& displacements, double near) {
  DoubleNumbers& numbers = doubles_->method.numbers();
  numbers.secant(stiffness);
  if (!(near > 0.0 && numbers.factorized_within(near)) && numbers.factorize() != FactorizationStatus::ok) return false;
  Eigen::VectorXd& correction = doubles_->correction;
  for (const Eigen::VectorXd& load : loads) {
    Eigen::VectorXd x;
    numbers.solve(load, x);
    State refined(std::move(x));
    // A refinement leaves about the square of the error that it corrects.
    for (int k = 0; k < kMostRefinements; ++k) {
      equations_->secant_residual(stiffness, refined, load, doubles_->residual);
      numbers.solve(doubles_->residual, correction);
      refined.set_to_step(refined, -1.0, correction);
      if (correction.norm() <= kRefined * refined.head.norm()) break;
    }
    displacements.push_back(std::move(refined.head));
  }
  return true;
}

bool NewtonSolver::solve_tangent(const State& q, const Eigen::VectorXd& rate, Eigen::VectorXd& x) {
  DoubleNumbers& numbers = doubles_->method.numbers();
  numbers.tangent(q, 0.0);
  if (numbers.factorize() != FactorizationStatus::ok) return wide().solve_tangent(q, rate, x);
  Eigen::VectorXd& residual = doubles_->residual;
  Eigen::VectorXd& correction = doubles_->correction;
  numbers.solve(rate, x);
  State refined(x);
  for (int k = 0; k <= kMostRefinements; ++k) {
    equations_->tangent_residual(q, refined, rate, residual);
    if (std::abs(refined.head.dot(residual)) <= kTangentTolerance * refined.head.dot(rate)) {
      x = refined.head;
      return true;
    }
    numbers.solve(residual, correction);
    refined.set_to_step(State(refined), -1.0, correction);
  }
  return wide().solve_tangent(q, rate, x);
}

}  // namespace fe
