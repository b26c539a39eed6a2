#pragma once

#include "prs/loads/result.h"
#include "prs/mechanism/modes.h"
#include "prs/record/record.h"

namespace prs {

Record<FrictionForces> record_of(Type<FrictionForces>);
Record<RunningLoads> record_of(Type<RunningLoads>);
Record<RunningLoads::AtRest> record_of(Type<RunningLoads::AtRest>);
Record<InterfaceLoads> record_of(Type<InterfaceLoads>);
Record<RollerShares> record_of(Type<RollerShares>);
Record<FullLoads> record_of(Type<FullLoads>);
Record<TravelResult> record_of(Type<TravelResult>);
Record<ModesResult> record_of(Type<ModesResult>);
Record<fe::NewtonIteration> record_of(Type<fe::NewtonIteration>);
Record<LoadCaseResult> record_of(Type<LoadCaseResult>);

/// Outcome of the solve of a case; equal shares need no solve and count as converged.
inline std::string_view status_name(const LoadCaseResult& result) {
  if (result.running) return name(result.running->status);
  return fe::name(result.solve ? result.solve->status : fe::NewtonStatus::converged);
}

/// Index of the largest value; absent if there is none.
inline std::optional<std::size_t> index_of_largest(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  const auto largest = std::max_element(values.begin(), values.end());
  return static_cast<std::size_t>(largest - values.begin());
}

/// Entry of a thread; absent if the list has none.
inline std::optional<double> entry_if_any(const std::vector<double>& values, std::optional<std::size_t> thread) {
  return thread && *thread < values.size() ? std::optional(values[*thread]) : std::nullopt;
}

/// Model of the bodies with which the loads were solved, and its known error.
struct ModelSummary {
  const Result* result = nullptr;
};

Record<ModelSummary> record_of(Type<ModelSummary>);

/// The model as a line for the terminal; empty if nothing was solved.
std::string model_line(const Result& result);

/// Whether the loads of any load case were solved.
bool has_solved(const Result& result);

/// Known error of the model at the full load of lesson 1's screw against finite elements (docs/refined.md,
/// docs/influence.md); empty for a model that was changed for comparison.
std::string_view known_bias(const ModelOptions& model);

/// A number of each part as documents show it, of all rollers together.
struct PartNumbers {
  double screw = 0.0, rollers = 0.0, nut = 0.0;
};
/// Times of each part; absent if nothing happens to it.
struct PartTimes {
  std::optional<double> screw, rollers, nut;
};
/// Numbers of each part over time.
struct PartSeries {
  std::vector<double> screw, rollers, nut;
};
struct InterfaceNumbers {
  double screw = 0.0, nut = 0.0;
};

inline constexpr double kZeroCelsius = 273.15;  // [K]

/// Temperatures in degC.
PartNumbers celsius_of(const PerPart<double>& kelvin);
PartSeries celsius_of(const PerPart<std::vector<double>>& kelvin);
InterfaceNumbers celsius_of(const PerInterface<double>& kelvin);

Record<PartNumbers> record_of(Type<PartNumbers>);
Record<PartTimes> record_of(Type<PartTimes>);
Record<PartSeries> record_of(Type<PartSeries>);
Record<InterfaceNumbers> record_of(Type<InterfaceNumbers>);
Record<HeatResult> record_of(Type<HeatResult>);
Record<HeatCycle> record_of(Type<HeatCycle>);

/// Contact of one interface, with related data of the threads.
struct ContactAt {
  const Contacts* contacts = nullptr;
  Interface interface = Interface::screw;

  const InterfaceContact& contact() const { return contacts->interfaces[interface]; }
  /// Whether the pitches are equal, so that backlash is defined.
  bool same_pitch() const {
    const contact::MechanismGeometry& threads = contacts->threads;
    return contact::same_pitch(interface == Interface::screw ? threads.screw : threads.nut, threads.roller);
  }
};

// One value per part, interface or sense of the load; the unit is that of the enclosing key.
Record<PerPart<double>> record_of(Type<PerPart<double>>);
Record<PerPart<std::array<double, 2>>> record_of(Type<PerPart<std::array<double, 2>>>);
Record<PerInterface<double>> record_of(Type<PerInterface<double>>);
Record<PerDirection<double>> record_of(Type<PerDirection<double>>);
Record<PerDirection<std::optional<double>>> record_of(Type<PerDirection<std::optional<double>>>);

Record<ContactAt> record_of(Type<ContactAt>);
Record<Contacts> record_of(Type<Contacts>);
Record<ThreadWidths> record_of(Type<ThreadWidths>);
/// Threads by themselves.
Record<contact::MechanismGeometry> record_of(Type<contact::MechanismGeometry>);

}  // namespace prs
