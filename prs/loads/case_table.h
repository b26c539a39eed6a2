#pragma once

#include "prs/loads/result.h"
#include "prs/record/table_text.h"

namespace prs {

struct CaseColumn {
  std::string_view title;
  std::string_view subtitle;  ///< With the unit of documents at its end.
  bool left_aligned;
  std::string (*cell)(const LoadCaseResult&);
};

/// A table with one row per load case.
struct CaseTable {
  std::span<const CaseColumn> columns;
  std::size_t load_columns = 0;  ///< The first say what the load is; a failed case has no others.
  std::string (*failure)(const LoadCaseResult&);  ///< Stands in their place; empty where none.
  std::string_view file;                          ///< That has all points of a range.
};

/// The table as a rule within `kTableWidth` columns. Beyond 24 cases a range shows its first,
/// middle and last point.
std::string case_table(const CaseTable& table, const std::vector<LoadCaseResult>& results);

/// Of a case without equilibrium; else empty.
std::string not_converged(const LoadCaseResult& result);

// Cells that tables of load cases share.
std::string case_name_cell(const LoadCaseResult& result);
std::string force_cell(const LoadCaseResult& result);  ///< In `table_unit("kN")`.
std::string direction_cell(const LoadCaseResult& result);
std::string stiffness_cell(const LoadCaseResult& result);     ///< [N/µm]
std::string displacement_cell(const LoadCaseResult& result);  ///< [µm]
/// The thread with the largest share [%], and its share.
std::string most_loaded_cell(const LoadCaseResult& result, Interface i);
/// The largest of all threads [GPa], and where it acts.
std::string pressure_cell(const LoadCaseResult& result);

/// Decimals of a force in kN: also one of a newton shows four digits.
int force_decimals(double force);

}  // namespace prs
