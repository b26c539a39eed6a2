#include "prs/loads/heat_record.h"

#include "prs/record/record_table.h"

namespace prs {
namespace {

constexpr Quantity<PartNumbers> kPartNumbers[] = {
    {"screw", of<&PartNumbers::screw>, "of the screw"},
    {"rollers", of<&PartNumbers::rollers>, "of all rollers"},
    {"nut", of<&PartNumbers::nut>, "of the nut"},
};

constexpr Quantity<PartSeries> kPartSeries[] = {
    {"screw", of<&PartSeries::screw>, "of the screw"},
    {"rollers", of<&PartSeries::rollers>, "of all rollers"},
    {"nut", of<&PartSeries::nut>, "of the nut"},
};

constexpr Quantity<InterfaceNumbers> kInterfaceNumbers[] = {
    {"screw", of<&InterfaceNumbers::screw>, "of the contacts at the screw"},
    {"nut", of<&InterfaceNumbers::nut>, "of the contacts at the nut"},
};

std::optional<std::string> reason_of(const std::string& reason) {
  return reason.empty() ? std::nullopt : std::optional(reason);
}

template <auto get>
constexpr auto balanced = of<get, &HeatResult::converged>;

constexpr Quantity<HeatResult> kHeat[] = {
    {"converged", of<&HeatResult::converged>, "whether there is a steady state"},
    {"status", of<&HeatResult::status>, "converged | no_steady_state | iteration_limit"},
    {"reason", of<[](const HeatResult& r) { return reason_of(r.reason); }>, "where not converged"},
    {"evaluations", of<&HeatResult::evaluations>, "of the losses at temperatures", "", "", "", "",
     Reach::document},
    {"other_steady_states", balanced<&HeatResult::others>,
     "whether hotter ones exist; this one is reached from ambient temperature"},
    {"temperature_degC", balanced<[](const HeatResult& r) { return celsius_of(r.temperature); }>,
     "of each part"},
    {"oil_degC", balanced<[](const HeatResult& r) {
       return r.oil ? std::optional(celsius_of(*r.oil)) : std::nullopt;
     }>,
     "at the contacts of each interface: the mean of its two bodies; needs a lubricant"},
    {"heat_W", balanced<[](const HeatResult& r) {
       return PartNumbers{r.heat.screw, r.heat.roller, r.heat.nut};
     }>,
     "that friction puts into each part"},
};

template <auto get>
constexpr auto periodic = of<get, &HeatCycle::converged>;

constexpr Quantity<HeatCycle> kHeatCycle[] = {
    {"converged", of<&HeatCycle::converged>, "whether there is a state that repeats itself"},
    {"status", of<&HeatCycle::status>, "converged | no_steady_state | iteration_limit"},
    {"reason", of<[](const HeatCycle& r) { return reason_of(r.reason); }>, "where not converged"},
    {"period_s", of<&HeatCycle::period>, "of the duty"},
    {"time_s", periodic<&HeatCycle::time>, "from the start of the cycle to its end"},
    {"temperature_degC", periodic<[](const HeatCycle& r) { return celsius_of(r.temperature); }>,
     "of each part at these times"},
    {"peak_degC", periodic<[](const HeatCycle& r) { return celsius_of(r.peak); }>,
     "largest of each part"},
    {"mean_degC", periodic<[](const HeatCycle& r) { return celsius_of(r.mean); }>,
     "of each part over the cycle"},
    {"energy_in_J", periodic<&HeatCycle::energy_in>,
     "that shaft and load bring in while they drive, per cycle"},
    {"energy_lost_J", periodic<&HeatCycle::energy_lost>, "to friction, per cycle"},
    {"efficiency", periodic<&HeatCycle::efficiency>, "energy out over energy in"},
};

}  // namespace

PartNumbers celsius_of(const PerPart<double>& k) {
  return {k.screw - kZeroCelsius, k.roller - kZeroCelsius, k.nut - kZeroCelsius};
}
PartSeries celsius_of(const PerPart<std::vector<double>>& kelvin) {
  PartSeries series{kelvin.screw, kelvin.roller, kelvin.nut};
  for (std::vector<double>* part : {&series.screw, &series.rollers, &series.nut})
    for (double& value : *part) value -= kZeroCelsius;
  return series;
}
InterfaceNumbers celsius_of(const PerInterface<double>& k) {
  return {k.screw - kZeroCelsius, k.nut - kZeroCelsius};
}

Record<PartNumbers> record_of(Type<PartNumbers>) {
  return {"PartNumbers", "A number of each part.", kPartNumbers};
}

Record<PartSeries> record_of(Type<PartSeries>) {
  return {"PartSeries", "Numbers of each part over time.", kPartSeries};
}

Record<InterfaceNumbers> record_of(Type<InterfaceNumbers>) {
  return {"InterfaceNumbers", "A number of each interface.", kInterfaceNumbers};
}

Record<HeatResult> record_of(Type<HeatResult>) {
  return {"Heat",
          "Steady temperatures: what friction puts into the parts flows off through the "
          "conductances.",
          kHeat};
}

Record<HeatCycle> record_of(Type<HeatCycle>) {
  return {"HeatCycle", "The state of a duty that repeats itself from cycle to cycle.", kHeatCycle};
}

}  // namespace prs
