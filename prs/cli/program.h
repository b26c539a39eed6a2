#pragma once

#include <CLI/CLI.hpp>

#include "prs/cli/printing.h"

namespace CLI {
class App;
}
namespace prs::cli {

/// Adds an option without a value.
CLI::Option* add_flag(CLI::App& command, const char* name, bool& flag, const char* help);

/// Gives the value of an option the name that help calls it by. Files and folders need a name; a folder is no file.
CLI::Option* name_value(CLI::Option* option, std::string_view type);

/// Adds an option, or an argument, whose value the help calls `type`.
template <class Value>
CLI::Option* add_value(CLI::App& command, const char* name, Value& value, const char* type, const char* help) {
  return name_value(command.add_option(name, value, help), type);
}

/// Lets the option be given several times, each time with one value.
CLI::Option* take_each(CLI::Option* option);

void add_json(CLI::App& command, OutputOptions& options);
void add_quiet(CLI::App& command, OutputOptions& options);
/// Adds `--json`, `--output` and `--quiet`.
void add_output_options(CLI::App& command, OutputOptions& options);
/// Adds options of commands with pictures, after those of output.
void add_png(CLI::App& command, OutputOptions& options);

/// Adds `--units`, for commands that print quantities.
void add_units_option(CLI::App& command, OutputOptions& options);

/// Adds `--csv` and `--csv-digits`, for commands that write CSV.
void add_csv_options(CLI::App& command, CsvStyle& style);

/// Runs a command, reports changes in its folder, and lists the files that it wrote. `case_file` is empty if it reads
/// no case.
int run_recorded(const std::function<int()>& run, const OutputOptions& options, const std::string& command,
                 const std::string& case_file, const std::vector<std::string>& overrides);

/// Main function of a program: makes the streams safe to write to, and turns exceptions of `run` into exit statuses and
/// lines on standard error.
int run_program(int (*run)(int argc, char** argv), int argc, char** argv);

/// Arguments of `prs validate`.
struct ValidateOptions : OutputOptions {
  std::string folder;  ///< Folder of the sources.
};

void add_validate_options(CLI::App& command, ValidateOptions& options);

}  // namespace prs::cli
