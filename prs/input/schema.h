#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace prs::input {

/// JSON Schema (draft 2020-12) of the input, for editors. It covers conditions on one key alone; bounds of dimensional
/// values other than their sign, and all relations between keys, are left to the reader. For references, `x-meaning`,
/// `x-value` and `x-condition` are the parts of a description.
nlohmann::ordered_json schema();

/// A key of the input as `--set` takes it, `load_cases[0].axial_force`, and its meaning.
struct InputKey {
  std::string path, meaning;
};

/// The path without brackets and their contents: `load_cases.axial_force`.
std::string without_places(std::string_view path);

/// All keys in the order of the schema; second overload: of the schema of a case.
std::vector<InputKey> input_keys(const nlohmann::ordered_json& schema);
const std::vector<InputKey>& input_keys();

}  // namespace prs::input
