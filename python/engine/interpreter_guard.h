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

/// Releases the interpreter while the object lives. After the interpreter has begun to end it does nothing: a thread
/// that returns to an ended interpreter crashes the process.
class GilRelease {
 public:
  GilRelease();
  ~GilRelease();
  GilRelease(const GilRelease&) = delete;
  GilRelease& operator=(const GilRelease&) = delete;

 private:
  PyThreadState* state_ = nullptr;
};

/// Link between long work and the interpreter: progress of the one, requests to stop from the other.
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

/// Runs `work(supervision)` in another thread, while this one calls `show(done, total)`, unless it is None; Ctrl-C,
/// exceptions of `show` and the interpreter's end stop the work.
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
    if (supervision.stopped()) {  // The interpreter ends, and no thread may write to its streams any more.
      PyErr_SetNone(PyExc_SystemExit);
      throw nanobind::python_error();
    }
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

/// Makes the interpreter, before it ends, stop supervised work and wait for other work in progress on other threads.
void end_work_with(nanobind::module_& module);

}  // namespace prs::python
