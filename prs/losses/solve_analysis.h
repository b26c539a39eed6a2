#pragma once

#include "prs/loads/load_analysis.h"

namespace prs {

/// Analysis of the loads of a screw at rest or, if `model.loads` requests it, of a running one.
const Analysis<Result>& solve_analysis();

/// `solve` with other options, and the warnings of the command.
Result solved(const Case& c, const AnalysisOptions& options = {});

}  // namespace prs
