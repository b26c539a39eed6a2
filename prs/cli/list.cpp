#include "prs/cli/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "prs/cli/lessons.h"
#include "prs/cli/usage_error.h"
#include "prs/input/schema.h"
#include "prs/input/source.h"
#include "prs/loads/case_table.h"
#include "prs/loads/load_json.h"
#include "prs/run/lists.h"
#include "prs/run/responses.h"
#include "prs/text.h"

namespace prs::cli {
namespace {

struct Item {
  std::string name, meaning;
};

/// The commands that take a case; with a file, those that have all they need in it.
std::vector<Item> command_items(const Options& options) {
  std::optional<input::CaseInput> in;
  std::vector<Item> items;
  const auto add = [&](const auto& row) {
    items.push_back({std::string(name(row.command)), std::string(row.help)});
  };
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
    if (!in || input::missing(*in, row.command).empty()) add(row);
  return items;
}

using Json = nlohmann::ordered_json;

/// What `--set` takes.
std::vector<Item> input_items() {
  std::vector<Item> items;
  for (const input::InputKey& key : input::input_keys()) items.push_back({key.path, key.meaning});
  return items;
}

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
  for (const auto& [name, meaning] : items)
    lines += hanging(name, at, meaning.empty() ? " " : meaning);
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

std::vector<Item> lesson_items() {
  std::vector<Item> items;
  for (const Lesson& lesson : lessons()) items.push_back({lesson.name, lesson.title});
  return items;
}

/// Something to choose from: lines that begin with its names, and the same as a document.
struct List {
  const char* word;
  const char* meaning;
  std::string (*text)(const Options&);
  Json (*json)(const Options&);
  bool takes_file = false;
};

constexpr List kLists[] = {
    {"commands", "those that take a case; with FILE, those for which it is complete",
     [](const Options& o) { return names(command_items(o)); },
     [](const Options& o) {
       return Json{{"commands", entries(command_items(o))}};
     },
     true},
    {"inputs", "keys of a case, as `--set` takes them",
     [](const Options&) { return columns(input_items()); },
     [](const Options&) {
       return Json{{"inputs", entries(input_items())}};
     }},
    {"lubricants", "known by name", [](const Options&) { return lubricants_table(); },
     [](const Options&) { return lubricants_json(); }},
    {"units", "of the input", [](const Options&) { return units_table(); },
     [](const Options&) { return units_json(); }},
    {"responses", "what a study may record; with FILE, what its results have",
     [](const Options& o) { return responses_table(responses(o)); },
     [](const Options& o) { return responses_json(responses(o)); }, true},
    {"lessons", "that `prs new --lesson` copies",
     [](const Options&) { return columns(lesson_items()); },
     [](const Options&) {
       return Json{{"lessons", entries(lesson_items())}};
     }},
};

}  // namespace

std::vector<std::string> list_words() {
  std::vector<std::string> words;
  for (const List& list : kLists) words.emplace_back(list.word);
  return words;
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
    throw UsageError(fmt::format("got {}; expected no further word", input::shown(options.file)));
  print(options.json ? json_text(list.json(options)) : list.text(options));
  return kDone;
}

}  // namespace prs::cli
