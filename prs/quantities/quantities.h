#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "prs/model/units.h"
#include "prs/loads/result.h"

namespace prs {

/// A result with one value a thread, as documents and files show it: key with unit, shown = SI *
/// factor.
struct ThreadQuantity {
  std::string_view key;
  std::vector<double> InterfaceLoads::*values;
  double factor;
};

inline constexpr ThreadQuantity kThreadQuantities[] = {
    {"axial_load_N", &InterfaceLoads::axial_load, 1.0},
    {"normal_load_N", &InterfaceLoads::normal_load, 1.0},
    {"load_rate_percent", &InterfaceLoads::load_rate, per_si::percent},
    {"approach_um", &InterfaceLoads::approach, per_si::micrometre},
    {"semi_major_mm", &InterfaceLoads::semi_major, per_si::millimetre},
    {"semi_minor_mm", &InterfaceLoads::semi_minor, per_si::millimetre},
    {"peak_pressure_MPa", &InterfaceLoads::peak_pressure, per_si::megapascal},
    {"max_shear_stress_MPa", &InterfaceLoads::max_shear_stress, per_si::megapascal},
    {"max_shear_depth_mm", &InterfaceLoads::max_shear_depth, per_si::millimetre},
};

/// A result with one value a load case, absent where the case does not define it.
struct CaseQuantity {
  std::string_view key;
  std::optional<double> LoadCaseResult::*value;
  double factor;
};

inline constexpr CaseQuantity kCaseQuantities[] = {
    {"axial_displacement_um", &LoadCaseResult::axial_displacement, per_si::micrometre},
    {"axial_stiffness_N_per_um", &LoadCaseResult::axial_stiffness, per_si::newton_per_micrometre},
    {"tangent_stiffness_N_per_um", &LoadCaseResult::tangent_stiffness,
     per_si::newton_per_micrometre},
};

/// How the solve of a case ended; equal shares need no solve and count as converged.
inline std::string_view status_name(const LoadCaseResult& result) {
  return fe::name(result.solve ? result.solve->status : fe::NewtonStatus::converged);
}

/// Index of the largest value; absent where there is none.
inline std::optional<std::size_t> index_of_largest(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  const auto largest = std::max_element(values.begin(), values.end());
  return static_cast<std::size_t>(largest - values.begin());
}

/// The entry of a thread; absent where the list has none.
inline std::optional<double> entry(const std::vector<double>& values,
                                   std::optional<std::size_t> thread) {
  return thread && *thread < values.size() ? std::optional(values[*thread]) : std::nullopt;
}

}  // namespace prs
