#pragma once

#include "prs/measures/measures.h"
#include "prs/model/criterion.h"

namespace prs {

/// Criteria of `measures`, and of the loads that it rests on.
std::vector<FoundCriterion> measures_criteria(const MeasuresResult& result, const JudgedCase& of);

inline bool lacks_shaft(const Case& c) { return !c.measures || !c.measures->shaft; }
inline constexpr const char* kAddShaft = "add measures.shaft";

}  // namespace prs
