#pragma once

#include "prs/svg/layout.h"

namespace prs {

/// The way through points, broken where one has no place. Points that only lead around outside of
/// the panel are left out.
std::string way(const Polyline& points, const Frame& frame, bool closed);

std::string series_svg(const Figure& figure, const Series& series, const Frame& frame);

constexpr int kLegendSymbolWidth = 34, kLegendSymbolHeight = 16;

/// What stands before an entry of the legend, with its upper left at 0, 0.
std::string legend_symbol(const Style& style);

}  // namespace prs
