#pragma once

#include "prs/cli/commands.h"

namespace prs::cli {

/// Chooses screws for a requirement, and writes one of them as a case.
int size(const Options& options);

}  // namespace prs::cli
