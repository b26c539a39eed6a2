#pragma once

#include <string>

#include "prs/loads/result.h"

namespace prs {

/// Slip at a glance, the warnings below: up to four load cases at length, more as one row per case.
/// Within 100 columns. `all`: with the estimates beside what is computed, by equal thread loads and
/// by a fit.
std::string slip_table(const Result& result, bool all = false);

/// One case thread by thread: the power lost at both interfaces of a roller [W] as bars. For a case
/// without an answer, one line that says why.
std::string slip_chart(const LoadCaseResult& result);

}  // namespace prs
