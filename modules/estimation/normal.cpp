#include "modules/estimation/normal.h"

#include <algorithm>
#include <cmath>

namespace modules::fit {
namespace {

constexpr double kBound = 1e-6;  // Nearer to a bound than that a value may be held there.

double log_change(const Spread& before, const Spread& after) {
  double change = 0.0;
  for (std::size_t c = 0; c < after.size(); ++c) change = std::max(change, std::abs(std::log(after[c] / before[c])));
  return change;
}

/// Distance of an unknown's value from the mean of its prior, in the prior's deviations.
double pull_of_prior(const Model& model, const VectorXd& z, Index j) {
  const auto& prior = *model.unknown(j).prior;
  return (model.u(j, z[j]) - prior.mean) / prior.deviation;
}

}  // namespace

Robust robust_at(const Model& model, const State& state, std::size_t curve, const Spread& spread) {
  const Readings& r = model.curves[curve];
  return robust(r.loss, (r.measured - state.values[curve]).array() * r.weight.array() / spread[curve]);
}

double objective(const Model& model, const State& state, const Spread& spread) {
  double sum = 0.0;
  for (const std::size_t c : model.fitted) sum += robust_at(model, state, c, spread).rho.sum();
  for (Index j = 0; j < model.count(); ++j)
    if (model.unknown(j).prior) sum += std::pow(pull_of_prior(model, state.z, j), 2);
  return sum;
}

Normal normal_at(const Model& model, const State& state, const Spread& spread, std::optional<Index> held) {
  const Index count = model.count();
  Normal n{.curves = {},
           .matrix = model.prior,
           .gradient = VectorXd::Zero(count),
           .objective = objective(model, state, spread)};
  n.curves.resize(model.curves.size(), {.information = MatrixXd::Zero(count, count)});
  for (Index j = 0; j < count; ++j)
    if (const auto& prior = model.unknown(j).prior)
      n.gradient[j] += model.range(j) * pull_of_prior(model, state.z, j) / prior->deviation;
  for (const std::size_t c : model.fitted) {
    const Readings& y = model.curves[c];
    const Robust r = robust_at(model, state, c, spread);
    Weighed& w = n.curves[c];
    w = {.information = state.information[c] / (spread[c] * spread[c]),
         .a = y.loss.is_robust() ? std::max(r.slope.mean(), kLeastSlope) : 1.0,
         .has_own_spread = y.is_estimated || y.loss.is_robust(),
         .is_estimated = y.is_estimated};
    n.gradient -= state.slopes.by_z[c].transpose() * (r.psi * y.weight.array() / spread[c]).matrix();
    n.matrix += w.a * w.information;
  }
  std::vector<Index> free;
  for (Index j = 0; j < count; ++j)
    if (j != held && pushed_out(model, state.z, n.gradient, j) == 0) free.push_back(j);
  invert(n, model, std::move(free));
  return n;
}

void invert(Normal& n, const Model& model, std::vector<Index> free) {
  n.free = std::move(free);
  n.inverse = inverse(n.matrix, n.free);
  for (const std::size_t c : model.fitted) {
    Weighed& w = n.curves[c];
    w.redundancy =
        static_cast<double>(model.problem.curves[c].rows) - w.a * (n.inverse.array() * w.information.array()).sum();
  }
}

int pushed_out(const Model& model, const VectorXd& z, const VectorXd& gradient, Index j) {
  if (!model.unknown(j).is_bounded) return 0;
  if (z[j] <= kBound && gradient[j] > 0.0) return -1;
  return z[j] >= 1.0 - kBound && gradient[j] < 0.0 ? 1 : 0;
}

Step newton_step(const Normal& n) {
  const VectorXd step = -(n.inverse * n.gradient);
  return {step, std::sqrt(std::max(0.0, step.dot(n.matrix * step)))};
}

VectorXd step_within_bounds(const Model& model, const Normal& n, const VectorXd& z) {
  VectorXd step = newton_step(n).z;
  std::vector<Index> free = n.free;
  for (;;) {
    const auto stops = [&](Index j) {
      const double next = z[j] + step[j];
      if (!model.unknown(j).is_bounded || (next >= 0.0 && next <= 1.0)) return false;
      step[j] = step[j] < 0.0 ? -z[j] : 1.0 - z[j];
      return true;
    };
    if (std::erase_if(free, stops) == 0) return step;
    VectorXd stopped = VectorXd::Zero(z.size());
    for (const Index j : n.free)
      if (std::ranges::find(free, j) == free.end()) stopped[j] = step[j];
    const VectorXd others = -(inverse(n.matrix, free) * (n.gradient + n.matrix * stopped));
    for (const Index j : free) step[j] = others[j];
  }
}

double set_spread(const Model& model, const State& state, Spread& spread) {
  const Spread before = spread;
  for (int round = 0; round < 1000; ++round) {
    const Spread last = spread;
    const Normal n = normal_at(model, state, spread);
    for (const std::size_t c : model.fitted) {
      const Readings& y = model.curves[c];
      if (!y.is_estimated) continue;
      const Robust r = robust_at(model, state, c, last);
      const double expected = consistency(y.loss) * std::max(n.curves[c].redundancy, 0.5);
      spread[c] = std::max(spread[c] * std::sqrt((r.psi * r.scaled).sum() / expected), y.floor);
    }
    if (log_change(last, spread) < 1e-2 * kSpreadSettled) break;
  }
  return log_change(before, spread);
}

}  // namespace modules::fit
