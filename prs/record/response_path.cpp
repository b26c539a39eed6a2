#include "prs/record/response_path.h"

#include <fmt/format.h>

#include <algorithm>

#include "prs/input/units.h"

namespace prs {
namespace {

void collect(const Json& series, std::vector<double>& values) {
  for (const Json& entry : series)
    if (entry.is_array())
      collect(entry, values);
    else
      values.push_back(entry.get<double>());
}

}  // namespace

std::string unit_of_response(std::string_view path) {
  const std::string_view unit = unit_at(path).text;
  for (const input::Dimension* d : input::dimensions())
    if (const input::Unit* u = unit.empty() ? nullptr : input::find_unit(unit, *d)) return std::string(u->spellings[0]);
  return std::string(unit);
}

bool is_series(const Json& json) {
  return json.is_array() && !json.empty() &&
         std::ranges::all_of(json, [](const Json& entry) { return entry.is_number() || is_series(entry); });
}

std::optional<double> number_at(const Json& json, std::string_view path) {
  if (path.empty()) return json.is_number() ? std::optional(json.get<double>()) : std::nullopt;
  if (path.starts_with('[')) {
    const std::optional<std::size_t> index = take_index(path);
    const bool there = index && json.is_array() && *index < json.size();
    return there ? number_at(json[*index], path) : std::nullopt;
  }
  if (const SeriesReader summary = summary_named(path, 1.0); summary && is_series(json)) {
    std::vector<double> values;
    collect(json, values);
    return summary(values);
  }
  if (!path.starts_with('.') || !json.is_object()) return std::nullopt;
  path.remove_prefix(1);
  const std::size_t length = std::min(path.find_first_of(".["), path.size());
  const auto found = json.find(std::string(path.substr(0, length)));
  return found == json.end() ? std::nullopt : number_at(*found, path.substr(length));
}

const Json* value_at(const Json& json, std::string_view path) {
  const std::size_t dot = std::min(path.find('.'), path.size());
  const auto found = json.is_object() ? json.find(std::string(path.substr(0, dot))) : json.end();
  if (found == json.end()) return nullptr;
  return dot == path.size() ? &*found : value_at(*found, path.substr(dot + 1));
}

void add_paths(const RecordInfo& record, const std::string& before, ResponsePaths& paths) {
  for (const QuantityInfo& q : record.quantities) {
    const std::string path =
        q.key.empty() || before.empty() ? before + std::string(q.key) : fmt::format("{}.{}", before, q.key);
    if (q.form.by_key || q.delivery == Reach::document) continue;
    if (q.kind == Kind::number) paths.numbers.push_back(path);
    if (q.kind == Kind::series || q.kind == Kind::matrix) paths.series.push_back(path);
    if (q.kind == Kind::record) add_paths(q.record(), path, paths);
  }
}

}  // namespace prs
