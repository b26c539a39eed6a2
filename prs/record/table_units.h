#pragma once

#include "prs/model/part.h"
#include "prs/record/record.h"

namespace prs {

/// What a person calls a response.
struct ResponseTitle {
  std::string name;  ///< `max screw peak pressure`
  std::string unit;  ///< `MPa`; empty where the path names none.
};

/// `screw.peak_pressure_MPa.max` -> `max screw peak pressure`, `MPa`: what belongs to a part of the
/// mechanism starts with its name, `slip`, `contact` and `measures` are left out.
ResponseTitle response_title(std::string_view path);

/// In what tables for people show quantities. Documents and CSV are always `si`: their names carry
/// the units.
enum class UnitSystem { si, us };

/// The system of the tables that this thread makes while the object lives, as a locale is that of a
/// stream; `si` where there is none.
class TableUnits {
 public:
  explicit TableUnits(UnitSystem system);
  ~TableUnits();
  TableUnits(const TableUnits&) = delete;
  TableUnits& operator=(const TableUnits&) = delete;

 private:
  UnitSystem before_;
};

/// The unit of tables in place of one of documents: `lbf` in place of `kN`. Where US designers use
/// the same, or the text is no unit of documents, the unit itself.
ShownUnit table_unit(const ShownUnit& unit);
ShownUnit table_unit(std::string_view text);

/// A label with the unit of tables at its end: `torque, lbf in` of `torque, N m`.
std::string with_table_unit(std::string_view label);

/// The system of the tables that are made now.
UnitSystem table_system();

/// A sentence whose quantities are in units of documents (`2.9 GPa`, `0.2 to 0.5 mm`) with those of
/// tables, as many digits, three at least. What stands in backticks, as one would type it, stays.
std::string in_table_units(const std::string& sentence);

/// A number of SI as tables show what documents show in this unit: `kN`.
double shown(double si, std::string_view unit);

/// The same with as many decimals as documents' unit would have with `decimals`, no coarser.
std::string fixed(std::optional<double> si, std::string_view unit, int decimals);
/// The same with the unit behind it: `12.00 kN`.
std::string fixed_with_unit(std::optional<double> si, std::string_view unit, int decimals);

/// What shows a number of documents in the unit of tables.
double table_factor(const ShownUnit& unit);
double table_factor(std::string_view unit);

/// A response of a study as tables show it.
struct TableResponse {
  ResponseTitle title;  ///< Title with the unit of tables.
  double factor = 1.0;  ///< What shows a number of documents in that unit.

  std::string text() const;  ///< `max screw peak pressure (MPa)`
};

TableResponse table_response(std::string_view path);

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
/// The same of what documents show in a unit, in that of tables: `24.04 in/s`.
std::string significant_with_unit(std::optional<double> si, std::string_view unit, int digits = 4);

/// As many significant digits, with an exponent where it is shorter.
std::string digits(std::optional<double> value, int digits);

/// Note below a table that leaves rows out: `all in slip.csv, with --output DIR`.
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
std::string bar_chart(const PerInterface<std::vector<double>>& values, int decimals, std::string_view unit);

}  // namespace prs
