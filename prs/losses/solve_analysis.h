#pragma once

#include "prs/loads/load_analysis.h"

namespace prs {

/// Loads of a screw at rest or, where `model.loads` asks for it, of one that runs.
const Analysis<Result>& solve_analysis();

/// `solve` with other means, and the warnings of the command.
Result solved(const Case& c, const AnalysisOptions& options = {});

}  // namespace prs
