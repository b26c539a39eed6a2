#pragma once

#include "prs/page/live_parts.h"
#include "prs/report/report.h"

namespace prs {

struct PageOptions {
  std::string command = {};  ///< Command that makes the report, as shown to the reader.
  /// Folders to search for studies and optimizations of the case.
  std::vector<std::filesystem::path> results = {};
  /// Whether the page holds the engine, so that a reader with scripts may change values; else it is static.
  bool live = true;
  /// Folder of the engine and the scripts (`read_live_parts`). If they are absent or of other sources, the page is
  /// static and a note gives the reason.
  std::filesystem::path live_parts = {};
  bool summary = false;  ///< Whether the page is the sheet to sign alone, without scripts.
};

/// All results of a case on one page.
struct Report {
  std::string html;
  /// Documents from which the page was made, by their commands, under `results`.
  nlohmann::ordered_json data;
  std::vector<std::string> notes;  ///< Failed or omitted parts, one per line.
  bool converged = true;
};

/// Runs every command for which the case has all inputs; for studies and optimizations, shows the results in `results`.
/// The page loads nothing from elsewhere, and its policy forbids it. Throws InputError if the case is wrong.
Report make_report(const input::Source& source, const PageOptions& options = {});

struct NamedText {
  std::string name, title, text;
};

/// The whole program as one page, with complete `parts`. `opened` is the case that it opens, empty for a choice;
/// `texts` are the lessons that it offers and, without a title, the files that cases name.
std::string workbench_page(const LiveParts& parts, const std::optional<input::Source>& opened,
                           const std::vector<NamedText>& texts);

}  // namespace prs
