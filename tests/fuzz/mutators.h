#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

/// Random cases that are mostly valid: keys, units, words and ranges are those of the schema, which is that of
/// prs/input/case_fields.cpp.
namespace prs::fuzz {

struct Random : std::minstd_rand {
  /// Spreads consecutive seeds, so that their draws are independent.
  explicit Random(std::uint32_t seed) : std::minstd_rand(seed * 2654435761u + 1) {}

  bool gentle = false;  ///< Whether to change values only slightly, so that most cases stay valid.
};

std::size_t below(std::size_t count, Random& random);

/// A random value that the schema describes.
nlohmann::ordered_json random_value(const nlohmann::ordered_json& schema, Random& random);

/// Changes one item in a value that the schema describes.
void change(nlohmann::ordered_json& value, const nlohmann::ordered_json& schema, Random& random);

/// The schema of the whole file.
const nlohmann::ordered_json& case_schema();

/// Schema of one alternative that accepts the value, if there are several.
const nlohmann::ordered_json& taken_by(const nlohmann::ordered_json& schema, const nlohmann::ordered_json& value,
                                       Random& random);

}  // namespace prs::fuzz
