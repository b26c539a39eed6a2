#pragma once

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

#include "prs/model/units.h"

// Quantities as problems state them, from SI, and in sentences of warnings.

namespace prs {

struct Warning;

/// Sentence of a warning with each quantity in braces: `the force, {12 kN}, is beyond {10 kN}`.
std::string marked_sentence(const Warning& warning);

/// The text with each quantity in braces replaced by what `shown` makes of it.
std::string with_quantities(std::string_view text, const auto& shown) {
  std::string all;
  for (std::size_t open = text.find('{'); open != text.npos; open = text.find('{')) {
    const std::string_view quantity = text.substr(open + 1, text.find('}', open) - open - 1);
    const std::size_t blank = quantity.find(' ');
    all.append(text.substr(0, open));
    text.remove_prefix(open + 1);
    if (blank == quantity.npos || unit_written(quantity.substr(blank + 1)).text.empty()) {
      all += '{';
    } else {
      all += shown(quantity);
      text.remove_prefix(quantity.size() + 1);
    }
  }
  return all.append(text);
}

inline std::string mm(double length) { return fmt::format("{:.7g} mm", 1e3 * length); }
inline std::string newton(double force) {
  return std::abs(force) < 1e3 ? fmt::format("{:.7g} N", force) : fmt::format("{:.7g} kN", 1e-3 * force);
}
inline std::string rpm(double speed) { return fmt::format("{:.7g} rpm", speed * 30.0 / std::numbers::pi); }
inline std::string mm2_per_s(double viscosity) { return fmt::format("{:.7g} mm^2/s", 1e6 * viscosity); }
inline std::string celsius(double temperature) { return fmt::format("{:.7g} degC", temperature - 273.15); }

}  // namespace prs
