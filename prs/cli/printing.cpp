#include "prs/cli/printing.h"

#include <fcntl.h>
#include <sys/ioctl.h>

#include <new>
#include <system_error>

#include "prs/file_descriptor.h"
#include "prs/loads/load_json.h"
#include "prs/text.h"

namespace prs::cli {
namespace {

[[noreturn]] void fail_to_print(int error) {
  if (error == EPIPE) throw ReaderGone();
  throw std::system_error(error, std::generic_category(), "cannot write to standard output");
}

/// Of the terminal that shows messages, which would break words; 0 where there is none.
std::size_t message_columns() noexcept {
  constexpr std::size_t kLeast = 40;
  winsize size{};
  if (::isatty(STDERR_FILENO) != 1 || ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0) return 0;
  return size.ws_col < kLeast ? 0 : size.ws_col;
}

}  // namespace

bool reserve_standard_streams() {
  // In the order of their numbers: a file gets the least that is free.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) != -1) continue;
    // One that cannot be written tells that a table gets lost.
    const int access = stream == STDERR_FILENO ? O_WRONLY : O_RDONLY;
    if (::open("/dev/null", access) != stream) return false;
  }
  return true;
}

void print(std::string_view text) {
  const int error = is_plain_lines(text) ? write_all(STDOUT_FILENO, text)
                                         : write_all(STDOUT_FILENO, printable_lines(text));
  if (error != 0) fail_to_print(error);
}

void close_output() {
  if (::close(STDOUT_FILENO) != 0 && errno != EINTR) fail_to_print(errno);
}

void say(std::string_view text) noexcept try {
  const std::size_t columns = message_columns();
  if (columns > 0 && text.size() > columns)
    write_all(STDERR_FILENO, wrapped_lines(printable_lines(text), columns));
  else if (is_plain_lines(text))
    write_all(STDERR_FILENO, text);
  else
    write_all(STDERR_FILENO, printable_lines(text));
} catch (const std::bad_alloc&) {
  write_all(STDERR_FILENO, is_plain_lines(text) ? text : "(out of memory for a message)");
}

void control_terminal(std::string_view sequence) noexcept { write_all(STDERR_FILENO, sequence); }

void note(const OutputOptions& options, const std::string& text) {
  if (!options.quiet) say(text + '\n');
}

int exit_status(bool converged) { return converged ? kDone : kNotConverged; }

}  // namespace prs::cli
