#include "prs/heat/analyze_heat.h"

#include "prs/life/contact_loads.h"
#include "prs/model/quantity_text.h"
#include "prs/slip/running.h"

namespace prs {
namespace {

/// Oils and hardened flanks of bearing steel last up to about 200 degC [K].
constexpr double kHotParts = 473.15;

HeatResult result_of(const SteadyHeat& found, bool has_oil) {
  HeatResult heat;
  heat.status = found.status;
  heat.reason = found.reason;
  heat.evaluations = found.evaluations;
  heat.others = found.others;
  heat.temperature = per_part(found.temperature);
  if (has_oil) heat.oil = oil_temperatures(found.temperature);
  heat.heat = per_part(found.heat);
  return heat;
}

void warn(const HeatResult& heat, std::vector<Warning>& warnings) {
  if (!heat.converged()) {
    warnings.push_back(no_steady_state(heat.status, heat.reason));
    return;
  }
  if (heat.others)
    warnings.push_back({"heat", "several_steady_states",
                        "there are several steady states; this is the one that the parts reach from the "
                        "temperature of their surroundings, hotter ones hold once they are reached"});
  for (const Part p : kParts)
    if (heat.temperature[p] > kHotParts)
      warnings.push_back(Warning{"heat", fmt::format("hot_{}", name(p)),
                                 fmt::format("{} at {:.0f} degC: above {} oils and hardened flanks do not last",
                                             name(p), heat.temperature[p] - 273.15, celsius(kHotParts))}
                             .with(heat.temperature[p], kHotParts, "K"_unit));
}

/// Forces of one sense up to this number are solved one by one; of more, heat is interpolated over
/// the force through that many of Chebyshev's extreme points.
constexpr std::size_t kForces = 12;

/// Loads whose heat is the same function of the force.
struct Kind {
  Direction direction = Direction::tension;
  DrivenBy driven_by = DrivenBy::screw;

  auto operator<=>(const Kind&) const = default;
};

/// Shares of time by the force.
using Shares = std::map<double, double>;

/// Mean of any polynomial through the points, with few forces.
Shares on_points(const Shares& shares) {
  if (shares.size() <= kForces) return shares;
  const double least = shares.begin()->first, greatest = shares.rbegin()->first;
  std::vector<double> force(kForces), weight(kForces);
  for (std::size_t n = 0; n < kForces; ++n) {
    const double along = std::cos(std::numbers::pi * static_cast<double>(n) / (kForces - 1));
    force[n] = 0.5 * (least + greatest) - 0.5 * (greatest - least) * along;
    weight[n] = (n % 2 == 0 ? 1.0 : -1.0) * (n == 0 || n + 1 == kForces ? 0.5 : 1.0);
  }
  force.front() = least, force.back() = greatest;
  Shares found;
  for (const auto& [f, share] : shares) {
    // Lagrange's polynomials in barycentric form.
    const auto at = std::ranges::find(force, f);
    double sum = 0.0;
    for (std::size_t n = 0; n < kForces; ++n) sum += weight[n] / (f - force[n]);
    for (std::size_t n = 0; n < kForces; ++n) {
      const double basis = at != force.end() ? (*at == force[n] ? 1.0 : 0.0) : weight[n] / (f - force[n]) / sum;
      found[force[n]] += share * basis;
    }
  }
  return found;
}

/// The loads of a spectrum and their shares of time. With a clock, a history's rests have theirs.
std::vector<TimedLoad> timed_loads(const Conditions& c, double lead, const std::optional<LoadHistory>& history) {
  const double speed = std::abs(c.operation->speed);
  const std::vector<LoadStep> steps = load_steps(*c.life, history, lead, speed);
  std::vector<double> time(steps.size());
  double total = 0.0;
  const std::optional<double> clock = history ? duration(*history) : std::nullopt;
  for (std::size_t k = 0; k < steps.size(); ++k) time[k] = steps[k].revolutions;
  if (clock) time = moving_times(*history, lead, speed);
  for (const double t : time) total += t;
  if (clock) total = *clock;

  std::map<Kind, Shares> kinds;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const LoadStep& step = steps[k];
    if (!(time[k] > 0.0) || (step.axial_force == 0.0 && !c.preload)) continue;
    const Direction d = step.axial_force < 0.0 ? Direction::compression : Direction::tension;
    const double by_load = step.revolutions > 0.0 ? step.driven_by_load / step.revolutions : 0.0;
    for (const auto& [by, part] : {std::pair(DrivenBy::screw, 1.0 - by_load), std::pair(DrivenBy::load, by_load)})
      if (part > 0.0) kinds[{d, by}][std::abs(step.axial_force)] += part * time[k] / total;
  }
  std::vector<TimedLoad> loads;
  for (const auto& [kind, shares] : kinds)
    for (const auto& [force, share] : on_points(shares)) {
      LoadCase load = driven_load_case(c, lead, kind.direction, kind.driven_by);
      load.axial_force = force;
      loads.push_back({std::move(load), share});
    }
  return loads;
}

/// The case with its parts, and what films they have, at these temperatures.
Conditions warm(const Conditions& c, const PerPart<double>& temperature) {
  Conditions at = c;
  at.deviations.temperature = temperature;
  return at;
}

}  // namespace

void add_new(std::vector<Warning> found, std::vector<Warning>& warnings) {
  for (Warning& warning : found)
    if (std::ranges::find(warnings, warning) == warnings.end()) warnings.push_back(std::move(warning));
}

Warning no_steady_state(HeatStatus status, const std::string& reason) {
  return {"heat", "no_steady_state", fmt::format("{}: {}", name(status), reason)};
}

SteadyHeat steady_heat_of(const Conditions& c, const Contacts& contacts, std::span<const TimedLoad> loads) {
  const ThermalNetwork network = thermal_network(*c.heat);
  const auto shares_of = [&](const Conditions& conditions, std::optional<LoadCase::Share> in_place) {
    std::vector<LossShare> shares;
    for (const TimedLoad& l : loads)
      if (l.share > 0.0)
        shares.push_back(
            {l.share, std::make_shared<CaseLosses>(conditions, contacts, l.load, in_place.value_or(l.load.share)), {}});
    return shares;
  };
  const std::vector<LossShare> equal = shares_of(c, LoadCase::Share::equal);
  SteadyHeat found = find_steady_heat(network, mean_heat(equal, equal, c.friction->is(contact::Lubrication::mixed)));
  const bool solved =
      std::ranges::any_of(loads, [](const TimedLoad& l) { return l.load.share == LoadCase::Share::solved; });
  if (!solved || !found.converged()) return found;
  const bool others = found.others;
  const Conditions fitted = has_both_flanks(c, LoadCase::Share::solved) ? with_interference(c, contacts) : c;
  found = find_steady_heat(network, mean_heat(shares_of(fitted, {}), equal, false), found.temperature);
  found.others = found.others || others;
  return found;
}

namespace {

/// Load cases with the temperatures at which their losses flow off, with a duty those of its mean. Loads and losses
/// stay.
Result with_temperatures(Result result, const Conditions& c) {
  const ThermalNetwork network = thermal_network(*c.heat);
  for (LoadCaseResult& r : result.load_cases) {
    SteadyHeat found;
    bool known = true;
    const auto take = [&](const LoadCaseResult& loaded, double share) {
      known = known && loaded.slip && loaded.slip->converged();
      if (known) found.heat += share * heat_of(loaded.slip->power);
    };
    if (c.heat->duty.empty()) take(r, 1.0);
    for (const Heat::DutyStep& step : c.heat->duty)
      for (const LoadCaseResult& other : result.load_cases)
        if (step.load_case == other.load_case.name) take(other, step.time() / c.heat->period());
    found.temperature = network.steady(found.heat);
    found.status = known ? HeatStatus::converged : HeatStatus::no_steady_state;
    if (!known) found.reason = "there is no slip";
    r.heat = result_of(found, false);  // The oil has the temperature that the case states.
  }
  return result;
}

}  // namespace

Result analyze_heat(const Conditions& c, Contacts contacts, AnalysisOptions options) {
  if (!c.heat) return analyze_slip(c, std::move(contacts), options);
  if (!warms(c.heat)) return with_temperatures(analyze_slip(c, std::move(contacts), options), c);
  require_rolling(c, contacts);
  Result result;
  result.model = c.model;
  std::vector<Warning> of_cycle;
  if (!c.heat->duty.empty()) {
    result.heat_cycle = duty_cycle(c, contacts, of_cycle, nullptr, nullptr, options.temperature_limit);
    if (!result.heat_cycle->converged())
      of_cycle.push_back(
          {"heat.duty", "no_cycle", fmt::format("{}: {}", name(result.heat_cycle->status), result.heat_cycle->reason)});
  }
  const OfParts ambient = OfParts::Constant(c.heat->ambient);
  for (const LoadCase& load : c.load_cases) {
    SteadyHeat found;
    if (c.heat->has_mission()) {
      found.status = result.heat_cycle->status;
      found.reason = result.heat_cycle->reason;
      if (found.converged()) found.temperature = of_parts(result.heat_cycle->mean);
    } else {
      const TimedLoad all_the_time[] = {{load}};
      found = steady_heat_of(c, contacts, all_the_time);
    }
    const OfParts temperature = found.converged() ? found.temperature : ambient;
    const Oils oils = warm_oils(c, oil_temperatures(temperature));
    Result one = analyze_slip(at_temperatures(c, load, temperature), contacts, options, oils);
    LoadCaseResult& loaded = one.load_cases.front();
    if (c.heat->has_mission() && loaded.slip) found.heat = heat_of(loaded.slip->power);
    loaded.heat = result_of(found, c.lubricant.has_value());
    if (!found.converged()) loaded.slip.reset();
    if (options.detail == Detail::complete) warn(*loaded.heat, loaded.warnings);
    result.load_cases.push_back(std::move(loaded));
    add_new(std::move(one.warnings), result.warnings);
  }
  add_new(std::move(of_cycle), result.warnings);
  result.contacts = std::move(contacts);
  return result;
}

PreloadResult analyze_warm_preload(const Conditions& c, Contacts contacts) {
  if (!warms(c.heat)) return analyze_preload(c, std::move(contacts));
  require_rolling(c, contacts);
  const auto named = std::ranges::find_if(
      c.load_cases, [&](const LoadCase& load) { return !c.preload->load_case || load.name == *c.preload->load_case; });
  const TimedLoad all_the_time[] = {{*named}};
  const SteadyHeat heat = steady_heat_of(c, contacts, all_the_time);
  PreloadResult result = analyze_preload(
      warm(c, per_part(heat.converged() ? heat.temperature : OfParts::Constant(c.heat->ambient))), std::move(contacts));
  result.load_case = named->name;
  result.heat_status = heat.status;
  if (!heat.converged()) result.warnings.push_back(no_steady_state(heat.status, heat.reason));
  return result;
}

LifeResult analyze_warm_life(const Conditions& c, Contacts contacts, std::optional<LoadHistory> history) {
  if (!c.life->takes_heat(warms(c.heat))) return analyze_life(c, std::move(contacts), std::move(history));
  require_rolling(c, contacts);
  HeatStatus status = HeatStatus::converged;
  std::string reason;
  PerPart<double> temperature;
  std::vector<Warning> warnings;
  if (c.heat->duty.empty()) {
    const SteadyHeat heat = steady_heat_of(c, contacts, timed_loads(c, contacts.mechanism.lead, history));
    status = heat.status, reason = heat.reason;
    temperature = per_part(heat.temperature);
  } else {
    const HeatCycle cycle = duty_cycle(c, contacts, warnings);
    status = cycle.status, reason = cycle.reason;
    temperature = cycle.mean;
  }
  if (status != HeatStatus::converged) {
    temperature = per_part(OfParts::Constant(c.heat->ambient));
    warnings.push_back(no_steady_state(status, reason));
  }
  const Oils oils = warm_oils(c, oil_temperatures(of_parts(temperature)));
  LifeResult result = analyze_life(warm(c, temperature), std::move(contacts), std::move(history), oils);
  result.temperature_status = status;
  if (status == HeatStatus::converged)
    result.temperature = temperature;
  else if (!result.failure)
    result.failure = std::string(name(status)) + ": " + reason;
  result.warnings.insert(result.warnings.end(), warnings.begin(), warnings.end());
  return result;
}

}  // namespace prs
