#pragma once

#include "prs/cli/command_line.h"

namespace prs::cli {

/// Script with which bash completes the commands, options, words and files of the program. Words that only the program
/// knows, such as the paths of `--set`, come from `prs list`.
std::string bash_completion(const CommandText& program);

}  // namespace prs::cli
