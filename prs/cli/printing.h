#pragma once

#include <chrono>
#include <functional>
#include <mutex>

#include "prs/output/files.h"
#include "prs/record/table_units.h"
#include "prs/run/commands.h"

namespace prs::cli {

using enum Exit;

/// Options on the printed output and the files.
struct OutputOptions {
  bool json = false;
  bool quiet = false;
  bool all = false;                   ///< Whether to print the full table.
  bool figures = false;               ///< Whether the document holds the pictures as data.
  bool png = false;                   ///< Whether pictures are written as PNG files, too.
  UnitSystem units = UnitSystem::si;  ///< Units of tables.
  std::optional<std::filesystem::path> output;
  CsvStyle csv;
};

/// Opens the standard streams that were closed at the start of the program, so that no other file gets their numbers.
/// Writing to such a stream fails. Returns false if that does not work.
bool reserve_standard_streams();

/// Error: the reader of standard output has closed it, as `head` does.
class ReaderGone : public std::runtime_error {
 public:
  ReaderGone() : std::runtime_error("standard output is read no further") {}
};

/// Shows this file on one line of all messages, also if parts of its name have several.
void print_on_one_line(const std::filesystem::path& file);

/// Prints on standard output, in the form of `printable_lines`. Throws on failure: ReaderGone or, as on a full disk,
/// std::system_error.
void print(std::string_view text);

/// Closes standard output. Throws delayed errors of a file system, as `print` does.
void close_output();

/// Prints on standard error, in the form of `printable_lines`; on a terminal, long lines break between words. Lines of
/// visible ASCII that are short or go elsewhere allocate no memory. A failure is ignored: results and exit status do
/// not depend on it.
void say(std::string_view text) noexcept;

/// Prints on standard error unchanged: for terminal control codes, never for text of the input.
void control_terminal(std::string_view sequence) noexcept;

/// Prints a line on standard error, unless quiet.
void note(const OutputOptions& options, const std::string& text);

/// Exit status of a command that has delivered its results.
int exit_status(bool converged);

/// A text of lines as a note; none if it is empty.
std::vector<std::string> notes_of(std::string text);

/// Writes the files and pictures of a result, prints its document or table, and returns the exit
/// status of the program.
int deliver(const Delivery& delivery, const DocumentInfo& info, const OutputOptions& options);

/// Progress of a study or other work: one line on standard error that is overwritten, if that is a terminal.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Shows a text that depends on the seconds since the line began, at most twice a second. May be called from any
  /// thread.
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
