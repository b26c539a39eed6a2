#pragma once

#include <cstddef>
#include <vector>

#include "prs/figures/figure.h"

namespace prs {

/// The grid with at most so many nodes along each axis, the outer ones among them.
GridData thinned(const GridData& grid, std::size_t most);

/// Equidistant round numbers around all values of a grid, at most so many steps; empty where the
/// grid has no value.
std::vector<double> round_levels(const GridData& grid, std::size_t most_steps);

/// Where a grid has this value: straight between its meetings with the lines of the grid, on which
/// it is linear (marching squares; Lorensen & Cline 1987 in the plane). Larger values lie to the
/// left of a line. Cells without a number at a corner have none.
std::vector<Polyline> contour_lines(const GridData& grid, double level);

/// An area to be filled over those before it.
struct ContourBand {
  std::size_t band = 0;  ///< Between levels k and k + 1; number of levels: no value.
  Polyline outline;      ///< Closed.
};

/// The areas between neighbouring levels, which ascend from below the least value of the grid.
std::vector<ContourBand> contour_bands(const GridData& grid, const std::vector<double>& levels);

}  // namespace prs
