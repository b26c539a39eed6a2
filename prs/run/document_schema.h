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

/// Table of results as a document with `documents` (places of records), `records` (their quantities) and `analyses`
/// (commands with their classes in Python and their places).
Json results_schema();

/// Record at a path of documents, `life` or `load_cases[]`; null if there is none.
const RecordInfo* record_at(std::string_view path);

/// Commands that have a document of `--json`.
std::span<const std::string_view> documented_commands();

/// JSON Schema (draft 2020-12) of the document of one of them. It contains every key; the keys that a case defines are
/// left open.
Json document_schema(std::string_view command);

}  // namespace prs
