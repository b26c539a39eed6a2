#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>
#include <numeric>

#include "modules/estimation/statistics.h"

namespace modules::fit {
namespace {

constexpr double kStep = 1e-3;           // Step of z in differences.
constexpr double kLeastStep = 1e-4;      // Smallest step: below, differences are lost in the tolerances of the values.
constexpr double kBound = 1e-6;          // Distance from a bound within which a value may be held there.
constexpr double kConverged = 1e-4;      // Tolerance of z, over a standard deviation.
constexpr double kSettled = 1e-6;        // Tolerance towards which the search continues if it can.
constexpr double kSpreadSettled = 1e-8;  // Relative change of a deviation.
constexpr double kNoInfluence = 1e-12;   // Influence, relative to the response, that counts as none.
constexpr double kEven = 1e-6;           // Difference of both sides over their distance from the middle.
constexpr double kAside = 0.03;          // Step of z if a search cannot begin.
constexpr double kLeastSlope = 0.05;     // Smallest slope of a loss, as a mean over its curve.

/// Results at one point z.
struct State {
  VectorXd z;
  std::vector<VectorXd> values;            ///< Values of each fitted curve, with its offset.
  std::vector<MatrixXd> slopes = {};       ///< Derivatives by z, after they were requested.
  std::vector<MatrixXd> information = {};  ///< J'J over the squares of stated deviations.
  std::vector<Index> even = {};            ///< Unknowns in which every curve is even here.
};
using StatePtr = std::shared_ptr<State>;

/// The normal equations at a state.
struct Normal {
  std::vector<Weighed> curves;
  MatrixXd matrix;    ///< A
  VectorXd gradient;  ///< dS/dz over 2
  double objective = 0.0;
  std::vector<Index> free = {};
  MatrixXd inverse = {};
};

/// Value in the unknown's own unit.
double shown(const Unknown& unknown, double u) { return unknown.is_log ? std::exp(u) : u; }
Estimate shown(const Unknown& unknown, Estimate e) {
  if (!unknown.is_log) return e;
  e.value = std::exp(e.value);
  return {e.value, e.deviation * e.value, std::exp(e.low), std::exp(e.high), e.degrees_of_freedom};
}

class Search {
 public:
  explicit Search(const Problem& problem)
      : problem_(problem), unknowns_(problem.unknowns), count_(static_cast<Index>(problem.unknowns.size())) {
    for (Unknown& unknown : unknowns_) {
      if (!unknown.is_log) continue;
      for (double* const value : {&unknown.from, &unknown.to, &unknown.start}) *value = std::log(*value);
      if (unknown.prior)
        unknown.prior = {std::log(unknown.prior->mean), unknown.prior->deviation / unknown.prior->mean};
    }
    for (std::size_t c = 0; c < problem.curves.size(); ++c) {
      const Curve& curve = problem.curves[c];
      losses_.push_back(curve.loss);
      measured_.emplace_back(
          Eigen::Map<const VectorXd>(curve.measured.data(), static_cast<Index>(curve.measured.size())));
      const auto n = static_cast<double>(std::max<std::size_t>(curve.rows, 1));
      const VectorXd& y = measured_.back();
      const bool estimated = is_estimated(c);
      spread_.push_back(1.0);
      floor_.push_back(0.0);
      if (estimated) {
        // Zero offset of a probe, which does not count as noise.
        const double middle = curve.offset ? y.mean() : 0.0;
        floor_[c] = std::max(1e-6 * (y.array() - middle).abs().maxCoeff(), 1e-150);
        spread_[c] = std::max(0.05 * std::sqrt((y.array() - y.mean()).square().sum() / n), floor_[c]);
      }
      if (curve.deviation.empty())
        weight_.emplace_back(VectorXd::Ones(y.size()));
      else
        weight_.emplace_back(
            Eigen::Map<const VectorXd>(curve.deviation.data(), static_cast<Index>(curve.deviation.size()))
                .cwiseInverse());
      reached_.emplace_back(problem.unknowns.size(), true);
      fitted_.push_back(curve.use == Curve::Use::fit);
    }
    step_ = VectorXd::Constant(count_, kStep);
    moved_ = MatrixXd::Zero(static_cast<Index>(fitted_.size()), count_);
    prior_ = MatrixXd::Zero(count_, count_);
    for (Index j = 0; j < count_; ++j)
      if (const auto& prior = unknown(j).prior) prior_(j, j) = std::pow(range(j) / prior->deviation, 2);
  }

  /// Evaluates the start; false if the function has no result there.
  bool look_at_start(const VectorXd& z, Result& result) {
    const StatePtr state = with_slopes(z);
    if (!state) return false;
    for (std::size_t c = 0; c < fitted_.size(); ++c)
      if (is_estimated(c) && spread_[c] == floor_[c])  // Whether all readings are equal.
        spread_[c] = std::max(spread_[c], 0.05 * (measured_[c] - state->values[c]).lpNorm<Eigen::Infinity>());
    first_spread_ = spread_;
    for (Index j = 0; j < count_; ++j) {
      if (unknown(j).is_offset) continue;
      bool moves = false;
      for (std::size_t c = 0; c < fitted_.size(); ++c) {
        if (!fitted_[c]) continue;
        moves = moves || moved_(static_cast<Index>(c), j) > kNoInfluence;
        reached_[c][static_cast<std::size_t>(j)] = is_moved(state->slopes, c, j);
      }
      looked_at_ = z;
      if (!moves) result.without_influence = static_cast<std::size_t>(j);
      if (!moves) return false;
    }
    return true;
  }

  VectorXd start(std::size_t k) const {
    VectorXd z(count_);
    for (Index j = 0; j < count_; ++j)
      z[j] = k == 0 ? (unknown(j).start - unknown(j).from) / range(j) : halton(k, static_cast<std::size_t>(j));
    return z;
  }

  /// Minimises the objective from a start on, with the deviations.
  Status run(const VectorXd& from) {
    spread_ = first_spread_;
    failure_.reset();
    held_by_.reset();
    VectorXd z = from;
    reaches_more(z);
    // A search cannot leave a point at which all curves are even, such as a tilt of 0.
    if (const StatePtr state = with_slopes(z))
      for (const Index j : state->even) {
        const VectorXd aside = kAside * VectorXd::Unit(count_, j), up = moved(z, aside), down = moved(z, -aside);
        const StatePtr above = at(up), below = at(down);
        if (above && (!below || objective(*above) <= objective(*below)))
          z = up;
        else if (below)
          z = down;
      }
    const bool jumps = std::ranges::any_of(losses_, [](const Loss& l) { return l.kind == Loss::Kind::cauchy; });
    Status status = Status::converged;
    if (jumps) {  // Far away most rows would look like outliers.
      const std::vector<Loss> given = losses_;
      for (Loss& loss : losses_) loss.kind = Loss::Kind::squares;
      status = settle(z, 2);
      losses_ = given;
      if (status == Status::no_equilibrium) return status;
    }
    do {
      status = settle(z, 3);
      if (status == Status::no_equilibrium) return status;
    } while (reaches_more(z) || takes_smaller_steps(z));
    if (status == Status::iteration_limit) status = settle(z, 17);
    place_ = z;
    return status;
  }

  const VectorXd& place() const { return place_; }
  const std::optional<Failure>& failure() const { return failure_; }
  /// Row whose missing result made the last of all attempts reduce a step.
  const std::optional<Failure>& held_by() const { return held_by_; }
  std::size_t iterations() const { return iterations_; }
  double value(std::size_t j) const {
    const auto at = static_cast<Index>(j);
    return shown(unknown(at), u(at, place_[at]));
  }

  /// Criterion for comparing starts.
  double criterion() {
    double sum = normal(*with_slopes(place_)).objective;
    for (std::size_t c = 0; c < fitted_.size(); ++c)
      if (is_estimated(c)) sum += 2.0 * static_cast<double>(problem_.curves[c].rows) * std::log(spread_[c]);
    return sum;
  }
  std::vector<double> spread() const { return spread_; }
  void set(const VectorXd& z, const std::vector<double>& spread) { place_ = z, spread_ = spread; }
  double distance(const VectorXd& a, const VectorXd& b) {
    const VectorXd d = a - b;
    return std::sqrt(std::max(0.0, d.dot(normal(*with_slopes(a)).matrix * d)));
  }

  void conclude(Status status, Result& result, bool whole);

 private:
  const Unknown& unknown(Index j) const { return unknowns_[static_cast<std::size_t>(j)]; }
  double range(Index j) const { return unknown(j).to - unknown(j).from; }
  bool is_estimated(std::size_t c) const {
    return problem_.curves[c].use == Curve::Use::fit && problem_.curves[c].deviation.empty();
  }
  double offset(std::size_t c, const VectorXd& z) const {
    const std::optional<std::size_t>& o = problem_.curves[c].offset;
    if (!o || problem_.curves[c].use != Curve::Use::fit) return 0.0;
    const auto j = static_cast<Index>(*o);
    return unknown(j).from + z[j] * range(j);
  }
  double u(Index j, double z) const { return unknown(j).from + z * range(j); }

  Request request(const VectorXd& z, std::vector<bool> curves) const {
    Request r{.values = {}, .curves = std::move(curves)};
    for (Index j = 0; j < count_; ++j) r.values.push_back(shown(unknown(j), u(j, z[j])));
    return r;
  }
  VectorXd values_of(const std::vector<double>& v) const {
    return Eigen::Map<const VectorXd>(v.data(), static_cast<Index>(v.size()));
  }

  StatePtr at(const VectorXd& z) {
    for (const StatePtr& known : known_)
      if (known->z == z) return known;
    const std::vector<Answer> answers = problem_.evaluate({request(z, fitted_)});
    if (answers[0].failure) {
      failure_ = answers[0].failure;
      return nullptr;
    }
    auto state = std::make_shared<State>(State{.z = z, .values = {}});
    for (std::size_t c = 0; c < fitted_.size(); ++c)
      state->values.emplace_back(fitted_[c] ? VectorXd(values_of(answers[0].values[c]).array() + offset(c, z))
                                            : VectorXd());
    known_.push_front(state);
    if (known_.size() > 4) known_.pop_back();
    return state;
  }

  StatePtr with_slopes(const VectorXd& z) {
    StatePtr state = at(z);
    if (!state || !state->slopes.empty()) return state;
    std::optional<std::vector<MatrixXd>> slopes = differentiate(z, state->values, fitted_);
    if (!slopes) return nullptr;
    state->slopes = *std::move(slopes);
    state->even = even_;
    for (std::size_t c = 0; c < fitted_.size(); ++c) {
      const MatrixXd weighted = fitted_[c] ? MatrixXd(weight_[c].asDiagonal() * state->slopes[c]) : MatrixXd(0, count_);
      state->information.emplace_back(weighted.transpose() * weighted);
    }
    return state;
  }

  /// d(f + o)/dz by differences, for the requested curves; none if a row has no result on either side.
  std::optional<std::vector<MatrixXd>> differentiate(const VectorXd& z, const std::vector<VectorXd>& values,
                                                     const std::vector<bool>& curves) {
    enum class Side { both, ahead, behind };
    std::vector<Request> requests;
    struct Asked {
      Index j;
      Side side;
      std::size_t first;
    };
    const auto ask = [&](std::vector<Asked>& list, Index j, Side side) {
      std::vector<bool> reached = curves;
      for (std::size_t c = 0; c < curves.size(); ++c)
        reached[c] = curves[c] && reached_[c][static_cast<std::size_t>(j)];
      if (std::ranges::none_of(reached, std::identity{})) return;
      list.push_back({j, side, requests.size()});
      for (const double steps : side == Side::both    ? std::array{-1.0, 1.0}
                                : side == Side::ahead ? std::array{1.0, 2.0}
                                                      : std::array{-1.0, -2.0}) {
        VectorXd moved = z;
        moved[j] += steps * step_[j];
        requests.push_back(request(moved, reached));
      }
    };
    even_.clear();
    std::vector<MatrixXd> slopes;
    for (std::size_t c = 0; c < curves.size(); ++c)
      slopes.emplace_back(MatrixXd::Zero(curves[c] ? static_cast<Index>(problem_.curves[c].rows) : 0, count_));
    std::vector<Asked> asked;
    for (Index j = 0; j < count_; ++j) {
      if (unknown(j).is_offset) continue;
      const bool bounded = unknown(j).is_bounded;
      ask(asked, j,
          bounded && z[j] < step_[j]         ? Side::ahead
          : bounded && z[j] > 1.0 - step_[j] ? Side::behind
                                             : Side::both);
    }
    for (int round = 0; round < 3 && !asked.empty(); ++round) {
      const std::vector<Answer> answers = problem_.evaluate(requests);
      requests.clear();
      std::vector<Asked> again;
      for (const auto& [j, side, first] : asked) {
        const Answer &one = answers[first], &two = answers[first + 1];
        if (one.failure || two.failure) {
          failure_ = one.failure ? one.failure : two.failure;
          // A central difference without a result on one side uses the other, a one-sided one the opposite side.
          const Side other = side == Side::both    ? (one.failure ? Side::ahead : Side::behind)
                             : side == Side::ahead ? Side::behind
                                                   : Side::ahead;
          const double last = z[j] + (other == Side::ahead ? 2.0 : -2.0) * step_[j];
          if (round == 2 || (unknown(j).is_bounded && !(last >= 0.0 && last <= 1.0))) return std::nullopt;
          ask(again, j, other);
          continue;
        }
        const double h = side == Side::behind ? -step_[j] : step_[j];
        bool moves = false, is_even = side == Side::both;
        for (std::size_t c = 0; c < curves.size(); ++c) {
          if (!curves[c] || !reached_[c][static_cast<std::size_t>(j)]) continue;
          const VectorXd a = values_of(one.values[c]), b = values_of(two.values[c]);
          const VectorXd here = values[c].array() - offset(c, z);
          slopes[c].col(j) =
              side == Side::both ? VectorXd((b - a) / (2.0 * h)) : VectorXd((-3.0 * here + 4.0 * a - b) / (2.0 * h));
          const Eigen::ArrayXd by = (a - here).array().abs().max((b - here).array().abs());
          moved_(static_cast<Index>(c), j) = (by > 0.0).select(by / here.array().abs(), 0.0).maxCoeff();
          moves = moves || moved_(static_cast<Index>(c), j) > kNoInfluence;
          is_even = is_even && ((b - a).array().abs() <= kEven * by).all();
        }
        if (moves && is_even) even_.push_back(j);
      }
      asked = std::move(again);
    }
    for (std::size_t c = 0; c < curves.size(); ++c)
      if (const auto& o = problem_.curves[c].offset; o && curves[c] && fitted_[c])
        slopes[c].col(static_cast<Index>(*o)).setConstant(range(static_cast<Index>(*o)));
    return slopes;
  }

  /// Whether an unknown changes a curve, by the last differences, more than the rounding between batches does.
  bool is_moved(const std::vector<MatrixXd>& slopes, std::size_t c, Index j) const {
    return moved_(static_cast<Index>(c), j) > kNoInfluence || (slopes[c].col(j).array() != 0.0).any();
  }

  /// Whether an unknown changes a curve here that it did not change before: effects beyond a threshold count from then
  /// on.
  bool reaches_more(const VectorXd& z) {
    const StatePtr state = looked_at_ == z ? nullptr : at(z);
    if (!state) return false;
    looked_at_ = z;
    const std::vector<std::vector<bool>> known = reached_;
    for (std::vector<bool>& of_curve : reached_) of_curve.flip();
    const std::optional<Failure> failure = failure_;
    const std::optional<std::vector<MatrixXd>> slopes = differentiate(z, state->values, fitted_);
    failure_ = failure;
    reached_ = known;
    if (!slopes) return false;
    bool more = false;
    for (Index j = 0; j < count_; ++j)
      for (std::size_t c = 0; c < fitted_.size(); ++c) {
        if (unknown(j).is_offset || known[c][static_cast<std::size_t>(j)]) continue;
        if (!fitted_[c] || !is_moved(*slopes, c, j)) continue;
        reached_[c][static_cast<std::size_t>(j)] = more = true;
      }
    if (more) known_.clear();
    return more;
  }

  /// Whether the step of an unknown near an end of its bounds, which may be wide, had to shrink: if a quarter of it
  /// gives slopes that differ by more than a hundredth.
  bool takes_smaller_steps(const VectorXd& z) {
    const StatePtr state = with_slopes(z);
    if (!state) return false;
    bool any = false;
    for (Index j = 0; j < count_; ++j) {
      const double to_bound = std::min(z[j], 1.0 - z[j]), before = step_[j];
      if (unknown(j).is_offset || unknown(j).is_log || to_bound > 20.0 * before || before <= kLeastStep) continue;
      const std::vector<std::vector<bool>> known = reached_;
      for (std::vector<bool>& of_curve : reached_)
        for (std::size_t k = 0; k < of_curve.size(); ++k) of_curve[k] = of_curve[k] && static_cast<Index>(k) == j;
      step_[j] = std::max(kLeastStep, 0.25 * before);
      const std::optional<std::vector<MatrixXd>> slopes = differentiate(z, state->values, fitted_);
      reached_ = known;
      double off = 0.0, all = 0.0;
      for (std::size_t c = 0; slopes && c < fitted_.size(); ++c) {
        if (!fitted_[c]) continue;
        const VectorXd weighed = weight_[c].cwiseProduct(state->slopes[c].col(j)) / spread_[c];
        off += (weight_[c].cwiseProduct((*slopes)[c].col(j)) / spread_[c] - weighed).squaredNorm();
        all += weighed.squaredNorm();
      }
      if (!(off > 1e-4 * all))
        step_[j] = before;
      else
        any = true;
    }
    if (any) known_.clear();
    return any;
  }

  /// Residual of one reading, over its deviation.
  double scaled(const State& s, std::size_t c, Index i) const {
    return (measured_[c][i] - s.values[c][i]) * weight_[c][i] / spread_[c];
  }
  double objective(const State& s) const {
    double sum = 0.0;
    for (std::size_t c = 0; c < fitted_.size(); ++c)
      for (Index i = 0; i < s.values[c].size(); ++i) sum += robust(losses_[c], scaled(s, c, i)).rho;
    for (Index j = 0; j < count_; ++j)
      if (const auto& p = unknown(j).prior) sum += std::pow((u(j, s.z[j]) - p->mean) / p->deviation, 2);
    return sum;
  }

  /// `held`: an unknown that is fixed.
  Normal normal(const State& s, std::optional<Index> held = {}) const {
    Normal n{.curves = {}, .matrix = prior_, .gradient = VectorXd::Zero(count_), .objective = objective(s)};
    for (Index j = 0; j < count_; ++j)
      if (const auto& p = unknown(j).prior)
        n.gradient[j] += range(j) * (u(j, s.z[j]) - p->mean) / (p->deviation * p->deviation);
    for (std::size_t c = 0; c < fitted_.size(); ++c) {
      Weighed w{.information = s.information[c] / (spread_[c] * spread_[c]),
                .has_own_spread = is_estimated(c) || losses_[c].is_robust(),
                .is_estimated = is_estimated(c)};
      if (fitted_[c]) {
        VectorXd pull(s.values[c].size());
        double slope = 0.0;
        for (Index i = 0; i < pull.size(); ++i) {
          const Robust r = robust(losses_[c], scaled(s, c, i));
          pull[i] = r.psi * weight_[c][i] / spread_[c];
          slope += r.slope;
        }
        w.a = losses_[c].is_robust() ? std::max(slope / static_cast<double>(pull.size()), kLeastSlope) : 1.0;
        n.gradient -= s.slopes[c].transpose() * pull;
        n.matrix += w.a * w.information;
      }
      n.curves.push_back(std::move(w));
    }
    for (Index j = 0; j < count_; ++j)
      if (j != held && pushed_out(s.z, n.gradient, j) == 0) n.free.push_back(j);
    n.inverse = inverse(n.matrix, n.free);
    for (std::size_t c = 0; c < fitted_.size(); ++c) {
      Weighed& w = n.curves[c];
      if (!fitted_[c]) continue;
      w.redundancy = static_cast<double>(s.values[c].size()) - w.a * (n.inverse.array() * w.information.array()).sum();
    }
    return n;
  }

  /// -1 or 1: at its lower or upper bound, beyond which the objective would be smaller.
  int pushed_out(const VectorXd& z, const VectorXd& gradient, Index j) const {
    if (!unknown(j).is_bounded) return 0;
    if (z[j] <= kBound && gradient[j] > 0.0) return -1;
    return z[j] >= 1.0 - kBound && gradient[j] < 0.0 ? 1 : 0;
  }

  /// Sets the estimated deviations at this state; returns their largest relative change.
  double set_spread(const State& s) {
    const std::vector<double> before = spread_;
    for (int round = 0; round < 1000; ++round) {
      double change = 0.0;
      const Normal n = normal(s);
      for (std::size_t c = 0; c < fitted_.size(); ++c) {
        if (!is_estimated(c)) continue;
        double sum = 0.0;
        for (Index i = 0; i < s.values[c].size(); ++i) {
          const double r = scaled(s, c, i);
          sum += robust(losses_[c], r).psi * r;
        }
        const double expected = consistency(losses_[c]) * std::max(n.curves[c].redundancy, 0.5);
        const double next = std::max(spread_[c] * std::sqrt(sum / expected), floor_[c]);
        change = std::max(change, std::abs(std::log(next / spread_[c])));
        spread_[c] = next;
      }
      if (change < 1e-2 * kSpreadSettled) break;
    }
    double change = 0.0;
    for (std::size_t c = 0; c < spread_.size(); ++c)
      change = std::max(change, std::abs(std::log(spread_[c] / before[c])));
    return change;
  }

  /// Newton's step; components that would leave their bounds stop there, and the others account for that.
  VectorXd step_of(const Normal& n, const VectorXd& z) const {
    VectorXd step = -(n.inverse * n.gradient);
    std::vector<Index> free = n.free;
    for (std::size_t round = 0; round < n.free.size(); ++round) {
      const auto leaves = [&](Index j) {
        return unknown(j).is_bounded && !(z[j] + step[j] >= 0.0 && z[j] + step[j] <= 1.0);
      };
      std::vector<Index> stopped;
      for (const Index j : free)
        if (leaves(j)) stopped.push_back(j);
      if (stopped.empty()) break;
      for (const Index j : stopped) {
        step[j] = step[j] < 0.0 ? -z[j] : 1.0 - z[j];
        std::erase(free, j);
      }
      VectorXd gradient = n.gradient;
      for (const Index j : n.free)
        if (std::ranges::find(free, j) == free.end()) gradient += n.matrix.col(j) * step[j];
      const MatrixXd inverse_of_free = inverse(n.matrix, free);
      const VectorXd others = -(inverse_of_free * gradient);
      for (const Index j : free) step[j] = others[j];
    }
    return step;
  }

  VectorXd moved(const VectorXd& z, const VectorXd& step) const {
    VectorXd next = z + step;
    for (Index j = 0; j < count_; ++j)
      if (unknown(j).is_bounded) next[j] = std::clamp(next[j], 0.0, 1.0);
    return next;
  }

  /// Ceres' search at given deviations; `held` is fixed.
  bool search(VectorXd& z, bool roughly, std::optional<Index> held = {}) {
    std::vector<Index> moving;
    std::vector<bool> bounded;
    std::vector<double> place;
    for (Index j = 0; j < count_; ++j) {
      if (j == held) continue;
      moving.push_back(j);
      bounded.push_back(unknown(j).is_bounded);
      place.push_back(z[j]);
    }
    std::size_t rows = 0;
    for (std::size_t c = 0; c < fitted_.size(); ++c)
      if (fitted_[c]) rows += problem_.curves[c].rows;
    std::vector<Index> priors;
    for (const Index j : moving)
      if (unknown(j).prior) priors.push_back(j);
    const Residuals residuals = [&](const double* x, double* r, double* derivatives) {
      VectorXd here = z;
      for (std::size_t k = 0; k < moving.size(); ++k) here[moving[k]] = x[k];
      const StatePtr s = derivatives != nullptr ? with_slopes(here) : at(here);
      if (!s) return false;
      Index row = 0;
      const auto width = static_cast<Index>(moving.size());
      const auto derivative = [&](Index at_row, Index k) -> double& { return derivatives[at_row * width + k]; };
      for (std::size_t c = 0; c < fitted_.size(); ++c)
        for (Index i = 0; i < s->values[c].size(); ++i, ++row) {
          const double scaled_residual = scaled(*s, c, i);
          const Robust loss = robust(losses_[c], scaled_residual);
          // Residual whose square is rho.
          const double root = std::copysign(std::sqrt(loss.rho), scaled_residual);
          const double by_r = std::abs(root) > 1e-100 ? loss.psi / root : 1.0;
          r[row] = root;
          if (derivatives != nullptr)
            for (Index k = 0; k < width; ++k)
              derivative(row, k) =
                  -by_r * s->slopes[c](i, moving[static_cast<std::size_t>(k)]) * weight_[c][i] / spread_[c];
        }
      for (const Index j : priors) {
        const auto& p = *unknown(j).prior;
        r[row] = (u(j, here[j]) - p.mean) / p.deviation;
        if (derivatives != nullptr)
          for (Index k = 0; k < width; ++k)
            derivative(row, k) = moving[static_cast<std::size_t>(k)] == j ? range(j) / p.deviation : 0.0;
        ++row;
      }
      return true;
    };
    if (moving.empty()) return true;
    const Minimum found = minimise(residuals, rows + priors.size(), bounded, roughly, place);
    iterations_ += found.iterations;
    for (std::size_t k = 0; k < moving.size(); ++k) z[moving[k]] = place[k];
    return found.has_converged;
  }

  /// Steps of the normal equations, with the deviations, until nothing changes; false if one fails.
  bool polish(VectorXd& z, double& norm, std::optional<Index> held = {}, double enough = kSettled) {
    double last = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 40; ++k) {
      const StatePtr s = with_slopes(z);
      if (!s) return false;
      const double spread_change = held ? 0.0 : set_spread(*s);
      const Normal n = normal(*s, held);
      const VectorXd step = -(n.inverse * n.gradient);
      norm = std::sqrt(std::max(0.0, step.dot(n.matrix * step)));
      if (norm <= enough && spread_change < kSpreadSettled) return true;
      // Limit of the accuracy of differences.
      if (k > 8 && norm <= kConverged && norm > 0.5 * last && spread_change < kSpreadSettled) return true;
      last = norm;
      ++iterations_;
      const VectorXd bounded = step_of(n, z);
      double share = 1.0;
      for (int halved = 0;; ++halved, share *= 0.5) {
        const VectorXd next = moved(z, share * bounded);
        const StatePtr there = at(next);
        // Differences are not exact slopes.
        if (there && objective(*there) <= n.objective + 1e-10 * n.objective + 1e-9) {
          z = next;
          break;
        }
        if (halved == 8) return norm <= kConverged && spread_change < kSpreadSettled;
      }
      if (norm < 1.0) go_on(z, *s, held, 0.3 * enough);
    }
    return norm <= kConverged;
  }

  /// Further steps with the slopes of a nearby state, at a fraction of the effort.
  void go_on(VectorXd& z, const State& near, std::optional<Index> held, double enough) {
    for (int k = 0; k < 30; ++k) {
      const StatePtr here = at(z);
      if (!here) return;
      State s{.z = z, .values = here->values, .slopes = near.slopes, .information = near.information};
      const double spread_change = held ? 0.0 : set_spread(s);
      const Normal n = normal(s, held);
      const VectorXd step = -(n.inverse * n.gradient);
      if (step.dot(n.matrix * step) <= enough * enough && spread_change < 0.3 * kSpreadSettled) return;
      const VectorXd next = moved(z, step_of(n, z));
      const StatePtr there = at(next);
      if (!there || objective(*there) > n.objective) return;
      z = next;
    }
  }

  Status settle(VectorXd& z, int attempts) {
    double norm = 0.0;
    for (int k = 0; k < attempts; ++k) {
      failure_.reset();
      search(z, k == 0);
      if (!with_slopes(z)) return Status::no_equilibrium;
      if (polish(z, norm)) return Status::converged;
      if (!with_slopes(z)) return Status::no_equilibrium;
    }
    held_by_ = failure_;
    return Status::iteration_limit;
  }

  void set_profile(Index j, const Normal& n, const Covariance& covariance, double level, UnknownResult& result);

  const Problem& problem_;
  std::vector<Unknown> unknowns_;  ///< Unknowns in u: the value, or its logarithm.
  Index count_;
  std::vector<Loss> losses_;
  std::vector<VectorXd> measured_, weight_;
  std::vector<double> spread_, first_spread_, floor_;
  std::vector<std::vector<bool>> reached_;
  VectorXd looked_at_;       ///< Point of the last slopes of all curves.
  VectorXd step_;            ///< Step of differences in z.
  MatrixXd moved_;           ///< Effect in the last differences, relative to the response: one row per curve.
  std::vector<Index> even_;  ///< Unknowns with equal differences on both sides.
  std::vector<bool> fitted_;
  MatrixXd prior_;
  VectorXd place_;
  std::deque<StatePtr> known_;
  std::optional<Failure> failure_, held_by_;
  std::size_t iterations_ = 0;
};

void Search::set_profile(Index j, const Normal& n, const Covariance& covariance, double level, UnknownResult& result) {
  const double deviation = std::sqrt(covariance.full(j, j));
  const double t = quantile(level, result.estimate->degrees_of_freedom);
  const double target = t * std::sqrt(covariance.full(j, j) / covariance.first(j, j));
  for (const double sense : {-1.0, 1.0}) {
    // sqrt(S_p - S) minus the target, over z_j; nearly straight.
    double x0 = place_[j], y0 = -target, x = x0 + sense * t * deviation;
    VectorXd from = place_;
    std::optional<double> end;
    bool at_edge = false, beyond = false;
    double inside = x0, inside_y = y0, outside = std::numeric_limits<double>::quiet_NaN(), outside_y = 0.0;
    for (int k = 0; k < 30; ++k) {
      const double edge = sense < 0.0 ? 0.0 : 1.0;
      if (unknown(j).is_bounded && sense * (x - edge) >= 0.0) {
        beyond = at_edge;
        if (at_edge) break;  // Still below the target there.
        x = edge;
      }
      // The other unknowns follow along the last direction.
      std::vector<Index> others = n.free;
      std::erase(others, j);
      VectorXd step = -(modules::fit::inverse(n.matrix, others) * n.matrix.col(j)) * (x - from[j]);
      VectorXd z = moved(from, step);
      z[j] = x;
      double norm = 0.0;
      if (!polish(z, norm, j, 1e-3)) {
        search(z, false, j);
        if (!polish(z, norm, j, 1e-3)) break;
      }
      from = z;
      const double rise = objective(*with_slopes(z)) - norm * norm - n.objective;
      const double y = std::sqrt(std::max(0.0, rise)) - target;
      at_edge = unknown(j).is_bounded && x == edge;
      beyond = at_edge && y < 0.0;
      if (beyond) break;
      (y < 0.0 ? inside : outside) = x;
      (y < 0.0 ? inside_y : outside_y) = y;
      double next = x - y * (x - x0) / (y - y0);
      if (!std::isfinite(next)) break;
      if (!std::isnan(outside) && !(sense * (next - inside) > 0.0 && sense * (outside - next) > 0.0))
        next = inside - inside_y * (outside - inside) / (outside_y - inside_y);
      x0 = x, y0 = y;
      if (std::abs(next - x) <= 2e-4 * deviation) {
        end = next;
        break;
      }
      x = next;
    }
    if (end) (sense < 0.0 ? result.profile_low : result.profile_high) = shown(unknown(j), u(j, *end));
    result.profile_failed = result.profile_failed || (!end && !beyond);
  }
}

void Search::conclude(Status status, Result& result, bool whole) {
  const StatePtr state = with_slopes(place_);
  Normal n = normal(*state);
  result.objective = n.objective;
  result.status = std::min(result.status, status);
  result.unknowns.assign(problem_.unknowns.size(), {});

  // Combinations that the data do not determine, over all unknowns.
  std::size_t rows = 0;
  for (const VectorXd& v : state->values) rows += static_cast<std::size_t>(v.size());
  Spectrum spectrum;
  if (rows * problem_.unknowns.size() < 4'000'000) {
    MatrixXd all(static_cast<Index>(rows) + count_, count_);
    Index row = 0;
    for (std::size_t c = 0; c < fitted_.size(); ++c) {
      if (!fitted_[c]) continue;
      const Index m = state->values[c].size();
      all.middleRows(row, m) = std::sqrt(n.curves[c].a) / spread_[c] * weight_[c].asDiagonal() * state->slopes[c];
      row += m;
    }
    all.bottomRows(count_) = prior_.cwiseSqrt();
    spectrum = exact_spectrum(all);
  } else {
    spectrum = spectrum_of(n.matrix);
  }
  std::vector<bool> named(problem_.unknowns.size());
  const auto add = [&](Unidentified direction) {
    if (direction.direction[0] < 0.0)
      for (double& v : direction.direction) v = -v;
    for (const std::size_t j : direction.unknowns) named[j] = true;
    result.unidentified.push_back(std::move(direction));
  };
  result.singular_value_ratios.assign(spectrum.ratios.begin(), spectrum.ratios.end());
  for (Index k = 0; k < spectrum.ratios.size(); ++k) {
    if (spectrum.is_identifiable(k)) continue;
    Unidentified direction{.unknowns = {}, .direction = {}, .ratio = spectrum.ratios[k]};
    for (std::size_t i = 0; i < spectrum.columns.size(); ++i) {
      const double v = spectrum.vectors(static_cast<Index>(i), k);
      if (std::abs(v) < 0.1) continue;
      direction.unknowns.push_back(static_cast<std::size_t>(spectrum.columns[i]));
      direction.direction.push_back(v);
    }
    add(std::move(direction));
  }
  for (Index j = 0; j < count_; ++j)
    if (std::ranges::find(spectrum.columns, j) == spectrum.columns.end()) {
      result.singular_value_ratios.push_back(0.0);
      add({.unknowns = {static_cast<std::size_t>(j)}, .direction = {1.0}, .ratio = 0.0});
    }
  if (!result.unidentified.empty()) result.status = std::min(result.status, Status::not_identifiable);

  // Named unknowns are never held.
  n.free.clear();
  for (Index j = 0; j < count_; ++j) {
    const auto at = static_cast<std::size_t>(j);
    UnknownResult& one = result.unknowns[at];
    one.is_identified = !named[at];
    if (named[at] || pushed_out(state->z, n.gradient, j) == 0)
      n.free.push_back(j);
    else
      one.at_bound = pushed_out(state->z, n.gradient, j);
    if (one.is_identified) one.value = shown(unknown(j), u(j, state->z[j]));
  }
  n.inverse = inverse(n.matrix, n.free);

  double tested = 0.0, tested_redundancy = 0.0;
  bool is_tested = false;
  for (std::size_t c = 0; c < fitted_.size(); ++c) {
    if (!fitted_[c]) continue;
    Weighed& w = n.curves[c];
    const auto m = static_cast<double>(state->values[c].size());
    w.redundancy = m - w.a * (n.inverse.array() * w.information.array()).sum();
    double squares = 0.0, sum = 0.0;
    for (Index i = 0; i < state->values[c].size(); ++i) {
      const double r = scaled(*state, c, i);
      squares += std::pow(robust(losses_[c], r).psi, 2);
      sum += r * r;
    }
    if (losses_[c].is_robust() && w.redundancy > 0.0) w.b = squares / w.redundancy;
    result.degrees_of_freedom += w.redundancy;
    const bool spent = (w.is_estimated && w.redundancy < 1.0 - 1e-9) || (losses_[c].is_robust() && w.a <= kLeastSlope);
    if (spent && !result.without_redundancy) result.without_redundancy = c;
    if (w.is_estimated || losses_[c].is_robust()) continue;
    is_tested = true;
    tested += sum;
    tested_redundancy += w.redundancy;
  }
  if (is_tested) {
    result.chi_square = tested;
    if (tested_redundancy > 1e-9) {
      result.reduced_chi_square = tested / tested_redundancy;
      result.p_value = chi_square_beyond(tested, tested_redundancy);
    }
  }
  if (result.without_redundancy) result.status = std::min(result.status, Status::no_redundancy);
  if (!whole) return;
  const bool has_deviations = !result.without_redundancy;
  const Covariance covariance = covariance_of(n.curves, prior_, n.inverse);
  const double level = problem_.level;

  for (const Index j : n.free) {
    UnknownResult& one = result.unknowns[static_cast<std::size_t>(j)];
    if (!one.is_identified || !has_deviations) continue;
    result.with_deviation.push_back(static_cast<std::size_t>(j));
    const Estimate e = covariance.of(VectorXd::Unit(count_, j) * range(j), u(j, state->z[j]), level);
    one.prior_decides = unknown(j).prior && e.deviation > 0.9 * unknown(j).prior->deviation;
    one.estimate = shown(unknown(j), e);
  }
  for (const std::size_t i : result.with_deviation) {
    std::vector<double>&row = result.covariance.emplace_back(), &correlations = result.correlation.emplace_back();
    const auto a = static_cast<Index>(i);
    const auto by_u = [&](std::size_t k) { return problem_.unknowns[k].is_log ? *result.unknowns[k].value : 1.0; };
    for (const std::size_t k : result.with_deviation) {
      const auto b = static_cast<Index>(k);
      const double c = covariance.full(a, b);
      row.push_back(c * range(a) * range(b) * by_u(i) * by_u(k));
      correlations.push_back(i == k ? 1.0 : c / std::sqrt(covariance.full(a, a) * covariance.full(b, b)));
    }
  }
  for (Unidentified& direction : result.unidentified) {
    if (direction.unknowns.size() != 2) continue;
    const auto a = static_cast<Index>(direction.unknowns[0]), b = static_cast<Index>(direction.unknowns[1]);
    if (unknown(a).is_log != unknown(b).is_log) continue;
    direction.factor = -(direction.direction[0] * range(a) / spectrum.length[a]) /
                       (direction.direction[1] * range(b) / spectrum.length[b]);
    const VectorXd g = VectorXd::Unit(count_, a) * range(a) + direction.factor * VectorXd::Unit(count_, b) * range(b);
    const double value = u(a, state->z[a]) + direction.factor * u(b, state->z[b]);
    direction.combination =
        shown(unknown(a), has_deviations ? covariance.of(g, value, level) : Estimate{.value = value});
  }

  // The other curves
  const bool everywhere = has_deviations && result.unidentified.empty();
  std::vector<bool> others(fitted_.size());
  for (std::size_t c = 0; c < others.size(); ++c)
    others[c] = !fitted_[c] && (everywhere || problem_.curves[c].use == Curve::Use::compare);
  std::vector<VectorXd> values = state->values;
  std::vector<MatrixXd> slopes = state->slopes;
  if (std::ranges::any_of(others, std::identity{})) {
    // A curve without a result does not affect the others.
    std::vector<Request> requests;
    std::vector<std::size_t> asked;
    for (std::size_t c = 0; c < others.size(); ++c) {
      if (!others[c]) continue;
      std::vector<bool> alone(others.size());
      alone[c] = true;
      requests.push_back(request(state->z, alone));
      asked.push_back(c);
    }
    const std::vector<Answer> answers = problem_.evaluate(requests);
    std::vector<bool> answered(others.size());
    for (std::size_t k = 0; k < asked.size(); ++k) {
      answered[asked[k]] = !answers[k].failure;
      if (!answers[k].failure)
        values[asked[k]] = values_of(answers[k].values[asked[k]]);
      else if (!result.failure)
        result.failure = answers[k].failure;
    }
    std::optional<std::vector<MatrixXd>> found = differentiate(state->z, values, answered);
    if (!found && !result.failure) result.failure = failure_;
    if (result.failure) result.status = Status::no_equilibrium;
    for (const std::size_t c : asked)
      if (found && answered[c])
        slopes[c] = std::move((*found)[c]);
      else
        values[c].resize(0);
  }
  for (std::size_t c = 0; c < fitted_.size(); ++c) {
    CurveResult& curve = result.curves[c];
    const bool banded = has_deviations && (fitted_[c] || everywhere);
    double mean_offset = 0.0;
    if (problem_.curves[c].has_free_mean && values[c].size() > 0) mean_offset = (measured_[c] - values[c]).mean();
    for (Index i = 0; i < values[c].size(); ++i) {
      const double value = values[c][i] + mean_offset;
      curve.fitted.push_back(value);
      if (banded) {
        const Estimate e = covariance.of(slopes[c].row(i).transpose(), value, level);
        curve.band_deviation.push_back(e.deviation);
        curve.low.push_back(e.low);
        curve.high.push_back(e.high);
      }
      if (measured_[c].size() == 0) continue;
      curve.residual.push_back(measured_[c][i] - value);
      if (!fitted_[c]) continue;
      curve.deviation.push_back(spread_[c] / weight_[c][i]);
      curve.is_without_noise = is_estimated(c) && spread_[c] <= floor_[c];
      curve.weight.push_back(robust(losses_[c], scaled(*state, c, i)).weight);
    }
    if (curve.residual.empty()) continue;
    const Eigen::Map<const VectorXd> residual(curve.residual.data(), static_cast<Index>(curve.residual.size()));
    curve.rms = std::sqrt(residual.squaredNorm() / static_cast<double>(residual.size()));
    const double whole_spread = (measured_[c].array() - measured_[c].mean()).square().sum();
    if (measured_[c].maxCoeff() > measured_[c].minCoeff())
      curve.r_squared = 1.0 - residual.squaredNorm() / whole_spread;
    curve.runs = runs_of(curve.residual);
    if (!fitted_[c]) continue;
    curve.redundancy = n.curves[c].redundancy;
    double chi = 0.0;
    for (Index i = 0; i < residual.size(); ++i) chi += std::pow(scaled(*state, c, i), 2);
    curve.chi_square = chi;
  }

  for (const std::size_t j : problem_.profile)
    if (result.unknowns[j].estimate) set_profile(static_cast<Index>(j), n, covariance, level, result.unknowns[j]);
}

}  // namespace

Result solve(const Problem& problem) {
  Search search(problem);
  Result result;
  result.status = Status::converged;
  result.curves.resize(problem.curves.size());
  result.unknowns.resize(problem.unknowns.size());
  const VectorXd first = search.start(0);
  if (!search.look_at_start(first, result)) {
    result.status = Status::no_equilibrium;
    result.failure = search.failure();
    result.failed_at_start = true;
    return result;
  }
  struct Found {
    VectorXd z;
    std::vector<double> spread;
    Status status;
    std::optional<Failure> held_by;
  };
  std::optional<std::size_t> best;
  std::vector<Found> found;
  std::optional<Failure> first_failure;
  for (std::size_t k = 0; k < problem.starts; ++k) {
    const Status status = search.run(search.start(k));
    StartResult& start = result.starts.emplace_back(StartResult{.status = status});
    found.push_back({search.place(), search.spread(), status, search.held_by()});
    if (status == Status::no_equilibrium) {
      if (!first_failure) first_failure = search.failure();
      continue;
    }
    Result ends;
    ends.status = Status::converged;
    search.conclude(status, ends, false);
    start.status = ends.status;
    start.objective = search.criterion();
    for (std::size_t j = 0; j < problem.unknowns.size(); ++j) start.values.push_back(search.value(j));
    // Of two at the same minimum the converged one is preferred.
    const auto rank = [&](std::size_t at) {
      const StartResult& s = result.starts[at];
      return *s.objective + (s.status == Status::iteration_limit ? 1e-3 : 0.0);
    };
    if (!best || rank(k) < rank(*best)) best = k;
  }
  if (!best) {
    result.status = Status::no_equilibrium;
    result.failure = first_failure;
    return result;
  }
  result.starts[*best].is_best = true;
  search.set(found[*best].z, found[*best].spread);
  search.conclude(found[*best].status, result, true);
  if (result.status == Status::iteration_limit) result.held_by = found[*best].held_by;
  for (std::size_t k = 0; k < found.size(); ++k) {
    StartResult& start = result.starts[k];
    if (k == *best || !start.objective || *start.objective > *result.starts[*best].objective + 4.0) continue;
    start.is_another_minimum = result.unidentified.empty() && search.distance(found[*best].z, found[k].z) > 0.1;
  }
  result.iterations = search.iterations();
  return result;
}

}  // namespace modules::fit
