#pragma once

namespace prs {

/// Room that `write_short` needs for one number; what lies behind its end may be overwritten.
inline constexpr int kShortNumberSize = 32;

/// Writes a finite number with `digits` significant digits at most, 1 to 17, as fmt's `{:.Ng}` does
/// to the last character, and returns the end. Numbers whose digits end clear of a tie, nearly all,
/// take one product and one whole number.
char* write_short(char* at, double value, int digits);

}  // namespace prs
