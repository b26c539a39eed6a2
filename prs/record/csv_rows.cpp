#include "prs/record/csv_rows.h"

#include <fmt/ranges.h>

#include <stdexcept>

namespace prs {

void CsvRows::name(std::string_view prefix, std::string_view key) {
  const std::string_view unit = unit_of(prefix).suffix;
  prefix.remove_suffix(unit.size());
  names_.push_back(fmt::format("{}{}{}{}", prefix, unit.empty() ? "" : "_", key, unit));
}

void CsvRows::load_case(const LoadCase& load) {
  (*this)("case", load.name);
  (*this)("axial_force_N", load.axial_force);
  (*this)("direction", load.direction ? prs::name(*load.direction) : "");
  (*this)("position_mm", load.position);
}

void CsvRows::end_row() {
  if (first_names_.empty())
    head_.row(first_names_ = names_);
  else if (names_ != first_names_)
    throw std::logic_error(fmt::format("a row of a CSV file has the fields {}, its first one {}",
                                       fmt::join(names_, ", "), fmt::join(first_names_, ", ")));
  names_.clear();
  rows_.end_row();
}

}  // namespace prs
