#include "prs/study/response.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "prs/record/record.h"

#include "prs/life/life_analysis.h"
#include "prs/loads/load_analysis.h"
#include "prs/losses/slip_analysis.h"
#include "prs/losses/solve_analysis.h"
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

/// The path begins with `.KEY` or `[k]`.
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
  const std::string below = "." + std::string(path);
  if (const Json* load_case = first_load_case(document))
    if (const std::optional<double> value = number_at(*load_case, below)) return value;
  return number_at(document, below);
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
