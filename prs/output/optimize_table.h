#pragma once

#include <string>

#include "prs/optimize/optimization_result.h"

namespace prs {

/// What came of an optimization within 110 columns: variables, objectives and what is constrained,
/// of the file's own design beside the compromise, the constraints, the check.
std::string optimize_table(const OptimizationResult& result);

}  // namespace prs
