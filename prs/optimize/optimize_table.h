#pragma once

#include <string>

#include "prs/optimize/optimization_result.h"

namespace prs {

/// Result of an optimization within 100 columns: variables, objectives and constrained responses of
/// the file's own design and of the compromise, then the constraints and the check.
std::string optimize_table(const OptimizationResult& result);

/// Why there is no compromise; empty where there is one.
std::string optimize_failure(const OptimizationResult& result);

}  // namespace prs
