#include "prs/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace prs {
namespace {

constexpr std::string_view kReplacement = "\uFFFD";

unsigned char byte(std::string_view text, std::size_t k) {
  return k < text.size() ? static_cast<unsigned char>(text[k]) : 0;
}

/// Code point of a well-formed UTF-8 sequence.
std::uint32_t code_point(std::string_view sequence) {
  if (sequence.size() == 1) return byte(sequence, 0);
  std::uint32_t code = byte(sequence, 0) & (0x7Fu >> sequence.size());
  for (std::size_t k = 1; k < sequence.size(); ++k) code = code << 6u | (byte(sequence, k) & 0x3Fu);
  return code;
}

bool is_between(std::uint32_t code, std::uint32_t first, std::uint32_t last) { return first <= code && code <= last; }

/// Whether a code point is C0, DELETE, C1, or a separator of lines or paragraphs.
bool is_control(std::uint32_t code) {
  return code < 0x20 || is_between(code, 0x7F, 0x9F) || is_between(code, 0x2028, 0x2029);
}

/// Whether a code point is invisible or reserved: marks and controls of writing direction, joiners and spaces without
/// width, tags, byte order marks (Unicode 15, general category Cf without the soft hyphen and signs of scripts), and
/// noncharacters, which XML does not allow.
bool is_hidden(std::uint32_t code) {
  return code == 0x061C || code == 0x180E || is_between(code, 0x200B, 0x200F) || is_between(code, 0x202A, 0x202E) ||
         is_between(code, 0x2060, 0x206F) || code == 0xFEFF || is_between(code, 0xFFF9, 0xFFFB) ||
         is_between(code, 0xFFFE, 0xFFFF) || is_between(code, 0xE0000, 0xE0FFF);
}

/// The text with each sequence as `write` appends it; malformed bytes become U+FFFD.
template <class Write>
std::string rewritten(std::string_view text, Write write) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = sequence_length(text);
    if (length == 0)
      result += kReplacement;
    else
      write(result, text.substr(0, length));
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

void append_printable(std::string& result, std::string_view sequence) {
  const std::uint32_t code = code_point(sequence);
  if (is_control(code))
    result += ' ';
  else
    result += is_hidden(code) ? kReplacement : sequence;
}

}  // namespace

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
    if ((byte(text, k) & 0xC0) != 0x80) return 0;
  return length;
}

bool is_plain_lines(std::string_view text) noexcept {
  const auto others = [](std::string_view part) {
    unsigned char any = 0;  // Without an early exit: compilers then process many characters at once.
    for (const char c : part) any |= static_cast<unsigned char>((c < 0x20 && c != '\n') || c == 0x7F);
    return any;
  };
  constexpr std::size_t kPart = 4096;
  for (std::size_t k = 0; k < text.size(); k += kPart)
    if (others(text.substr(k, kPart)) != 0) return false;
  return true;
}

std::string printable(std::string_view text) {
  if (is_plain_lines(text) && text.find('\n') == text.npos) return std::string(text);
  return rewritten(text, append_printable);
}

std::string printable_lines(std::string_view text) {
  if (is_plain_lines(text)) return std::string(text);
  return rewritten(text, [](std::string& result, std::string_view sequence) {
    if (sequence == "\n")
      result += sequence;
    else
      append_printable(result, sequence);
  });
}

std::string printable_json(std::string json) {
  if (is_plain_lines(json)) return json;
  return rewritten(json, [](std::string& result, std::string_view sequence) {
    const std::uint32_t code = code_point(sequence);
    // Blanks between values stay; within strings JSON has no other control characters.
    if (code < 0x20 || !(is_control(code) || is_hidden(code)))
      result += sequence;
    else if (code < 0x10000)
      result += fmt::format("\\u{:04x}", code);
    else
      result += fmt::format("\\u{:04x}\\u{:04x}", 0xD7C0 + (code >> 10u), 0xDC00 + (code & 0x3FFu));
  });
}

namespace {

bool is_continuation(unsigned char c) { return (c & 0xC0) == 0x80; }

/// Offset at which the code point number `index` begins.
std::size_t byte_offset(std::string_view text, std::size_t index) {
  std::size_t offset = 0;
  for (std::size_t k = 0; k < index; ++k) offset += sequence_length(text.substr(offset));
  return offset;
}

}  // namespace

std::size_t width(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return !is_continuation(static_cast<unsigned char>(c)); }));
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

std::string wrapped_lines(std::string_view text, std::size_t max_width) {
  std::string result;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    const bool ends = line.size() < text.size();
    text.remove_prefix(line.size() + (ends ? 1 : 0));
    if (width(line) <= max_width) {
      result.append(line).append(ends ? "\n" : "");
      continue;
    }
    const std::size_t blanks = std::min(line.find_first_not_of(' '), line.size());
    std::string lines = wrapped(line.substr(blanks), std::string(blanks + 2, ' '), max_width);
    lines.erase(0, 2);
    if (!ends) lines.pop_back();
    result += lines;
  }
  return result;
}

std::string capitalised(std::string text) {
  const auto is_small = [](char c) { return c >= 'a' && c <= 'z'; };
  if (text.size() > 1 && is_small(text[0]) && is_small(text[1])) text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

}  // namespace prs
