#pragma once

#include "prs/svg/elements.h"
#include "prs/svg/layout.h"

namespace prs {

/// A map in the colours of a scale: cells of one colour or, as an embedded image, filled contours
/// and cells that are many.
std::string map_svg(const Map& map, const ColourScale& scale, const Frame& frame);

/// The lines where a map has one value.
struct Contours {
  double level = 0.0;
  std::vector<Polyline> lines = {};
};

/// Those between filled contours.
std::vector<Contours> contours_of(const Map& map, const ColourScale& scale);

std::string contours_svg(const std::vector<Contours>& contours, const Frame& frame);

/// Their numbers, where there is room; what they take joins `taken`.
std::string contour_numbers(const std::vector<Contours>& contours, const Frame& frame,
                            std::vector<TextBox>& taken);

}  // namespace prs
