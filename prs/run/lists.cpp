#include "prs/run/lists.h"

#include "prs/loads/case_table.h"
#include "prs/run/commands.h"
#include "prs/study/response.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr std::size_t kUnitsAt = 60;

}  // namespace

std::string lubricants_table() {
  std::string text = fmt::format("{:<16}{:>12}{:>12}{:>12}\n{:<16}{:>12}{:>12}{:>12}\n", "name", "nu at 40",
                                 "nu at 100", "density", "", "mm^2/s", "mm^2/s", "kg/m^3");
  std::vector<std::string_view> sources;
  for (const NamedLubricant& l : named_lubricants()) {
    auto source = std::ranges::find(sources, l.source);
    if (source == sources.end()) source = sources.insert(source, l.source);
    text += fmt::format("{:<16}{:>12.6g}{:>12.6g}{:>12.6g}   {} [{}]\n", l.name, 1e6 * l.viscosity_40,
                        1e6 * l.viscosity_100, l.density, l.what, source - sources.begin() + 1);
  }
  text +=
      "\nKinematic viscosity nu of the oil, or of the base oil of the grease, which is all that "
      "counts:\nits thickener is not modelled.\n";
  for (std::size_t i = 0; i < sources.size(); ++i) text += fmt::format("[{}] {}\n", i + 1, sources[i]);
  return text;
}

Json lubricants_json() {
  Json json;
  for (const NamedLubricant& l : named_lubricants())
    json["lubricants"].push_back({{"name", l.name},
                                  {"description", l.what},
                                  {"viscosity_40_mm2_per_s", 1e6 * l.viscosity_40},
                                  {"viscosity_100_mm2_per_s", 1e6 * l.viscosity_100},
                                  {"density_kg_per_m3", l.density},
                                  {"source", l.source}});
  return json;
}

std::string units_table() {
  std::string text = fmt::format("{:<38}{:<22}{}\n", "quantity", "example", "units");
  for (const input::Dimension* d : input::dimensions()) {
    std::string units;
    for (const input::Unit& unit : d->units) {
      units += units.empty() ? "" : ", ";
      for (const std::string_view spelling : unit.spellings)
        if (!spelling.empty()) units += fmt::format("{}{}", spelling == unit.spellings[0] ? "" : " = ", spelling);
    }
    text += hanging(fmt::format("{:<38}{}", d->name, d->example), kUnitsAt, units);
  }
  return text + "\nA number, then its unit: `5 mm`. Differences of temperatures are in K, degC or degF.\n";
}

Json units_json() {
  Json json;
  for (const input::Dimension* d : input::dimensions()) {
    Json dimension{{"quantity", d->name}, {"example", d->example}, {"shown_in", d->canonical}};
    for (const input::Unit& unit : d->units) {
      Json spellings = Json::array();
      for (const std::string_view spelling : unit.spellings)
        if (!spelling.empty()) spellings.push_back(spelling);
      dimension["units"].push_back(std::move(spellings));
    }
    json["quantities"].push_back(std::move(dimension));
  }
  return json;
}

std::string responses_table(const std::vector<std::string>& paths) {
  std::size_t widest = 0;
  for (const std::string& path : paths) widest = std::max(widest, width(path));
  std::string text = padded("path", widest, true) + "  unit         title\n";
  for (const std::string& path : paths) {
    const ResponseTitle title = response_title(path);
    text += padded(path, widest, true) + "  " + padded(std::string(title.unit), 11, true) + "  " + title.name + '\n';
  }
  return text + "\nOf numbers thread by thread also `.min`, `.mean` and `[k]`, k from 0.\n";
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
  std::ranges::move(others, std::back_inserter(of_load_cases));
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
      if (std::ranges::find(paths, path) == paths.end()) paths.push_back(std::move(path));
  }
  return paths;
}

}  // namespace prs
