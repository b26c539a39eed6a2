#pragma once

#include <functional>

#include "prs/study/designs.h"

namespace prs {

/// Answers designs [first, first + count), or the first of them where that takes long; none once
/// the run is interrupted. A pure function, called from many threads at once.
using Evaluate = std::function<RowBlock(std::size_t first, std::size_t count)>;

/// The next designs to evaluate, about `most` of them; none once all are given away. From any
/// thread.
using NextRange = std::function<std::optional<DesignRange>(std::size_t most)>;

/// Takes an encoded block, in any order, from any thread.
using TakeRecord = std::function<void(const std::string& record)>;

/// Processors that this process may use.
std::size_t available_processors();

/// Threads of a run whose user names no number: one per processor, or one where TBB is missing.
std::size_t default_threads();

/// Evaluates `chunk` designs at a time on `threads` threads until none is left, and encodes them,
/// in as many blocks as `evaluate` makes of them. The number of blocks under way is limited, so
/// that a slow `take` slows the rest down. An exception in one of the functions ends the run and is
/// thrown again.
void run_schedule(std::size_t threads, std::size_t chunk, const NextRange& next,
                  const Evaluate& evaluate, const TakeRecord& take);

/// Calls `prepare(k)` for k = 0 .. count-1 on `threads` threads, and what it returns one at a time
/// in the order of k.
void run_in_order(std::size_t count, std::size_t threads,
                  const std::function<std::function<void()>(std::size_t k)>& prepare);

}  // namespace prs
