#pragma once

#include "prs/page/live_parts.h"
#include "prs/report/report.h"

namespace prs {

struct PageOptions {
  std::string command = {};  ///< Command that makes the report, as it is told to the reader.
  /// Folders in which studies and optimizations of the case are looked for.
  std::vector<std::filesystem::path> results = {};
  /// Whether the page holds the engine, so that a reader with scripts may change values; else it is for
  /// reading alone.
  bool live = true;
  /// Folder of the engine and the scripts (`read_live_parts`). Where they are absent or of other sources, the
  /// page is static and a note says why.
  std::filesystem::path live_parts = {};
};

/// All that a case asks for, on one page.
struct Report {
  std::string html;
  /// The documents that the page was made of, by their commands, under `results`.
  nlohmann::ordered_json data;
  std::vector<std::string> notes;  ///< What could not be computed or was left out, a line each.
  bool converged = true;
};

/// Runs every command for which the case has all that it needs; of studies and optimizations, shows
/// what `results` holds. The page asks for nothing from anywhere, and its policy lets it ask for
/// nothing. Throws InputError where the case is wrong.
Report make_report(const input::Source& source, const PageOptions& options = {});

struct NamedText {
  std::string name, title, text;
};

/// The whole program as one page, with complete `parts`. `opened` is what it starts with, empty for the choice
/// of a start; `texts` are the lessons that it offers and, without a title, the files that cases name.
std::string workbench_page(const LiveParts& parts, const std::optional<input::Source>& opened,
                           const std::vector<NamedText>& texts);

}  // namespace prs
