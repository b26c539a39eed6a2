#include "modules/estimation/differences.h"

#include <algorithm>

namespace modules::fit {
namespace {

constexpr double kStep = 1e-3;          // Step in z.
constexpr double kLeastStep = 1e-4;     // Below that differences drown in the tolerances of what they are of.
constexpr double kNoInfluence = 1e-12;  // Least change by an unknown, as a share of the response.
constexpr double kEven = 1e-6;          // Difference of both sides over their distance from the middle.

enum class Side { both, ahead, behind };

/// Two places at which the function is asked, in steps.
std::array<double, 2> steps_of(Side side) {
  if (side == Side::both) return {-1.0, 1.0};
  return side == Side::ahead ? std::array{1.0, 2.0} : std::array{-1.0, -2.0};
}

/// Side to try after a failure: of two the one without it, else the other one.
Side other_than(Side side, bool first_failed) {
  if (side == Side::both) return first_failed ? Side::ahead : Side::behind;
  return side == Side::ahead ? Side::behind : Side::ahead;
}

/// Differences that are found side by side, two requests each.
struct Batch {
  struct Difference {
    Index j;
    Side side;
    double step;
  };
  std::vector<Difference> differences = {};
  std::vector<Request> requests = {};

  void add(const Model& model, const VectorXd& z, const Mask& wanted, const Difference& d) {
    if (!wanted.col(d.j).any()) return;
    differences.push_back(d);
    for (const double steps : steps_of(d.side))
      requests.push_back(model.request(z + steps * d.step * VectorXd::Unit(z.size(), d.j),
                                       {wanted.col(d.j).begin(), wanted.col(d.j).end()}));
  }
};

void set_slope(const Model& model, const Batch::Difference& d, const Answer& one, const Answer& two, const State& here,
               const Mask& wanted, Slopes& slopes) {
  const double h = d.side == Side::behind ? -d.step : d.step;
  bool moves = false, is_even = d.side == Side::both;
  for (std::size_t c = 0; c < here.values.size(); ++c) {
    const auto row = static_cast<Index>(c);
    if (!wanted(row, d.j)) continue;
    const VectorXd a = vector_of(one.values[c]), b = vector_of(two.values[c]);
    const VectorXd f = here.values[c].array() - model.offset(c, here.z);
    slopes.by_z[c].col(d.j) =
        d.side == Side::both ? VectorXd((b - a) / (2.0 * h)) : VectorXd((-3.0 * f + 4.0 * a - b) / (2.0 * h));
    const ArrayXd by = (a - f).array().abs().max((b - f).array().abs());
    slopes.change(row, d.j) = (by > 0.0).select(by / f.array().abs(), 0.0).maxCoeff();
    moves = moves || slopes.change(row, d.j) > kNoInfluence;
    is_even = is_even && ((b - a).array().abs() <= kEven * by).all();
  }
  if (moves && is_even) slopes.even.push_back(d.j);
}

/// Flags the curves that an unknown moves by more than the rounding between batches.
Mask moves(const Slopes& slopes) {
  Mask all = slopes.change.array() > kNoInfluence;
  for (Index c = 0; c < all.rows(); ++c)
    all.row(c) = all.row(c) || (slopes.by_z[static_cast<std::size_t>(c)].array() != 0.0).colwise().any();
  return all;
}

}  // namespace

Differences::Differences(const Model& model)
    : model_(model),
      fitted_(Mask::Constant(static_cast<Index>(model.curves.size()), model.count(), false)),
      step_(VectorXd::Constant(model.count(), kStep)) {
  for (const std::size_t c : model.fitted) fitted_.row(static_cast<Index>(c)).setConstant(true);
  reached_ = fitted_;
}

StatePtr Differences::at(const VectorXd& z) {
  for (const StatePtr& known : known_)
    if (known->z == z) return known;
  std::vector<bool> fitted;
  for (const Readings& r : model_.curves) fitted.push_back(r.is_fitted);
  const std::vector<Answer> answers = model_.problem.evaluate({model_.request(z, fitted)});
  if (answers[0].failure) {
    failure = answers[0].failure;
    return nullptr;
  }
  const auto state = std::make_shared<State>(State{.z = z, .values = std::vector<VectorXd>(model_.curves.size())});
  for (const std::size_t c : model_.fitted)
    state->values[c] = vector_of(answers[0].values[c]).array() + model_.offset(c, z);
  known_.push_front(state);
  if (known_.size() > 4) known_.pop_back();
  return state;
}

StatePtr Differences::with_slopes(const VectorXd& z) {
  StatePtr state = at(z);
  if (!state || state->slopes) return state;
  state->slopes = slopes(z, state->values, reached_);
  if (state->slopes.failure) failure = state->slopes.failure;
  if (!state->slopes) return nullptr;
  state->information.assign(model_.curves.size(), MatrixXd::Zero(model_.count(), model_.count()));
  for (const std::size_t c : model_.fitted) {
    const MatrixXd weighted = model_.curves[c].weight.asDiagonal() * state->slopes.by_z[c];
    state->information[c] = weighted.transpose() * weighted;
  }
  return state;
}

Slopes Differences::slopes(const VectorXd& z, const std::vector<VectorXd>& values, const Mask& wanted) const {
  Slopes found{.by_z = {}, .change = MatrixXd::Zero(wanted.rows(), wanted.cols()), .even = {}, .failure = {}};
  for (const VectorXd& of_curve : values) found.by_z.emplace_back(MatrixXd::Zero(of_curve.size(), z.size()));
  const State here{.z = z, .values = values};
  Batch batch;
  for (Index j = 0; j < z.size(); ++j) {
    if (model_.unknown(j).is_offset) continue;
    const bool bounded = model_.unknown(j).is_bounded;
    const Side side = bounded && z[j] < step_[j]         ? Side::ahead
                      : bounded && z[j] > 1.0 - step_[j] ? Side::behind
                                                         : Side::both;
    batch.add(model_, z, wanted, {j, side, step_[j]});
  }
  for (int round = 0; !batch.differences.empty(); ++round) {
    const std::vector<Answer> answers = model_.problem.evaluate(batch.requests);
    Batch again;
    for (std::size_t k = 0; k < batch.differences.size(); ++k) {
      const auto& [j, side, step] = batch.differences[k];
      const Answer &one = answers[2 * k], &two = answers[2 * k + 1];
      if (!one.failure && !two.failure) {
        set_slope(model_, batch.differences[k], one, two, here, wanted, found);
        continue;
      }
      found.failure = one.failure ? one.failure : two.failure;
      const Side other = other_than(side, one.failure.has_value());
      const double last = z[j] + steps_of(other)[1] * step;
      if (round == 2 || (model_.unknown(j).is_bounded && !(last >= 0.0 && last <= 1.0)))
        return {.by_z = {}, .change = {}, .even = {}, .failure = found.failure};
      again.add(model_, z, wanted, {j, other, step});
    }
    batch = std::move(again);
  }
  for (const std::size_t c : model_.fitted)
    if (const auto& offset = model_.problem.curves[c].offset)
      found.by_z[c].col(static_cast<Index>(*offset)).setConstant(model_.range(static_cast<Index>(*offset)));
  return found;
}

std::optional<std::size_t> Differences::look_at(const State& state) {
  const Mask moved = moves(state.slopes);
  for (Index j = 0; j < model_.count(); ++j) {
    if (model_.unknown(j).is_offset) continue;
    reached_.col(j) = fitted_.col(j) && moved.col(j);
    if (!(state.slopes.change.col(j).array() > kNoInfluence).any()) return static_cast<std::size_t>(j);
  }
  looked_at_ = state.z;
  return std::nullopt;
}

bool Differences::reaches_more(const VectorXd& z) {
  const StatePtr state = looked_at_ == z ? nullptr : at(z);
  if (!state) return false;
  looked_at_ = z;
  const Mask unreached = fitted_ && !reached_;
  const Slopes found = slopes(z, state->values, unreached);
  if (!found) return false;
  const Mask more = unreached && moves(found);
  if (!more.any()) return false;
  reached_ = reached_ || more;
  known_.clear();
  return true;
}

bool Differences::takes_smaller_steps(const VectorXd& z, const Spread& spread) {
  const StatePtr state = with_slopes(z);
  if (!state) return false;
  bool any = false;
  for (Index j = 0; j < model_.count(); ++j) {
    const double to_bound = std::min(z[j], 1.0 - z[j]), before = step_[j];
    const Unknown& unknown = model_.unknown(j);
    if (unknown.is_offset || unknown.is_log || to_bound > 20.0 * before || before <= kLeastStep) continue;
    Mask wanted = Mask::Constant(reached_.rows(), reached_.cols(), false);
    wanted.col(j) = reached_.col(j);
    step_[j] = std::max(kLeastStep, 0.25 * before);
    const Slopes finer = slopes(z, state->values, wanted);
    double off = 0.0, all = 0.0;
    for (std::size_t k = 0; finer && k < model_.fitted.size(); ++k) {
      const std::size_t c = model_.fitted[k];
      const ArrayXd weight = model_.curves[c].weight.array() / spread[c];
      const ArrayXd slope = state->slopes.by_z[c].col(j);
      off += (weight * (finer.by_z[c].col(j).array() - slope)).matrix().squaredNorm();
      all += (weight * slope).matrix().squaredNorm();
    }
    if (off > 1e-4 * all)
      any = true;
    else
      step_[j] = before;
  }
  if (any) known_.clear();
  return any;
}

}  // namespace modules::fit
