#pragma once

#include "prs/loads/load_criteria.h"
#include "prs/measures/measures.h"

namespace prs {

/// Criteria of `measures`, and of the loads that it rests on.
std::vector<FoundCriterion> measures_criteria(const MeasuresResult& result, const JudgedCase& of);

/// Elements in series with the mechanism; refers to its arguments.
InSeriesOf in_series_of(const MeasuresResult& result, const JudgedCase& of);

inline bool lacks_shaft(const Case& c) { return !c.measures || !c.measures->shaft; }
inline constexpr const char* kAddShaft = "add measures.shaft";

}  // namespace prs
