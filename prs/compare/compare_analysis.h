#pragma once

#include "prs/compare/compare_models.h"
#include "prs/record/analysis.h"

namespace prs {

const Analysis<ModelComparison>& compare_analysis();

}  // namespace prs
