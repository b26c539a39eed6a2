#pragma once

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace prs::input {

/// A text that is not a table of comma-separated values. `what()`: `got VALUE; expected WHAT; how
/// to fix it`.
class CsvError : public std::runtime_error {
 public:
  CsvError(std::size_t offset, const std::string& message) : std::runtime_error(message), offset_(offset) {}
  std::size_t offset() const { return offset_; }  ///< Position of the error in the text.

 private:
  std::size_t offset_;
};

/// Rows of a text of comma-separated values after RFC 4180: fields in double quotes may hold separators, line ends and
/// doubled quotes, lines end with LF or CR LF. Fields are separated by commas, semicolons or tabs, whichever comes
/// first in the first row outside quotes. Blanks around fields, empty lines, lines that start with `#`, a line
/// `sep=;` of a spreadsheet before the first row and a byte order mark are skipped, as are empty fields beyond the
/// columns of the first row and rows without values at the end. Between semicolons or tabs numbers may have decimal
/// commas and marks between thousands, as European spreadsheets write them: `fields` has them with a point; ambiguous
/// ones, such as `1.250` in a column without a comma, are not numbers. Rows are read one at a time; the longest allowed
/// row has 1 MiB.
class CsvReader {
 public:
  /// The text must outlive the reader.
  explicit CsvReader(std::string_view text);
  ~CsvReader();
  CsvReader(const CsvReader&) = delete;
  CsvReader& operator=(const CsvReader&) = delete;

  /// Reads the next row; false at the end. Throws CsvError.
  bool next();

  /// Fields of the row, valid until the next row is read.
  const std::vector<std::string_view>& fields() const;

  /// Offset at which the row begins in the text.
  std::size_t row_offset() const;

  /// Offset of a field of a row that begins at `row`; after the last field, of the end of the row.
  std::size_t field_offset(std::size_t row, std::size_t field) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace prs::input
