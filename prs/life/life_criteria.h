#pragma once

#include "prs/life/analyze_life.h"
#include "prs/model/criterion.h"

namespace prs {

std::vector<FoundCriterion> life_criteria(const LifeResult& result, const JudgedCase& of);

}  // namespace prs
