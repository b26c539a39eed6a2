#pragma once

#include "prs/compare/reference_analysis.h"

namespace prs {

/// References as points, with bars if their deviation is known, and models as lines: a panel per load case and
/// response, a figure for each quantity.
Figures reference_figures(const ModelComparison& c, const FigureOptions& options);

/// References over the threads, tension to one side and compression to the other: a panel per
/// configuration and response.
Figures reference_butterfly(const ModelComparison& c, bool tension_to_left);

}  // namespace prs
