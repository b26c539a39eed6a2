#include "prs/svg/text_width.h"

#include "prs/svg/layout.h"

namespace prs {
namespace {

/// Advance widths of ASCII from the space on, in thousandths of the font's size: DejaVu Sans, which
/// Linux takes where it has neither Helvetica nor Arial, and which is wider than both.
constexpr short kWidths[] = {
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361,  318, 337, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632,
    575, 775, 752, 295, 295, 656, 557, 863, 748, 787, 603, 787, 695, 635,  611, 732, 684, 989, 685,
    611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615, 352,  635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592,  525, 636, 337, 636, 838};
static_assert(std::size(kWidths) == 95);

constexpr int kOther = 700, kWide = 1000;  // Of letters beyond ASCII, and of those of East Asia.

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
