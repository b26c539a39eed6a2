#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

#include "prs/report/findings.h"

namespace prs {

/// A section of the page and how it is written.
struct SectionRow {
  std::string_view id, title;
  std::function<std::string(Findings&)> make;
  bool is_quick = false;  ///< Of `solve` or `contact` alone: follows while a value moves.
};

/// In the order in which a reviewer asks: the answer, the part, what is doubtful, what was put in,
/// then what came out.
std::span<const SectionRow> section_rows();

ReportSection section_of(Findings& all, const SectionRow& row);

/// Every document, by its command under `results`.
nlohmann::ordered_json documents_of(const Findings& all);

}  // namespace prs
