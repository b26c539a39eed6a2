#include "prs/record/csv_rows.h"

#include <fmt/format.h>

namespace prs {

void CsvRows::name(std::string_view prefix, std::string_view key) {
  if (!is_first_) return;
  const std::string_view unit = unit_of(prefix).suffix;
  prefix.remove_suffix(unit.size());
  head_.text(fmt::format("{}{}{}{}", prefix, unit.empty() ? "" : "_", key, unit));
}

void CsvRows::load_case(const LoadCase& load) {
  (*this)("case", load.name);
  (*this)("axial_force_N", load.axial_force);
  (*this)("direction", load.direction ? prs::name(*load.direction) : "");
  (*this)("position_mm", load.position);
}

void CsvRows::end_row() {
  if (is_first_) head_.end_row();
  is_first_ = false;
  rows_.end_row();
}

}  // namespace prs
