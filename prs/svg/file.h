#pragma once

#include "prs/record/figure.h"

namespace prs {

/// A figure as an SVG file of its own: all panels, the scale of colours and the legend, on white
/// paper.
std::string svg_file(const Figure& figure);

}  // namespace prs
