#pragma once

#include <nlohmann/json_fwd.hpp>

#include "prs/measures/analyze_measures.h"
#include "prs/record/analysis.h"

namespace prs {

/// What `solve` gives, with the measures of the mechanism and of each load case.
const Analysis<MeasuresResult>& measures_analysis();

/// Formula, validity and source of every measure, with the key under which documents show it.
nlohmann::ordered_json measure_explanations_json();

}  // namespace prs
