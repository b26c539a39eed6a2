#pragma once

#include <vector>

#include "prs/figures/figure.h"
#include "prs/optimize/optimization_result.h"

namespace prs {

/// `history`: each objective over the designs in their order, feasible and infeasible, the best so
/// far and the chosen one (as Yao et al. 2023, fig. 12). With several objectives `front`: the
/// designs and the fronts of both searches, a panel a pair of objectives, with the file's own
/// design and the compromise.
std::vector<Figure> optimize_figures(const OptimizationResult& result);

}  // namespace prs
