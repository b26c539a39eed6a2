#include "prs/losses/slip_criteria.h"

#include <fmt/format.h>

#include "prs/heat/analyze_heat.h"
#include "prs/heat/thermal_network.h"
#include "prs/loads/load_criteria.h"
#include "prs/losses/motor_demand.h"
#include "prs/slip/slip.h"

namespace prs {
namespace {

/// The efficiency over a spectrum of distances whose steps that the screw drives are load cases, each at its force:
/// sum F s over sum F s/eta. Absent where a step is none.
std::optional<double> efficiency_over_spectrum(const Result& slip, const Case& c) {
  if (!c.life || c.life->history) return std::nullopt;
  double out = 0.0, in = 0.0;
  for (const SpectrumLoad& step : c.life->spectrum) {
    if (!step.distance) return std::nullopt;
    const double work = step.force * *step.distance;
    if (step.driven_by == DrivenBy::load || work == 0.0) continue;
    std::optional<double> worst;  // Least efficiency of load cases at other speeds.
    for (const LoadCaseResult& r : slip.load_cases) {
      const double force = std::abs(r.load_case.axial_force);
      if (r.load_case.direction == step.direction && std::abs(force - step.force) <= kLimitRounding * force &&
          r.slip->driven_by == DrivenBy::screw && r.slip->efficiency)
        worst = std::min(*r.slip->efficiency, worst.value_or(*r.slip->efficiency));
    }
    if (!worst) return std::nullopt;
    out += work;
    in += work / *worst;
  }
  return in > 0.0 ? std::optional(out / in) : std::nullopt;
}

bool has_answer(const LoadCaseResult& r) { return r.slip && r.slip->has_answer(); }
bool has_temperatures(const LoadCaseResult& r) { return !r.heat || r.heat->converged(); }
bool screw_drives(const LoadCaseResult& r) {
  return r.slip && !r.slip->is_held() && r.slip->driven_by == DrivenBy::screw;
}

/// Efficiency of the load cases in which the screw drives, over the duty cycle or the spectrum if there is one.
FoundCriterion efficiency(const Result& slip, const Case& c) {
  FoundCriterion found("efficiency", "the screw drives in no load case");
  found.applies = std::ranges::any_of(slip.load_cases, screw_drives);
  // The life of a mission rests on its mean temperatures, and so does its efficiency over the spectrum.
  if (const auto& cycle = slip.heat_cycle; cycle && !(cycle->is_mission() && c.life)) {
    const char* const whole = cycle->is_mission() ? "over the mission" : "over the cycle";
    if (found.applies && cycle->converged()) found.take(cycle->efficiency, "heat.duty", whole);
    if (!cycle->converged()) found.why = "the duty cycle did not converge", found.applies = true;
    return found;
  }
  for (const LoadCaseResult& r : slip.load_cases) {
    if (!has_answer(r)) return {"efficiency", fmt::format("the slip of {} did not converge", r.load_case.name)};
    if (r.slip->status == SlipStatus::imposed)
      return {"efficiency",
              fmt::format("{} has a stated slip ratio, which takes a force of its own", r.load_case.name)};
    if (screw_drives(r)) found.take(r.slip->efficiency, r.load_case.name);
  }
  if (const std::optional<double> whole = efficiency_over_spectrum(slip, c)) {
    found.value = found.best = whole;
    found.where = "life.spectrum";
    found.note = "over its travel";
  }
  return found;
}

/// The load cases of a duty cycle with stated losses all have the temperatures of its mean.
FoundCriterion temperature(const Result& slip, const Case& c) {
  FoundCriterion found("temperature", "the temperatures did not converge");
  if (slip.heat_cycle) {
    if (slip.heat_cycle->converged()) take_temperatures(found, slip.heat_cycle->peak, "heat.duty");
  } else if (std::ranges::all_of(slip.load_cases, [](const auto& r) { return r.heat && r.heat->converged(); })) {
    const bool of_cycle = c.heat && !c.heat->duty.empty();
    for (const LoadCaseResult& r : slip.load_cases)
      take_temperatures(found, r.heat->temperature, of_cycle ? "heat.duty" : r.load_case.name);
  }
  return found;
}

/// Films at the mean temperatures of a duty: those at steady temperatures, which it never reaches, say nothing.
std::optional<Result> films_over_duty(const Result& slip, const Case& c) {
  if (!slip.heat_cycle || !c.lubricant || !c.roughness) return std::nullopt;
  Conditions warm = c;
  warm.deviations.temperature = temperature_of(slip, c, 0);
  if (!warm.deviations.temperature) return std::nullopt;
  warm.heat.reset();
  const Oils oils = warm_oils(c, oil_temperatures(of_parts(*warm.deviations.temperature)));
  return analyze_slip(warm, slip.contacts, kManyDesigns, oils);
}

/// Film ratios of all threads, of both nuts where there are two.
std::vector<std::pair<Interface, double>> film_ratios(const SlipResult& slip) {
  std::vector<std::pair<Interface, double>> all;
  for (const SlipResult* nut : {&slip, static_cast<const SlipResult*>(slip.second_nut.get())})
    for (const Interface i : kInterfaces)
      if (nut)
        for (const double ratio : nut->threads[i].film_ratio) all.emplace_back(i, ratio);
  return all;
}

/// Central film over roughness, the least of all threads.
FoundCriterion film(const Result& slip, const Case& c) {
  FoundCriterion found("film", !c.lubricant      ? "no lubricant"
                               : !c.roughness    ? "add roughness"
                               : slip.heat_cycle ? "the temperatures of the duty did not converge"
                               : std::ranges::any_of(slip.load_cases, is_held)    ? "a screw at rest has no film"
                               : std::ranges::all_of(slip.load_cases, has_answer) ? "no thread touches"
                                                                                  : "the slip did not converge");
  found.applies = c.lubricant.has_value();
  const std::optional<Result> mean = films_over_duty(slip, c);
  if (slip.heat_cycle && !mean) return found;
  for (const LoadCaseResult& r : (mean ? *mean : slip).load_cases)
    if (r.slip && r.slip->converged())
      for (const auto& [i, ratio] : film_ratios(*r.slip))
        if (ratio > 0.0)
          found.take(ratio, r.load_case.name,
                     fmt::format("roller-{}{}{}", name(i), mean ? ", at the mean temperatures of the duty" : "",
                                 c.life ? "; lives are those of full, clean films" : ""));
  return found;
}

const LoadCaseResult* named(const Result& result, const std::optional<std::string>& name) {
  const auto found =
      std::ranges::find_if(result.load_cases, [&](const LoadCaseResult& r) { return r.load_case.name == name; });
  return found == result.load_cases.end() ? nullptr : &*found;
}

/// Whether the screw locks itself; not where slip has no answer.
bool locks(const Result* slip, const MotorDuty& duty) {
  const LoadCaseResult* const back = slip ? named(*slip, duty.driven_back) : nullptr;
  return back && back->slip && back->slip->converged() && back->slip->self_locking.value_or(false);
}

/// Demand of the cycle on the motor, each step with the friction of its load case; none without slip or inertia.
std::optional<MotorDemand> demand_of(const MotorDuty& duty, const Result* slip, double lead,
                                     std::optional<double> inertia) {
  if (!slip || !inertia) return std::nullopt;
  std::vector<DrivenStep> steps;
  for (const MotorDuty::Step& step : duty.cycle) {
    const LoadCaseResult* const loaded = named(*slip, step.load_case);
    const std::optional<double> torque = loaded ? screw_torque(*loaded, lead) : 0.0;
    if (!torque) return std::nullopt;
    const double force = loaded ? loaded->load_case.axial_force : 0.0;
    steps.push_back({step, force != 0.0 ? *torque * std::abs(step.force / force) : *torque});
  }
  return motor_demand(steps, duty.motor, lead, *inertia, duty.drag_torque, duty.brake_torque || locks(slip, duty));
}

}  // namespace

std::vector<FoundCriterion> slip_criteria(const Result& slip, const JudgedCase& of) {
  // Slip has running loads of warm parts, but in a duty cycle at steady temperatures that it never reaches; in a
  // mission at its mean ones.
  const bool is_steady = !slip.heat_cycle || slip.heat_cycle->is_mission();
  std::vector<FoundCriterion> all{is_steady ? pressure_criterion(slip, of, false) : FoundCriterion("peak_pressure"),
                                  efficiency(slip, of.c), film(slip, of.c)};
  if (of.c.heat) all.push_back(temperature(slip, of.c));
  if (is_steady) {
    all.push_back(convergence(failed_cases(slip, "slip", has_answer)));
    all.push_back(convergence(failed_cases(slip, "temperatures", has_temperatures)));
  }
  if (slip.heat_cycle) all.push_back(convergence(slip.heat_cycle->converged() ? "" : "the duty cycle"));
  return all;
}

std::optional<PerPart<double>> temperature_of(const Result& slip, const Case& c, std::size_t load_case) {
  if (!warms(c.heat)) return std::nullopt;
  if (const auto& cycle = slip.heat_cycle) return cycle->converged() ? std::optional(cycle->mean) : std::nullopt;
  const auto& heat = slip.load_cases[load_case].heat;
  return heat && heat->converged() ? std::optional(heat->temperature) : std::nullopt;
}

std::vector<FoundCriterion> motor_criteria(const Case& c, const MotorDuty& duty, const Result* slip,
                                           std::optional<double> inertia, const std::string* why) {
  const double lead = std::abs(c.mechanism.lead), per_speed = 2.0 * std::numbers::pi * duty.motor.gear_ratio / lead;
  FoundCriterion speed("motor_speed", "nothing moves"), brake("brake", "no force at rest");
  double largest = 0.0;
  for (const MotorDuty::Step& step : duty.cycle) largest = std::max(largest, step.largest_speed());
  speed.applies = largest > 0.0;
  if (speed.applies) speed.take(per_speed * largest * "rpm"_per_si, "");
  if (duty.motor.largest_speed) speed.limit = *duty.motor.largest_speed * "rpm"_per_si;
  brake.applies = duty.holding_force > 0.0;
  if (duty.brake_torque) {
    brake.limit = 1.0;
    if (brake.applies)
      brake.take(*duty.brake_torque / (duty.brake_safety * duty.holding_force / per_speed), "",
                 fmt::format("with a safety of {:g}", duty.brake_safety));
  }
  std::vector<FoundCriterion> all{speed, brake};
  if (!slip && !why) return all;
  const std::string reason = !slip ? *why : "a step has no slip, or the parts no inertia";
  FoundCriterion rms("motor_torque", reason), peak("motor_peak_torque", reason);
  const std::optional<MotorDemand> demand = demand_of(duty, slip, lead, inertia);
  const std::string_view at_mean =
      slip && slip->heat_cycle && slip->heat_cycle->is_mission() ? ", at the mean temperatures of the mission" : "";
  const std::string of_cycle = fmt::format("motor.cycle{}", at_mean), over_cycle = "rms over " + of_cycle;
  if (demand) {
    rms.take(demand->rms_torque, "", over_cycle);
    peak.take(demand->peak_torque, "", of_cycle);
  }
  FoundCriterion voltage("motor_voltage", duty.motor.resistance ? reason : "add motor.resistance"),
      current("motor_current", reason), rms_current("motor_rms_current", reason);
  if (demand && demand->electric) {
    voltage.take(demand->electric->peak_voltage, "", of_cycle);
    current.take(demand->electric->peak_current, "", of_cycle);
    rms_current.take(demand->electric->rms_current, "", over_cycle);
  }
  rms.limit = duty.motor.rated_torque;
  peak.limit = duty.motor.peak_torque;
  voltage.limit = duty.motor.supply.voltage;
  current.limit = duty.motor.supply.current;
  rms_current.limit = duty.motor.continuous_current;
  all.insert(all.end(), {rms, peak, voltage, current, rms_current});
  if (duty.back_driving == BackDriving::allowed) return all;
  FoundCriterion back("back_driving");
  back.standing = locks(slip, duty) == (duty.back_driving == BackDriving::forbidden) ? Standing::green : Standing::red;
  back.note = locks(slip, duty) ? "the screw locks itself" : "the load turns the screw";
  all.push_back(back);
  return all;
}

}  // namespace prs
