#pragma once

#include <ctime>

namespace test {

/// Processor time of a call on this thread [s]: other work on the machine hardly matters. Compare it with other work in
/// the same run, never with a number.
template <class Call>
double cpu_seconds(Call call) {
  const auto now = [] {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  const double begin = now();
  call();
  return now() - begin;
}

}  // namespace test
