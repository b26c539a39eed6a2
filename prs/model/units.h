#pragma once

#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <string_view>

/// The units of results, SI and US, and the US units by definition (NIST SP 811, appendix B).
namespace prs {

inline constexpr double kInch = 0.0254;
inline constexpr double kPound = 0.45359237;
inline constexpr double kPoundForce = kPound * 9.80665;
inline constexpr double kPerInch = 1.0 / kInch;
inline constexpr double kPerPound = 1.0 / kPound;
inline constexpr double kPerPoundForce = 1.0 / kPoundForce;

/// A unit of results: how the keys of documents end in it, how people write it, and shown = SI *
/// factor. Tables in US units show another one where US designers use another.
struct ShownUnit {
  std::string_view suffix = {};
  std::string_view text = {};
  double factor = 1.0;
  std::string_view us_text = {};
  double us_factor = 1.0;

  bool operator==(const ShownUnit&) const = default;
};

inline constexpr ShownUnit kNoUnit;

/// Longer suffixes before their own ends.
inline constexpr ShownUnit kShownUnits[] = {
    {"_N_per_mm1_5", "N/mm^1.5", 3.16227766016837933e-5, "lbf/in^1.5", kPerPoundForce * 0.004048093872429343},
    {"_mm3_per_km", "mm³/km", 1e12},
    {"_mm_per_N1_3", "mm/N^(1/3)", 1e3, "in/lbf^(1/3)", kPerInch * 1.6446070162173028},
    {"_mm_per_rad", "mm/rad", 1e3, "in/rad", kPerInch},
    {"_kN_per_kg", "kN/kg", 1e-3, "lbf/lb", kPerPoundForce / kPerPound},
    {"_W_per_mm2", "W/mm²", 1e-6, "W/in²", 1.0 / (kPerInch * kPerInch)},
    {"_N_per_um", "N/µm", 1e-6, "lbf/µin", 1e-6 * kPerPoundForce / kPerInch},
    {"_um_per_Nm", "µm/(N m)", 1e6},
    {"_um_per_N", "µm/N", 1e6},
    {"_rad_per_s_per_Nm", "rad/s/(N m)", 1.0},
    {"_N_s_per_m", "N s/m", 1.0},
    {"_rad_per_m", "rad/m", 1.0},
    {"_m_per_s", "m/s", 1.0},
    {"_mm_per_min", "mm/min", 60e3, "in/min", 60.0 * kPerInch},
    {"_m_per_s2", "m/s²", 1.0},
    {"_mm_per_s", "mm/s", 1e3, "in/s", kPerInch},
    {"_W_per_K", "W/K", 1.0},
    {"_kg_per_m", "kg/m", 1.0, "lb/in", kPerPound / kPerInch},
    {"_kg_mm2", "kg mm²", 1e6, "lb in²", kPerPound* kPerInch* kPerInch},
    {"_per_mm", "1/mm", 1e-3, "1/in", 1.0 / kPerInch},
    {"_revolutions", "revolutions", 1.0},
    {"_percent", "%", 100.0},
    {"_h", "h", 1.0 / 3600.0},
    {"_hours", "h", 1.0},
    {"_degC", "°C", 1.0},
    {"_mrad", "mrad", 1e3},
    {"_mPas", "mPa s", 1e3},
    {"_Nmm", "N mm", 1e3, "lbf in", kPerPoundForce* kPerInch},
    {"_Nm", "N m", 1.0, "lbf in", kPerPoundForce* kPerInch},
    {"_cm3", "cm³", 1e6, "in³", kPerInch* kPerInch* kPerInch},
    {"_GPa", "GPa", 1e-9, "ksi", 1e-3 * kPerPoundForce / (kPerInch * kPerInch)},
    {"_MPa", "MPa", 1e-6, "ksi", 1e-3 * kPerPoundForce / (kPerInch * kPerInch)},
    {"_rpm", "rpm", 30.0 / std::numbers::pi},
    {"_deg", "deg", 180.0 / std::numbers::pi},
    {"_km", "km", 1e-3, "10^6 in", 1e-6 * kPerInch},
    {"_Hz", "Hz", 1.0},
    {"_kg", "kg", 1.0, "lb", kPerPound},
    {"_kN", "kN", 1e-3, "lbf", kPerPoundForce},
    {"_mm", "mm", 1e3, "in", kPerInch},
    {"_um", "µm", 1e6, "µin", 1e6 * kPerInch},
    {"_nm", "nm", 1e9, "µin", 1e6 * kPerInch},
    {"_W", "W", 1.0},
    {"_A", "A", 1.0},
    {"_V", "V", 1.0},
    {"_K", "K", 1.0},
    {"_N", "N", 1.0, "lbf", kPerPoundForce},
    {"_J", "J", 1.0},
    {"_m", "m", 1.0, "in", kPerInch},
    {"_s", "s", 1.0},
};

/// The unit that people write so, also `um` for `µm`; kNoUnit where there is none.
constexpr const ShownUnit& unit_written(std::string_view text) {
  constexpr std::string_view kMicro = "µ";
  for (const ShownUnit& unit : kShownUnits) {
    if (unit.text == text) return unit;
    const std::size_t at = unit.text.find(kMicro), after = at + kMicro.size();
    if (at != unit.text.npos && text.size() + 1 == unit.text.size() && text.substr(0, at) == unit.text.substr(0, at) &&
        text[at] == 'u' && text.substr(at + 1) == unit.text.substr(after))
      return unit;
  }
  return kNoUnit;
}

/// Unit with this text, `"kN"_unit`, and its factor from SI, `"kN"_per_si`; an unknown one does not compile.
consteval ShownUnit operator""_unit(const char* text, std::size_t size) {
  const ShownUnit& unit = unit_written({text, size});
  return unit.text.empty() ? throw std::invalid_argument("no such unit") : unit;
}
consteval double operator""_per_si(const char* text, std::size_t size) { return operator""_unit(text, size).factor; }

}  // namespace prs
