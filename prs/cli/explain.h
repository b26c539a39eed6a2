#pragma once

#include "prs/cli/commands.h"

namespace prs::cli {

/// Prints title, formula, validity and source of what `options.explain` names, a measure or the
/// path of a result; of every measure where it is empty.
int explain(const Options& options);

}  // namespace prs::cli
