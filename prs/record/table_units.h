#pragma once

#include "prs/model/part.h"
#include "prs/model/warning.h"
#include "prs/record/record.h"
#include "prs/record/response_title.h"

namespace prs {

/// Units of tables for people. Documents and CSV are always `si`: their names carry the units.
enum class UnitSystem { si, us };

/// Sets the unit system of tables made by this thread while the object lives, like the locale of a stream; default
/// `si`.
class TableUnits {
 public:
  explicit TableUnits(UnitSystem system);
  ~TableUnits();
  TableUnits(const TableUnits&) = delete;
  TableUnits& operator=(const TableUnits&) = delete;

 private:
  UnitSystem before_;
};

/// Unit of tables that replaces one of documents: `lbf` for `kN`. The unit itself if US designers use it too, or if it
/// is not a unit of documents.
ShownUnit table_unit(const ShownUnit& unit);
ShownUnit table_unit(std::string_view text);

/// A label with the table unit at its end: `torque, lbf in` for `torque, N m`.
std::string with_table_unit(std::string_view label);

/// Unit system of the tables being made.
UnitSystem table_system();

/// A number that is written in a document unit, in the table unit with as many digits, at least three.
std::string table_number(std::string_view number, std::string_view unit);
/// A quantity `12.5 kN` in the table unit, likewise.
std::string in_table_unit(std::string_view quantity);

/// Sentence of a warning with its quantities in table units.
std::string table_sentence(const Warning& warning);

/// An SI number as tables show it if documents show it in this unit: `kN`.
double shown(double si, std::string_view unit);

/// Number as text, with as many decimals as the document unit would have with `decimals`, no coarser.
std::string fixed(std::optional<double> si, std::string_view unit, int decimals);
/// Number as text with its unit: `12.00 kN`.
std::string fixed_with_unit(std::optional<double> si, std::string_view unit, int decimals);

/// Factor from a document unit to the table unit.
double table_factor(const ShownUnit& unit);
double table_factor(std::string_view unit);

/// A response of a study as tables show it.
struct TableResponse {
  ResponseTitle title;  ///< Title with the unit of tables.
  double factor = 1.0;  ///< Factor from the document unit to that unit.

  std::string text() const;  ///< `max screw peak pressure (MPa)`
};

TableResponse table_response(std::string_view path);

/// Text for a value that a case does not define.
inline constexpr std::string_view kAbsent = "–";

/// SI * factor with `decimals` decimals; a value that rounds to zero has no sign.
std::string fixed(std::optional<double> si, double factor, int decimals);
/// The value with its sign, `+0.00` if it rounds to zero.
std::string fixed_change(double value, int decimals);

/// Value with at most `digits` significant digits, by default four, the accuracy of the formulas; without an exponent
/// from 1e-4 to 1e9.
std::string significant(std::optional<double> value, int digits = 4);
/// Value with significant digits in the table unit that replaces a document unit: `24.04 in/s`.
std::string significant_with_unit(std::optional<double> si, std::string_view unit, int digits = 4);

/// Value with significant digits, with an exponent where that is shorter.
std::string digits(std::optional<double> value, int digits);

}  // namespace prs
