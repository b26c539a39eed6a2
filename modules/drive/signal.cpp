#include "modules/drive/signal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace prs {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kNever = std::numeric_limits<double>::infinity();

const std::vector<SignalForm::Point>* places_of(const SignalForm& term) {
  return term.steps ? &*term.steps : term.points ? &*term.points : nullptr;
}

/// Value, slope and curvature of mean + amplitude sin(2 pi n) from n, n' and n''.
BoundSignal::Value wave(double mean, double amplitude, double n, double rate, double bend) {
  const double s = std::sin(kTurn * n), c = std::cos(kTurn * n), w = kTurn * rate;
  return {mean + amplitude * s, amplitude * w * c, amplitude * (kTurn * bend * c - w * w * s)};
}

BoundSignal::Value sweep_at(const SignalForm::Sweep& s, double t, bool is_over) {
  const double ratio = std::log(s.to / s.from);
  const bool linear = s.spacing == SignalForm::Spacing::linear || ratio == 0.0;
  const double along = is_over ? s.duration : t;
  const double growth = linear ? 0.0 : std::exp(ratio * along / s.duration);
  const double turns = linear ? (s.from + 0.5 * (s.to - s.from) * along / s.duration) * along
                              : s.from * s.duration / ratio * (growth - 1.0);
  if (is_over) return wave(s.mean, s.amplitude, turns + s.to * (t - s.duration), s.to, 0.0);
  const double rate = linear ? s.from + (s.to - s.from) * along / s.duration : s.from * growth;
  const double bend = linear ? (s.to - s.from) / s.duration : rate * ratio / s.duration;
  return wave(s.mean, s.amplitude, turns, rate, bend);
}

}  // namespace

BoundSignal::BoundSignal(const std::vector<SignalForm>& terms) {
  for (const SignalForm& term : terms) terms_.push_back({term});
  bind(0.0);
}

void BoundSignal::bind(double t) {
  for (Term& term : terms_) {
    if (const auto* places = places_of(term.what))
      term.piece =
          static_cast<std::size_t>(std::ranges::upper_bound(*places, t, {}, &SignalForm::Point::at) - places->begin());
    if (term.what.sweep) term.is_over = t >= term.what.sweep->duration;
  }
}

BoundSignal::Value BoundSignal::at(double t) const {
  Value sum;
  for (const Term& term : terms_) {
    const SignalForm& what = term.what;
    Value v{what.has_form() ? 0.0 : what.constant};
    if (const auto* places = places_of(what); places && !places->empty()) {
      const std::size_t k = term.piece;
      if (k > 0) v.value = (*places)[k - 1].value;
      if (what.points && k == 0) v.value = places->front().value;
      if (what.points && k > 0 && k < places->size()) {
        const SignalForm::Point &a = (*places)[k - 1], &b = (*places)[k];
        v.slope = (b.value - a.value) / (b.at - a.at);
        v.value = a.value + v.slope * (t - a.at);
      }
    }
    if (what.sine)
      v = wave(what.sine->mean, what.sine->amplitude, what.sine->frequency * t + what.sine->phase / kTurn,
               what.sine->frequency, 0.0);
    if (what.sweep) v = sweep_at(*what.sweep, t, term.is_over);
    sum.value += v.value;
    sum.slope += v.slope;
    sum.curve += v.curve;
  }
  return sum;
}

double BoundSignal::next(double t) const {
  double next = kNever;
  for (const Term& term : terms_) {
    if (const auto* places = places_of(term.what)) {
      const auto later = std::ranges::upper_bound(*places, t, {}, &SignalForm::Point::at);
      if (later != places->end()) next = std::min(next, later->at);
    }
    if (term.what.sweep && t < term.what.sweep->duration) next = std::min(next, term.what.sweep->duration);
  }
  return next;
}

double BoundSignal::fastest() const {
  double fastest = 0.0;
  for (const Term& term : terms_) {
    if (term.what.sine) fastest = std::max(fastest, term.what.sine->frequency);
    if (term.what.sweep) fastest = std::max({fastest, term.what.sweep->from, term.what.sweep->to});
  }
  return fastest;
}

}  // namespace prs
