#pragma once

#include <CLI/CLI.hpp>

#include "prs/cli/commands.h"

namespace prs::cli {

/// The program: its commands and options as a parser, and the parsed values.
struct Program {
  CLI::App app{"Load distribution, losses, life and design of planetary roller screws", "prs"};
  Options options;
  std::function<int(const Options&)> run;  ///< Chosen command.
};

/// Adds every command with its options and examples. Help, manual, completions and suggestions are
/// made from them.
void add_commands(Program& program);

}  // namespace prs::cli
