#pragma once

#include <nlohmann/json_fwd.hpp>

#include "prs/measures/analyze_measures.h"
#include "prs/quantities/json.h"

namespace prs {

/// The document of `prs measures --json`: that of `prs solve`, with the mechanism's measures under
/// `measures` and those of each load case under `load_cases[].measures`.
nlohmann::ordered_json measures_json(const MeasuresResult& result, const DocumentInfo& info);

/// Formula, validity and source of every measure, with the key under which documents show it.
nlohmann::ordered_json measure_explanations_json();

}  // namespace prs
