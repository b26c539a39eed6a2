#pragma once

#include "prs/input/csv_reader.h"
#include "prs/input/source.h"
#include "prs/input/units.h"

namespace prs::input {

/// `5 mm`, or `5` without a unit.
std::string with_unit(double number, std::string_view unit);

/// Conversion of numbers from one unit to another.
struct Conversion {
  double factor = 1.0, offset = 0.0;

  double operator()(double x) const { return factor * x + offset; }
};
/// Conversion between two units; none if they do not have the same dimension.
std::optional<Conversion> conversion(std::string_view from, std::string_view to);

/// Units of the same dimension, for messages.
std::string units_like(std::string_view unit);

/// A table of readings in a CSV file that a block of the input names: all fields as texts, with their places. Throws
/// InputError, which names file, line and column.
class Readings {
 public:
  /// `at`: path of the block, whose key `file` has the name. Reads the heading.
  Readings(const std::string& file, const std::string& at, const Source& source);

  const std::string& name() const { return name_; }                 ///< Name of the file in messages.
  const std::vector<std::string>& names() const { return names_; }  ///< Names of the columns.
  /// Index of a column that the input names under `key`.
  std::size_t column(const std::string& name, const std::string& key) const;
  /// Reads the next row; false at the end.
  bool next();
  /// Line of the row in the file, from 1.
  std::size_t line() const { return line_; }
  /// Column of the line, from 1, at which a field starts.
  std::size_t column_at(std::size_t field) const;
  std::string text(std::size_t field) const;
  double number(std::size_t field) const;
  [[noreturn]] void refuse(std::size_t field, const std::string& got, const std::string& expected) const;
  /// Refuses a name in the heading, before any row is read. Throws InputError.
  [[noreturn]] void refuse_name(std::size_t field, const std::string& expected) const;
  [[noreturn]] void refuse_file(const std::string& what) const;

 private:
  const Source& source_;
  std::string text_, name_;
  CsvReader reader_;
  std::vector<std::string> names_;
  std::size_t line_ = 1, counted_ = 0;
};

}  // namespace prs::input
