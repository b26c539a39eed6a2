#pragma once

#include <nlohmann/json.hpp>

#include "prs/input/source.h"
#include "prs/record/table_units.h"
#include "prs/svg/elements.h"

namespace prs {

/// Largest sizes of a page's parts, in bytes.
struct ReportRoom {
  std::size_t files = 1'100'000;
  std::size_t pictures = 600'000;  ///< Size of pictures of stored studies.
  std::size_t data = 600'000;      ///< Size of data of all commands.
};

struct ReportOptions {
  std::string command = {};  ///< Command that makes the report, as shown to the reader.
  /// Folders to search for studies and optimizations of the case.
  std::vector<std::filesystem::path> results = {};
  ReportRoom room = {};
  bool summary = false;  ///< Whether the page is the sheet to sign alone.
};

constexpr std::string_view kSummary = "summary";  ///< Section of the sheet to sign, which screens show alone only.

/// A section of the page.
struct ReportSection {
  std::string id;
  std::string title;
  std::string body;  ///< HTML; empty if there is nothing to show.
};

/// All results of a case, in the parts of a page.
struct ReportParts {
  std::string title;  ///< Text.
  std::string mark;   ///< Text for every sheet of a print.
  std::string head;   ///< HTML above the sections.
  std::vector<ReportSection> sections;
  std::string foot;
  std::string controls;  ///< HTML of the sliders.
  Json threads;          ///< Threads that can be shown; null if there are none.
  /// Documents from which the page was made, by their commands, under `results`; `shown` lacks those that are too long
  /// for a page.
  Json data, shown;
  std::vector<std::string> notes;  ///< Failed or omitted parts, one per line.
  bool converged = true;
};

/// Runs every command for which the case has all inputs; for studies and optimizations, shows the contents of
/// `results`. Throws InputError if the case is wrong.
ReportParts report_parts(const input::Source& source, const ReportOptions& options);

/// A thread of a load case; both count from 0, threads over all rollers.
struct ThreadChoice {
  std::size_t load_case = 0;
  std::size_t thread = 0;
};

/// Request of a page whose reader moves values.
struct LiveQuestion {
  std::size_t own = 0;  ///< Number of overrides that are the report's.
  bool quick = false;   ///< Whether to return only parts that follow a moving value, from `solve` or `contact`.
  std::vector<std::string> sections = {};  ///< Empty: all.
  std::optional<ThreadChoice> thread = {};
  UnitSystem units = UnitSystem::si;
};

struct LiveAnswer {
  Json sections;                   ///< HTML of sections by their names; empty if nothing is to be shown.
  std::string head;                ///< HTML above them; empty in a quick answer.
  Json threads;                    ///< Threads as in `ReportParts`; null in a quick answer.
  bool all_follow = true;          ///< Whether no section keeps loads of its own, or stays unchanged.
  std::vector<std::string> kept;   ///< Sections that stay as in the report: their module is missing.
  std::vector<std::string> notes;  ///< Failed parts.
  bool converged = true;
};

/// Sections of `report_parts` for changed values, with those of the report behind them. Throws InputError if the case
/// is wrong.
LiveAnswer live_sections(const input::Source& source, const LiveQuestion& question);

/// A figure as an SVG element for an HTML page with `svg_style()`. `id` is unique on the page.
std::string svg(const Figure& figure, const std::string& id);

/// Rules for its classes, with the variables of the page's theme (`svg_rules`).
std::string svg_style();

}  // namespace prs
