#pragma once

#include "prs/loads/result.h"
#include "prs/run/verdict.h"

namespace prs {

/// Inputs that a case lacks for a command; none if the command runs.
struct CommandNeeds {
  Command command = Command::check;
  std::vector<Problem> unmet;
  std::optional<ModelOptions::Loads> loads;  ///< Kind of loads that a command with loads of threads uses.
  bool is_built = true;      ///< false if the program omits the command, or a part that the case requests (PRS_FULL).
  std::string failure = {};  ///< Error that it found in a complete input.
};

/// The resolved case, derived numbers, warnings, and the commands with complete inputs.
struct CheckResult {
  std::vector<input::EchoEntry> fields;
  std::map<std::string, std::string> assumed;  ///< See `input::assumptions`.
  std::vector<CommandNeeds> commands;
  Result geometry;  ///< Result with contacts and warnings only.
  std::optional<CaseVerdict> verdict = {};
};

/// Record without contacts and threads.
Record<CheckResult> record_of(Type<CheckResult>);

/// Basis of a value, `given`, `assumed` or `default`, and the reason of an assumed one.
std::pair<std::string_view, std::string_view> basis_of(const input::EchoEntry& field, const CheckResult& result);

/// Numbers that follow from the mechanism, by their keys in documents.
Json derived_of(const Mechanism& mechanism);

/// `check` with the verdict, for which all commands with complete inputs are run.
const Analysis<CheckResult>& check_analysis();

/// `check` without the verdict.
Delivery run_check(const input::Source& source, const input::CaseInput& in);

}  // namespace prs
