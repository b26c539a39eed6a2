#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "prs/model/part.h"

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

/// As many significant digits, with an exponent where it is shorter.
std::string digits(std::optional<double> value, int digits);

/// Where a table leaves rows out: `all in slip.csv, with --output DIR`.
std::string all_in(std::string_view file);

/// The text, padded with spaces to `columns` columns.
std::string padded(const std::string& text, std::size_t columns, bool left_aligned);
/// The same of what may be too long: shortened.
std::string fitted(std::string_view text, std::size_t columns, bool left_aligned = false);

/// The layout of rows with a label and, behind it, cells of one width, aligned to the right.
struct TableRows {
  std::size_t label_width;
  std::size_t cell_width;
  std::size_t gap = 0;  ///< Blanks before each cell.

  /// One row, the remark at its end.
  std::string operator()(const std::string& label, const std::vector<std::string>& cells,
                         std::string_view remark = {}) const;
};

/// A text behind a label of so many columns; its later lines stand below the first.
std::string hanging(const std::string& label, std::size_t columns, std::string_view text);

/// The line without the blanks at its end.
std::string ended(std::string line);

/// A text of documents as tables show it: `flank's edge` of `flank_edge`, `iteration limit` of
/// `iteration_limit`.
std::string words_of_text(std::string_view text);

/// Bars of both interfaces side by side, one line per thread, under the names of the
/// interfaces. Each bar is followed by its value with `decimals` decimals and the unit; the largest
/// value has the full length.
std::string bar_chart(const PerInterface<std::vector<double>>& values, int decimals,
                      std::string_view unit);

}  // namespace prs
