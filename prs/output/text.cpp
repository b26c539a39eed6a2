#include "prs/output/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace prs {
namespace {

constexpr std::string_view kReplacement = "\uFFFD";

unsigned char byte(std::string_view text, std::size_t k) {
  return k < text.size() ? static_cast<unsigned char>(text[k]) : 0;
}

bool is_continuation(unsigned char c) { return (c & 0xC0) == 0x80; }

/// Length of the well-formed sequence at the start of the text (Unicode 15, table 3-7), else 0.
std::size_t sequence_length(std::string_view text) {
  const unsigned char first = byte(text, 0);
  const unsigned char second = byte(text, 1);
  if (first < 0x80) return 1;
  if (first < 0xC2 || first > 0xF4) return 0;
  if (first == 0xE0 && second < 0xA0) return 0;  // Overlong.
  if (first == 0xED && second > 0x9F) return 0;  // Surrogates.
  if (first == 0xF0 && second < 0x90) return 0;  // Overlong.
  if (first == 0xF4 && second > 0x8F) return 0;  // Beyond U+10FFFF.
  const std::size_t length = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  for (std::size_t k = 1; k < length; ++k)
    if (!is_continuation(byte(text, k))) return 0;
  return length;
}

bool is_control(std::string_view sequence) {
  const unsigned char first = byte(sequence, 0);
  return first < 0x20 || first == 0x7F || (first == 0xC2 && byte(sequence, 1) < 0xA0);
}

/// U+FFFE and U+FFFF, which XML does not allow.
bool is_noncharacter(std::string_view sequence) {
  return sequence == "\xEF\xBF\xBE" || sequence == "\xEF\xBF\xBF";
}

/// Where the code point number `index` begins.
std::size_t byte_offset(std::string_view text, std::size_t index) {
  std::size_t offset = 0;
  for (std::size_t k = 0; k < index; ++k) offset += sequence_length(text.substr(offset));
  return offset;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = sequence_length(text);
    const std::string_view sequence = text.substr(0, std::max<std::size_t>(length, 1));
    if (length == 0 || is_noncharacter(sequence))
      result += kReplacement;
    else if (is_control(sequence))
      result += ' ';
    else
      result += sequence;
    text.remove_prefix(sequence.size());
  }
  return result;
}

std::size_t width(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return !is_continuation(static_cast<unsigned char>(c));
  }));
}

std::string shortened(std::string_view text, std::size_t max_width) {
  const std::size_t full_width = width(text);
  if (full_width <= max_width) return std::string(text);
  const std::size_t kept = max_width - std::min<std::size_t>(max_width, 1);
  const std::size_t head = kept - kept / 2;
  const std::size_t head_end = byte_offset(text, head);
  const std::size_t tail_begin = byte_offset(text, full_width - kept / 2);
  return fmt::format("{}…{}", text.substr(0, head_end), text.substr(tail_begin));
}

std::string wrapped(std::string_view text, std::string_view indent, std::size_t max_width) {
  std::string result(indent);
  std::size_t column = width(indent);
  bool line_is_empty = true;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
    if (!line_is_empty && column + 1 + width(word) > max_width) {
      result += '\n';
      result += indent;
      column = width(indent);
      line_is_empty = true;
    }
    if (!line_is_empty) result += ' ';
    result += word;
    column += width(word) + (line_is_empty ? 0 : 1);
    line_is_empty = false;
  }
  return result + '\n';
}

}  // namespace prs
