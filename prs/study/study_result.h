#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "prs/model/study.h"
#include "prs/model/warning.h"
#include "prs/study/analysis.h"
#include "prs/study/row_block.h"

namespace prs {

/// One design of a study and its results.
struct StudyRow {
  Design design;
  DesignStatus status;
  std::vector<std::optional<double>> responses;  ///< In the order of the study's.
};

/// Rows that are kept for tables, figures and documents; files hold all of them.
inline constexpr std::size_t kMostRowsShown = 20'000;

/// A study with its first rows in the order of the designs, the base case first, and what all of
/// them say together.
struct StudyResult {
  Study study;  ///< Its responses are those recorded.
  std::vector<StudyRow> rows;
  std::size_t designs = 0;  ///< All, base case included.
  std::size_t refused = 0;
  std::size_t failed = 0;  ///< Not converged, or failed.
  StudySummary summary;
  std::vector<Warning> warnings = {};

  const StudyRow& base() const { return rows.front(); }
};

/// Adds a block, the next in order, to the counts and, as far as they are kept, to the rows.
void add(StudyResult& result, const RowBlock& block);

}  // namespace prs
