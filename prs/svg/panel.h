#pragma once

#include "prs/svg/elements.h"
#include "prs/svg/layout.h"

namespace prs {

/// A panel in its place, with its axes. `id` is unique in the document. Needs a figure with ranges.
std::string panel_svg(const Figure& figure, const Layout& layout, std::size_t index,
                      const std::string& id);

/// The scale of the colours, with its numbers and label below the box.
std::string colour_bar_svg(const ColourScale& scale, const Box& box);

}  // namespace prs
