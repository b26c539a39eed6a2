#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "prs/quantities/record.h"

namespace prs {

/// The table of results as a document: `documents`, where each record stands, and `records`, what
/// each quantity is.
nlohmann::ordered_json results_schema();

/// The record at a path of documents, `life` or `load_cases[]`; null where none stands.
const RecordInfo* record_at(std::string_view path);

}  // namespace prs
