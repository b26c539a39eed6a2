#pragma once

#include "prs/input/source.h"

namespace prs::input {

/// One value of a YAML document and its place.
struct Node {
  enum class Kind { null, scalar, sequence, map };

  Kind kind = Kind::null;
  bool quoted = false;    ///< Whether a scalar is in quotes or a text block: then never a number.
  std::string text = {};  ///< Text of a scalar.
  Place place = {};

  std::string key = {};  ///< Key of the value in its map.
  Place key_place = {};
  std::vector<Node> children = {};  ///< Entries of a sequence or map, in file order.
};

/// The value under a key of a map, or null.
const Node* find(const Node& map, std::string_view key);

/// Whether a value is a map {screw, roller, nut} or has one of these keys.
bool is_per_part(const Node& node);

/// Type of a scalar for every reader of YAML 1.2: `5` is a number, `"5"` and `5 mm` are texts.
enum class ScalarType { text, number, boolean };
ScalarType scalar_type(const Node& scalar);

/// Reads the one YAML document of a source and applies its overrides `path=value`, where a path is
/// `mechanism.rollers`, `load_cases[0].axial_force` or, by the entry's `name`,
/// `load_cases[pull].axial_force`, and the value is YAML. Missing maps are created; an index or a
/// name must exist, a name once.
///
/// Nesting is bounded by 64 levels and the document, with its aliases expanded, by 200,000 values.
/// Tags, merge keys (`<<`), further documents and texts that are not UTF-8 are refused. Throws
/// InputError; duplicate keys are added to `errors` and the first occurrence stays.
Node read_document(const Source& source, ErrorList& errors);

/// Sets the value at a path; missing maps are created. The key, and created maps, get the place `at`; the value keeps
/// its own. Adds an error at `at` and returns false if the path leads nowhere.
bool set_value(Node& root, const std::string& path, Node value, Place at, ErrorList& errors);

/// Applies the override with this index of the source that `errors` belongs to. Throws InputError.
void apply_override(Node& root, const Source& source, std::size_t index, ErrorList& errors);

/// The value as YAML on one line, as `--set PATH=` takes it.
std::string flow_text(const Node& value);

/// The value at a path, or null.
const Node* find_path(const Node& root, std::string_view path);

/// The path with indices in place of entry names: `load_cases[0].axial_force` for `load_cases[pull].axial_force`.
/// Unchanged if it leads nowhere.
std::string with_indices(const Node& root, const std::string& path);

/// Whether the node, a node below it or one of their keys is at the place.
bool stands_in(const Node& node, Place place);

/// Place of the value at a path such as `load_cases[0].axial_force`; if absent, place of the key of the innermost map
/// that exists.
Place locate(const Node& root, std::string_view path);

/// Adds an error at the place of a path.
void refuse(const Node& root, std::string_view path, std::string_view message, ErrorList& errors);

/// Throws the InputError that names the place of `path` in the source, for an error found only after the case was read.
[[noreturn]] void fail_at(const Source& source, std::string_view path, std::string_view message);
template <class Arg, class... Args>
[[noreturn]] void fail_at(const Source& source, std::string_view path, fmt::format_string<Arg, Args...> message,
                          Arg&& arg, Args&&... args) {
  fail_at(source, path, fmt::format(message, std::forward<Arg>(arg), std::forward<Args>(args)...));
}

/// Runs `compute` on a case that came from `source`, so that errors of the case are reported at their places.
template <class Compute>
auto compute_from(const Source& source, Compute compute) {
  try {
    return compute();
  } catch (const CaseError& error) {
    fail_at(source, error.path(), error.what());
  }
}

}  // namespace prs::input
