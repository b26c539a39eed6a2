#include "prs/validation/csv_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "prs/validation/reference.h"

namespace prs {

CsvTable::CsvTable(const std::filesystem::path& file)
    : source_(input::load_source(file.string(), {})) {
  const std::string& text = source_.text;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find('\n', from), text.size());
    Row row = read_row(from, to);
    if (header_.empty()) {
      header_ = std::move(row);
    } else if (row.size() != header_.size()) {
      fail_at(row.front().place, "",
              fmt::format("got {} fields; expected {} as in the first line", row.size(),
                          header_.size()));
    } else {
      rows_.push_back(std::move(row));
    }
    from = to + 1;
  }
  if (rows_.empty()) fail_at({}, "", "expected column names and rows of values");
}

CsvTable::Row CsvTable::read_row(std::size_t from, std::size_t to) const {
  if (to > from && source_.text[to - 1] == '\r') --to;
  Row row;
  for (std::size_t start = from; start <= to;) {
    const std::size_t end = std::min(source_.text.find(',', start), to);
    row.push_back({source_.text.substr(start, end - start), {start}});
    if (row.back().text.empty()) fail_at(row.back().place, "", "got an empty field");
    if (row.back().text.find('"') != std::string::npos)
      fail_at(row.back().place, "", "got a quote; expected a bare field");
    start = end + 1;
  }
  return row;
}

bool CsvTable::has_column(std::string_view name) const {
  return std::ranges::find(header_, name, &Field::text) != header_.end();
}

std::size_t CsvTable::column(std::string_view name) const {
  const auto found = std::ranges::find(header_, name, &Field::text);
  if (found == header_.end()) fail_at({}, name, "missing; expected a column of this name");
  return static_cast<std::size_t>(found - header_.begin());
}

std::string CsvTable::text(std::size_t row, std::size_t column) const {
  return rows_[row][column].text;
}

double CsvTable::number(std::size_t row, std::size_t column) const {
  const std::string& text = rows_[row][column].text;
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value))
    fail(row, column, fmt::format("got {}; expected a number", input::shown(text)));
  return value;
}

double CsvTable::half_unit(std::size_t row, std::size_t column) const {
  return PrintedNumber{rows_[row][column].text, {}}.half_unit();
}

void CsvTable::fail(std::size_t row, std::size_t column, std::string_view message) const {
  fail_at(rows_[row][column].place, header_[column].text, message);
}

void CsvTable::fail_at(input::Place place, std::string_view key, std::string_view message) const {
  input::ErrorList errors(source_);
  errors.fail(place, key, message);
}

}  // namespace prs
