#pragma once

#include <optional>
#include <vector>

#include "prs/figures/figure.h"
#include "prs/loads/result.h"

namespace prs {

/// Points that a curve over loads needs.
inline constexpr std::size_t kMinSweepPoints = 3;

// The figures that load cases give rise to; absent where the result holds no data for one.
// A configuration has one line style, whichever the direction. What exceeds the lines or rows that
// can be told apart is left out, and the title says so.

/// Load rate of each thread [%]: a row of panels a direction, a column an interface (Abevi 2015,
/// figs. 11-14). A range is represented by its last point.
std::optional<Figure> load_distribution_figure(const Result& result);

/// Largest Hertz pressure of each thread [GPa], laid out like the load distribution.
std::optional<Figure> peak_pressure_figure(const Result& result);

/// Axial stiffness [N/um] against the load [kN] of each range (fig. 10), secant and tangent.
std::optional<Figure> stiffness_figure(const Result& result);

/// Load rate of each thread [%] against the load [kN] of each range, tension to the left: a row of
/// panels a configuration, a column an interface (figs. 15-18).
std::optional<Figure> butterfly_figure(const Result& result);

/// All of these that there are.
std::vector<Figure> result_figures(const Result& result);

}  // namespace prs
