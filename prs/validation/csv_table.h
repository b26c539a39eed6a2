#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "prs/input/source.h"

namespace prs {

/// Comma-separated values below one line of column names, as a source's scripts write them. Fields
/// are bare: quotes and empty fields are refused, as are rows of another length than the first. All
/// members throw input::InputError, which names file, line and column.
class CsvTable {
 public:
  explicit CsvTable(const std::filesystem::path& file);

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
  struct Field {
    std::string text;
    input::Place place;
  };
  using Row = std::vector<Field>;

  Row read_row(std::size_t from, std::size_t to) const;
  [[noreturn]] void fail_at(input::Place place, std::string_view key,
                            std::string_view message) const;

  input::Source source_;
  Row header_;
  std::vector<Row> rows_;
};

}  // namespace prs
