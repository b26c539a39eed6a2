#pragma once

#include "prs/input/echo.h"
#include "prs/loads/result.h"
#include "prs/model/problems.h"
#include "prs/record/analysis.h"
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

/// Without contacts and threads.
Record<CheckResult> record_of(Type<CheckResult>);

/// With the verdict, for which it runs what the case is ready for.
const Analysis<CheckResult>& check_analysis();

/// `check` without the verdict.
Delivery run_check(const input::Source& source, const input::CaseInput& in);

/// A command that was run for a case: what it found, or what it found wrong.
struct Attempt {
  Command command = Command::check;
  const Delivery* delivery = nullptr;
  std::string failure = {};
};

/// The verdict on a case by what was run of it.
CaseVerdict verdict_by(const input::CaseInput& in, std::span<const Attempt> attempts);

}  // namespace prs
