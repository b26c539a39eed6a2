#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "prs/loads/result.h"

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

/// Adds what every document says of the contacts, under `contact`, and of the threads by
/// themselves, under `threads`; nothing of these where no heights are given.
void put_contacts(nlohmann::ordered_json& document, const Contacts& contacts);

/// The document of `--json`: units stand in the keys, arrays start at the thread next to the loaded
/// end of the screw. What the result does not define is absent, as is a number that is not finite.
nlohmann::ordered_json to_json(const Result& result, const DocumentInfo& info);

/// Text of a document, two spaces deep, with a newline at the end. Malformed UTF-8 becomes U+FFFD.
std::string json_text(const nlohmann::ordered_json& document);

}  // namespace prs
