#pragma once

#include "prs/svg/elements.h"

namespace prs {

/// A panel at its position, with its axes. `id` is unique in the document. Needs a figure with ranges.
std::string panel_svg(const Figure& figure, const Layout& layout, std::size_t index, const std::string& id);

/// Colour scale, with its numbers and label below the box.
std::string colour_bar_svg(const ColourScale& scale, const Box& box);

/// Path through points, broken at missing ones. Points that only lead around outside the panel are left out.
std::string way(const Polyline& points, const Frame& frame, bool closed);

std::string series_svg(const Figure& figure, const Series& series, const Frame& frame);

constexpr int kLegendSymbolWidth = 34, kLegendSymbolHeight = 16;

/// Symbol of an entry of the legend, with its upper left at 0, 0.
std::string legend_symbol(const Style& style);

/// A figure as a separate SVG file: all panels, the scale of colours and the legend, on white paper.
std::string svg_file(const Figure& figure);

}  // namespace prs
