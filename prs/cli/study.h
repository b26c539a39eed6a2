#pragma once

#include "prs/cli/commands.h"

namespace prs::cli {

int study(const Options& options);
/// Writes the files of a study from the journals in `options.folders`.
int merge_study(const Options& options);
/// Multi-objective design: writes the Pareto front and the chosen design of the file's `optimize`.
int optimize(const Options& options);
/// Finds the unknown inputs of the file's `fit` from its curves.
int fit(const Options& options);

}  // namespace prs::cli
