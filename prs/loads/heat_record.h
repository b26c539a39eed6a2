#pragma once

#include "prs/loads/result.h"
#include "prs/record/record.h"

namespace prs {

/// A number of each part as documents show it, of all rollers together.
struct PartNumbers {
  double screw = 0.0, rollers = 0.0, nut = 0.0;
};
/// Those over time.
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
Record<PartSeries> record_of(Type<PartSeries>);
Record<InterfaceNumbers> record_of(Type<InterfaceNumbers>);
Record<HeatResult> record_of(Type<HeatResult>);
Record<HeatCycle> record_of(Type<HeatCycle>);

}  // namespace prs
