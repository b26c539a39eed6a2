#pragma once

#include <vector>

#include "prs/figures/figure.h"

namespace prs {

/// The lines where a grid has a value, linear along the edges of its cells (marching squares).
/// Cells with a node without a number have none.
std::vector<Polyline> contour_lines(const GridData& grid, double level);

/// What of a cell lies at that value or above it, its lower left node being (i, j).
Polyline part_above(const GridData& grid, std::size_t i, std::size_t j, double level);

}  // namespace prs
