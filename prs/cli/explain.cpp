#include "prs/cli/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "prs/cli/printing.h"
#include "prs/cli/usage_error.h"
#include "prs/input/did_you_mean.h"
#include "prs/input/source.h"
#include "prs/loads/load_json.h"
#include "prs/measures/measures_analysis.h"
#include "prs/run/results_schema.h"
#include "prs/text.h"

namespace prs::cli {
namespace {

using Json = nlohmann::ordered_json;

/// A quantity where it stands in a document.
struct Place {
  std::string path;  ///< `load_cases[].screw.axial_load_N`.
  Json quantity;
};

void add_places(const Json& records, const std::string& record, const std::string& path,
                std::vector<Place>& places) {
  for (const Json& quantity : records[record]["quantities"]) {
    const std::string own = path + "." + quantity["key"].get<std::string>();
    places.push_back({own, quantity});
    if (quantity.contains("record"))
      add_places(records, quantity["record"], own + (quantity["kind"] == "records" ? "[]" : ""),
                 places);
  }
}

std::vector<Place> all_places() {
  const Json schema = results_schema();
  std::vector<Place> places;
  for (const Json& document : schema["documents"])
    add_places(schema["records"], document["record"], document["path"], places);
  return places;
}

/// Without what stands in brackets.
std::string plain_path(std::string_view path) {
  std::string plain;
  bool inside = false;
  for (const char c : path) {
    inside = c == '[' || (inside && c != ']');
    if (!inside && c != ']') plain += c;
  }
  return plain;
}

std::vector<Place> places_of(const std::vector<Place>& all, const std::string& name) {
  std::vector<Place> found;
  std::ranges::copy_if(all, std::back_inserter(found), [&](const Place& place) {
    const std::string path = "." + plain_path(place.path);
    return path.ends_with("." + plain_path(name));
  });
  return found;
}

[[noreturn]] void refuse(const std::string& name, const std::vector<Place>& all) {
  std::vector<std::string> known;
  for (const Place& place : all) {
    known.push_back(place.quantity["key"]);
    known.push_back(plain_path(place.path));
  }
  const std::string hint = input::did_you_mean(plain_path(name), {known.begin(), known.end()});
  throw UsageError(fmt::format("--explain: got {}; expected a measure or the path of a result; {}",
                               input::shown(name),
                               hint.empty() ? "`prs schema results` lists them" : hint));
}

std::string text_of(const Json& quantity) {
  std::string text;
  for (const auto& [key, before] :
       {std::pair{"title", ""}, std::pair{"unit", "unit: "}, std::pair{"meaning", "meaning: "},
        std::pair{"validity", "valid: "}, std::pair{"source", "source: "}})
    if (const std::string said = quantity.value(key, ""); !said.empty())
      text += wrapped(before + said, "  ", 100);
  return text;
}

}  // namespace

int explain(const Options& options) {
  // A single word after `--explain` goes to FILE, which the parser wants most.
  std::string name = options.explain->empty() ? options.file : *options.explain;
  if (std::filesystem::is_regular_file(name)) name.clear();  // The case, which it needs not.
  if (name.empty()) {
    print(options.json ? json_text(measure_explanations_json()) : measure_explanations());
    return kDone;
  }
  const std::vector<Place> all = all_places();
  std::vector<Place> found = places_of(all, name);
  // `peak_pressure_MPa.max` of a study is that of `peak_pressure_MPa`.
  if (found.empty()) found = places_of(all, name.substr(0, name.rfind('.')));
  if (found.empty()) refuse(name, all);
  Json document = Json::array();
  std::string text;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const Json& quantity = found[k].quantity;
    Json entry{{"path", found[k].path}};
    entry.update(quantity);
    document.push_back(std::move(entry));
    text += found[k].path + "\n";
    // What stands in several places is explained once.
    if (k + 1 == found.size() || found[k + 1].quantity != quantity) text += text_of(quantity);
  }
  print(options.json ? json_text({{"explanations", document}}) : text);
  return kDone;
}

}  // namespace prs::cli
