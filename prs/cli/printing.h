#pragma once

#include <string>

#include "prs/cli/commands.h"

namespace prs::cli {

/// On standard output. Throws where the text does not arrive, as on a full disk.
void print(const std::string& text);

/// A line on standard error, unless quiet.
void note(const Options& options, const std::string& text);

}  // namespace prs::cli
