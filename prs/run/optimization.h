#pragma once

#include "prs/input/optimize_reader.h"
#include "prs/optimize/optimizer.h"

namespace prs {

/// Checks limits relative to the file's own design once its responses are known. Throws InputError.
void check_initial(const input::OptimizeInput& input, const EvaluatedDesign& initial);

/// Runs the optimization of a source on `threads` threads: the file's own design first, on which
/// limits may depend, then the search on the journal that `open` gives for it. Absent where it was
/// interrupted. Throws InputError, also for a response that the design does not have.
std::optional<OptimizationResult> run_optimization(
    const input::OptimizeInput& in, std::size_t threads,
    const std::function<Journal(const JournalHeader&)>& open, const OptimizeOptions& options);

/// The source with the chosen design written into it; nothing where no design was chosen.
std::optional<std::string> chosen_case(const OptimizationResult& result,
                                       const input::Source& source);

}  // namespace prs
