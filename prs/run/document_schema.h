#pragma once

#include <span>
#include <string_view>

#include "prs/json_type.h"

namespace prs {

/// Commands that have a document of `--json`.
std::span<const std::string_view> documented_commands();

/// JSON Schema (draft 2020-12) of the document of one of them. It knows every key; which of them a
/// case defines is left open.
Json document_schema(std::string_view command);

}  // namespace prs
