#pragma once

#include <nlohmann/json.hpp>
#include <random>
#include <string>

/// Random cases that are mostly sound: keys, units, words and ranges are those of the schema, which
/// is that of prs/input/case_fields.h.
namespace prs::fuzz {

using Random = std::minstd_rand;

std::size_t below(std::size_t count, Random& random);

/// A random value of what the schema describes.
nlohmann::ordered_json random_value(const nlohmann::ordered_json& schema, Random& random);

/// Changes one thing in a value that the schema describes.
void change(nlohmann::ordered_json& value, const nlohmann::ordered_json& schema, Random& random);

/// The schema of the whole file.
const nlohmann::ordered_json& case_schema();

/// The schema of one alternative that takes the value, where there are several.
const nlohmann::ordered_json& taken_by(const nlohmann::ordered_json& schema,
                                       const nlohmann::ordered_json& value, Random& random);

}  // namespace prs::fuzz
