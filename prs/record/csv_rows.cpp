#include "prs/record/csv_rows.h"

#include <fmt/format.h>

#include <stdexcept>

namespace prs {

void CsvRows::name(std::string_view field) {
  if (is_first_)
    names_.emplace_back(field);
  else if (column_ == names_.size() || names_[column_] != field)
    throw std::logic_error(fmt::format("field {} of a row of a CSV file is not that of its first row", field));
  ++column_;
}

void CsvRows::name(std::string_view prefix, std::string_view key) {
  const std::string_view unit = unit_of(prefix).suffix;
  prefix.remove_suffix(unit.size());
  name(fmt::format("{}{}{}{}", prefix, unit.empty() ? "" : "_", key, unit));
}

void CsvRows::load_case(const LoadCase& load) {
  (*this)("case", load.name);
  (*this)("axial_force_N", load.axial_force);
  (*this)("direction", load.direction ? prs::name(*load.direction) : "");
  (*this)("position_mm", load.position);
}

void CsvRows::end_row() {
  if (column_ != names_.size())
    throw std::logic_error(fmt::format("a row of a CSV file lacks field {} of its first row", names_[column_]));
  if (is_first_) head_.row(names_);
  is_first_ = false;
  column_ = 0;
  rows_.end_row();
}

}  // namespace prs
