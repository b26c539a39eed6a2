#include "prs/svg/text_width.h"

#include "prs/svg/layout.h"

namespace prs {
namespace {

/// Advance widths of ASCII from the space on, in thousandths of the font's size, as Adobe's font
/// metrics have them.
constexpr short kWidths[] = {
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333,  278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,
    611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667,  611, 722, 667, 944, 667,
    667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278,  556, 556, 222, 222, 500,
    222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500,  500, 334, 260, 334, 584};
static_assert(std::size(kWidths) == 95);

constexpr int kOther = 600, kWide = 1000;  // Of letters beyond ASCII, and of those of East Asia.

}  // namespace

double text_width(std::string_view text) {
  int thousandths = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 && byte < 0xc0) continue;  // Not the first byte of a letter.
    thousandths += byte >= 0xe3                  ? kWide
                   : byte >= 0xc0                ? kOther
                   : byte >= 0x20 && byte < 0x7f ? kWidths[byte - 0x20]
                                                 : 0;
  }
  return 1e-3 * kFontSize * thousandths;
}

TextBox text_box(std::string_view text, double x, double baseline, double share) {
  const double width = text_width(text);
  return {x - share * width, x + (1.0 - share) * width, baseline - 0.75 * kFontSize,
          baseline + 0.22 * kFontSize};
}

}  // namespace prs
