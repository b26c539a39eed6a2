#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace test {

using CsvRow = std::map<std::string, std::string>;

/// Fields of RFC 4180 text, line by line.
inline std::vector<std::vector<std::string>> parse_fields(const std::string& csv, char separator = ',') {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> row(1);
  bool quoted = false;
  for (const char c : csv) {
    if (c == '"') {
      // The second of two quotes inside a quoted field reopens it and is a quote.
      if (!quoted && !row.back().empty()) row.back() += c;
      quoted = !quoted;
    } else if (c == separator && !quoted) {
      row.emplace_back();
    } else if (c == '\n' && !quoted) {
      rows.push_back(std::exchange(row, std::vector<std::string>(1)));
    } else {
      row.back() += c;
    }
  }
  return rows;
}

/// Rows by the names in the header; every row has as many fields.
inline std::vector<CsvRow> parse(const std::string& csv) {
  const auto fields = parse_fields(csv);
  std::vector<CsvRow> rows;
  for (std::size_t r = 1; r < fields.size(); ++r) {
    EXPECT_EQ(fields[r].size(), fields[0].size());
    CsvRow& row = rows.emplace_back();
    for (std::size_t c = 0; c < fields[0].size(); ++c) row[fields[0][c]] = fields[r][c];
  }
  return rows;
}

}  // namespace test
