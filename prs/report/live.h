#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "prs/input/source.h"
#include "prs/record/table_units.h"
#include "prs/report/report.h"

namespace prs {

/// What a page whose reader moves values wants to see anew.
struct LiveQuestion {
  std::size_t own = 0;  ///< So many of the overrides are the report's.
  bool quick = false;   ///< Only what follows while a value moves, from `solve` or `contact`.
  std::vector<std::string> sections = {};  ///< Empty: all.
  std::optional<ThreadChoice> thread = {};
  UnitSystem units = UnitSystem::si;
};

struct LiveAnswer {
  nlohmann::ordered_json sections;  ///< HTML, by their names; empty where nothing is to be shown.
  std::string head;                 ///< HTML above them; empty in a quick answer.
  nlohmann::ordered_json threads;   ///< As in `ReportParts`; null in a quick answer.
  bool all_follow = true;           ///< Whether no section keeps loads of its own.
  std::vector<std::string> notes;   ///< What could not be computed.
  bool converged = true;
};

/// The sections of `report_parts` for changed values, those of the report behind them. Throws
/// InputError where the case is wrong.
LiveAnswer live_sections(const input::Source& source, const LiveQuestion& question);

}  // namespace prs
