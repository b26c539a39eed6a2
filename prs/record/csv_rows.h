#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "prs/model/load_case.h"
#include "prs/record/record_table.h"

namespace prs {

/// CSV file that names its fields where it writes them: the names of the first row are the header, and a later row with
/// other names throws std::logic_error. It takes numbers in SI and writes them in the units of their names.
class CsvRows {
 public:
  explicit CsvRows(const CsvStyle& style) : head_(style), rows_(style, CsvWriter::Part::rows) {}

  template <class T>
  void operator()(std::string_view name, const T& value) {
    names_.emplace_back(name);
    rows_.field(value, unit_of(name).factor);
  }

  /// Writes the numbers, counts, flags and texts of a record, of an optional one or of a pointer to one, `from` one key
  /// up to another; empty fields if there is no record. The unit of a prefix stays at the end: `temperature_degC` and
  /// `screw` make `temperature_screw_degC`.
  template <class T>
  void record(std::string_view prefix, const T& value, std::string_view from = {}, std::string_view until = {}) {
    const auto* owner = detail::pointer_to(value);
    bool is_in = from.empty();
    for (const auto& q : record_of<detail::Held<T>>().quantities) {
      if (!until.empty() && q.key == until) break;
      is_in = is_in || q.key == from;
      if (!is_in ||
          (!q.value.number && q.value.kind != Kind::count && q.value.kind != Kind::flag && q.value.kind != Kind::text))
        continue;
      name(prefix, q.key);
      if (q.value.number) {
        rows_.number(owner ? q.value.number(*owner) : std::nullopt, q.unit.factor);
      } else {
        const auto json = owner ? q.value.json(*owner, q.unit) : Json();
        rows_.text(json.is_null() ? std::string() : json.is_string() ? json.template get<std::string>() : json.dump());
      }
    }
  }

  /// Writes entry `k` of each series of a record, likewise.
  template <class T>
  void series(std::string_view prefix, const T& value, std::size_t k) {
    const auto* owner = detail::pointer_to(value);
    for (const auto& q : record_of<detail::Held<T>>().quantities) {
      if (!q.value.series) continue;
      name(prefix, q.key);
      const std::span<const double> values = owner ? q.value.series(*owner) : std::span<const double>();
      rows_.number(k < values.size() ? std::optional(values[k]) : std::nullopt, q.unit.factor);
    }
  }

  /// Writes the fields that identify a load case.
  void load_case(const LoadCase& load);

  void end_row();
  /// Removes the rows but keeps their names: the header of a file that may have no rows.
  void drop_rows() { rows_.take(); }
  std::string take() { return head_.take() + rows_.take(); }

 private:
  void name(std::string_view prefix, std::string_view key);

  CsvWriter head_, rows_;
  std::vector<std::string> names_, first_names_;  ///< Names of the fields of this row and of the first one.
};

}  // namespace prs
