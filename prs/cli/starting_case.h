#pragma once

#include <string_view>

namespace prs::cli {

// Commented starting cases, embedded from templates/ when the program is built.
extern const std::string_view kInvertedCase;
extern const std::string_view kStandardCase;

}  // namespace prs::cli
