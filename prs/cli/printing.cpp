#include "prs/cli/printing.h"

#include <sys/ioctl.h>

#include <boost/algorithm/string/replace.hpp>
#include <new>
#include <system_error>

#include "prs/cli/interruption.h"
#include "prs/text.h"

namespace prs::cli {
namespace {

/// Names that have line ends.
std::vector<std::string> names_of_lines;

std::string shown_lines(std::string_view text) {
  std::string lines(text);
  for (const std::string& name : names_of_lines) boost::replace_all(lines, name, printable(name));
  if (text.ends_with('\n')) lines.back() = '\n';
  return printable_lines(lines);
}

bool is_shown_as_it_is(std::string_view text) noexcept { return names_of_lines.empty() && is_plain_lines(text); }

/// Writes lines; returns the error, 0 for none.
int write_lines(int stream, std::string_view text) {
  return is_shown_as_it_is(text) ? write_all(stream, text) : write_all(stream, shown_lines(text));
}

[[noreturn]] void fail_to_print(int error) {
  if (error == EPIPE) throw ReaderGone();
  throw std::system_error(error, std::generic_category(), "cannot write to standard output");
}

/// Columns of the terminal for messages, at which it would break words; 0 if there is none.
std::size_t message_columns() noexcept {
  constexpr std::size_t kLeast = 40;
  winsize size{};
  if (::isatty(STDERR_FILENO) != 1 || ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0) return 0;
  return size.ws_col < kLeast ? 0 : size.ws_col;
}

using WriteText = std::function<void(const TextSink&)>;

void write(const Delivery& delivery, const WriteText& document, const Figures& shown, const OutputOptions& options) {
  const Interruption after_the_files;  // Written files are listed, however the run ends.
  std::error_code told_by_the_file;
  std::filesystem::create_directories(*options.output, told_by_the_file);
  const std::filesystem::path path = *options.output / delivery.file;
  StagedFile staged(path);
  document([&](std::string_view text) { staged.append(text); });
  staged.close();
  std::vector<OutputFile> files;
  if (delivery.files) std::ranges::move(delivery.files(options.csv), std::back_inserter(files));
  if (delivery.keeps_figures && !shown.empty())
    files.push_back(
        {delivery.file.substr(0, delivery.file.find('.')) + std::string(kFiguresEnding), figures_text(shown)});
  write_files(*options.output, files);
  staged.publish();
  record_written(path);
  draw_figures(shown, *options.output, options.png);
  if (Interruption::asked()) throw Interrupted();
  for (const std::string& text : delivery.without_figure) note(options, text);
}

constexpr auto kPeriod = std::chrono::milliseconds(200);

}  // namespace

bool reserve_standard_streams() {
  // In the order of their numbers: an opened file gets the smallest free one.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) != -1) continue;
    // Opened for reading, so that writing fails and reports that a table is lost.
    const int access = stream == STDERR_FILENO ? O_WRONLY : O_RDONLY;
    if (::open("/dev/null", access) != stream) return false;
  }
  return true;
}

void print_on_one_line(const std::filesystem::path& file) {
  for (const std::filesystem::path& part : file)
    if (part.native().find('\n') != std::string::npos && part.native().find_first_not_of('\n') != std::string::npos)
      names_of_lines.push_back(part.string());
}

void print(std::string_view text) {
  if (const int error = write_lines(STDOUT_FILENO, text); error != 0) fail_to_print(error);
}

void close_output() {
  if (::close(STDOUT_FILENO) != 0 && errno != EINTR) fail_to_print(errno);
}

void say(std::string_view text) noexcept try {
  const std::size_t columns = message_columns();
  if (columns > 0 && text.size() > columns)
    write_all(STDERR_FILENO, wrapped_lines(shown_lines(text), columns));
  else
    write_lines(STDERR_FILENO, text);
} catch (const std::bad_alloc&) {
  write_all(STDERR_FILENO, is_shown_as_it_is(text) ? text : "(out of memory for a message)");
}

void control_terminal(std::string_view sequence) noexcept { write_all(STDERR_FILENO, sequence); }

void note(const OutputOptions& options, const std::string& text) {
  if (!options.quiet) say(text + '\n');
}

int exit_status(bool converged) { return converged ? kDone : kNotConverged; }

std::vector<std::string> notes_of(std::string text) {
  if (text.empty()) return {};
  text.erase(text.find_last_not_of('\n') + 1);
  return {std::move(text)};
}

int deliver(const Delivery& delivery, const DocumentInfo& info, const OutputOptions& options) {
  const bool has_document = options.json || options.output;
  if (options.figures && !has_document)
    note(options, "--figures has no effect without a document; add --json or --output DIR");
  Figures shown;
  if (delivery.pictures && (options.output || (options.figures && options.json)))
    shown = figures(delivery.pictures(), options.all);
  nlohmann::ordered_json json;
  if (has_document) {
    json = delivery.outline ? delivery.outline(info) : delivery.document(info);
    if (options.figures) json["figures"] = to_json(shown);
  }
  const WriteText document = [&](const TextSink& sink) {
    delivery.write ? delivery.write(json, sink) : sink(json_text(json));
  };
  if (options.output) write(delivery, document, shown, options);
  if (options.json) {
    document([](std::string_view text) { print(text); });
    for (const std::string& text : delivery.notes) note(options, text);
  } else if (!options.quiet) {
    const TableUnits units(options.units);
    print(options.all && delivery.full_table ? delivery.full_table() : delivery.table());
    const bool more_than_document = delivery.files || delivery.pictures;
    if (options.output && more_than_document) print(fmt::format("\nFiles: {}\n", options.output->string()));
  }
  if (delivery.wrong_input.empty()) return status_of(delivery);
  say(delivery.wrong_input + '\n');
  return kWrongInput;
}

ProgressLine::ProgressLine(bool quiet) : shown_(!quiet && isatty(STDERR_FILENO) == 1), next_(start_ + kPeriod) {}

void ProgressLine::show(const std::function<std::string(double seconds)>& text) {
  if (!shown_) return;
  const std::lock_guard lock(mutex_);
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + kPeriod;
  write(text(std::chrono::duration<double>(now - start_).count()));
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
