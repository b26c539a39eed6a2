#pragma once

#include "prs/input/csv_reader.h"
#include "prs/input/source.h"

namespace prs {

/// Comma-separated values below one line of column names, see `input::CsvReader`. Empty fields are
/// refused, as are rows of another length than the first. All members throw input::InputError,
/// which names file, line and column.
class CsvTable {
 public:
  explicit CsvTable(const std::filesystem::path& file);
  CsvTable(const CsvTable&) = delete;
  CsvTable& operator=(const CsvTable&) = delete;

  std::size_t rows() const { return rows_.size(); }
  /// Index of the column; an error where there is none.
  std::size_t column(std::string_view name) const;
  bool has_column(std::string_view name) const;

  std::string text(std::size_t row, std::size_t column) const;
  /// A finite number and nothing else.
  double number(std::size_t row, std::size_t column) const;
  /// Half a unit of the number's last digit.
  double half_unit(std::size_t row, std::size_t column) const;

  /// What turns out to be wrong with a field.
  [[noreturn]] void fail(std::size_t row, std::size_t column, std::string_view message) const;

 private:
  struct Row {
    std::size_t offset = 0;  ///< Where it begins in the file.
    std::vector<std::string> fields;
  };

  /// The next row; none at the end of the file.
  std::optional<Row> next_row();
  [[noreturn]] void fail_at(std::size_t offset, std::string_view key,
                            std::string_view message) const;

  input::Source source_;
  input::CsvReader reader_;  ///< Reads the source's text.
  std::vector<std::string> header_;
  std::vector<Row> rows_;
};

}  // namespace prs
