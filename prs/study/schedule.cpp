#include "prs/study/schedule.h"

#include <tbb/concurrent_queue.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <stdexcept>

#include "prs/study/journal.h"

namespace prs {
namespace {

/// Blocks on their way, a thread: enough that no thread waits for another.
constexpr std::size_t kBlocksPerThread = 4;

/// Has items given one at a time until `give` says that there are no more, prepared on so many
/// threads, also where there are fewer processors, and taken one at a time in `order`. The items
/// are kept here: a pipeline that an exception ends may forget those on their way.
template <class Item, class Give, class Prepare, class Take>
void run_pipeline(std::size_t threads, tbb::filter_mode order, const Give& give,
                  const Prepare& prepare, const Take& take) {
  std::vector<Item> items(kBlocksPerThread * threads);
  tbb::concurrent_queue<Item*> idle;
  for (Item& item : items) idle.push(&item);

  const auto next = [&](tbb::flow_control& control) {
    Item* item = nullptr;
    if (!idle.try_pop(item)) throw std::logic_error("more items on their way than there are");
    if (!give(*item)) control.stop();
    return item;
  };
  const auto prepared = [&](Item* item) {
    prepare(*item);
    return item;
  };
  const auto done = [&](Item* item) {
    take(*item);
    idle.push(item);
  };
  const auto filters = tbb::make_filter<void, Item*>(tbb::filter_mode::serial_in_order, next) &
                       tbb::make_filter<Item*, Item*>(tbb::filter_mode::parallel, prepared) &
                       tbb::make_filter<Item*, void>(order, done);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(static_cast<int>(threads));
  arena.execute([&] { tbb::parallel_pipeline(items.size(), filters); });
}

}  // namespace

std::size_t available_processors() {
  return static_cast<std::size_t>(tbb::info::default_concurrency());
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
    block.record = encode(evaluate(block.designs.first, block.designs.count));
  };
  run_pipeline<Block>(threads, tbb::filter_mode::serial_out_of_order, give, compute,
                      [&](const Block& block) { take(block.record); });
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
      threads, tbb::filter_mode::serial_in_order, give,
      [&](Step& step) { step.run = prepare(step.k); },
      [](Step& step) {
        step.run();
        step.run = nullptr;
      });
}

}  // namespace prs
