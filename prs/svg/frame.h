#pragma once

#include <cmath>

#include "prs/svg/layout.h"

namespace prs {

/// Along one side of a panel: from coordinates to pixels.
struct Ruler {
  double from = 0.0, to = 1.0;
  int start = 0, end = 1;
  bool logarithmic = false;

  double operator()(double value) const {
    const double share =
        logarithmic ? std::log(value / from) / std::log(to / from) : (value - from) / (to - from);
    return start + share * (end - start);
  }
  /// And back.
  double value_at(double pixel) const {
    const double share = (pixel - start) / (end - start);
    return logarithmic ? from * std::pow(to / from, share) : from + share * (to - from);
  }
};

/// A panel in its place, its axes with their ranges.
struct Frame {
  const Panel& panel;
  Box box;
  Axis x, y;
  Ruler across, up;
};

/// The figure with its free axes fitted to what is shown. What follows needs it.
Figure with_ranges(Figure figure);

Frame frame_of(const Figure& figure, const Layout& layout, std::size_t index);

}  // namespace prs
