#pragma once

#include <chrono>
#include <mutex>

#include "prs/study/study_run.h"

namespace prs::cli {

/// How far a study is, or another work: a line on standard error that is written over, where that
/// is a terminal.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// May be called from any thread.
  void show(const StudyProgress& progress);
  void tell(std::string_view text);
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  void write(std::string_view text);

  bool shown_;
  bool is_written_ = false;
  Clock::time_point start_ = Clock::now();
  std::mutex mutex_;
  Clock::time_point next_;
};

}  // namespace prs::cli
