#pragma once

#include "prs/optimize/optimization_result.h"
#include "prs/record/csv_writer.h"

namespace prs {

/// Result of an optimization within 100 columns: variables, objectives and constrained responses of
/// the file's own design and of the compromise, then the constraints and the check.
std::string optimize_table(const OptimizationResult& result);

/// Why there is no compromise; empty where there is one.
std::string optimize_failure(const OptimizationResult& result);

/// The front of both searches, one row per design: where it stands in history.csv, whether it is
/// the compromise, the variables and what is linked to them (`mechanism.flank_angle.screw_deg`),
/// the responses under their paths.
std::string front_csv(const OptimizationResult& result, const CsvStyle& style = {});

/// Every design in the order in which it was evaluated, the file's own first: its number, the
/// algorithm, generation from 1, feasible, violation (empty without an answer), status, reason,
/// variables, responses.
std::string history_csv(const OptimizationResult& result, const CsvStyle& style = {});

}  // namespace prs
