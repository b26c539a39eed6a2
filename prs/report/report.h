#pragma once

#include <nlohmann/json.hpp>

#include "prs/input/source.h"
#include "prs/record/table_units.h"
#include "prs/svg/elements.h"

namespace prs {

/// So much a page carries, in bytes.
struct ReportRoom {
  std::size_t files = 1'100'000;
  std::size_t pictures = 600'000;  ///< Room for pictures of stored studies.
  std::size_t data = 600'000;      ///< Room for data of all commands.
};

struct ReportOptions {
  std::string command = {};  ///< Command that makes the report, as it is told to the reader.
  /// Folders in which studies and optimizations of the case are looked for.
  std::vector<std::filesystem::path> results = {};
  ReportRoom room = {};
};

/// A section of the page.
struct ReportSection {
  std::string id;
  std::string title;
  std::string body;  ///< HTML; empty where there is nothing to show.
};

/// All that a case asks for, in the parts of a page.
struct ReportParts {
  std::string title;  ///< Text.
  std::string mark;   ///< Text, of every sheet of a print.
  std::string head;   ///< HTML above the sections.
  std::vector<ReportSection> sections;
  std::string foot;
  std::string controls;  ///< HTML of the sliders.
  Json threads;          ///< Which threads can be looked at; null where none can.
  /// The documents that the page was made of, by their commands, under `results`; `shown` lacks
  /// those that are too long for a page.
  Json data, shown;
  std::vector<std::string> notes;  ///< What could not be computed or was left out, a line each.
  bool converged = true;
};

/// Runs every command for which the case has all that it needs; of studies and optimizations, shows
/// what `results` holds. Throws InputError where the case is wrong.
ReportParts report_parts(const input::Source& source, const ReportOptions& options);
/// The same of a requirement: `prs size`.
ReportParts requirement_parts(const input::Source& source, const ReportOptions& options);

/// A thread of a load case; both count from 0, threads over all rollers.
struct ThreadChoice {
  std::size_t load_case = 0;
  std::size_t thread = 0;
};

/// What a page whose reader moves values wants to see anew.
struct LiveQuestion {
  std::size_t own = 0;                     ///< So many of the overrides are the report's.
  bool quick = false;                      ///< Only what follows while a value moves, from `solve` or `contact`.
  std::vector<std::string> sections = {};  ///< Empty: all.
  std::optional<ThreadChoice> thread = {};
  UnitSystem units = UnitSystem::si;
};

struct LiveAnswer {
  Json sections;                   ///< HTML, by their names; empty where nothing is to be shown.
  std::string head;                ///< HTML above them; empty in a quick answer.
  Json threads;                    ///< As in `ReportParts`; null in a quick answer.
  bool all_follow = true;          ///< Whether no section keeps loads of its own, or stays.
  std::vector<std::string> kept;   ///< Sections that stay as the report has them: their module is not here.
  std::vector<std::string> notes;  ///< What could not be computed.
  bool converged = true;
};

/// The sections of `report_parts` for changed values, those of the report behind them. Throws
/// InputError where the case is wrong.
LiveAnswer live_sections(const input::Source& source, const LiveQuestion& question);

/// A figure as an SVG element for an HTML page with `svg_style()`. `id` is unique on the page.
std::string svg(const Figure& figure, const std::string& id);

/// The rules that its classes follow, by the variables of the page's theme (`svg_rules`).
std::string svg_style();

}  // namespace prs
