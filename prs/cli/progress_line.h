#pragma once

#include <chrono>
#include <mutex>

#include "prs/study/study_run.h"

namespace prs::cli {

/// How far a study is: a line on standard error that is written over, where that is a terminal.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// From any thread.
  void show(const StudyProgress& progress);
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  bool shown_;
  Clock::time_point start_ = Clock::now();
  std::mutex mutex_;
  Clock::time_point next_;
};

}  // namespace prs::cli
