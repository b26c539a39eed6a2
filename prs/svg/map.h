#pragma once

#include "prs/svg/panel.h"

namespace prs {

/// A map in the colours of a scale: cells of one colour or, as an embedded image, filled contours and large numbers of
/// cells.
std::string map_svg(const Map& map, const ColourScale& scale, const Frame& frame);

/// Lines on which a map has one value.
struct Contours {
  double level = 0.0;
  std::vector<Polyline> lines = {};
};

/// Lines between filled contours.
std::vector<Contours> contours_of(const Map& map, const ColourScale& scale);

std::string contours_svg(const std::vector<Contours>& contours, const Frame& frame);

/// Numbers of the lines, where they fit; their boxes are added to `taken`.
std::string contour_numbers(const std::vector<Contours>& contours, const Frame& frame, std::vector<TextBox>& taken);

}  // namespace prs
