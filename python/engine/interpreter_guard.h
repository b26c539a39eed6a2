#pragma once

#include <nanobind/nanobind.h>

#include <atomic>
#include <chrono>
#include <future>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "prs/study/study_run.h"

namespace prs::python {

/// While it lives, this thread leaves the interpreter to others. Once the interpreter has begun to
/// end it does nothing: a thread that comes back to an interpreter that has ended takes the process
/// down.
class GilRelease {
 public:
  GilRelease();
  ~GilRelease();
  GilRelease(const GilRelease&) = delete;
  GilRelease& operator=(const GilRelease&) = delete;

 private:
  PyThreadState* state_ = nullptr;
};

/// Between long work and the interpreter: how far the one is, whether the other wants it to stop.
class Supervision {
 public:
  Supervision();
  ~Supervision();
  Supervision(const Supervision&) = delete;
  Supervision& operator=(const Supervision&) = delete;

  bool stopped() const { return stop_; }
  void stop() { stop_ = true; }

  void report(const StudyProgress& progress) {
    const std::lock_guard lock(mutex_);
    progress_ = progress;
  }
  StudyProgress progress() const {
    const std::lock_guard lock(mutex_);
    return progress_;
  }

 private:
  std::atomic<bool> stop_ = false;
  mutable std::mutex mutex_;
  StudyProgress progress_;
};

/// Runs `work(supervision)` on a thread of its own, while this one calls `show(done, total)`,
/// unless it is None, and has Ctrl-C, what `show` throws and the interpreter's end end the work.
template <class Work>
auto beside_interpreter(Work work, const nanobind::object& show) {
  constexpr std::chrono::milliseconds kGlance{50};
  Supervision supervision;
  auto future = std::async(std::launch::async, [&] { return work(supervision); });
  const auto ended = [&](std::chrono::milliseconds wait) {
    const GilRelease released;
    return future.wait_for(wait) == std::future_status::ready;
  };
  const auto shown = [&] {
    if (PyErr_CheckSignals() != 0) throw nanobind::python_error();
    if (supervision.stopped()) throw std::runtime_error("stopped, for the interpreter ends");
    const StudyProgress progress = supervision.progress();
    if (!show.is_none() && progress.total > 0) show(progress.done, progress.total);
  };
  try {
    while (!ended(kGlance)) shown();
    shown();
  } catch (...) {
    supervision.stop();
    const GilRelease released;
    future.wait();
    throw;
  }
  return future.get();
}

/// Has the interpreter, before it ends, stop supervised work and wait for what else is under way on
/// other threads.
void end_work_with(nanobind::module_& module);

}  // namespace prs::python
