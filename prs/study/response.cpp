#include "prs/study/response.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <numeric>

#include "prs/life/life_analysis.h"
#include "prs/loads/load_analysis.h"
#include "prs/losses/slip_analysis.h"
#include "prs/measures/measures_analysis.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

/// Numbers, or rows of numbers.
bool is_series(const Json& json) {
  return json.is_array() && !json.empty() && std::ranges::all_of(json, [](const Json& entry) {
           return entry.is_number() || is_series(entry);
         });
}

void collect(const Json& series, std::vector<double>& values) {
  for (const Json& entry : series)
    if (entry.is_array())
      collect(entry, values);
    else
      values.push_back(entry.get<double>());
}

std::optional<double> summary(const Json& series, std::string_view word) {
  if (!is_series(series)) return std::nullopt;
  std::vector<double> values;
  collect(series, values);
  if (word == "max") return std::ranges::max(values);
  if (word == "min") return std::ranges::min(values);
  if (word == "mean")
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  return std::nullopt;
}

/// Takes `KEY` or `[k]` from the head of a path and follows it; null where it leads nowhere.
const Json* follow(const Json& json, std::string_view& path) {
  if (path.starts_with('[')) {
    std::size_t index = 0;
    const char* end = path.data() + path.size();
    const auto [stop, error] = std::from_chars(path.data() + 1, end, index);
    if (error != std::errc{} || stop == end || *stop != ']') return nullptr;
    path.remove_prefix(static_cast<std::size_t>(stop + 1 - path.data()));
    return json.is_array() && index < json.size() ? &json[index] : nullptr;
  }
  const std::size_t length = std::min(path.find_first_of(".["), path.size());
  const auto found = json.is_object() ? json.find(std::string(path.substr(0, length))) : json.end();
  path.remove_prefix(length);
  return found == json.end() ? nullptr : &*found;
}

std::optional<double> number_at(const Json& root, std::string_view path) {
  const Json* json = &root;
  while (!path.empty()) {
    if (json != &root && path.starts_with('.')) path.remove_prefix(1);
    if (const std::optional<double> value = summary(*json, path)) return value;
    json = follow(*json, path);
    if (!json) return std::nullopt;
  }
  return json->is_number() ? std::optional(json->get<double>()) : std::nullopt;
}

const Json* first_load_case(const Json& document) {
  const auto cases = document.is_object() ? document.find("load_cases") : document.end();
  if (cases == document.end() || !cases->is_array() || cases->empty()) return nullptr;
  return &(*cases)[0];
}

void list_paths(const Json& json, const std::string& path, std::vector<std::string>& paths) {
  if (json.is_number()) paths.push_back(path);
  if (is_series(json)) paths.push_back(path + ".max");
  if (!json.is_object()) return;
  for (const auto& [key, value] : json.items())
    list_paths(value, path.empty() ? key : path + "." + key, paths);
}

}  // namespace

std::optional<double> response(const Json& document, std::string_view path) {
  if (const Json* load_case = first_load_case(document))
    if (const std::optional<double> value = number_at(*load_case, path)) return value;
  return number_at(document, path);
}

std::vector<std::string> response_paths(const Json& document) {
  std::vector<std::string> paths;
  if (const Json* load_case = first_load_case(document)) list_paths(*load_case, "", paths);
  list_paths(document, "", paths);
  return paths;
}

std::vector<std::string> default_responses(Command command) {
  for (const AnyAnalysis& analysis :
       {any(contact_analysis()), any(solve_analysis()), any(slip_analysis()), any(life_analysis()),
        any(measures_analysis())})
    if (analysis.command == command) return {analysis.responses.begin(), analysis.responses.end()};
  return {};
}

}  // namespace prs
