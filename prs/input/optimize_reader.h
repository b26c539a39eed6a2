#pragma once

#include "prs/input/study_reader.h"
#include "prs/model/optimization.h"

namespace prs::input {

/// An optimization and the document that it starts from.
struct OptimizeInput {
  StudyInput start;  ///< For the engine: its study is that of `optimization`.
  Optimization optimization;
  std::vector<std::string> asked_at;  ///< Where in the document each response is first asked for.
};

/// Reads the optimization of a source and checks it: the file's own design in full, and that each
/// value of each variable, or its ends, read well in their place. Throws InputError, which names
/// every error found.
OptimizeInput read_optimize_input(const Source& source);

}  // namespace prs::input
