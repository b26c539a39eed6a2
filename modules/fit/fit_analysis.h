#pragma once

#include "modules/fit/fit.h"
#include "prs/record/analysis.h"

namespace prs {

Record<FitResult> record_of(Type<FitResult>);

const Analysis<FitResult>& fit_analysis();

}  // namespace prs
