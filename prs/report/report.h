#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "prs/input/source.h"

namespace prs {

struct ReportOptions {
  std::string command;  ///< That makes the report, as it is told to the reader.
  /// Where studies and optimizations of the case are looked for.
  std::vector<std::filesystem::path> results = {};
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
/// what `results` holds. Throws InputError where the case is wrong.
Report make_report(const input::Source& source, const ReportOptions& options);

}  // namespace prs
