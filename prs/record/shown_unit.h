#pragma once

#include <numbers>
#include <string_view>

namespace prs {

/// A unit of results: how the keys of documents end in it, how people write it, and shown = SI *
/// factor.
struct ShownUnit {
  std::string_view suffix;
  std::string_view text;
  double factor = 1.0;
};

inline constexpr ShownUnit kNoUnit;

/// Longer suffixes before their own ends.
inline constexpr ShownUnit kShownUnits[] = {
    {"_N_per_mm1_5", "N/mm^1.5", 3.16227766016837933e-5},  // 1000^-1.5
    {"_mm3_per_km", "mm³/km", 1e12},
    {"_mm_per_N1_3", "mm/N^(1/3)", 1e3},
    {"_mm_per_rad", "mm/rad", 1e3},
    {"_kN_per_kg", "kN/kg", 1e-3},
    {"_W_per_mm2", "W/mm²", 1e-6},
    {"_N_per_um", "N/µm", 1e-6},
    {"_mm_per_s", "mm/s", 1e3},
    {"_kg_per_m", "kg/m", 1.0},
    {"_kg_mm2", "kg mm²", 1e6},
    {"_per_mm", "1/mm", 1e-3},
    {"_revolutions", "revolutions", 1.0},
    {"_percent", "%", 100.0},
    {"_hours", "h", 1.0},
    {"_degC", "°C", 1.0},
    {"_mrad", "mrad", 1e3},
    {"_mPas", "mPa s", 1e3},
    {"_Nmm", "N mm", 1e3},
    {"_Nm", "N m", 1.0},
    {"_cm3", "cm³", 1e6},
    {"_GPa", "GPa", 1e-9},
    {"_MPa", "MPa", 1e-6},
    {"_rpm", "rpm", 30.0 / std::numbers::pi},
    {"_deg", "deg", 180.0 / std::numbers::pi},
    {"_km", "km", 1e-3},
    {"_kg", "kg", 1.0},
    {"_kN", "kN", 1e-3},
    {"_mm", "mm", 1e3},
    {"_um", "µm", 1e6},
    {"_nm", "nm", 1e9},
    {"_W", "W", 1.0},
    {"_K", "K", 1.0},
    {"_N", "N", 1.0},
    {"_J", "J", 1.0},
    {"_h", "h", 1.0 / 3600.0},
    {"_m", "m", 1.0},
    {"_s", "s", 1.0},
};

/// The unit at the end of a key, `MPa` of `peak_pressure_MPa`; kNoUnit where there is none, as in
/// `share_of_revolutions`.
constexpr const ShownUnit& unit_of(std::string_view key) {
  for (const ShownUnit& unit : kShownUnits)
    if (key.ends_with(unit.suffix))
      return key.substr(0, key.size() - unit.suffix.size()).ends_with("_of") ? kNoUnit : unit;
  return kNoUnit;
}

}  // namespace prs
