#include "prs/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace prs {
namespace {

bool is_continuation(unsigned char c) { return (c & 0xC0) == 0x80; }

/// Where the code point number `index` begins.
std::size_t byte_offset(std::string_view text, std::size_t index) {
  std::size_t offset = 0;
  for (std::size_t k = 0; k < index; ++k) offset += sequence_length(text.substr(offset));
  return offset;
}

}  // namespace

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
  if (text.size() > 1 && is_small(text[0]) && is_small(text[1]))
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

}  // namespace prs
