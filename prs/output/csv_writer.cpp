#include "prs/output/csv_writer.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "prs/document/units.h"

namespace prs {

void CsvWriter::text(std::string_view value) {
  separate();
  if (value.find_first_of(",\"\r\n") == std::string_view::npos) {
    csv_ += value;
    return;
  }
  csv_ += '"';
  for (const char c : value) csv_ += c == '"' ? std::string("\"\"") : std::string(1, c);
  csv_ += '"';
}

void CsvWriter::number(std::optional<double> si, double factor) {
  separate();
  if (!si || !std::isfinite(*si)) return;
  std::array<char, 32> digits;  // A shortest double has 24 at most.
  csv_.append(digits.data(), fmt::format_to(digits.data(), "{}", *si * factor));
}

void CsvWriter::integer(std::optional<std::size_t> value) {
  separate();
  if (value) csv_ += fmt::format_int(*value).c_str();
}

void CsvWriter::end_row() {
  csv_ += '\n';
  row_is_empty_ = true;
}

void CsvWriter::separate() {
  if (!row_is_empty_) csv_ += ',';
  row_is_empty_ = false;
}

void load_header(CsvWriter& csv) {
  for (const char* key : {"case", "axial_force_N", "direction", "position_mm"}) csv.text(key);
}

void load_fields(CsvWriter& csv, const LoadCase& load) {
  csv.text(load.name);
  csv.number(load.axial_force);
  csv.text(load.direction ? name(*load.direction) : "");
  csv.number(load.position, per_si::millimetre);
}

}  // namespace prs
