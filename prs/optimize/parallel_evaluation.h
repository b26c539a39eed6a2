#pragma once

#include <cstddef>

#include "prs/optimize/optimizer.h"
#include "prs/study/design_engine.h"

namespace prs {

/// Has the engine, which must outlive the function, answer designs on so many threads.
EvaluateDesigns evaluate_in_parallel(const DesignEngine& engine, std::size_t threads);

}  // namespace prs
