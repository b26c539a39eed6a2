#include "fe/wide_newton.h"

#include <Eigen/SparseCholesky>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <limits>
#include <optional>

#include "fe/double_tangent.h"
#include "fe/index.h"
#include "fe/newton_method.h"

namespace fe {
namespace {

using Wide = boost::multiprecision::cpp_bin_float_quad;
using WideVector = Eigen::Matrix<Wide, Eigen::Dynamic, 1>;

/// Pivots below this share of the largest leave no digit in the solution.
constexpr double kSmallestWidePivotRatio = 1e-33;

/// As in NewtonOptions: small compared with the softest stiffness of a model.
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

/// What the states, forces and energies of both kinds of steps are.
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

  Wide energy_and_residual(const State& q, const Eigen::VectorXd& f, Vector& residual) const {
    Wide energy = Wide(0.5) * equations.linear_forces(q, residual);
    const Vector load = f.cast<Wide>();
    energy += q.value.dot(Wide(0.5) * residual - load);
    residual -= load;
    for (const Equations::Spring& s : equations.springs()) {
      const SpringResponse r = response(s, q);
      energy += r.energy;
      for (std::size_t i = 0; i < s.count; ++i)
        residual[s.equation[i]] += Wide(r.force) * s.coefficient[i];
    }
    return energy;
  }

  double force_change(const State& q, const Vector& x) const {
    return equations.force_change(to_state(q), x.cast<double>());
  }

  double largest_approach(const State& q) const { return equations.largest_approach(to_state(q)); }
  static double force_rounding(const State&) { return 0.0; }
  /// What the laws round stays.
  bool residual_is_rounding(const State& q, const Vector& residual) const {
    Eigen::VectorXd rounding = Eigen::VectorXd::Zero(equations.size());
    for (const Equations::Spring& s : equations.springs()) {
      const double force = response(s, q).force;
      for (std::size_t i = 0; i < s.count; ++i)
        rounding[s.equation[i]] += force * std::abs(s.coefficient[i]);
    }
    rounding *= 4.0 * std::numeric_limits<double>::epsilon();
    return (residual.cast<double>().array().abs() <= rounding.array()).all();
  }

  /// The laws' energies have the digits of a double.
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
  bool solved(const Vector& b, const Vector& x) const {
    return doubles.solved(b.cast<double>(), x.cast<double>());
  }

  DoubleTangent& doubles;
  Eigen::VectorXd step;
};

/// Steps in wide numbers.
struct WideSteps : WideNumbers {
  static constexpr int kMostStalls = std::numeric_limits<int>::max();
  static constexpr double kNoGain = 0.0;
  using Matrix = Eigen::SparseMatrix<Wide>;

  explicit WideSteps(const Equations& e) : WideNumbers(e), linear(e.linear_values<Wide>()) {
    const SparseSymmetric& pattern = e.linear_stiffness();
    matrix =
        Eigen::Map<const Matrix>(e.size(), e.size(), static_cast<Eigen::Index>(linear.size()),
                                 pattern.column_start.data(), pattern.row.data(), linear.data());
    factor.analyzePattern(matrix);
  }

  void tangent(const State& q, double least) {
    std::copy(linear.begin(), linear.end(), matrix.valuePtr());
    for (const Equations::Spring& s : equations.springs())
      s.for_each_tangent(Wide(std::max(response(s, q).tangent, least)),
                         [&](int slot, const Wide& k) { matrix.valuePtr()[slot] += k; });
  }

  void shift_by(double change) {
    for (int j = 0; j < equations.size(); ++j) {
      const int diagonal = matrix.outerIndexPtr()[j + 1] - 1;
      matrix.valuePtr()[diagonal] += change * at(linear, diagonal);
    }
  }

  FactorizationStatus factorize() {
    factor.factorize(matrix);
    if (factor.info() != Eigen::Success) return FactorizationStatus::not_positive_definite;
    const Vector pivots = factor.vectorD();
    for (const Wide& pivot : pivots)
      if (!(pivot > kSmallestWidePivotRatio * pivots.maxCoeff()))
        return FactorizationStatus::not_positive_definite;
    return FactorizationStatus::ok;
  }

  void solve(const Vector& b, Vector& x) const { x = factor.solve(b); }
  static bool factorized_within(double) { return false; }
  bool solved(const Vector&, const Vector&) const { return true; }

  std::vector<Wide> linear;
  Matrix matrix;  ///< Upper triangle of the tangent.
  Eigen::SimplicialLDLT<Matrix, Eigen::Upper, Eigen::NaturalOrdering<int>> factor;
};

}  // namespace

struct WideNewton::Implementation {
  const Equations& equations;
  NewtonMethod<DoubleSteps> by_doubles;
  std::optional<NewtonMethod<WideSteps>> by_wide;

  NewtonMethod<WideSteps>& wide() { return by_wide ? *by_wide : by_wide.emplace(equations); }
};

WideNewton::WideNewton(const Equations& equations, DoubleTangent& doubles)
    : implementation_(
          new Implementation{equations, NewtonMethod<DoubleSteps>(equations, doubles), {}}) {}
WideNewton::~WideNewton() = default;

NewtonSummary WideNewton::solve(const Eigen::VectorXd& f, const NewtonOptions& options, int limit,
                                State& q) {
  WideState wide = to_wide(q);
  NewtonSummary summary = implementation_->by_doubles.solve(f, options, limit, kMostShifted, wide);
  if (digits_may_help(summary)) {
    if (!(summary.relative_residual <= kNear)) wide = to_wide(q);
    NewtonOptions wide_options = options;
    wide_options.first_shift = kFirstShift;
    const int left = limit - summary.iterations();
    continue_by(implementation_->wide().solve(f, wide_options, left, left, wide), summary);
    summary.wide = true;
  }
  q = to_state(wide);
  return summary;
}

bool WideNewton::solve_tangent(const State& q, const Eigen::VectorXd& rate, Eigen::VectorXd& x) {
  WideSteps& numbers = implementation_->wide().numbers();
  numbers.tangent(to_wide(q), 0.0);
  if (numbers.factorize() != FactorizationStatus::ok) return false;
  WideVector wide;
  numbers.solve(rate.cast<Wide>(), wide);
  x = wide.cast<double>();
  return true;
}

}  // namespace fe
