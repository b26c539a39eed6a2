#pragma once

#include "prs/input/source.h"
#include "prs/json_type.h"

namespace prs::input {

/// The file of a source with its overrides and defaults in place: a case with the same results.
/// What is absent and has no default stays absent; a history has its place and its SHA-256. Throws
/// InputError.
nlohmann::ordered_json resolved_input(const Source& source);

/// SHA-256 of what is computed, hexadecimal: of the file; with overrides, or a history that it
/// names, of the file, then of each of these and of the SHA-256 of the history, with a NUL before.
std::string input_sha256(const Source& source);
/// The same of a source that names these files, by their texts.
std::string input_sha256(const Source& source, const std::vector<std::string>& files);

}  // namespace prs::input
