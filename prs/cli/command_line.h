#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <vector>

#include "prs/input/units.h"
#include "prs/json_type.h"

namespace CLI {

class App;
class Option;

}  // namespace CLI

namespace prs::cli {

/// An option or an argument of a command, as texts.
struct OptionText {
  std::vector<std::string> names;  ///< `-o`, `--output`; empty for an argument without a name.
  std::string value;               ///< Name of its value: `DIR`; empty for a flag.
  std::vector<std::string> words;  ///< Allowed values, if they are few.
  std::string help;
  bool required = false;
  bool repeatable = false;
  bool optional_value = false;
};

/// A command as texts, from which help, manual, completions and suggestions are made.
struct CommandText {
  std::string name;  ///< Full name as typed: `prs study merge`.
  std::string group;
  std::string help;
  std::string examples;  ///< Command lines for a shell.
  std::vector<OptionText> arguments, options;
  std::vector<CommandText> commands;
};

/// The commands and options of a parser.
CommandText describe(const CLI::App& app);

/// The command named by words such as `study`, `merge`. Throws UsageError if there is none.
const CommandText& find_command(const CommandText& program, std::span<const std::string> words);

/// Restricts the option to one of these words, which help and completions list.
void take_one_of(CLI::Option* option, std::vector<std::string> words);

/// Restricts the option to a whole number within bounds.
void take_whole_number(CLI::Option* option, long least, long most);

/// Parses a command line. If nothing is left to run, as after `--help` or a mistake, prints the text and returns the
/// exit status.
std::optional<int> parse(CLI::App& app, int argc, char** argv);

/// Prints an error of the command line, with the help to read; returns the exit status.
int report_usage(const CLI::App& app, std::string_view message);

/// Error of the command line. `what()` says what was found, what is allowed and how to fix it; the handler adds the
/// help of the command.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  template <class Arg, class... Args>
  UsageError(fmt::format_string<Arg, Args...> message, Arg&& arg, Args&&... args)
      : UsageError(fmt::format(message, std::forward<Arg>(arg), std::forward<Args>(args)...)) {}
};

/// Throws UsageError for an option of the command line: `--lead: MESSAGE`.
[[noreturn]] void fail_option(std::string_view option, std::string_view message);
template <class Arg, class... Args>
[[noreturn]] void fail_option(std::string_view option, fmt::format_string<Arg, Args...> message, Arg&& arg,
                              Args&&... args) {
  fail_option(option, fmt::format(message, std::forward<Arg>(arg), std::forward<Args>(args)...));
}

/// The word quoted for a shell; a file whose name begins with `-` is one of the current folder.
std::string quoted(std::string word);

/// The value of an option [SI] within bounds that `expected` describes. A blank between number and unit may be missing.
double quantity_option(std::string_view option, const std::string& text, const input::Dimension& dimension,
                       const input::Bounds& bounds, std::string_view expected);

}  // namespace prs::cli
