#include "prs/study/schedule.h"

#include <sched.h>

#include <algorithm>
#include <thread>

#include "prs/components/pipeline.h"
#include "prs/study/journal.h"

namespace prs {
namespace {

/// Blocks on their way, a thread: enough that no thread waits for another.
constexpr std::size_t kBlocksPerThread = 4;

/// PipelineModule::run on items that are kept here. One thread does without the module.
template <class Item, class Give, class Prepare, class Take>
void run_pipeline(std::size_t threads, bool in_order, const Give& give, const Prepare& prepare,
                  const Take& take) {
  std::vector<Item> items(threads == 1 ? 1 : kBlocksPerThread * threads);
  if (threads == 1) {
    for (Item& item = items.front(); give(item); take(item)) prepare(item);
    return;
  }
  modules::loaded<PipelineModule>().run(
      threads, items.size(), in_order, [&](std::size_t k) { return give(items[k]); },
      [&](std::size_t k) { prepare(items[k]); }, [&](std::size_t k) { take(items[k]); });
}

}  // namespace

std::size_t available_processors() {
  cpu_set_t own;
  CPU_ZERO(&own);
  if (sched_getaffinity(0, sizeof own, &own) == 0) return static_cast<std::size_t>(CPU_COUNT(&own));
  return std::max(1u, std::thread::hardware_concurrency());  // More than the set can hold.
}

std::size_t default_threads() {
  const std::size_t processors = available_processors();
  if (processors == 1) return 1;
  try {
    modules::loaded<PipelineModule>();
  } catch (const modules::Missing&) {
    return 1;
  }
  return processors;
}

void run_schedule(std::size_t threads, std::size_t chunk, const NextRange& next,
                  const Evaluate& evaluate, const TakeRecord& take) {
  struct Block {
    DesignRange designs;
    std::string record;
  };
  const auto give = [&](Block& block) {
    const std::optional<DesignRange> designs = next(chunk);
    block.designs = designs.value_or(DesignRange{});
    return designs.has_value();
  };
  const auto compute = [&](Block& block) {
    DesignRange& rest = block.designs;
    do {
      const RowBlock rows = evaluate(rest.first, rest.count);
      block.record.clear();
      if (rows.rows == 0) return;
      rest = {rest.first + rows.rows, rest.count - rows.rows};
      block.record = encode(rows);
      if (rest.count > 0) take(block.record);
    } while (rest.count > 0);
  };
  run_pipeline<Block>(threads, false, give, compute, [&](const Block& block) {
    if (!block.record.empty()) take(block.record);
  });
}

void run_in_order(std::size_t count, std::size_t threads,
                  const std::function<std::function<void()>(std::size_t)>& prepare) {
  struct Step {
    std::size_t k = 0;
    std::function<void()> run;
  };
  std::size_t next = 0;
  const auto give = [&](Step& step) {
    step.k = next;
    return next++ < count;
  };
  run_pipeline<Step>(
      threads, true, give, [&](Step& step) { step.run = prepare(step.k); },
      [](Step& step) {
        step.run();
        step.run = nullptr;
      });
}

}  // namespace prs
