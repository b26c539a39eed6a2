#pragma once

#include "prs/optimize/optimize_files.h"

namespace prs {

/// Pictures of an optimization. The result must outlive the list.
Pictures optimization_pictures(const OptimizationResult& result);

}  // namespace prs
