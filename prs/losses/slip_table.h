#pragma once

#include "prs/losses/slip_analysis.h"

namespace prs {

/// Slip at a glance, the warnings below: up to four load cases at length, more as one row per case.
/// Within 100 columns. `all`: with the estimates beside what is computed, by equal thread loads and
/// by a fit.
std::string slip_table(const Result& result, bool all = false);

/// One case thread by thread: the power lost at both interfaces of a roller [W] as bars. For a case
/// without an answer, one line that says why.
std::string slip_chart(const LoadCaseResult& result);

/// `slip.csv`: one row per load case, failed ones included: slip ratio, efficiency, power lost to
/// each source, torques, the hottest thread and what equal shares would give. Fields as in
/// `load_cases.csv`.
std::string slip_csv(const Result& result, const CsvStyle& style = {});

/// `slip_threads.csv`: one row per thread and interface of every load case with an answer.
std::string slip_threads_csv(const Result& result, const CsvStyle& style = {});

/// Steady temperatures of the load cases that have a heat balance, one row per case.
std::string heat_csv(const Result& result, const CsvStyle& style);

/// Temperatures over the cycle of a duty, a row for each time.
std::string heat_cycle_csv(const HeatCycle& cycle, const CsvStyle& style);

}  // namespace prs
