#pragma once

#include <string>
#include <vector>

#include "prs/svg/frame.h"
#include "prs/svg/text_width.h"

namespace prs {

/// A map in the colours of a scale: cells of one colour, or filled contours. Of many nodes it is an
/// embedded image.
std::string map_svg(const Map& map, const ColourScale& scale, const Frame& frame);

/// The lines between filled contours.
std::string contours_svg(const Map& map, const ColourScale& scale, const Frame& frame);

/// Their numbers, where there is room; what they take joins `taken`.
std::string contour_numbers(const Map& map, const ColourScale& scale, const Frame& frame,
                            std::vector<TextBox>& taken);

}  // namespace prs
