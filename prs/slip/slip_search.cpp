#include "prs/slip/slip_search.h"

#include <algorithm>

#include "prs/slip/result/slip_result.h"

namespace prs {
namespace {

/// Tolerance of the slip ratio.
constexpr double kSlipTolerance = 1e-14;
constexpr int kMostEvaluations = 100;

/// Moment, as a share of c |F_N|/N_R, below which it is rounding.
constexpr double kNoMoment = 1e-15;

/// First step if Newton's method from the ideal slip ratio leads away from the root.
constexpr double kFirstStep = 2e-3;
constexpr double kLongestStep = 10.0;

/// Relative length of a step of Newton's method below which its error is below rounding.
constexpr double kLastStep = 1e-4;

}  // namespace

SlipSearch::SlipSearch(const SlipRange& range, double speed, const std::optional<double>& imposed,
                       const std::optional<double>& near)
    : imposed_(imposed),
      sense_(std::copysign(1.0, speed)),
      ideal_(range.ideal),
      way_(range.pure_sliding - range.ideal),
      far_(std::numeric_limits<double>::quiet_NaN()) {
  if (imposed) end_as(SlipStatus::imposed);
  if (imposed || !near || *near == ideal_) return;
  t_ = last_step_ = (*near - ideal_) / way_;
  set_end(t_);
}

void SlipSearch::set_end(double residue_at_ideal) {
  const double pure_sliding = ideal_ + way_;
  at_ideal_ = residue_at_ideal;
  end_ = residue_at_ideal > 0.0 ? 1.0 : (1.0 - pure_sliding - ideal_) / way_;
}

double SlipSearch::slip_ratio() const { return imposed_ ? *imposed_ : ideal_ + t_ * way_; }

void SlipSearch::end_as(SlipStatus status) {
  last_ = status;
  wants_slope_ = false;
}

void SlipSearch::jam() {
  ++evaluations_;
  status_ = SlipStatus::jammed;
}

void SlipSearch::take(double relative_residue, double slope) {
  ++evaluations_;
  if (last_ != SlipStatus::not_computed) {
    status_ = last_;
    return;
  }
  const bool had_slope = wants_slope_;
  residue_ = sense_ * relative_residue;
  if (had_slope) slope_ = sense_ * slope * way_;
  if (evaluations_ == kMostEvaluations) return end_as(SlipStatus::iteration_limit);
  step();
  // An evaluation without slope can be the last one.
  if (!had_slope && last_ != SlipStatus::not_computed) status_ = last_;
}

void SlipSearch::evaluate_next_at(double t) {
  last_step_ = t - t_;
  wants_slope_ = !(std::abs(last_step_) <= kLastStep * std::abs(t));
  t_ = t;
}

void SlipSearch::step() {
  double newton = t_ - residue_ / slope_;
  if (evaluations_ == 1 && t_ == 0.0) {
    if (std::abs(residue_) <= kNoMoment) return end_as(SlipStatus::converged);
    // If friction alone resists, the moment has the sense of the speed at t = 0 and the root lies at t > 0 (3.45); a
    // driven carrier can push it to t < 0, at most to where the carrier turns with the driving part.
    set_end(residue_);
    if (!(newton / end_ > 0.0 && newton / end_ <= 1.0)) newton = std::copysign(kFirstStep, end_);
    return evaluate_next_at(newton);
  }
  const double width = kSlipTolerance / std::abs(way_);
  if (std::abs(residue_) <= width * std::abs(slope_)) return end_as(SlipStatus::converged);
  if (residue_ * at_ideal_ > 0.0) {
    if (t_ == end_) return end_as(SlipStatus::no_equilibrium);
    near_ = t_;
  } else {
    far_ = t_;
  }
  if (std::isnan(far_)) {
    const double longest = std::abs(kLongestStep * t_) < std::abs(end_) ? kLongestStep * t_ : end_;
    const bool ahead = newton / t_ > 1.0 && newton / longest <= 1.0;
    return evaluate_next_at(ahead ? newton : longest);
  }
  if (std::abs(far_ - near_) <= width) return end_as(SlipStatus::converged);
  const bool converges = (newton - near_) * (newton - far_) < 0.0 && std::abs(newton - t_) < 0.5 * std::abs(last_step_);
  evaluate_next_at(converges ? newton : 0.5 * (near_ + far_));
}

}  // namespace prs
