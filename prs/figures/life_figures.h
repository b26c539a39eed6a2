#pragma once

#include <vector>

#include "prs/life/analyze_life.h"
#include "prs/figures/figure.h"

namespace prs {

/// Equivalent loads and lives of the threads; with a history its course and the matrix of its
/// cycles.
std::vector<Figure> life_figures(const LifeResult& result);

}  // namespace prs
