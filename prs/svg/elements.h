#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace prs {

/// A text as HTML and SVG show it: `printable`, with markup escaped.
std::string html(std::string_view text);

/// As `{:.1f}` has it, which pictures are full of; numbers beyond a picture need not be exact.
std::string tenth_of(double value);

/// Tenths of a unit as a path has them: short, without a space before a sign.
void append_tenths(std::string& path, long tenths, bool first);

/// A number at a tick, no finer than its step needs, with a typographic minus.
std::string tick_text(double value, double step);

/// A text element. The classes say how it is aligned.
std::string text(double x, double y, std::string_view classes, std::string_view content,
                 std::string_view more = "");

constexpr int kLineHeight = 17;  ///< Between lines of text.

/// Lines of text, the last one at y.
std::string texts(double x, double y, std::string_view classes,
                  const std::vector<std::string>& lines, std::string_view more = "");

/// The attribute that turns a text about its place, in degrees.
std::string turned(double x, double y, int angle);

std::string segment(double x1, double y1, double x2, double y2, std::string_view attributes);

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
