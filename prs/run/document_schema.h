#pragma once

#include "prs/record/analysis.h"

namespace prs {

/// A record of documents with the keys that analyses add to it.
struct DocumentRecord {
  std::string_view path;
  RecordInfo record;
  bool required = true;
};

std::vector<DocumentRecord> records_at(std::span<const Place> places);

/// The table of results as a document: `documents`, where each record stands, `records`, what each
/// quantity is, and `analyses`, what each command is, its class in Python and its places.
Json results_schema();

/// The record at a path of documents, `life` or `load_cases[]`; null where none stands.
const RecordInfo* record_at(std::string_view path);

/// Commands that have a document of `--json`.
std::span<const std::string_view> documented_commands();

/// JSON Schema (draft 2020-12) of the document of one of them. It knows every key; which of them a
/// case defines is left open.
Json document_schema(std::string_view command);

}  // namespace prs
