#pragma once

#include <string>

#include "prs/loads/result.h"

namespace prs {

/// The load cases at a glance: one row per case and the warnings below, as a rule within
/// `kTableWidth` columns. Beyond 24 cases a range shows its first, middle and last point.
std::string load_case_table(const Result& result);

/// One case thread by thread: the load rate at both interfaces [%] as bars. For a case without an
/// answer, one line that says why.
std::string load_distribution_chart(const LoadCaseResult& result);

}  // namespace prs
