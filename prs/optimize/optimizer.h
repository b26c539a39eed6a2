#pragma once

#include "prs/optimize/optimization_result.h"
#include "prs/study/design_engine.h"
#include "prs/study/study_run.h"

namespace prs {

/// Answers designs, a row each.
using EvaluateDesigns = std::function<RowBlock(const std::vector<std::vector<Draw>>& designs)>;

struct OptimizeOptions {
  std::function<bool()> interrupted = {};            ///< Asked before designs are evaluated.
  std::function<void(StudyProgress)> progress = {};  ///< Told after designs were evaluated.
};

/// Searches the front, and once more with the second algorithm; the designs of both compete for the
/// front that is delivered. Every answer goes into the journal
/// at once. A search is a function of the optimization and the answers alone, so that one that was
/// interrupted is run again from its start on the answers that the journal holds, which takes no
/// time, and then goes on as if nothing had happened. Absent where it was interrupted. Throws what
/// `evaluate` and the journal throw.
std::optional<OptimizationResult> optimize(const Optimization& optimization,
                                           const EvaluateDesigns& evaluate, Journal& journal,
                                           const OptimizeOptions& options);

/// Value of a variable at x in [0, 1]: numbers are rounded to a power of ten, at most a millionth
/// of their range, so that they are the same wherever they are written down; levels share the
/// interval equally.
Draw draw_at(const Factor& variable, double x);

/// Position of the file's own value, such that `draw_at` gives it back; absent where the variable
/// does not have it.
std::optional<double> place_of_base(const Factor& variable);

/// A function that evaluates designs with the engine on `threads` threads. The engine must outlive
/// it.
EvaluateDesigns evaluate_in_parallel(const DesignEngine& engine, std::size_t threads);

}  // namespace prs
