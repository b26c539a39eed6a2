#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "prs/model/part.h"

namespace prs {

inline constexpr std::size_t kTableWidth = 100;

/// Note below a table that leaves rows out: `all in slip.csv, with --output DIR`.
std::string all_in(std::string_view file);

/// The text, padded with spaces to `columns` columns.
std::string padded(const std::string& text, std::size_t columns, bool left_aligned);
/// The text padded, or shortened if it is too long.
std::string fitted(std::string_view text, std::size_t columns, bool left_aligned = false);

/// Layout of rows with a label and cells of one width, aligned to the right.
struct TableRows {
  std::size_t label_width;
  std::size_t cell_width;
  std::size_t gap = 0;  ///< Blanks before each cell.

  /// One row, with the remark at its end.
  std::string operator()(const std::string& label, const std::vector<std::string>& cells,
                         std::string_view remark = {}) const;
};

/// A text after a label of this many columns; further lines are indented to it.
std::string hanging(const std::string& label, std::size_t columns, std::string_view text);

/// The line without trailing blanks.
std::string ended(std::string line);

/// A text of documents as tables show it: `at rest` for `static`, `iteration limit` for `iteration_limit`.
std::string words_of_text(std::string_view text);

/// Bars of both interfaces side by side, one line per thread, under the names of the
/// interfaces. Each bar is followed by its value with `decimals` decimals and the unit; the largest
/// value has the full length.
std::string bar_chart(const PerInterface<std::vector<double>>& values, int decimals, std::string_view unit);

}  // namespace prs
