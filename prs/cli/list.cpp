#include "prs/cli/list.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "prs/output/lists.h"
#include "prs/quantities/json.h"
#include "prs/text.h"

namespace prs::cli {
namespace {

struct Item {
  std::string name, meaning;
};

/// The commands that take a case; with a file, those that have all they need in it.
std::vector<Item> command_items(const Options& options) {
  std::optional<input::CaseInput> in;
  if (!options.file.empty()) in = input::read_case_input(case_source(options), Command::check);
  std::vector<Item> items;
  for (const CommandRow& row : commands())
    if (!in || input::missing(*in, row.command).empty())
      items.push_back({std::string(name(row.command)), std::string(row.help)});
  return items;
}

struct List {
  const char* word;
  std::vector<Item> (*items)(const Options&);
  bool names_only;  ///< On a terminal: one word per line, for scripts.
  // In place of the items, a table of its own.
  std::string (*table)() = nullptr;
  nlohmann::ordered_json (*json)() = nullptr;
};

constexpr List kLists[] = {{"commands", command_items, true},
                           {"lubricants", nullptr, false, lubricants_table, lubricants_json}};

std::string list_text(const List& list, const std::vector<Item>& items) {
  std::size_t longest = 0;
  for (const Item& item : items) longest = std::max(longest, width(item.name));
  std::string lines;
  for (const Item& item : items)
    lines += list.names_only ? item.name + "\n"
                             : fmt::format("{:<{}}  {}\n", item.name, longest, item.meaning);
  return lines;
}

}  // namespace

std::vector<std::string> list_words() {
  std::vector<std::string> words;
  for (const List& list : kLists) words.emplace_back(list.word);
  return words;
}

int list(const Options& options) {
  const List& list = *std::ranges::find(kLists, std::string_view(options.what),
                                        [](const List& l) { return std::string_view(l.word); });
  if (list.table != nullptr) {
    print(options.json ? json_text(list.json()) : list.table());
    return kDone;
  }
  const std::vector<Item> items = list.items(options);
  if (!options.json) {
    print(list_text(list, items));
    return kDone;
  }
  nlohmann::ordered_json entries = nlohmann::ordered_json::array();
  for (const auto& [name, meaning] : items)
    entries.push_back({{"name", name}, {"meaning", meaning}});
  print(json_text({{list.word, entries}}));
  return kDone;
}

}  // namespace prs::cli
