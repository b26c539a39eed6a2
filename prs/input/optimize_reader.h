#pragma once

#include "prs/input/study_reader.h"

namespace prs::input {

/// Reads the optimization of a source and checks it: the file's own design in full, and that each value of each
/// variable, or its ends, can be read at their places. Throws InputError, which names every error found.
OptimizeInput read_optimize_input(const Source& source);

}  // namespace prs::input
