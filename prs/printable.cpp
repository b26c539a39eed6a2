#include "prs/printable.h"

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

bool is_between(std::uint32_t code, std::uint32_t first, std::uint32_t last) {
  return first <= code && code <= last;
}

/// C0, DELETE, C1, and the separators of lines and paragraphs.
bool is_control(std::uint32_t code) {
  return code < 0x20 || is_between(code, 0x7F, 0x9F) || is_between(code, 0x2028, 0x2029);
}

/// Marks and controls of writing direction, joiners and spaces without width, tags, byte order
/// marks (Unicode 15, general category Cf but for the soft hyphen and signs of scripts), and
/// noncharacters, which XML does not allow.
bool is_hidden(std::uint32_t code) {
  return code == 0x061C || code == 0x180E || is_between(code, 0x200B, 0x200F) ||
         is_between(code, 0x202A, 0x202E) || is_between(code, 0x2060, 0x206F) || code == 0xFEFF ||
         is_between(code, 0xFFF9, 0xFFFB) || is_between(code, 0xFFFE, 0xFFFF) ||
         is_between(code, 0xE0000, 0xE0FFF);
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
    unsigned char any = 0;  // To the end of the part: compilers look at many characters at once.
    for (const char c : part)
      any |= static_cast<unsigned char>((c < 0x20 && c != '\n') || c == 0x7F);
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

std::string printable_json(std::string_view json) {
  if (is_plain_lines(json)) return std::string(json);
  return rewritten(json, [](std::string& result, std::string_view sequence) {
    const std::uint32_t code = code_point(sequence);
    // Blanks between values are plain; within strings JSON has no other control characters.
    if (code < 0x20 || !(is_control(code) || is_hidden(code)))
      result += sequence;
    else if (code < 0x10000)
      result += fmt::format("\\u{:04x}", code);
    else
      result += fmt::format("\\u{:04x}\\u{:04x}", 0xD7C0 + (code >> 10u), 0xDC00 + (code & 0x3FFu));
  });
}

}  // namespace prs
