#pragma once

#include <cstddef>

#include "prs/optimize/optimizer.h"
#include "prs/study/design_engine.h"

namespace prs {

/// A function that evaluates designs with the engine on `threads` threads. The engine must outlive
/// it.
EvaluateDesigns evaluate_in_parallel(const DesignEngine& engine, std::size_t threads);

}  // namespace prs
