#pragma once

#include "prs/optimize/optimization_result.h"
#include "prs/record/pictures.h"

namespace prs {

/// What an optimization can show. The result must outlive the list.
Pictures optimization_pictures(const OptimizationResult& result);

}  // namespace prs
