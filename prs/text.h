#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "prs/printable.h"

namespace prs {

/// Number of code points of well-formed UTF-8.
std::size_t width(std::string_view text);

/// The text itself, or its two ends and an ellipsis between them, `max_width` code points in all.
std::string shortened(std::string_view text, std::size_t max_width);

/// Breaks the text at spaces into lines of at most `max_width` code points that start with
/// `indent`; a longer word stays whole. Ends with a newline.
std::string wrapped(std::string_view text, std::string_view indent, std::size_t max_width);

/// The same for each line of a text that is wider, whose further lines stand two columns further
/// in.
std::string wrapped_lines(std::string_view text, std::size_t max_width);

/// With a large first letter, where it begins a word and is no symbol.
std::string capitalised(std::string text);

}  // namespace prs
