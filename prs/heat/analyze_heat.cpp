#include "prs/heat/analyze_heat.h"

#include "prs/heat/duty_cycle.h"
#include "prs/model/quantity_text.h"
#include "prs/preload/preloaded_mechanism.h"

namespace prs {
namespace {

/// Oils and hardened flanks of bearing steel last up to about 200 degC [K].
constexpr double kHotParts = 473.15;

/// Losses of loads that take turns.
class MeanLosses {
 public:
  MeanLosses(const Conditions& c, const Contacts& contacts, std::span<const TimedLoad> loads,
             bool equal) {
    for (const TimedLoad& l : loads)
      if (l.share > 0.0)
        parts_.push_back(
            {l.share, std::make_unique<CaseLosses>(c, contacts, l.load,
                                                   equal ? LoadCase::Share::equal : l.load.share)});
  }

  std::optional<OfParts> at(const OfParts& t) {
    return sum([&](CaseLosses& losses) -> std::optional<OfParts> {
      const std::optional<Losses> found = losses.at(t);
      if (found) return found->heat;
      failure_ = losses.failure();
      return std::nullopt;
    });
  }
  std::optional<OfParts> estimate(const PerInterface<double>& oil) const {
    return sum([&](const CaseLosses& losses) { return losses.estimate(oil); });
  }
  std::optional<OfParts> rough_estimate(const PerInterface<double>& oil) const {
    return sum([&](const CaseLosses& losses) { return losses.rough_estimate(oil); });
  }
  const std::string& failure() const { return failure_; }

 private:
  template <class Heat>
  std::optional<OfParts> sum(Heat heat_of) const {
    OfParts all = OfParts::Zero();
    for (const auto& [share, losses] : parts_) {
      const std::optional<OfParts> heat = heat_of(*losses);
      if (!heat) return std::nullopt;
      all += share * *heat;
    }
    return all;
  }

  std::vector<std::pair<double, std::unique_ptr<CaseLosses>>> parts_;
  std::string failure_;
};

HeatSource source_of(MeanLosses& exact, const MeanLosses& equal, bool may_grow) {
  return {[&exact](const OfParts& t) { return exact.at(t); }, [&exact] { return exact.failure(); },
          [&equal](const PerInterface<double>& oil) { return equal.estimate(oil); },
          [&equal](const PerInterface<double>& oil) { return equal.rough_estimate(oil); },
          may_grow};
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
    warnings.push_back(no_steady_state(heat.status, heat.reason));
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

Warning no_steady_state(HeatStatus status, const std::string& reason) {
  return {"heat", "no_steady_state", fmt::format("{}: {}", name(status), reason)};
}

SteadyHeat steady_heat_of(const Conditions& c, const Contacts& contacts,
                          std::span<const TimedLoad> loads) {
  const ThermalNetwork network = thermal_network(*c.heat);
  MeanLosses equal(c, contacts, loads, true);
  SteadyHeat found = find_steady_heat(network, source_of(equal, equal, heat_may_grow(c)));
  const bool solved = std::ranges::any_of(
      loads, [](const TimedLoad& l) { return l.load.share == LoadCase::Share::solved; });
  if (!solved || !found.converged()) return found;
  const bool others = found.others;
  const Conditions fitted =
      has_both_flanks(c, LoadCase::Share::solved) ? with_interference(c, contacts) : c;
  MeanLosses exact(fitted, contacts, loads, false);
  found = find_steady_heat(network, source_of(exact, equal, false), found.temperature);
  found.others = found.others || others;
  return found;
}

Result analyze_heat(const Conditions& c, Contacts contacts, AnalysisOptions options) {
  if (!c.heat) return analyze_slip(c, std::move(contacts), options);
  require_rolling(c, contacts);
  Result result;
  result.model = c.model;
  for (const LoadCase& load : c.load_cases) {
    const TimedLoad all_the_time[] = {{load}};
    const SteadyHeat found = steady_heat_of(c, contacts, all_the_time);
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
