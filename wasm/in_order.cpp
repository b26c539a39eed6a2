#include <functional>

#include "prs/study/study_run.h"

/// Parallel runs for a module that has one thread.
namespace prs {

std::size_t default_threads() { return 1; }

void run_in_order(std::size_t count, std::size_t, const std::function<std::function<void()>(std::size_t k)>& prepare) {
  for (std::size_t k = 0; k < count; ++k)
    if (const std::function<void()> deliver = prepare(k)) deliver();
}

}  // namespace prs
