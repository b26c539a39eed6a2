#pragma once

#include "prs/loads/result.h"
#include "prs/record/table_units.h"

namespace prs {

/// Largest number of cases that a table lists one by one; more share lines.
inline constexpr std::size_t kMaxUnfoldedCases = 24;

/// Load cases made from one range of the input (`NAME[k]`), in order, or a single case.
struct CaseGroup {
  std::string name;  ///< NAME, without `[k]`.
  std::optional<Direction> direction;
  std::vector<const LoadCaseResult*> cases;  ///< Cases, never empty; they point into the grouped results.
};

/// Groups by name and direction, in the order of the first members.
std::vector<CaseGroup> group_cases(const std::vector<LoadCaseResult>& results);

/// One configuration of the mechanism in one or both directions of load.
struct LoadedConfiguration {
  std::string name;
  std::vector<CaseGroup> groups;  ///< At most one per direction.

  const CaseGroup* group(std::optional<Direction> direction) const;
};

/// Groups of at least `min_points` cases for which `keep` is true, without the other cases. Two directions belong
/// together if their names differ in the last word only: `config1-tension` and `config1-compression` make `config1`.
std::vector<LoadedConfiguration> loaded_configurations(const std::vector<LoadCaseResult>& results,
                                                       std::size_t min_points, bool (*keep)(const LoadCaseResult&));

/// List of names with the points of a range folded: `a[0–44], b, c[3, 7–9]`. Beyond twelve entries their number is
/// given.
std::string folded_names(const std::vector<std::string>& names);

struct CaseColumn {
  std::string_view title;
  std::string_view subtitle;  ///< Subtitle with the unit of documents at its end.
  bool left_aligned;
  std::string (*cell)(const LoadCaseResult&);
};

/// A table with one row per load case.
struct CaseTable {
  std::span<const CaseColumn> columns;
  std::size_t load_columns = 0;  ///< Number of columns that describe the load; a failed case has only these.
  /// Text for a failed case in place of the other columns; empty for others.
  std::string (*failure)(const LoadCaseResult&);
  std::string_view file;  ///< File with all points of a range.
};

/// The table, usually within `kTableWidth` columns. Beyond 24 cases a range shows its first, middle and last point.
std::string case_table(const CaseTable& table, const std::vector<LoadCaseResult>& results);

/// Text for a case without equilibrium; else empty.
std::string not_converged(const LoadCaseResult& result);

// Cells that tables of load cases share.
std::string case_name_cell(const LoadCaseResult& result);
std::string force_cell(const LoadCaseResult& result);  ///< In `table_unit("kN")`.
std::string direction_cell(const LoadCaseResult& result);
std::string stiffness_cell(const LoadCaseResult& result);     ///< [N/µm]
std::string displacement_cell(const LoadCaseResult& result);  ///< [µm]
/// The thread with the largest share [%], and its share.
std::string most_loaded_cell(const LoadCaseResult& result, Interface i);
/// The largest pressure of all threads [GPa], and its place.
std::string pressure_cell(const LoadCaseResult& result);

/// Decimals of a force in kN, enough for four digits of one newton.
int force_decimals(double force);

/// Warnings with one code and path, of several load cases, combined.
struct WarningGroup {
  Warning worst;
  std::vector<std::string> cases = {};  ///< Names, each once; empty: the warning is about the whole case.
  bool differs = false;                 ///< Whether their sentences differ.
  bool several_paths = false;           ///< Whether their paths differ in the index of the load case.

  std::string text() const;
  /// `worst in push, and 2 other load cases`, or if all have the same sentence `in a, b[0–44]`; empty if it is about
  /// the whole case.
  std::string where() const;
};

/// Groups in the order of their first members.
std::vector<WarningGroup> grouped(const std::vector<Warning>& warnings);

/// Warnings of the whole case, then those of the load cases with their names.
std::vector<Warning> all_warnings(std::vector<Warning> of_case, const std::vector<LoadCaseResult>& load_cases);
std::vector<Warning> all_warnings(const Result& result);

/// Each group once with its cases, in the units of tables: warnings, then assumptions, each under a heading. Empty if
/// there is none.
std::string warning_summary(const std::vector<Warning>& warnings);
/// The summary after an empty line.
std::string warning_section(const std::vector<Warning>& warnings);

}  // namespace prs
