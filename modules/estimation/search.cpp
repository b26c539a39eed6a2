#include "modules/estimation/search.h"

#include <algorithm>
#include <cmath>

#include "modules/estimation/minimise.h"

namespace modules::fit {
namespace {

constexpr double kConverged = 1e-4;  // Largest step of a converged search, in standard deviations.
constexpr double kSettled = 1e-6;    // Step to which the search continues where it can.
constexpr double kEnough = 1e-3;     // Step that is enough near a minimum whose unknown is held.
constexpr double kAside = 0.03;      // Step aside in z, where a search cannot begin.

using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Residuals whose squares sum up to the objective, with their derivatives by some unknowns.
bool put_residuals(const Search& s, const VectorXd& z, const std::vector<Index>& moving, double* residuals,
                   double* derivatives) {
  const Model& model = s.model;
  const StatePtr state = derivatives != nullptr ? s.function.with_slopes(z) : s.function.at(z);
  if (!state) return false;
  Index row = 0;
  const auto width = static_cast<Index>(moving.size());
  for (const std::size_t c : model.fitted) {
    const Robust loss = robust_at(model, *state, c, s.spread);
    const Index rows = loss.rho.size();
    const ArrayXd root = loss.rho.sqrt() * loss.scaled.sign();
    Eigen::Map<ArrayXd>(residuals + row, rows) = root;
    if (derivatives != nullptr) {
      const ArrayXd by_r = (root.abs() > 1e-100).select(loss.psi / root, 1.0);
      Eigen::Map<Rows>(derivatives + row * width, rows, width) =
          (-by_r * model.curves[c].weight.array() / s.spread[c]).matrix().asDiagonal() *
          state->slopes.by_z[c](Eigen::all, moving);
    }
    row += rows;
  }
  for (Index k = 0; k < width; ++k) {
    const Index j = moving[static_cast<std::size_t>(k)];
    const auto& prior = model.unknown(j).prior;
    if (!prior) continue;
    residuals[row] = (model.u(j, z[j]) - prior->mean) / prior->deviation;
    if (derivatives != nullptr)
      Eigen::Map<VectorXd>(derivatives + row * width, width) =
          VectorXd::Unit(width, k) * model.range(j) / prior->deviation;
    ++row;
  }
  return true;
}

/// Ceres' search at given deviations.
void search_by_ceres(Search& s, bool roughly) {
  std::vector<Index> moving;
  std::vector<bool> bounded;
  std::size_t rows = 0;
  for (Index j = 0; j < s.model.count(); ++j) {
    if (j == s.held) continue;
    moving.push_back(j);
    bounded.push_back(s.model.unknown(j).is_bounded);
    rows += s.model.unknown(j).prior ? 1 : 0;
  }
  if (moving.empty()) return;
  for (const std::size_t c : s.model.fitted) rows += s.model.problem.curves[c].rows;
  const VectorXd start = s.z(moving);
  std::vector<double> place(start.begin(), start.end());
  const Residuals residuals = [&](const double* x, double* r, double* derivatives) {
    VectorXd here = s.z;
    here(moving) = Eigen::Map<const VectorXd>(x, start.size());
    return put_residuals(s, here, moving, r, derivatives);
  };
  s.iterations += minimise(residuals, rows, bounded, roughly, place);
  s.z(moving) = vector_of(place);
}

double set_spread(Search& s, const State& state) { return s.held ? 0.0 : set_spread(s.model, state, s.spread); }

/// Further steps with the slopes of a state nearby, at a fraction of the effort.
void go_on(Search& s, const State& near, double enough) {
  for (int k = 0; k < 30; ++k) {
    const StatePtr here = s.function.at(s.z);
    if (!here) return;
    const State state{.z = s.z, .values = here->values, .slopes = near.slopes, .information = near.information};
    const double spread_change = set_spread(s, state);
    const Normal n = normal_at(s.model, state, s.spread, s.held);
    if (newton_step(n).norm <= enough && spread_change < 0.3 * kSpreadSettled) return;
    const VectorXd next = s.model.moved(s.z, step_within_bounds(s.model, n, s.z));
    const StatePtr there = s.function.at(next);
    if (!there || objective(s.model, *there, s.spread) > n.objective) return;
    s.z = next;
  }
}

/// Takes Newton's step, or the largest share of it that does not lead up.
bool take_step(Search& s, const Normal& n) {
  const VectorXd whole = step_within_bounds(s.model, n, s.z);
  double share = 1.0;
  for (int halved = 0; halved <= 8; ++halved, share *= 0.5) {
    const VectorXd next = s.model.moved(s.z, share * whole);
    const StatePtr there = s.function.at(next);
    // Differences are not the slope to the last digit.
    if (!there || !(objective(s.model, *there, s.spread) <= n.objective + 1e-10 * n.objective + 1e-9)) continue;
    s.z = next;
    return true;
  }
  return false;
}

/// Steps of the normal equations, deviations with them, until nothing moves: the length of the last
/// one; none where one leads nowhere.
std::optional<double> polish(Search& s, double enough) {
  double last = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 40; ++k) {
    const StatePtr state = s.function.with_slopes(s.z);
    if (!state) return std::nullopt;
    const bool settled = set_spread(s, *state) < kSpreadSettled;
    const Normal n = normal_at(s.model, *state, s.spread, s.held);
    const double norm = newton_step(n).norm;
    const bool is_near = norm <= kConverged && settled;
    // The second: as near as differences lead.
    if ((norm <= enough && settled) || (k > 8 && is_near && norm > 0.5 * last)) return norm;
    last = norm;
    ++s.iterations;
    if (!take_step(s, n)) return is_near ? std::optional(norm) : std::nullopt;
    if (norm < 1.0) go_on(s, *state, 0.3 * enough);
  }
  return last <= kConverged ? std::optional(last) : std::nullopt;
}

Status settle(Search& s, int attempts) {
  for (int k = 0; k < attempts; ++k) {
    s.function.failure.reset();
    search_by_ceres(s, k == 0);
    const bool converged = s.function.with_slopes(s.z) && polish(s, kSettled);
    if (!s.function.with_slopes(s.z)) return Status::no_equilibrium;
    if (converged) return Status::converged;
  }
  return Status::iteration_limit;
}

/// No search leaves a place about which all curves are even: a tilt of 0.
void leave_even_place(Search& s) {
  const StatePtr state = s.function.with_slopes(s.z);
  if (!state) return;
  for (const Index j : state->slopes.even) {
    const VectorXd aside = kAside * VectorXd::Unit(s.z.size(), j);
    const VectorXd up = s.model.moved(s.z, aside), down = s.model.moved(s.z, -aside);
    const StatePtr above = s.function.at(up), below = s.function.at(down);
    const auto height = [&](const StatePtr& at) { return objective(s.model, *at, s.spread); };
    if (above && (!below || height(above) <= height(below)))
      s.z = up;
    else if (below)
      s.z = down;
  }
}

/// Settles with the losses of squares: from afar most rows would look like outliers.
Status settle_with_squares(Search& s) {
  Model squares = s.model;
  for (Readings& r : squares.curves) r.loss.kind = Loss::Kind::squares;
  Search first{squares, s.function, s.z, s.spread};
  const Status status = settle(first, 2);
  s.z = first.z, s.spread = first.spread, s.iterations += first.iterations;
  return status;
}

Status settle_all(Search& s) {
  leave_even_place(s);
  const auto jumps = [](const Readings& r) { return r.loss.kind == Loss::Kind::cauchy; };
  Status status = Status::converged;
  if (std::ranges::any_of(s.model.curves, jumps)) status = settle_with_squares(s);
  if (status == Status::no_equilibrium) return status;
  do {
    status = settle(s, 3);
    if (status == Status::no_equilibrium) return status;
  } while (s.function.reaches_more(s.z) || s.function.takes_smaller_steps(s.z, s.spread));
  return status == Status::iteration_limit ? settle(s, 17) : status;
}

}  // namespace

Status run(Search& s) {
  s.function.failure.reset();
  s.function.reaches_more(s.z);
  const Status status = settle_all(s);
  s.failure = s.function.failure;
  return status;
}

std::optional<double> settle_near(Search& s) {
  if (const std::optional<double> norm = polish(s, kEnough)) return norm;
  search_by_ceres(s, false);
  return polish(s, kEnough);
}

}  // namespace modules::fit
