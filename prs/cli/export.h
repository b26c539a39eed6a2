#pragma once

#include "prs/cli/commands.h"

namespace prs::cli {

/// Writes models of the screw for other programs.
int export_model(const Options& options);

}  // namespace prs::cli
