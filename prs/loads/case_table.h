#pragma once

#include "prs/loads/result.h"
#include "prs/record/table_units.h"

namespace prs {

/// Most cases that a table names one by one; of more, it shows what they share in one line.
inline constexpr std::size_t kMaxUnfoldedCases = 24;

/// The load cases that one range of the input made (`NAME[k]`), in their order, or a single case.
struct CaseGroup {
  std::string name;  ///< NAME, without `[k]`.
  std::optional<Direction> direction;
  std::vector<const LoadCaseResult*> cases;  ///< Never empty; point into the grouped results.
};

/// Groups by name and direction, in the order of the first members.
std::vector<CaseGroup> group_cases(const std::vector<LoadCaseResult>& results);

/// One configuration of the mechanism in one or both directions of load.
struct LoadedConfiguration {
  std::string name;
  std::vector<CaseGroup> groups;  ///< At most one per direction.

  const CaseGroup* group(std::optional<Direction> direction) const;
};

/// Groups of at least `min_points` cases of which `keep` is true, the others left out. Two
/// directions belong together where their names differ in the last word only: `config1-tension` and
/// `config1-compression` make `config1`.
std::vector<LoadedConfiguration> loaded_configurations(const std::vector<LoadCaseResult>& results,
                                                       std::size_t min_points, bool (*keep)(const LoadCaseResult&));

/// Lists names with the points of a range folded: `a[0–44], b, c[3, 7–9]`. Beyond
/// twelve entries says how many there are.
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
  std::size_t load_columns = 0;                   ///< The first say what the load is; a failed case has no others.
  std::string (*failure)(const LoadCaseResult&);  ///< Stands in their place; empty where none.
  std::string_view file;                          ///< File that has all points of a range.
};

/// The table as a rule within `kTableWidth` columns. Beyond 24 cases a range shows its first,
/// middle and last point.
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
/// The largest of all threads [GPa], and where it acts.
std::string pressure_cell(const LoadCaseResult& result);

/// Decimals of a force in kN: also one of a newton shows four digits.
int force_decimals(double force);

/// Warnings with one code and path, those of several load cases, as one.
struct WarningGroup {
  Warning worst;
  std::vector<std::string> cases = {};  ///< Each once; none: it is about the whole case.
  bool differs = false;                 ///< Not all say the same.
  bool several_paths = false;           ///< By the index of the load case.

  std::string text() const;
  /// `worst in push, and 2 other load cases`, or where all say the same `in a, b[0–44]`; empty
  /// where it is about the whole case.
  std::string where() const;
};

/// Groups in the order of their first members.
std::vector<WarningGroup> grouped(const std::vector<Warning>& warnings);

/// Those of the whole case, then those of the load cases with their names.
std::vector<Warning> all_warnings(std::vector<Warning> of_case, const std::vector<LoadCaseResult>& load_cases);
std::vector<Warning> all_warnings(const Result& result);

/// Each group once with the cases it concerns, in the units of tables: warnings, then assumptions, each
/// below its heading. Empty where there is none.
std::string warning_summary(const std::vector<Warning>& warnings);
/// The same below an empty line.
std::string warning_section(const std::vector<Warning>& warnings);

}  // namespace prs
