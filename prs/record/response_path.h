#pragma once

#include "prs/record/record.h"

namespace prs {

/// Unit of a response for people: `um` of `axial_displacement_um`.
std::string unit_of_response(std::string_view path);

/// Whether it is an array of numbers, or of rows of numbers.
bool is_series(const Json& json);

/// The number at a path that begins with `.KEY` or `[k]`; in an array at `[k]`, `.max`, `.min`, `.mean`.
std::optional<double> number_at(const Json& json, std::string_view path);

/// Value under keys with dots between them; null if there is none.
const Json* value_at(const Json& json, std::string_view path);

/// Paths of the numbers and of the series of a record.
struct ResponsePaths {
  std::vector<std::string> numbers, series;
};
void add_paths(const RecordInfo& record, const std::string& before, ResponsePaths& paths);

}  // namespace prs
