#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace prs {

/// The text on one line of well-formed UTF-8 without hidden characters: control characters and separators of lines
/// become spaces; malformed bytes, invisible characters and those that turn the direction of writing become U+FFFD.
/// Makes names from files safe for terminals, scripts and SVG.
std::string printable(std::string_view text);

/// `printable` for a text of many lines.
std::string printable_lines(std::string_view text);

/// Whether a text is lines of visible ASCII, which `printable_lines` leaves as they are.
bool is_plain_lines(std::string_view text) noexcept;

/// JSON whose strings show such characters as \uXXXX, so that it can be printed and has the same meaning.
std::string printable_json(std::string json);

/// Length of the well-formed sequence at the start of the text (Unicode 15, table 3-7), else 0.
std::size_t sequence_length(std::string_view text);

/// Number of code points of well-formed UTF-8.
std::size_t width(std::string_view text);

/// The text itself, or its two ends and an ellipsis between them, `max_width` code points in all.
std::string shortened(std::string_view text, std::size_t max_width);

/// Breaks the text at spaces into lines of at most `max_width` code points that start with
/// `indent`; a longer word stays whole. Ends with a newline.
std::string wrapped(std::string_view text, std::string_view indent, std::size_t max_width);

/// Wraps each line of a text that is too wide; continuation lines are indented by two more columns.
std::string wrapped_lines(std::string_view text, std::size_t max_width);

/// The text with a capital first letter, if that begins a word and is not a symbol.
std::string capitalised(std::string text);

}  // namespace prs
