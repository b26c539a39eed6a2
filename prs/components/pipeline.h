#pragma once

#include <functional>

#include "modules/module.h"

namespace prs {

/// Work on several threads, by oneTBB.
struct PipelineModule : modules::Module {
  static constexpr modules::Name kName{"prs_tbb.so", "TBB", "libtbb-dev", ", or take --threads 1"};

  /// Sends work through three steps. At most `places` pieces are under way at once, each in a place
  /// of its own. `give` fills one place at a time until it returns false. `prepare` runs on
  /// `threads` threads, even where there are fewer processors. `take` gets one piece at a time,
  /// with `in_order` in the order in which they were given. An exception in a step ends the run and
  /// is thrown again.
  void (*run)(std::size_t threads, std::size_t places, bool in_order,
              const std::function<bool(std::size_t place)>& give,
              const std::function<void(std::size_t place)>& prepare,
              const std::function<void(std::size_t place)>& take);
};

}  // namespace prs
