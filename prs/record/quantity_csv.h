#pragma once

#include <nlohmann/json.hpp>

#include "prs/record/csv_writer.h"
#include "prs/record/record.h"

namespace prs {

/// Whether it has a column: numbers, counts, flags and texts do.
template <class Owner>
bool is_scalar(const Quantity<Owner>& q) {
  return q.value.number || q.value.kind == Kind::count || q.value.kind == Kind::flag ||
         q.value.kind == Kind::text;
}

/// Those from a key on.
template <class Owner>
std::span<const Quantity<Owner>> rows_from(std::string_view key) {
  const auto all = record_of<Owner>().quantities;
  return key.empty() ? all : std::span(&quantity<Owner>(key), all.data() + all.size());
}

/// Names of the columns of a record, from the quantity `from` on.
template <class Owner>
void scalar_header(CsvWriter& csv, std::string_view prefix = {}, std::string_view from = {}) {
  for (const Quantity<Owner>& q : rows_from<Owner>(from))
    if (is_scalar(q)) csv.text(std::string(prefix).append(q.key));
}

/// Its fields, empty where there is no such record.
template <class Owner>
void scalar_fields(CsvWriter& csv, const std::type_identity_t<Owner>* owner,
                   std::string_view from = {}) {
  for (const Quantity<Owner>& q : rows_from<Owner>(from)) {
    if (!is_scalar(q)) continue;
    if (q.value.number) {
      csv.number(owner ? q.value.number(*owner) : std::nullopt, q.unit.factor);
      continue;
    }
    const auto json = owner ? q.value.json(*owner, q.unit) : Json();
    csv.text(json.is_null()     ? std::string()
             : json.is_string() ? json.template get<std::string>()
                                : json.dump());
  }
}

template <class Owner>
void series_header(CsvWriter& csv, std::string_view prefix = {}) {
  for (const Quantity<Owner>& q : record_of<Owner>().quantities)
    if (q.value.series) csv.text(std::string(prefix).append(q.key));
}

/// The numbers of one thread.
template <class Owner>
void series_fields(CsvWriter& csv, const Owner& owner, std::size_t thread) {
  for (const Quantity<Owner>& q : record_of<Owner>().quantities) {
    if (!q.value.series) continue;
    const std::span<const double> values = q.value.series(owner);
    csv.number(thread < values.size() ? std::optional(values[thread]) : std::nullopt,
               q.unit.factor);
  }
}

}  // namespace prs
