#pragma once

#include "prs/loads/load_json.h"
#include "prs/optimize/optimization_result.h"
#include "prs/record/record.h"

namespace prs {

Record<OptimizationResult> record_of(Type<OptimizationResult>);

/// The document of `prs optimize --json`: what was asked for, the file's own design, the
/// compromise with changes in percent, the front by numbers of its designs, of each search its own
/// front, and of a check how the two compare.
nlohmann::ordered_json optimize_json(const OptimizationResult& result, const DocumentInfo& info);

}  // namespace prs
