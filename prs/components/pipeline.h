#pragma once

#include <cstddef>
#include <functional>

#include "modules/module.h"

namespace prs {

/// Work on several threads, by oneTBB.
struct PipelineModule : modules::Module {
  static constexpr modules::Name kName{"prs_tbb.so", "TBB", "libtbb-dev", ", or take --threads 1"};

  /// Work of one kind on its way through three steps, so many pieces of it at once, each in a place
  /// of its own: `give` fills a place, one at a time, until it says that there is no more;
  /// `prepare` runs on so many threads, also where there are fewer processors; `take` gets one at a
  /// time, in the order in which they were given where `in_order`. What a step throws ends all and
  /// is thrown again.
  void (*run)(std::size_t threads, std::size_t places, bool in_order,
              const std::function<bool(std::size_t place)>& give,
              const std::function<void(std::size_t place)>& prepare,
              const std::function<void(std::size_t place)>& take);
};

}  // namespace prs
