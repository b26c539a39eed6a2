#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace prs {

inline constexpr std::size_t kTableWidth = 100;
/// Stands for what a case does not define.
inline constexpr std::string_view kAbsent = "–";

/// SI * factor with `decimals` decimals; what rounds to zero has no sign.
std::string fixed(std::optional<double> si, double factor, int decimals);
/// The value with its sign, `+0.00` where it rounds to zero.
std::string fixed_change(double value, int decimals);

/// Significant digits at most, four as these formulas are good for; from 1e-4 to 1e9 without an
/// exponent.
std::string significant(std::optional<double> value, int digits = 4);

/// Where a table leaves rows out: `all in slip.csv, with --output DIR`.
std::string all_in(std::string_view file);

/// The text, padded with spaces to `columns` columns.
std::string padded(const std::string& text, std::size_t columns, bool left_aligned);

}  // namespace prs
