#include "prs/cli/list.h"

#include "prs/cli/command_line.h"
#include "prs/cli/package.h"
#include "prs/input/did_you_mean.h"
#include "prs/input/schema.h"
#include "prs/loads/case_table.h"
#include "prs/loads/load_analysis.h"
#include "prs/measures/measures_analysis.h"
#include "prs/record/table_layout.h"
#include "prs/run/analyses.h"
#include "prs/run/document_schema.h"
#include "prs/run/response_lists.h"
#include "prs/size/requirement.h"
#include "prs/text.h"

namespace prs::cli {
namespace {

struct Item {
  std::string name, meaning;
};

/// Commands that take a case; with a file, those for which it has all inputs.
std::vector<Item> command_items(const Options& options) {
  std::optional<input::CaseInput> in;
  std::vector<Item> items;
  const auto add = [&](const auto& row) { items.push_back({std::string(name(row.command)), std::string(row.help)}); };
  if (!options.file.empty()) {
    const input::Source source = case_source(options);
    if (const OtherFile* file = other_file(source)) {
      add(analysis_of(Command::check));
      add(*file);
      return items;
    }
    in = input::read_case_input(source, Command::check);
  }
  for (const AnyAnalysis& row : analyses())
    if (!in || (row.is_built && input::missing(*in, row.command).empty())) add(row);
  return items;
}

/// Paths for `--set`.
std::vector<Item> key_items(const std::vector<input::InputKey>& keys) {
  return each(keys, [](auto& key) { return Item{key.path, key.meaning}; });
}
std::vector<Item> input_items(const Options&) { return key_items(input::input_keys()); }
std::vector<Item> requirement_items(const Options&) { return key_items(input::input_keys(requirement_schema())); }

std::string names(const std::vector<Item>& items) {
  std::string lines;
  for (const Item& item : items) lines += item.name + "\n";
  return lines;
}

std::string columns(const std::vector<Item>& items) {
  std::size_t longest = 0;
  for (const Item& item : items) longest = std::max(longest, width(item.name));
  std::string lines;
  const std::size_t at = longest + 2;
  for (const auto& [name, meaning] : items) lines += hanging(name, at, meaning.empty() ? " " : meaning);
  return lines;
}

Json entries(const std::vector<Item>& items) {
  Json json = Json::array();
  for (const auto& [name, meaning] : items) json.push_back({{"name", name}, {"meaning", meaning}});
  return json;
}

std::vector<std::string> responses(const Options& options) {
  return options.file.empty() ? known_responses() : responses_of(case_source(options));
}

std::vector<Item> lesson_items(const Options&) {
  return each(lessons(), [](const Lesson& lesson) { return Item{lesson.name, lesson.title}; });
}

/// A list of choices: items, or a table with names at the start of its lines and a document.
struct List {
  const char* word;
  const char* meaning;
  bool takes_file = false;
  std::vector<Item> (*items)(const Options&) = nullptr;
  std::string (*table)(const Options&) = nullptr;
  Json (*document)(const Options&) = nullptr;
};

constexpr List kLists[] = {
    {"commands", "those that take a case; with FILE, those for which it is complete", true, command_items,
     [](const Options& o) { return names(command_items(o)); }},
    {"inputs", "keys of a case, as `--set` takes them", false, input_items},
    {"requirement", "keys of a requirement of `prs size`", false, requirement_items},
    {"lubricants", "known by name", false, nullptr, [](const Options&) { return lubricants_table(); },
     [](const Options&) { return lubricants_json(); }},
    {"units", "of the input", false, nullptr, [](const Options&) { return units_table(); },
     [](const Options&) { return units_json(); }},
    {"responses", "what a study may record; with FILE, what its results have", true, nullptr,
     [](const Options& o) { return responses_table(responses(o)); },
     [](const Options& o) { return responses_json(responses(o)); }},
    {"lessons", "that `prs new --lesson` copies", false, lesson_items},
};

}  // namespace

std::vector<std::string> list_words() {
  return each(kLists, [](const List& list) { return std::string(list.word); });
}

std::string list_help() {
  std::string text = "What to list.";
  for (const List& list : kLists) text += fmt::format(" {}: {}.", list.word, list.meaning);
  return text;
}

int list(const Options& options) {
  const List& list = *std::ranges::find(kLists, std::string_view(options.what),
                                        [](const List& l) { return std::string_view(l.word); });
  if (!options.file.empty() && !list.takes_file)
    throw UsageError("got {}; expected no further word", input::shown(options.file));
  if (options.json)
    print(json_text(list.items ? Json{{list.word, entries(list.items(options))}} : list.document(options)));
  else
    print(list.table ? list.table(options) : columns(list.items(options)));
  return kDone;
}

namespace {

/// A quantity and its place in a document.
struct Place {
  std::string path;  ///< `load_cases[].screw.axial_load_N`.
  Json quantity;
};

void add_places(const Json& records, const std::string& record, const std::string& path, std::vector<Place>& places) {
  for (const Json& quantity : records[record]["quantities"]) {
    const std::string own = path + "." + quantity["key"].get<std::string>();
    places.push_back({own, quantity});
    if (quantity.contains("record"))
      add_places(records, quantity["record"], own + (quantity["kind"] == "records" ? "[]" : ""), places);
  }
}

std::vector<Place> all_places() {
  const Json schema = results_schema();
  std::vector<Place> places;
  for (const Json& document : schema["documents"])
    add_places(schema["records"], document["record"], document["path"], places);
  return places;
}

std::vector<Place> places_of(const std::vector<Place>& all, const std::string& name) {
  std::vector<Place> found;
  std::ranges::copy_if(all, std::back_inserter(found), [&](const Place& place) {
    const std::string path = "." + input::without_places(place.path);
    return path.ends_with("." + input::without_places(name));
  });
  return found;
}

[[noreturn]] void refuse(const std::string& name, const std::vector<Place>& all) {
  std::vector<std::string> known;
  for (const Place& place : all) {
    known.push_back(place.quantity["key"]);
    known.push_back(input::without_places(place.path));
  }
  const std::string hint = input::did_you_mean(input::without_places(name), {known.begin(), known.end()});
  throw UsageError("--explain: got {}; expected a measure or the path of a result; {}", input::shown(name),
                   hint.empty() ? "`prs schema results` lists them" : hint);
}

std::string text_of_quantity(const Json& quantity) {
  std::string text;
  for (const auto& [key, before] :
       {std::pair{"title", ""}, std::pair{"unit", "unit: "}, std::pair{"meaning", "meaning: "},
        std::pair{"validity", "valid: "}, std::pair{"source", "source: "}})
    if (const std::string said = quantity.value(key, ""); !said.empty()) text += wrapped(before + said, "  ", 100);
  return text;
}

}  // namespace

int explain(const Options& options) {
  // A single word after `--explain` becomes FILE, which the parser fills first.
  std::string name = options.explain->empty() ? options.file : *options.explain;
  if (std::error_code error; std::filesystem::is_regular_file(name, error))
    name.clear();  // The case, which is not needed.
  if (name.empty()) {
    print(options.json ? json_text(measure_explanations_json()) : measure_explanations());
    return kDone;
  }
  const std::vector<Place> all = all_places();
  std::vector<Place> found = places_of(all, name);
  // A path of a study such as `peak_pressure_MPa.max` is explained by `peak_pressure_MPa`.
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
    // A quantity in several places is explained once.
    if (k + 1 == found.size() || found[k + 1].quantity != quantity) text += text_of_quantity(quantity);
  }
  print(options.json ? json_text({{"explanations", document}}) : text);
  return kDone;
}

}  // namespace prs::cli
