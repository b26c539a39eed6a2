#pragma once

#include <vector>

#include "prs/output/figure.h"
#include "prs/study/run.h"

namespace prs {

/// The figures of a study, at most 24. With slip, one a factor: power by source, stacked, and
/// efficiency beside its fit (Sandu 2018, fig. 3.9 and appendix C). Otherwise one a response, with
/// a panel a factor. The base case is marked. Levels without a number stand in their order.
std::vector<Figure> study_figures(const StudyResult& result);

}  // namespace prs
