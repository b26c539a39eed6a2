#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "prs/input/echo.h"
#include "prs/loads/result.h"
#include "prs/model/command.h"
#include "prs/model/problems.h"
#include "prs/record/record.h"
#include "prs/run/verdict.h"

namespace prs {

/// What a case must get before a command runs; nothing where it does.
struct CommandNeeds {
  Command command = Command::check;
  std::vector<Problem> unmet;
  std::optional<ModelOptions::Loads> loads;  ///< Of a command that has loads of threads.
};

/// The resolved case, what follows from it, what is unusual, and what it is ready for.
struct CheckResult {
  std::vector<input::EchoEntry> fields;
  std::map<std::string, std::string> assumed;  ///< See `input::assumptions`.
  std::vector<CommandNeeds> commands;
  Result geometry;  ///< Contacts and warnings alone.
  std::optional<CaseVerdict> verdict = {};
};

/// Readiness by command and what to add, warnings, derived values.
std::string check_table(const CheckResult& result);

/// The same, with every value of the input: given, assumed or a default.
std::string full_check_table(const CheckResult& result);

/// Without contacts and threads.
template <>
Record<CheckResult> record_of();

void put_check(nlohmann::ordered_json& document, const CheckResult& result);

}  // namespace prs
