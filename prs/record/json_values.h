#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

namespace prs {

/// Sets the key to SI * factor; nothing where the value is absent or not finite.
inline void put(nlohmann::ordered_json& object, std::string_view key, std::optional<double> si,
                double factor = 1.0) {
  if (si && std::isfinite(*si)) object[key] = *si * factor;
}

/// An array of SI * factor.
inline nlohmann::ordered_json shown(const auto& si_values, double factor) {
  auto array = nlohmann::ordered_json::array();
  for (const double value : si_values) array.push_back(value * factor);
  return array;
}

}  // namespace prs
