#pragma once

#include <chrono>
#include <functional>
#include <mutex>

#include "prs/output/files.h"
#include "prs/record/table_units.h"
#include "prs/run/commands.h"

namespace prs::cli {

using enum Exit;

/// What a run is to print, and where its files go.
struct OutputOptions {
  bool json = false;
  bool quiet = false;
  bool all = false;                   ///< The table with all that there is.
  bool figures = false;               ///< The document holds the pictures as data.
  bool png = false;                   ///< Pictures are written as PNG files, too.
  UnitSystem units = UnitSystem::si;  ///< Units of tables.
  std::optional<std::filesystem::path> output;
  CsvStyle csv;
};

/// Opens the standard streams that the program was started without, so that no other file gets
/// their numbers. What is written to such a stream fails. False where that does not work.
bool reserve_standard_streams();

/// The reader of standard output has closed it, as `head` does.
class ReaderGone : public std::runtime_error {
 public:
  ReaderGone() : std::runtime_error("standard output is read no further") {}
};

/// Prints on standard output, as `printable_lines` shows it. Throws where that fails: ReaderGone
/// or, as on a full disk, std::system_error.
void print(std::string_view text);

/// Closes standard output. Throws what a file system held back until then, as `print` does.
void close_output();

/// Prints on standard error, as `printable_lines` shows it; on a terminal, long lines break between
/// words. Lines of visible ASCII that are short or go elsewhere allocate no memory. A failure is
/// ignored: results and exit status do not depend on it.
void say(std::string_view text) noexcept;

/// Prints on standard error unchanged: for terminal control codes, never for text of the input.
void control_terminal(std::string_view sequence) noexcept;

/// Prints a line on standard error, unless quiet.
void note(const OutputOptions& options, const std::string& text);

/// Exit status of a command that has delivered its results.
int exit_status(bool converged);

/// A text of lines as a note; none where it is empty.
std::vector<std::string> notes_of(std::string text);

/// Writes the files and pictures of a result, prints its document or table, and returns the exit
/// status of the program.
int deliver(const Delivery& delivery, const DocumentInfo& info, const OutputOptions& options);

/// How far a study is, or another work: a line on standard error that is written over, where that
/// is a terminal.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Shows a text that depends on the seconds since the line began, twice a second at most. May be
  /// called from any thread.
  void show(const std::function<std::string(double seconds)>& text);
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
