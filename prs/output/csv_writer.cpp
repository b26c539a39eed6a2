#include "prs/output/csv_writer.h"

#include <fmt/format.h>

#include <cmath>

#include "prs/output/units.h"

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
  text(si && std::isfinite(*si) ? fmt::to_string(*si * factor) : std::string());
}

void CsvWriter::integer(std::optional<std::size_t> value) {
  text(value ? fmt::to_string(*value) : std::string());
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
