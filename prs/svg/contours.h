#pragma once

#include <vector>

#include "prs/record/figure.h"

namespace prs {

/// The lines where a grid has a value, linear along the edges of its cells (marching squares).
/// Cells with a node without a number have none.
std::vector<Polyline> contour_lines(const GridData& grid, double level);

}  // namespace prs
