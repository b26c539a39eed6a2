#include "prs/validation/csv_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "prs/validation/reference.h"

namespace prs {

CsvTable::CsvTable(const std::filesystem::path& file)
    : source_(input::load_source(file.string(), {})), reader_(source_.text) {
  if (std::optional<Row> header = next_row()) header_ = std::move(header->fields);
  while (std::optional<Row> row = next_row()) {
    if (row->fields.size() != header_.size())
      fail_at(
          row->offset, "",
          fmt::format("got {} fields; expected {} as in the heading; complete or delete the row",
                      row->fields.size(), header_.size()));
    rows_.push_back(*std::move(row));
  }
  if (rows_.empty())
    fail_at(0, "", "got no row of values; expected some below the column names; check the file");
}

std::optional<CsvTable::Row> CsvTable::next_row() {
  try {
    if (!reader_.next()) return std::nullopt;
  } catch (const input::CsvError& error) {
    fail_at(error.offset(), "", error.what());
  }
  Row row{reader_.row_offset(), {}};
  for (const std::string_view field : reader_.fields()) {
    if (field.empty())
      fail_at(reader_.field_offset(row.offset, row.fields.size()), "",
              "got an empty field; expected a value; write one");
    row.fields.emplace_back(field);
  }
  return row;
}

bool CsvTable::has_column(std::string_view name) const {
  return std::ranges::find(header_, name) != header_.end();
}

std::size_t CsvTable::column(std::string_view name) const {
  const auto found = std::ranges::find(header_, name);
  if (found == header_.end()) fail_at(0, name, "missing; expected a column of this name");
  return static_cast<std::size_t>(found - header_.begin());
}

std::string CsvTable::text(std::size_t row, std::size_t column) const {
  return rows_[row].fields[column];
}

double CsvTable::number(std::size_t row, std::size_t column) const {
  const std::string& text = rows_[row].fields[column];
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value))
    fail(row, column, fmt::format("got {}; expected a number", input::shown(text)));
  return value;
}

double CsvTable::half_unit(std::size_t row, std::size_t column) const {
  return PrintedNumber{rows_[row].fields[column], {}}.half_unit();
}

void CsvTable::fail(std::size_t row, std::size_t column, std::string_view message) const {
  fail_at(reader_.field_offset(rows_[row].offset, column), header_[column], message);
}

void CsvTable::fail_at(std::size_t offset, std::string_view key, std::string_view message) const {
  input::ErrorList errors(source_);
  errors.fail({offset}, key, message);
}

}  // namespace prs
