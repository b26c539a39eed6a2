#pragma once

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

// Quantities as problems state them, from SI.

namespace prs {

inline std::string mm(double length) { return fmt::format("{:.7g} mm", 1e3 * length); }
inline std::string newton(double force) {
  return std::abs(force) < 1e3 ? fmt::format("{:.7g} N", force) : fmt::format("{:.7g} kN", 1e-3 * force);
}
inline std::string rpm(double speed) { return fmt::format("{:.7g} rpm", speed * 30.0 / std::numbers::pi); }
inline std::string mm2_per_s(double viscosity) { return fmt::format("{:.7g} mm^2/s", 1e6 * viscosity); }
inline std::string celsius(double temperature) { return fmt::format("{:.7g} degC", temperature - 273.15); }

}  // namespace prs
