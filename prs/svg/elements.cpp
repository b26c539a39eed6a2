#include "prs/svg/elements.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>

#include "prs/svg/layout.h"
#include "prs/text.h"

namespace prs {
namespace {

struct Escape {
  char of;
  std::string_view text;
};
constexpr std::array<Escape, 5> kEscapes{
    {{'<', "&lt;"}, {'>', "&gt;"}, {'&', "&amp;"}, {'"', "&quot;"}, {'\'', "&#39;"}}};

}  // namespace

std::string html(std::string_view content) {
  if (is_plain_lines(content) && content.find_first_of("<>&\"'\n") == content.npos)
    return std::string(content);
  std::string escaped;
  for (const char c : printable(content))
    if (const auto* known = std::ranges::find(kEscapes, c, &Escape::of); known != kEscapes.end())
      escaped += known->text;
    else
      escaped += c;
  return escaped;
}

std::string tenth_of(double value) {
  char digits[24];
  const long tenths = std::lround(10.0 * std::clamp(value, -1e7, 1e7));
  char* end = digits;
  if (tenths < 0) *end++ = '-';
  end = std::to_chars(end, std::end(digits), std::abs(tenths) / 10).ptr;
  *end++ = '.';
  *end++ = static_cast<char>('0' + std::abs(tenths) % 10);
  return {digits, end};
}

void append_tenths(std::string& d, long n, bool first) {
  char digits[24];
  char* end = digits;
  if (n < 0)
    *end++ = '-';
  else if (!first)
    *end++ = ' ';
  const long size = std::abs(n);
  if (size >= 10 || size == 0) end = std::to_chars(end, std::end(digits), size / 10).ptr;
  if (size % 10 != 0) {
    *end++ = '.';
    *end++ = static_cast<char>('0' + size % 10);
  }
  d.append(digits, end);
}

std::string tick_text(double value, double step) {
  const double size = std::abs(value);
  if (step > 0.0 && size < 1e-9 * step) value = 0.0;
  std::string shown = fmt::format("{:.6g}", value);
  if (shown.starts_with('-')) shown.replace(0, 1, "\u2212");
  return shown;
}

std::string text(double x, double y, std::string_view classes, std::string_view content,
                 std::string_view more) {
  std::string all = "<text x=\"" + tenth_of(x) + "\" y=\"" + tenth_of(y) + "\" class=\"";
  return all.append(classes).append("\"").append(more).append(">") + html(content) + "</text>";
}

std::string texts(double x, double y, std::string_view classes,
                  const std::vector<std::string>& lines, std::string_view more) {
  std::string all;
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (!lines[k].empty())
      all += text(x, y - kLineHeight * static_cast<double>(lines.size() - 1 - k), classes, lines[k],
                  more);
  return all;
}

std::string turned(double x, double y, int angle) {
  return " transform=\"rotate(" + std::to_string(angle) + " " + tenth_of(x) + " " + tenth_of(y) +
         ")\"";
}

std::string segment(double x1, double y1, double x2, double y2, std::string_view attributes) {
  std::string all = "<path d=\"M" + tenth_of(x1) + " " + tenth_of(y1) + "L" + tenth_of(x2) + " " +
                    tenth_of(y2) + "\" ";
  return all.append(attributes).append("/>");
}

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
