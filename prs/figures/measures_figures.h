#pragma once

#include <vector>

#include "prs/measures/analyze_measures.h"
#include "prs/figures/figure.h"

namespace prs {

/// Yang's load rates beside those of the model, a panel a load case, at most 6.
std::vector<Figure> measures_figures(const MeasuresResult& result);

}  // namespace prs
