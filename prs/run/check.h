#pragma once

#include "prs/loads/result.h"
#include "prs/run/verdict.h"

namespace prs {

/// What a case must get before a command runs; nothing where it does.
struct CommandNeeds {
  Command command = Command::check;
  std::vector<Problem> unmet;
  std::optional<ModelOptions::Loads> loads;  ///< Loads that a command with loads of threads takes.
  bool is_built = true;  ///< False where the program leaves out the command, or what the case asks for (PRS_FULL).
};

/// The resolved case, what follows from it, what is unusual, and what it is ready for.
struct CheckResult {
  std::vector<input::EchoEntry> fields;
  std::map<std::string, std::string> assumed;  ///< See `input::assumptions`.
  std::vector<CommandNeeds> commands;
  Result geometry;  ///< Contacts and warnings alone.
  std::optional<CaseVerdict> verdict = {};
};

/// Without contacts and threads.
Record<CheckResult> record_of(Type<CheckResult>);

/// What a value rests on, `given`, `assumed` or `default`, and the reason of an assumed one.
std::pair<std::string_view, std::string_view> basis_of(const input::EchoEntry& field, const CheckResult& result);

/// Numbers that follow from the mechanism, by their keys in documents.
Json derived_of(const Mechanism& mechanism);

/// `check` with the verdict, for which it runs what the case is ready for.
const Analysis<CheckResult>& check_analysis();

/// `check` without the verdict.
Delivery run_check(const input::Source& source, const input::CaseInput& in);

}  // namespace prs
