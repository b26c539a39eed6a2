#pragma once

#include "prs/life/analyze_life.h"
#include "prs/record/analysis.h"

namespace prs {

/// Lives that are not finite, without load, are absent.
const Analysis<LifeResult>& life_analysis();

/// Reads the force history that the case refers to.
LifeResult life_of(const input::Source& source, const input::CaseInput& in);

}  // namespace prs
