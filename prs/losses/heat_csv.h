#pragma once

#include <string>

#include "prs/loads/result.h"
#include "prs/record/csv_style.h"

namespace prs {

/// Steady temperatures of the load cases that have a heat balance, a row each.
std::string heat_csv(const Result& result, const CsvStyle& style);

/// Temperatures over the cycle of a duty, a row for each time.
std::string heat_cycle_csv(const HeatCycle& cycle, const CsvStyle& style);

}  // namespace prs
