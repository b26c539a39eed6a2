#pragma once

#include "prs/cli/command_line.h"

namespace prs::cli {

// Scripts with which shells complete the commands, options, words and files of the program. Words that only the program
// knows, such as the paths of `--set`, come from `prs list`.

std::string bash_completion(const CommandText& program);

std::string zsh_completion(const CommandText& program);

std::string fish_completion(const CommandText& program);

}  // namespace prs::cli
