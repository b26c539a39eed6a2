#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "prs/model/warning.h"

namespace prs {

/// What every document says of its origin.
struct DocumentInfo {
  std::string version;                      ///< Version of the program.
  std::string schema_version;               ///< Version of the input's schema.
  std::string input_sha256;                 ///< SHA-256 of the input file, hexadecimal.
  std::vector<std::string> overrides = {};  ///< `path=value` that changed it.
  std::string command = {};                 ///< The command that was run.
  std::string case_file = {};               ///< As it was given.
  /// The case with overrides and defaults in place; asked for once per document.
  std::function<nlohmann::ordered_json()> resolved_input = {};
};

/// How every document begins: its origin and the warnings on the whole input.
nlohmann::ordered_json document_head(const DocumentInfo& info,
                                     const std::vector<Warning>& warnings);

/// Text of a document, two spaces deep, with a newline at the end. Malformed UTF-8 becomes U+FFFD.
std::string json_text(const nlohmann::ordered_json& document);

/// Takes the pieces of a text.
using TextSink = std::function<void(std::string_view)>;

/// What `json_text` gives of a document whose list of load cases is empty in `outline` and filled
/// by `load_case`, one after the other: memory for one of them is enough.
void write_with_load_cases(
    const nlohmann::ordered_json& outline,
    const std::function<std::optional<nlohmann::ordered_json>(std::size_t)>& load_case,
    const TextSink& sink);

}  // namespace prs
