#pragma once

#include <string_view>

namespace prs {

/// Pixels that a text takes in the widest of the fonts that stand for Helvetica or Arial.
double text_width(std::string_view text);

/// A text's rectangle in a picture, pixels from the upper left.
struct TextBox {
  double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0;

  bool overlaps(const TextBox& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

/// Box of a line of text of which `share` lies left of x: 1 ends, 0 begins, 0.5 centres it there.
TextBox text_box(std::string_view text, double x, double baseline, double share);

}  // namespace prs
