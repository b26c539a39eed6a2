#include "prs/study/schedule.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include "prs/study/journal.h"

namespace prs {
namespace {

/// Blocks on their way, a thread: enough that no thread waits for another.
constexpr std::size_t kBlocksPerThread = 4;

/// Runs a pipeline on so many threads, also where there are fewer processors.
template <class Filters>
void run_pipeline(std::size_t threads, const Filters& filters) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(static_cast<int>(threads));
  arena.execute([&] { tbb::parallel_pipeline(kBlocksPerThread * threads, filters); });
}

}  // namespace

std::size_t available_processors() {
  return static_cast<std::size_t>(tbb::info::default_concurrency());
}

void run_schedule(std::size_t threads, std::size_t chunk, const NextRange& next,
                  const Evaluate& evaluate, const TakeRecord& take) {
  const auto give = [&](tbb::flow_control& control) {
    const std::optional<DesignRange> range = next(chunk);
    if (!range) control.stop();
    return range.value_or(DesignRange{});
  };
  const auto compute = [&](DesignRange range) {
    return encode(evaluate(range.first, range.count));
  };
  run_pipeline(
      threads,
      tbb::make_filter<void, DesignRange>(tbb::filter_mode::serial_in_order, give) &
          tbb::make_filter<DesignRange, std::string>(tbb::filter_mode::parallel, compute) &
          tbb::make_filter<std::string, void>(tbb::filter_mode::serial_out_of_order, take));
}

void run_in_order(std::size_t count, std::size_t threads,
                  const std::function<std::function<void()>(std::size_t)>& prepare) {
  using Step = std::function<void()>;
  std::size_t next = 0;
  const auto give = [&](tbb::flow_control& control) {
    if (next == count) control.stop();
    return next == count ? 0 : next++;
  };
  const auto run = [](const Step& step) { step(); };
  run_pipeline(threads,
               tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, give) &
                   tbb::make_filter<std::size_t, Step>(tbb::filter_mode::parallel, prepare) &
                   tbb::make_filter<Step, void>(tbb::filter_mode::serial_in_order, run));
}

}  // namespace prs
