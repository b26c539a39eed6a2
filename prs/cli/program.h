#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "prs/cli/printing.h"

namespace CLI {
class App;
}

namespace prs::cli {

/// Below the help of a program.
inline constexpr const char* kExitStatuses =
    "Exit status: 0 done, 1 failed, 2 the input or the command line is wrong, 3 a load case did "
    "not "
    "converge.";

/// `--json`, `--output` and `--quiet`.
void add_output_options(CLI::App& command, OutputOptions& options);

/// `--csv` and `--csv-digits`, of commands that write CSV.
void add_csv_options(CLI::App& command, CsvStyle& style);

/// Parses a command line. Where nothing is left to run, as after `--help` or a mistake, prints what
/// there is to say and returns the exit status.
std::optional<int> parse(CLI::App& app, int argc, char** argv);

/// Runs a command, tells what it found in its folders, and lists what it wrote. `case_file` is
/// empty where it reads no case.
int run_recorded(const std::function<int()>& run, const OutputOptions& options,
                 const std::string& command, const std::string& case_file,
                 const std::vector<std::string>& overrides);

/// The main function of a program: makes the streams safe to write to, and exit statuses and lines
/// on standard error of what `run` throws.
int run_program(int (*run)(int argc, char** argv), int argc, char** argv);

}  // namespace prs::cli
