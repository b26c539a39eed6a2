#include "prs/heat/analyze_heat.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "prs/heat/duty_cycle.h"
#include "prs/model/quantity_text.h"

namespace prs {
namespace {

/// Oils and hardened flanks of bearing steel last up to about 200 degC [K].
constexpr double kHotParts = 473.15;

HeatSource source_of(CaseLosses& exact, const CaseLosses& equal, bool may_grow) {
  return {[&exact](const OfParts& t) {
            const std::optional<Losses> losses = exact.at(t);
            return losses ? std::optional(losses->heat) : std::nullopt;
          },
          [&exact] { return exact.failure(); },
          [&equal](const PerInterface<double>& oil) { return equal.estimate(oil); },
          [&equal](const PerInterface<double>& oil) { return equal.rough_estimate(oil); },
          may_grow};
}

/// With solved shares from the steady state of equal ones.
SteadyHeat steady_heat_of(const Conditions& c, const Contacts& contacts, const LoadCase& load) {
  const ThermalNetwork network = thermal_network(*c.heat);
  CaseLosses equal(c, contacts, load, LoadCase::Share::equal);
  SteadyHeat found = find_steady_heat(network, source_of(equal, equal, heat_may_grow(c)));
  if (load.share == LoadCase::Share::equal || !found.converged()) return found;
  const bool others = found.others;
  CaseLosses solved(c, contacts, load, load.share);
  found = find_steady_heat(network, source_of(solved, equal, false), found.temperature);
  found.others = found.others || others;
  return found;
}

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
    warnings.push_back(
        {"heat", "no_steady_state", fmt::format("{}: {}", name(heat.status), heat.reason)});
    return;
  }
  if (heat.others)
    warnings.push_back(
        {"heat", "several_steady_states",
         "there are several steady states; this is the one that the parts reach from the "
         "temperature of their surroundings, hotter ones hold once they are reached"});
  for (const Part p : kParts)
    if (heat.temperature[p] > kHotParts)
      warnings.push_back(
          Warning{"heat", fmt::format("hot_{}", name(p)),
                  fmt::format("{} at {:.0f} degC: above {} oils and hardened flanks do not last",
                              name(p), heat.temperature[p] - 273.15, celsius(kHotParts))}
              .with(heat.temperature[p], kHotParts, text_unit::kelvin));
}

/// Moves those over that are not there yet.
void merge(std::vector<Warning> from, std::vector<Warning>& into) {
  for (Warning& warning : from)
    if (std::ranges::find(into, warning) == into.end()) into.push_back(std::move(warning));
}

}  // namespace

Result analyze_heat(const Conditions& c, Contacts contacts, AnalysisOptions options) {
  if (!c.heat) return analyze_slip(c, std::move(contacts), options);
  require_rolling(c, contacts);
  Result result;
  result.model = c.model;
  for (const LoadCase& load : c.load_cases) {
    const SteadyHeat found = steady_heat_of(c, contacts, load);
    const OfParts temperature =
        found.converged() ? found.temperature : OfParts::Constant(c.heat->ambient);
    const Oils oils = warm_oils(c, oil_temperatures(temperature));
    Result one = analyze_slip(at_temperatures(c, load, temperature), contacts, options, oils);
    LoadCaseResult& loaded = one.load_cases.front();
    loaded.heat = result_of(found, c.lubricant.has_value());
    if (!found.converged()) loaded.slip.reset();
    if (options.detail == Detail::complete) warn(*loaded.heat, loaded.warnings);
    result.load_cases.push_back(std::move(loaded));
    merge(std::move(one.warnings), result.warnings);
  }
  if (!c.heat->duty.empty()) {
    result.heat_cycle = periodic_heat_cycle(c, contacts, result.warnings);
    if (!result.heat_cycle->converged())
      result.warnings.push_back(
          {"heat.duty", "no_cycle",
           fmt::format("{}: {}", name(result.heat_cycle->status), result.heat_cycle->reason)});
  }
  result.contacts = std::move(contacts);
  return result;
}

}  // namespace prs
