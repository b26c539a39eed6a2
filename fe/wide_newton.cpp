#include "fe/wide_newton.h"

#include <optional>

#include "fe/newton_method.h"
#include "fe/quad.h"

namespace fe {
namespace {

using Eigen::VectorXd;

using Wide = Quad;
using WideVector = Eigen::Matrix<Wide, Eigen::Dynamic, 1>;

/// Pivots below this share of the largest leave no digit in the solution.
constexpr double kSmallestWidePivotRatio = 1e-33;

/// First shift (see NewtonOptions): small compared with the softest stiffness of a model.
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
  State state(VectorXd(q.value.size()));
  for (Eigen::Index i = 0; i < q.value.size(); ++i) {
    state.head[i] = static_cast<double>(q.value[i]);
    state.tail[i] = static_cast<double>(q.value[i] - state.head[i]);
  }
  return state;
}

/// Types of states, forces and energies, and operations on them, in both kinds of steps.
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

  /// The laws themselves have the digits of a double, of the net approach.
  SpringResponse response(const Equations::Spring& s, const State& q) const {
    return evaluate(without_gap(s.law), static_cast<double>(net_approach(s, q)));
  }

  Wide energy_and_residual(const State& q, const VectorXd& f, Vector& residual) const {
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
  /// Whether the residual is within the rounding of the springs' laws, which no step removes.
  bool residual_is_rounding(const State& q, const Vector& residual) const {
    VectorXd rounding = VectorXd::Zero(equations.size());
    for (const Equations::Spring& s : equations.springs()) {
      const double force = response(s, q).force;
      for (std::size_t i = 0; i < s.count; ++i) rounding[s.equation[i]] += force * std::abs(s.coefficient[i]);
    }
    rounding *= kForceRounding;
    return (residual.cast<double>().array().abs() <= rounding.array()).all();
  }

  /// The laws' energies have the digits of a double.
  double energy_rounding(const State& q, const VectorXd&, const Wide&) const {
    double energy = 0.0;
    for (const Equations::Spring& s : equations.springs()) energy += response(s, q).energy;
    return kEnergyRounding * energy;
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
  VectorXd step;
};

/// L D L' of a symmetric matrix in wide numbers, L row by row.
class WideCholesky {
 public:
  /// `pattern`: of the matrix, in the order of elimination; has to outlive this.
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

  /// `value`: of the entries of the pattern.
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

}  // namespace

struct WideNewton::Methods {
  Methods(const Equations& of, DoubleTangent& doubles) : equations(of), by_doubles(of, doubles) {}

  NewtonMethod<WideSteps>& by_wide() { return wide ? *wide : wide.emplace(equations); }

  const Equations& equations;
  NewtonMethod<DoubleSteps> by_doubles;
  std::optional<NewtonMethod<WideSteps>> wide;
};

WideNewton::WideNewton(const Equations& equations, DoubleTangent& doubles)
    : methods_(std::make_unique<Methods>(equations, doubles)) {}
WideNewton::~WideNewton() = default;

NewtonSummary WideNewton::solve(const VectorXd& f, const NewtonOptions& options, int limit, State& q) {
  WideState wide = to_wide(q);
  NewtonSummary summary = methods_->by_doubles.solve(f, options, limit, kMostShifted, wide);
  if (digits_may_help(summary)) {
    if (!(summary.relative_residual <= kNear)) wide = to_wide(q);
    NewtonOptions wide_options = options;
    wide_options.first_shift = kFirstShift;
    const int left = limit - summary.iterations();
    continue_by(methods_->by_wide().solve(f, wide_options, left, left, wide), summary);
    summary.wide = true;
  }
  q = to_state(wide);
  return summary;
}

bool WideNewton::solve_tangent(const State& q, const VectorXd& rate, VectorXd& x) {
  WideSteps& numbers = methods_->by_wide().numbers();
  numbers.tangent(to_wide(q), 0.0);
  if (numbers.factorize() != FactorizationStatus::ok) return false;
  WideVector wide;
  numbers.solve(rate.cast<Wide>(), wide);
  x = wide.cast<double>();
  return true;
}

}  // namespace fe
