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

template <>
Record<PartNumbers> record_of();
template <>
Record<PartSeries> record_of();
template <>
Record<InterfaceNumbers> record_of();
template <>
Record<HeatResult> record_of();
template <>
Record<HeatCycle> record_of();

}  // namespace prs
