#pragma once

#include "prs/output/files.h"
#include "prs/record/csv_writer.h"
#include "prs/record/table_units.h"
#include "prs/run/exit_status.h"

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

}  // namespace prs::cli
