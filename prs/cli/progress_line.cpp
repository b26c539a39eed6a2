#include "prs/cli/progress_line.h"

#include "prs/cli/printing.h"
#include "prs/study/study_table.h"

namespace prs::cli {
namespace {

constexpr auto kPeriod = std::chrono::milliseconds(200);

}  // namespace

ProgressLine::ProgressLine(bool quiet)
    : shown_(!quiet && isatty(STDERR_FILENO) == 1), next_(start_ + kPeriod) {}

void ProgressLine::show(const StudyProgress& progress) {
  if (!shown_) return;
  const std::lock_guard lock(mutex_);
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + kPeriod;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  write(progress_line(progress.done, progress.total, seconds, progress.found));
}

void ProgressLine::tell(std::string_view text) {
  if (!shown_) return;
  const std::lock_guard lock(mutex_);
  write(text);
}

void ProgressLine::clear() {
  if (!shown_) return;
  const std::lock_guard lock(mutex_);
  if (is_written_) control_terminal("\r\x1b[K");
  is_written_ = false;
}

void ProgressLine::write(std::string_view text) {
  control_terminal(fmt::format("\r\x1b[K{}", text));
  is_written_ = true;
}

}  // namespace prs::cli
