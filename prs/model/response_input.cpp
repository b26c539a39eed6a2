#include "prs/model/response_input.h"

#include <algorithm>
#include <cmath>

#include "prs/model/check_case.h"
#include "prs/model/quantity_text.h"

namespace prs {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
const std::vector<SignalForm::Point>* places_of(const SignalForm& term) {
  return term.steps ? &*term.steps : term.points ? &*term.points : nullptr;
}

}  // namespace

const Signal& ResponseInput::signal() const {
  if (motor.torque) return *motor.torque;
  if (motor.speed) return *motor.speed;
  return motor.controller->position ? *motor.controller->position : *motor.controller->speed;
}

std::string_view ResponseInput::signal_path() const {
  if (motor.torque) return "motor.torque";
  if (motor.speed) return "motor.speed";
  return motor.controller->position ? "motor.controller.position" : "motor.controller.speed";
}

void ResponseInput::for_each_signal(const std::function<void(const std::string&, Signal&)>& use) {
  if (motor.torque) use("response.motor.torque", *motor.torque);
  if (motor.speed) use("response.motor.speed", *motor.speed);
  if (motor.controller && motor.controller->speed) use("response.motor.controller.speed", *motor.controller->speed);
  if (motor.controller && motor.controller->position)
    use("response.motor.controller.position", *motor.controller->position);
  load.linkage ? use("response.load.torque", load.torque) : use("response.load.force", load.force);
}

namespace {

constexpr std::string_view kForms = "a value, or one of steps, points, sine, sweep, file";

void check_term(const std::string& path, const SignalTerm& term, Problems& problems) {
  const std::pair<std::string_view, bool> forms[] = {{"steps", term.steps.has_value()},
                                                     {"points", term.points.has_value()},
                                                     {"sine", term.sine.has_value()},
                                                     {"sweep", term.sweep.has_value()},
                                                     {"file", term.file.has_value()}};
  std::string_view first;
  for (const auto& [form, stands] : forms) {
    if (!stands) continue;
    if (!first.empty())
      problems.add(fmt::format("{}.{}", path, form),
                   "stands next to `{}`; expected {}; delete one of the two, or write a list of both to add them",
                   first, kForms);
    first = form;
  }
  if (first.empty() && std::isnan(term.constant))
    problems.add(path, "got no form; expected {}; write one of them", kForms);
  if (const auto* places = places_of(term))
    for (std::size_t k = 1; k < places->size(); ++k)
      if (!((*places)[k].at > (*places)[k - 1].at)) {
        problems.add(fmt::format("{}.{}", path, term.steps ? "steps" : "points"),
                     "got the time {:.9g} s behind {:.9g} s; expected times that rise; sort them", (*places)[k].at,
                     (*places)[k - 1].at);
        break;
      }
}

bool has_file(const Signal& signal) {
  return signal.one.file || std::ranges::any_of(signal.many, [](const SignalTerm& t) { return t.file.has_value(); });
}

/// A prescribed speed must be continuous and agree with the start.
void check_prescribed(const ResponseInput& r, double reach, Problems& problems) {
  BoundSignal speed(r.motor.speed->terms());
  const double at_start = speed.at(0.0).value;
  if (!(std::abs(reach * at_start - r.start.speed) <= 1e-9 * std::max(std::abs(r.start.speed), std::abs(reach))))
    problems.add("response.start.speed",
                 "got {:.9g} mm/s; expected lead/(2 pi) times `motor.speed` at t = 0, {:.9g} mm/s; write that",
                 1e3 * r.start.speed, 1e3 * reach * at_start);
  for (double t = speed.next(0.0); t < r.duration; t = speed.next(t)) {
    const double before = speed.at(t).value;
    speed.bind(t);
    const double behind = speed.at(t).value;
    if (std::abs(behind - before) <= 1e-9 * std::max({std::abs(before), std::abs(behind), 1.0})) continue;
    problems.add("response.motor.speed",
                 "jumps from {} to {} at {:.9g} s; expected a speed without jumps; write `points` with a ramp",
                 rpm(before), rpm(behind), t);
    return;
  }
}

void check_inertia(const ResponseInput& r, Problems& problems) {
  const bool driven = !r.motor.speed;
  constexpr std::string_view kText = "got 0 kg cm^2; expected an inertia > 0 of {}; add `inertia: 3 kg cm^2` to `{}`";
  if (r.coupling) {
    if (!(r.screw.inertia > 0.0))
      problems.add("response.screw.inertia",
                   fmt::format(fmt::runtime(kText), "what turns behind the coupling", "screw"));
    if (driven && !(r.motor.inertia > 0.0))
      problems.add("response.motor.inertia", fmt::format(fmt::runtime(kText), "a rotor that a torque turns", "motor"));
  } else if (driven && !(r.motor.inertia + r.screw.inertia > 0.0)) {
    problems.add("response.motor.inertia",
                 fmt::format(fmt::runtime(kText), "what a torque turns, motor or screw", "motor"));
  }
}

void check_lever(const ResponseInput& r, Problems& problems) {
  if (r.load.linkage && !r.start.angle)
    problems.add_missing("response.start.angle", "the angle of the lever at `start.position`", "60 deg");
  else if (r.start.angle && !r.load.linkage)
    problems.add("response.start.angle", "belongs to a lever; expected it with `load.linkage` alone; delete it");
  else if (r.start.angle && prs_is_dead_centre(*r.start.angle))
    problems.add(
        "response.start.angle",
        "got {:.6g} deg; expected an angle from 1 to 179 deg, off the dead centres at 0 and 180 deg; change it",
        *r.start.angle * "deg"_per_si);
}

void check_motor(const ResponseInput& r, Problems& problems) {
  const ResponseInput::Motor& m = r.motor;
  const int drives = m.torque.has_value() + m.speed.has_value() + m.controller.has_value();
  if (drives != 1)
    problems.add("response.motor", "got {}; expected exactly one of torque, speed, controller; {}",
                 drives == 0 ? "none of them" : fmt::format("{} of them", drives),
                 drives == 0 ? "add one, for example `torque: 4 N m`" : "delete the others");
  if (!m.controller) return;
  const bool both = m.controller->speed && m.controller->position;
  if (both || !(m.controller->speed || m.controller->position))
    problems.add("response.motor.controller", "got {}; expected exactly one of speed, position; {}",
                 both ? "both" : "neither", both ? "delete one" : "add one, for example `speed: 600 rpm`");
}

}  // namespace

void check_response(const Case& c, Problems& problems) {
  ResponseInput r = *c.response;
  const double reach = c.mechanism.lead / kTurn;
  check_motor(r, problems);
  check_lever(r, problems);
  r.for_each_signal([&](const std::string& path, const Signal& signal) {
    if (signal.many.empty()) return check_term(path, signal.one, problems);
    for (std::size_t k = 0; k < signal.many.size(); ++k)
      check_term(fmt::format("{}[{}]", path, k), signal.many[k], problems);
  });
  check_inertia(r, problems);
  if (!(r.duration / r.interval() <= kMostSamples))
    problems.add("response.sample_interval",
                 "got {:.6g} s in {:.6g} s; expected at most {:.0f} samples; take {:.6g} s or more", r.interval(),
                 r.duration, kMostSamples, r.duration / kMostSamples);
  if (const auto& m = r.material_damping) {
    const bool sound = m->time ? !m->loss_factor && !m->at_frequency : m->loss_factor && m->at_frequency;
    if (!sound)
      problems.add("response.material_damping",
                   "expected `time` alone, or `loss_factor` and `at_frequency`; write for example {{time: 15 us}} or "
                   "{{loss_factor: 3 %, at_frequency: 300 Hz}}{}",
                   "");
  }
  const auto& [upper, lower] = r.end_stops;
  if (upper && lower && !(upper->at > lower->at))
    problems.add("response.end_stops",
                 "got the upper one at {}, the lower one at {}; expected upper above lower; swap them", mm(upper->at),
                 mm(lower->at));
  const double nearest =
      std::min(std::max(r.start.position, lower ? lower->at : -HUGE_VAL), upper ? upper->at : HUGE_VAL);
  if (nearest != r.start.position)
    problems.add(
        "response.start.position",
        "got {}, beyond an end stop; expected a start between the stops, the nearest is {}; move start or stop",
        mm(r.start.position), mm(nearest));
  if (r.shaft && r.shaft->span && !(r.shaft->length < *r.shaft->span))
    problems.add("response.shaft.length", "got {}; expected less than the span, {}; check both", mm(r.shaft->length),
                 mm(*r.shaft->span));
  if (r.settling && !(r.settling->after < r.duration))
    problems.add("response.settling.after",
                 "got {:.6g} s; expected a time before the end, {:.6g} s; take an earlier one", r.settling->after,
                 r.duration);
  const bool knows_load = !has_file(r.load.acting());
  const bool is_prescribed = r.motor.speed && !r.motor.torque && !r.motor.controller;
  if (is_prescribed && !has_file(*r.motor.speed)) check_prescribed(r, reach, problems);
  if (const auto& f = r.frequency_response) {
    if (!(f->to > f->from))
      problems.add("response.frequency_response.to", "got {:.6g} Hz; expected more than `from`, {:.6g} Hz; swap them",
                   f->to, f->from);
    if (f->input == ResponseInput::Input::motor_torque &&
        (r.motor.speed || f->screw == ResponseInput::ScrewState::held))
      problems.add("response.frequency_response.input",
                   "got motor_torque with {}; expected `screw: rolling` and a motor with torque or controller; write "
                   "load_force, or change that",
                   r.motor.speed ? "a prescribed speed" : "a held screw");
    const bool is_open = !c.preload || c.preload->backlash;
    if (is_open && (f->force || knows_load) &&
        f->force.value_or(BoundSignal(r.load.acting().terms()).at(0.0).value) == 0.0)
      problems.add("response.frequency_response.force",
                   "got 0 N, where flanks do not touch; expected a force other than 0 without a preload{}; write for "
                   "example `force: 1 kN`",
                   "");
  }
}

void need_response(const Case& c, Problems& problems) {
  c.preload ? need_preload(c, problems) : need_solve(c, problems);
  if (!c.response)
    problems.add_missing("response", "the drive of the screw",
                         "{duration: 0.1 s, motor: {inertia: 5 kg cm^2, torque: 2 N m}, load: {mass: 40 kg}}");
}

}  // namespace prs
