#include "prs/run/response_lists.h"

#include "prs/indices.h"

#include "prs/record/table_layout.h"
#include "prs/run/analyses.h"
#include "prs/study/response.h"
#include "prs/text.h"

namespace prs {

std::string responses_table(const std::vector<std::string>& paths) {
  std::size_t widest = 0;
  for (const std::string& path : paths) widest = std::max(widest, width(path));
  std::string text = padded("path", widest, true) + "  unit         title\n";
  for (const std::string& path : paths) {
    const ResponseTitle title = response_title(path);
    text += padded(path, widest, true) + "  " + padded(std::string(title.unit), 11, true) + "  " + title.name + '\n';
  }
  return text +
         "\nOf numbers thread by thread also `.min`, `.mean` and `[k]`, k from 0; studies record all of them without "
         "`.max`.\n";
}

Json responses_json(const std::vector<std::string>& paths) {
  Json json{{"responses", Json::array()}};
  for (const std::string& path : paths) {
    const ResponseTitle title = response_title(path);
    json["responses"].push_back({{"path", path}, {"unit", title.unit}, {"title", title.name}});
  }
  return json;
}

namespace {

/// Path of the load cases; a response without it is that of the first.
constexpr std::string_view kLoadCases = "load_cases[].";

void add_numbers(const RecordInfo& record, const std::string& before, std::vector<std::string>& paths) {
  for (const QuantityInfo& q : record.quantities) {
    const std::string path = before + std::string(q.key);
    if (q.kind == Kind::number || q.kind == Kind::count) paths.push_back(path);
    if (q.kind == Kind::series) paths.push_back(path + ".max");
    if (q.kind == Kind::record) add_numbers(q.record(), path + ".", paths);
  }
}

}  // namespace

std::vector<std::string> known_responses() {
  std::vector<std::string> of_load_cases, others;
  std::set<std::string_view> known;
  for (const AnyAnalysis& analysis : analyses()) {
    if (analysis.responses.empty()) continue;
    for (const Place& place : analysis.places) {
      if (place.path == "model" || !known.insert(place.path).second) continue;
      const std::string before = std::string(place.path) + '.';
      if (before.starts_with(kLoadCases))
        add_numbers(place.record(), before.substr(kLoadCases.size()), of_load_cases);
      else
        add_numbers(place.record(), before, others);
    }
  }
  append(of_load_cases, others);
  return of_load_cases;
}

std::vector<std::string> responses_of(const input::Source& source) {
  const input::CaseInput in = input::read_case_input(source, Command::check);
  std::vector<std::string> paths;
  for (const AnyAnalysis& analysis : analyses()) {
    const Command command = analysis.command;
    if (analysis.responses.empty()) continue;
    if (in.study ? *in.study != command : !input::missing(in, command).empty()) continue;
    const Json document = run(analysis, source).document({});
    for (std::string& path : response_paths(document))
      if (!contains(paths, path)) paths.push_back(std::move(path));
  }
  return paths;
}

}  // namespace prs
