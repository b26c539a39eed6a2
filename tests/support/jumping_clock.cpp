// Loaded into the program before the C library: the wall clock jumps by decades at every reading,
// back and ahead; the steady clock, which no machine sets back, jumps ahead by an hour.

#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

#include <atomic>
#include <ctime>
#include <iterator>

namespace {

constexpr std::time_t kYear = 31'556'952;
constexpr std::time_t kTimes[] = {200 * kYear, -kYear, 70 * kYear, 0};  // Seconds since 1970.

std::atomic<unsigned> readings{0};

std::time_t jump() { return kTimes[readings++ % std::size(kTimes)]; }

}  // namespace

extern "C" {

int clock_gettime(clockid_t clock, timespec* time) noexcept {
  if (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE) {
    *time = {jump(), 0};
    return 0;
  }
  const long status = ::syscall(SYS_clock_gettime, clock, time);
  if (clock == CLOCK_MONOTONIC || clock == CLOCK_MONOTONIC_RAW || clock == CLOCK_BOOTTIME)
    time->tv_sec += 3600 * static_cast<std::time_t>(++readings);
  return static_cast<int>(status);
}

int gettimeofday(timeval* time, void*) noexcept {
  *time = {jump(), 0};
  return 0;
}

std::time_t time(std::time_t* time) noexcept {
  const std::time_t now = jump();
  if (time) *time = now;
  return now;
}

}  // extern "C"
