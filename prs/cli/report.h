#pragma once

#include "prs/cli/commands.h"

namespace prs::cli {

/// Writes all results of a case as one page.
int report(const Options& options);
/// Writes that page, to a temporary folder if no file is named, and opens it.
int explore(const Options& options);
/// Writes the whole program as one page, with or without a file to start with.
int workbench(const Options& options);

}  // namespace prs::cli
