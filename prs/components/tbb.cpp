#include <tbb/concurrent_queue.h>
#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include "prs/components/components.h"
#ifdef PRS_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace prs {
namespace {

/// Reports to the thread sanitizer how oneTBB, which is not instrumented, synchronises by atomics: what happened before
/// `give` has happened after `take` of the same object. Does nothing without that sanitizer.
class HandOver {
 public:
#ifdef PRS_THREAD_SANITIZER
  void give() { __tsan_release(this); }
  void take() { __tsan_acquire(this); }
#else
  void give() {}
  void take() {}
#endif
};

void run(std::size_t threads, std::size_t places, bool in_order, const std::function<bool(std::size_t)>& give,
         const std::function<void(std::size_t)>& prepare, const std::function<void(std::size_t)>& take) {
  tbb::concurrent_queue<std::size_t> idle;
  for (std::size_t place = 0; place < places; ++place) idle.push(place);
  // Between filters, and between calls of a serial filter.
  std::vector<HandOver> at(places);
  HandOver first, last;
  first.give();

  const auto next = [&](tbb::flow_control& control) {
    std::size_t place = 0;
    if (!idle.try_pop(place)) throw std::logic_error("more on their way than there are places");
    first.take();
    at[place].take();
    if (!give(place)) control.stop();
    first.give();
    at[place].give();
    return place;
  };
  const auto prepared = [&](std::size_t place) {
    at[place].take();
    prepare(place);
    at[place].give();
    return place;
  };
  const auto done = [&](std::size_t place) {
    last.take();
    at[place].take();
    take(place);
    last.give();
    at[place].give();
    idle.push(place);
  };
  const tbb::filter_mode order = in_order ? tbb::filter_mode::serial_in_order : tbb::filter_mode::serial_out_of_order;
  const auto filters = tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, next) &
                       tbb::make_filter<std::size_t, std::size_t>(tbb::filter_mode::parallel, prepared) &
                       tbb::make_filter<std::size_t, void>(order, done);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(static_cast<int>(threads));
  arena.execute([&] { tbb::parallel_pipeline(places, filters); });
  for (HandOver& place : at) place.take();
  first.take();
  last.take();
}

}  // namespace
}  // namespace prs

extern "C" __attribute__((visibility("default"))) const prs::PipelineModule prs_module{{}, prs::run};
