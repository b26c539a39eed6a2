#pragma once

#include <span>
#include <string>

#include "prs/record/analysis.h"
#include "prs/run/check.h"

namespace prs {

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
