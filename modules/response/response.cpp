#include "modules/response/response.h"

#include <cmath>

#include "prs/heat/analyze_heat.h"
#include "prs/input/force_history.h"
#include "prs/model/check_case.h"
#include "prs/preload/preloaded_mechanism.h"

namespace prs {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// Signals in the form for the equations.
struct DriveSignals {
  BoundSignal motor, force;

  PrsSignals functions() {
    return {this,
            [](void* self, double t) {
              auto& s = *static_cast<DriveSignals*>(self);
              s.motor.bind(t);
              s.force.bind(t);
            },
            [](void* self, double t, PrsInputs* inputs) {
              const auto& s = *static_cast<const DriveSignals*>(self);
              const BoundSignal::Value v = s.motor.at(t);
              *inputs = {v.value, v.slope, v.curve, s.force.at(t).value};
            },
            [](void* self, double t) {
              const auto& s = *static_cast<const DriveSignals*>(self);
              return std::min(s.motor.next(t), s.force.next(t));
            }};
  }
};

Conditions at_rest(Conditions c) {
  if (c.model.loads != ModelOptions::Loads::running) c.model.loads = ModelOptions::Loads::at_rest;
  return c;
}

void add_pressure(LargestForce& largest, const Contacts& contacts, Interface i, double pressure) {
  largest.peak_pressure = std::max(largest.peak_pressure.value_or(0.0), pressure);
  const ContactPressure found{i, pressure, contacts.interfaces[i].pressure_limit};
  if (!largest.pressure || largest.pressure->share() < found.share()) largest.pressure = found;
}

/// `largest` with the thread loads that `prs solve` gives for it as a load case.
LargestForce under_solve(const Conditions& conditions, const Contacts& contacts, const std::string& load_case,
                         LargestForce largest, Direction d) {
  Conditions c = conditions;
  c.model.loads = ModelOptions::Loads::at_rest;
  const auto pattern = std::ranges::find(c.load_cases, load_case, &LoadCase::name);
  LoadCase load = *pattern;
  load.direction = d;
  load.axial_force = largest.force;
  load.travel.reset();
  load.modes.reset();
  c.load_cases = {load};
  const Result result = analyze(c, contacts);
  const LoadCaseResult& found = result.load_cases.front();
  if (!found.converged() || !found.threads) return largest;
  largest.threads.emplace();
  for (const Interface i : kInterfaces) {
    const InterfaceLoads& loads = (*found.threads)[i];
    const auto most = std::ranges::max_element(loads.normal_load) - loads.normal_load.begin();
    const auto k = static_cast<std::size_t>(most);
    MostLoaded& thread = (*largest.threads)[i];
    thread.normal_load = loads.normal_load[k];
    thread.thread =
        1 + (loads.threads_per_roller > 0 ? static_cast<int>(most) % loads.threads_per_roller : static_cast<int>(most));
    if (k < loads.peak_pressure.size()) {
      thread.peak_pressure = loads.peak_pressure[k];
      add_pressure(largest, contacts, i, *thread.peak_pressure);
    }
  }
  return largest;
}

/// Adds the loads of both senses as in `prs preload`.
void put_under_preload(const Conditions& conditions, const Contacts& contacts,
                       PerDirection<std::optional<LargestForce>>& largest, double least) {
  Conditions c = conditions;
  const auto force = [&](Direction d) { return largest[d] ? largest[d]->force : 0.0; };
  c.preload->load = {-force(Direction::compression), force(Direction::tension), 2};
  const PreloadResult result = analyze_preload(c, contacts);
  for (const Direction d : kDirections) {
    if (force(d) <= least) continue;
    const PreloadPoint& point = d == Direction::compression ? result.curve.points.front() : result.curve.points.back();
    if (!point.solve.converged()) continue;
    largest[d]->normal_load = 0.0;
    for (const Direction side : kDirections) {
      const SideLoads& loads = point.sides[side];
      largest[d]->normal_load =
          std::max({*largest[d]->normal_load, loads.max_normal_load.screw, loads.max_normal_load.nut});
      for (const Interface i : kInterfaces)
        if (result.peak_pressure(loads))
          add_pressure(*largest[d], contacts, i,
                       contact::at_load(contacts.interfaces[i].hertz, loads.max_normal_load[i]).peak_pressure);
    }
  }
}

/// Friction torque of a preloaded screw without load, as in `prs slip`: for a running screw.
std::optional<double> torque_at_zero_load(const Case& c, const std::string& load_case) {
  Case one = c;
  const auto pattern = std::ranges::find(c.load_cases, load_case, &LoadCase::name);
  if (pattern != c.load_cases.end())
    one.load_cases = {*pattern};
  else
    one.load_cases.resize(1);
  LoadCase& load = one.load_cases.front();
  load.axial_force = 0.0;
  if (load_case.empty()) load.position = c.preload->position;  // Position as for the curves.
  if (!load.direction) load.direction = Direction::tension;
  if (!slip_takes_running_loads(c.model, load.share) || !missing(one, Command::slip).empty()) return {};
  try {
    const Result result = analyze_heat(one, {.detail = Detail::numbers});
    const std::optional<SlipResult>& slip = result.load_cases.front().slip;
    if (slip && slip->converged()) return std::abs(slip->torque_screw);
  } catch (const CaseError&) {  // No value if slip refuses the case.
  }
  return {};
}

/// Warns of the conditions for which the curves' torque is valid in a drive.
void tell_of_preload(const Case& c, const std::string& load_case, std::vector<Warning>& warnings) {
  for (Warning& warning : warnings) {
    constexpr std::string_view kOther = " for `slip`";
    if (const std::size_t at = warning.what.find(kOther); warning.code == "no_friction" && at != warning.what.npos)
      warning.what.erase(at, kOther.size());
    if (warning.code != "torque_without_preload") continue;
    warning.fix = "state it in `response.screw.drag_torque`";
    const std::optional<double> torque = torque_at_zero_load(c, load_case);
    if (!torque) continue;
    warning.what += ", {value} by `prs slip` at zero load";
    warning = std::move(warning).with(torque, {}, "N m"_unit);
  }
}

SettlingResult settling_of(const ResponseInput& input, const DriveResult& run) {
  const ResponseInput::Settling& block = *input.settling;
  SettlingResult s{run.x.back()};
  const bool holds = input.motor.controller && input.motor.controller->position &&
                     input.motor.cut_at.value_or(HUGE_VAL) >= input.duration;
  const double there = holds ? run.last_reference : s.final_position;
  if (holds) {
    s.reference = there;
    s.settled = std::abs(s.final_position - there) <= block.band;
    if (!*s.settled) return s;
  }
  s.time = 0.0;
  for (std::size_t k = 0; k < run.time.size(); ++k)
    if (run.time[k] >= block.after * (1.0 - 1e-12) && std::abs(run.x[k] - there) > block.band)
      s.time = (k + 1 < run.time.size() ? run.time[k + 1] : run.time[k]) - block.after;
  return s;
}

FrequencyResponse frequency_response(const PrsDrive& drive, const ResponseInput& input) {
  const ResponseInput::FrequencyResponse& f = *input.frequency_response;
  const double share = 1.0 / (f.points - 1), ratio = f.to / f.from;
  std::vector<double> all;
  for (int k = 0; k < f.points; ++k)
    all.push_back(k + 1 == f.points                               ? f.to
                  : f.spacing == SignalForm::Spacing::logarithmic ? f.from * std::pow(ratio, k * share)
                                                                  : f.from + (f.to - f.from) * k * share);
  const double position = f.position.value_or(input.start.position);
  const double load = BoundSignal(input.load.acting().terms()).at(0.0).value;
  const WorkingPoint point{f.force.value_or(input.load.linkage ? load / prs_lever_at(&drive, position).ratio : load),
                           position, f.speed.value_or(0.0), f.input == ResponseInput::Input::motor_torque};
  double c = 0.0, slope = 0.0;
  if (prs_shaft_compliance(&drive, point.position, &c, &slope) == 0)
    throw CaseError("response.frequency_response.position",
                    "lies off the shaft; expected a place on `response.shaft.length`; move it");
  if (input.load.linkage && prs_is_dead_centre(prs_lever_at(&drive, point.position).angle))
    throw CaseError("response.frequency_response.position",
                    "has the lever at a dead centre; expected an angle from 1 to 179 deg; move it");
  FrequencyResponse r = small_vibration(drive, point, std::move(all));
  if (r.resonances.empty() && r.frequency.empty())
    throw CaseError("response.frequency_response.force",
                    "flanks do not touch there; expected a force other than 0 without a preload; change it");
  return r;
}

/// Warns of the pressure under the largest forces, in place of those at the ends of the curves.
void warn_of_pressure(ResponseResult& r) {
  std::erase_if(r.warnings, [](const Warning& w) {
    return w.code.ends_with("_peak_pressure") || w.code.ends_with("_running_pressure");
  });
  for (const Direction d : kDirections)
    if (const auto& largest = r.largest[d]; largest && largest->pressure && largest->pressure->share() > 1.0)
      r.warnings.push_back(
          Warning{"response", fmt::format("{}_peak_pressure", name(d)),
                  fmt::format("{} peak pressure {{value}} exceeds {{limit}}, under {{{:.4g} kN}} in {} at {:.6g} ms",
                              label(largest->pressure->at), 1e-3 * largest->force, name(d), 1e3 * largest->time),
                  "lower speed or torque, soften what stops the load, or take more contacts"}
              .with(largest->pressure->value, *largest->pressure->limit, "GPa"_unit));
}

void add_warnings(const Case& c, ResponseResult& r) {
  warn_of_pressure(r);
  const auto& point = r.input.frequency_response;
  const double force = std::max(r.run.largest_force, point ? std::abs(point->force.value_or(0.0)) : 0.0);
  const double speed = std::max(r.run.largest_speed, point ? std::abs(point->speed.value_or(0.0)) : 0.0);
  if (force > r.curves_force * (1.0 + 1e-9))
    r.warnings.push_back(
        Warning{"response.curves.force", "beyond_force",
                "the largest force is {value}, the curves end at {limit}: beyond, the force goes on in "
                "a straight line and friction grows with it",
                "raise `response.curves.force`"}
            .with(force, r.curves_force, "kN"_unit));
  if (r.curves_speed > 0.0 && speed > r.curves_speed * (1.0 + 1e-9))
    r.warnings.push_back(
        Warning{"response.curves.speed", "beyond_speed",
                fmt::format("the screw reaches {:.0f} rpm, the table of friction ends at {:.0f} rpm, whose "
                            "values stay",
                            speed * "rpm"_per_si, r.curves_speed * "rpm"_per_si),
                "raise `response.curves.speed`"});
  if (!(c.response->screw.inertia > 0.0))
    r.warnings.push_back({"response.screw.inertia", "no_screw_inertia",
                          "the screw has no inertia of its own: its shaft, spin and orbit of the rollers are left out",
                          "add up what `prs measures` has of the turning part, without what travels"});
  constexpr std::size_t kMany = 20;
  if (!c.response->material_damping && r.run.impacts.size() > kMany)
    r.warnings.push_back({"response.material_damping", "no_material_damping",
                          fmt::format("flanks close {} times: without damping their vibration dies away by friction "
                                      "alone",
                                      r.run.impacts.size()),
                          "write `material_damping: {loss_factor: 3 %, at_frequency: 300 Hz}`, for example"});
  if (r.run.status == DriveStatus::step_limit)
    r.warnings.push_back({"response", "step_limit",
                          fmt::format("the drive vibrates with up to {:.4g} Hz, too fast for {:.6g} s",
                                      r.run.fastest / kTurn, r.input.duration),
                          "shorten `duration`, or check masses, inertias and stiffnesses and their units"});
}

}  // namespace

double ResponseResult::residual() const {
  double lost = 0.0;
  for (const EnergyLoss& loss : kEnergyLosses) lost += run.*loss.energy;
  return run.motor + run.load - (run.stored_end - run.stored_start) - lost;
}

double ResponseResult::rms_torque() const {
  const double time = converged() ? input.duration : run.stopped_at;
  return time > 0.0 ? std::sqrt(run.torque_squared / time) : 0.0;
}

SystemCurves response_curves(const Case& c, const CurveOptions& asked) {
  Case stated = c;
  static_cast<Conditions&>(stated) = at_rest(c);
  CurveOptions options = asked;
  if (c.response) {
    const ResponseInput::Curves& curves = c.response->curves;
    if (!options.force) options.force = curves.force;
    if (!options.speed) options.speed = curves.speed;
    if (!options.load_case && curves.load_case) {
      options.load_case = curves.load_case;
      if (std::ranges::find(c.load_cases, *curves.load_case, &LoadCase::name) == c.load_cases.end())
        throw CaseError("response.curves.load_case",
                        fmt::format("got `{}`; expected the name of a load case of this file; change it, or leave it "
                                    "out",
                                    *curves.load_case));
    }
  }
  return system_curves(stated, options);
}

ResponseInput with_signal_files(const Case& c, const input::Source& source) {
  Case filled = c;
  bool any = false;
  const auto fill = [&](const std::string& path, SignalTerm& term) {
    if (!term.file) return;
    const SignalTerm::File file = *term.file;
    const std::string block = path + ".file";
    const std::string text = input::named_file_text(file.name, block + ".name", source);
    const input::Dimension& dimension = path.starts_with("response.load.force") ? input::unit::force
                                        : path.find(".torque") != path.npos     ? input::unit::torque
                                        : path.find(".position") != path.npos   ? input::unit::length
                                                                                : input::unit::rotational_speed;
    std::vector<double> time, value;
    std::vector<input::WantedColumn> columns = {{"file.time", &file.time, &input::unit::duration, &time},
                                                {"file.value", &file.value, &dimension, &value}};
    input::read_columns(text, input::name_in_messages(file.name, source), path, columns, source);
    term.points.emplace();
    for (std::size_t k = 0; k < time.size(); ++k) {
      if (k > 0 && !(time[k] > time[k - 1]))
        throw CaseError(block + ".time.column",
                        fmt::format("got {:.9g} s twice in row {}; expected times that rise; delete one of the rows",
                                    time[k], k + 1));
      term.points->push_back({time[k], value[k]});
    }
    term.file.reset();
    any = true;
  };
  filled.response->for_each_signal([&](const std::string& path, Signal& signal) {
    fill(path, signal.one);
    for (std::size_t k = 0; k < signal.many.size(); ++k) fill(fmt::format("{}[{}]", path, k), signal.many[k]);
  });
  if (any) {
    Problems problems;
    check_response(filled, problems);
    if (std::vector<Problem> found = std::move(problems).take(); !found.empty()) throw CaseError(found.front());
  }
  return *filled.response;
}

PrsDrive drive_of(const Case& c, const ResponseInput& in, const SystemCurves& curves) {
  PrsDrive d{};
  d.curves = curves.view();
  d.mass = in.load.mass;
  if (in.load.linkage) {
    const PrsLever start = prs_lever(&*in.load.linkage, *in.start.angle);
    d.linkage = *in.load.linkage;
    d.lever_inertia = in.load.inertia;
    d.lever_length = start.length;
    d.mass = d.lever_inertia / (start.ratio * start.ratio);
  }
  d.screw_inertia = in.screw.inertia;
  d.motor_inertia = in.motor.inertia;
  if (in.coupling) {
    d.coupled = 1;
    d.coupling_stiffness = in.coupling->stiffness;
    d.coupling_damping = in.coupling->damping;
  }
  d.motor_friction = in.motor.friction_torque;
  d.motor_damping = in.motor.damping;
  d.brake_torque = in.brake ? in.brake->torque : 0.0;
  d.brake_at = in.brake ? in.brake->at : HUGE_VAL;
  d.cut_at = in.motor.cut_at.value_or(HUGE_VAL);
  d.drag = in.screw.drag_torque;
  d.load_friction = in.load.friction_force;
  d.load_damping = in.load.damping;
  if (const auto& m = in.material_damping)
    d.material_damping = m->time ? *m->time : *m->loss_factor / (kTurn * *m->at_frequency);
  const auto stop = [](const std::optional<ResponseInput::EndStop>& s) {
    return s ? PrsStop{1, s->at, s->stiffness, s->damping} : PrsStop{};
  };
  d.stop[PRS_UPPER] = stop(in.end_stops.upper);
  d.stop[PRS_LOWER] = stop(in.end_stops.lower);
  if (in.shaft) {
    d.has_shaft = 1;
    d.fixed_fixed = in.shaft->ends == ResponseInput::Ends::fixed_fixed ? 1 : 0;
    d.shaft_length = in.shaft->length;
    d.shaft_span = in.shaft->span.value_or(HUGE_VAL);
    const double diameter = *c.mechanism.pitch_diameter.screw, bore = c.structure->screw.bore;
    d.shaft_rigidity = c.materials->screw.youngs_modulus * std::numbers::pi / 4.0 * (diameter * diameter - bore * bore);
  }
  d.start_position = in.start.position;
  d.start_speed = in.start.speed;
  d.start_deflection = in.start.deflection.value_or(HUGE_VAL);
  d.largest_torque = d.largest_speed = HUGE_VAL;
  d.by = in.motor.torque ? PRS_BY_TORQUE : PRS_BY_SPEED;
  if (const auto& k = in.motor.controller) {
    d.by = k->position ? PRS_POSITION_LOOP : PRS_SPEED_LOOP;
    d.position_gain = k->position_gain.value_or(0.0);
    d.speed_gain = k->speed_gain;
    d.integral_time = k->integral_time.value_or(0.0);
    d.largest_torque = k->largest_torque.value_or(HUGE_VAL);
    d.largest_speed = k->largest_speed.value_or(HUGE_VAL);
    d.feedback_of_load = k->feedback == ResponseInput::Feedback::load ? 1 : 0;
    d.feeds_speed_forward = k->speed_feed_forward ? 1 : 0;
  }
  if (in.motor.current_loop) d.time_constant = in.motor.current_loop->time_constant;
  return d;
}

DriveResult run_drive(const PrsDrive& drive, const ResponseInput& in, const std::vector<double>* times) {
  DriveSignals signals{BoundSignal(in.signal().terms()), BoundSignal(in.load.acting().terms())};
  DriveResult result;
  modules::loaded<ResponseModule>().integrate(
      {drive, signals.functions(), in.duration, in.interval(), times ? times->size() : in.samples(), in.tolerance,
       std::max(signals.motor.fastest(), signals.force.fastest()), times},
      result);
  if (result.status == DriveStatus::left_shaft && in.load.linkage)
    if (const double angle = prs_lever_at(&drive, result.position).angle; prs_is_dead_centre(angle))
      throw CaseError(
          "response.load.linkage",
          fmt::format("the lever reaches {:.4g} deg at {:.6g} s, a dead centre; expected an angle from 1 to "
                      "179 deg; change the motion, base or arm, or take an end stop",
                      angle * "deg"_per_si, result.stopped_at));
  if (result.status == DriveStatus::left_shaft)
    throw CaseError("response.shaft.length",
                    fmt::format("the nut leaves the shaft at position {:.6g} mm, {:.6g} s; expected a motion on the "
                                "shaft; take a longer one, or an end stop",
                                1e3 * result.position, result.stopped_at));
  return result;
}

ResponseResult analyze_response(const Case& c, const input::Source& source, const std::vector<double>* times) {
  ResponseResult r;
  r.input = with_signal_files(c, source);
  r.has_preload = c.preload.has_value();
  const SystemCurves curves = response_curves(c);
  r.warnings = curves.warnings;
  tell_of_preload(c, curves.load_case, r.warnings);
  const PrsDrive drive = drive_of(c, r.input, curves);
  r.load_case = curves.load_case;
  r.curves_force = std::min(curves.senses.tension.force.back(), curves.senses.compression.force.back());
  if (!curves.friction.speed.empty()) r.curves_speed = curves.friction.speed.back();
  r.can_open = drive.curves.tension.root != 0 || drive.curves.compression.root != 0;
  if (r.input.frequency_response) r.frequency_response = frequency_response(drive, r.input);
  r.run = run_drive(drive, r.input, times);
  const double least = 1e-4 * std::max(curves.senses.tension.force.back(), curves.senses.compression.force.back());
  for (const Direction d : kDirections) {
    const DrivePeak& peak = d == Direction::tension ? r.run.tension : r.run.compression;
    if (peak.value > 0.0) r.largest[d] = LargestForce{peak.value, peak.time};
  }
  const Contacts contacts = checked_contacts(c, Detail::complete);
  if (r.has_preload) {
    if (std::max(r.run.tension.value, r.run.compression.value) > least)
      put_under_preload(c, contacts, r.largest, least);
  } else {
    for (const Direction d : kDirections)
      if (r.largest[d] && r.largest[d]->force > least)
        r.largest[d] = under_solve(c, contacts, curves.load_case, *r.largest[d], d);
  }
  if (r.input.motor.controller && r.run.error.is_reached && drive.cut_at > 0.0)
    r.following_error =
        FollowingError{r.input.motor.controller->position.has_value(), r.run.error.value, r.run.error.time,
                       std::sqrt(r.run.error_squared / std::min(r.input.duration, drive.cut_at))};
  if (r.input.settling && r.converged()) r.settling = settling_of(r.input, r.run);
  add_warnings(c, r);
  return r;
}

}  // namespace prs
