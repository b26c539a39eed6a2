#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace prs::cli {

/// An option or an argument of a command, in words.
struct OptionText {
  std::vector<std::string> names;  ///< `-o`, `--output`; none of an argument without a name.
  std::string value;               ///< Name of its value: `DIR`; empty for a flag.
  std::vector<std::string> words;  ///< The values that it takes, where they are few.
  std::string help;
  bool required = false;
  bool repeatable = false;
  bool optional_value = false;
};

/// A command in words: what help, manual, completions and suggestions are made from.
struct CommandText {
  std::string name;  ///< Full name as typed: `prs study merge`.
  std::string group;
  std::string help;
  std::string examples;  ///< Lines of a shell.
  std::vector<OptionText> arguments, options;
  std::vector<CommandText> commands;
};

/// The commands and options of a parser.
CommandText describe(const CLI::App& app);

/// The command that words such as `study`, `merge` name. Throws UsageError where none is.
const CommandText& find_command(const CommandText& program, std::span<const std::string> words);

/// The option takes one of these words, which help and completions list.
void take_one_of(CLI::Option* option, std::vector<std::string> words);

/// The option takes a whole number within bounds.
void take_whole_number(CLI::Option* option, long least, long most);

/// Parses a command line. Where nothing is left to run, as after `--help` or a mistake, prints what
/// there is to say and returns the exit status.
std::optional<int> parse(CLI::App& app, int argc, char** argv);

/// Says what is wrong with the command line, with the help to read; returns the exit status.
int report_usage(const CLI::App& app, std::string_view message);

}  // namespace prs::cli
