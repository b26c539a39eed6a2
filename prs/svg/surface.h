#pragma once

#include <string>

#include "prs/svg/frame.h"

namespace prs {

/// A surface in space, seen obliquely from above, with its axes.
std::string surface_svg(const Surface& surface, const ColourScale& scale, const Frame& frame);

}  // namespace prs
