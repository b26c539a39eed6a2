#pragma once

#include <string>
#include <vector>

#include "prs/cli/commands.h"

namespace prs::cli {

/// What `prs list` takes: `commands`, ..
std::vector<std::string> list_words();

/// What each of them is.
std::string list_help();

/// Prints what there is to choose from: one name per line with its meaning, or one document.
int list(const Options& options);

}  // namespace prs::cli
