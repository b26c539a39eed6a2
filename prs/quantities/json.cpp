#include "prs/quantities/json.h"

#include <algorithm>

#include "prs/printable.h"
#include "prs/quantities/contact_quantities.h"
#include "prs/quantities/heat_quantities.h"
#include "prs/quantities/life_json.h"
#include "prs/quantities/life_quantities.h"
#include "prs/quantities/load_case_stream.h"
#include "prs/quantities/measure_quantities.h"
#include "prs/quantities/measures_json.h"
#include "prs/quantities/model_summary.h"
#include "prs/quantities/preload_json.h"
#include "prs/quantities/preload_quantities.h"
#include "prs/quantities/quantities.h"
#include "prs/quantities/record_table.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

/// Documents of more cases leave the histories out.
constexpr std::size_t kMostHistories = 100;

template <class Owner>
void put_explanations(Json& list, std::string_view of) {
  for (const Quantity<Owner>& q : record_of<Owner>().quantities)
    list.push_back({{"key", q.key},
                    {"of", q.value.kind == Kind::series ? "thread" : of},
                    {"title", q.title},
                    {"formula", q.meaning},
                    {"validity", q.validity},
                    {"source", q.source}});
}

template <class R>
Json with_load_cases(Json outline, const R& result) {
  for (std::size_t k = 0; std::optional<Json> load_case = load_case_json(result, k); ++k)
    outline["load_cases"].push_back(*std::move(load_case));
  return outline;
}

/// Malformed UTF-8 is replaced.
std::string dumped(const Json& document) {
  return printable_json(document.dump(2, ' ', false, Json::error_handler_t::replace));
}

}  // namespace

Json document_head(const DocumentInfo& info, const std::vector<Warning>& warnings) {
  Json document;
  document["prs_version"] = info.version;
  document["schema_version"] = info.schema_version;
  if (!info.command.empty()) document["command"] = info.command;
  if (!info.case_file.empty()) document["case_file"] = info.case_file;
  if (!info.input_sha256.empty()) document["input_sha256"] = info.input_sha256;
  if (!info.overrides.empty()) document["overrides"] = info.overrides;
  document["warnings"] = sentences(warnings);
  if (info.resolved_input) document["resolved_input"] = info.resolved_input();
  return document;
}

void put_contacts(Json& document, const Contacts& contacts) {
  document["contact"] = object_of(contacts);
  if (Json threads = object_of(contacts.threads); !threads.empty())
    document["threads"] = std::move(threads);
}

Json outline_json(const Result& result, const DocumentInfo& info) {
  Json document = document_head(info, result.warnings);
  if (result.contacts.threads.centre_distance > 0.0) put_contacts(document, result.contacts);
  const auto is_solved = [](const LoadCaseResult& load_case) {
    return load_case.solve.has_value();
  };
  if (std::ranges::any_of(result.load_cases, is_solved)) document["model"] = model_json(result);
  document["load_cases"] = Json::array();
  if (result.heat_cycle) document["heat_cycle"] = object_of(*result.heat_cycle);
  return document;
}

std::optional<Json> load_case_json(const Result& result, std::size_t k) {
  if (k >= result.load_cases.size()) return std::nullopt;
  Json json = object_of(result.load_cases[k]);
  if (result.load_cases.size() > kMostHistories) json.erase("newton_history");
  return json;
}

Json to_json(const Result& result, const DocumentInfo& info) {
  return with_load_cases(outline_json(result, info), result);
}

Json outline_json(const MeasuresResult& result, const DocumentInfo& info) {
  Json document = outline_json(result.analysis, info);
  document["measures"] = object_of(result.measures);
  return document;
}

std::optional<Json> load_case_json(const MeasuresResult& result, std::size_t k) {
  std::optional<Json> json = load_case_json(result.analysis, k);
  if (json && k < result.load_measures.size() && result.load_measures[k])
    (*json)["measures"] = object_of(*result.load_measures[k]);
  return json;
}

Json measures_json(const MeasuresResult& result, const DocumentInfo& info) {
  return with_load_cases(outline_json(result, info), result);
}

Json measure_explanations_json() {
  Json list = Json::array();
  put_explanations<Measures>(list, "mechanism");
  put_explanations<LoadMeasures>(list, "load case");
  return list;
}

Json preload_json(const PreloadResult& result, const DocumentInfo& info) {
  Json document = document_head(info, result.warnings);
  put_contacts(document, result.contacts);
  document["preload"] = object_of(result);
  return document;
}

Json life_json(const LifeResult& result, const DocumentInfo& info) {
  Json document = document_head(info, result.warnings);
  put_contacts(document, result.contacts);
  document["life"] = object_of(result);
  return document;
}

std::string json_text(const Json& document) { return dumped(document) + '\n'; }

void write_with_load_cases(const Json& outline,
                           const std::function<std::optional<Json>(std::size_t)>& load_case,
                           const TextSink& sink) {
  const std::string text = json_text(outline);
  // JSON escapes line ends in texts, so this line can only be the key of the document.
  constexpr std::string_view kEmpty = "\n  \"load_cases\": []";
  const std::size_t list = text.find(kEmpty);
  std::optional<Json> next = list == text.npos ? std::nullopt : load_case(0);
  if (!next) return sink(text);
  const std::size_t first = list + kEmpty.size() - 1;
  std::string piece = text.substr(0, first) + '\n';
  for (std::size_t k = 1; next; ++k) {
    std::string lines = "    ";
    for (const char c : dumped(*next)) {
      lines += c;
      if (c == '\n') lines += "    ";
    }
    next = load_case(k);
    sink(piece.append(lines).append(next ? ",\n" : "\n"));
    piece.clear();
  }
  sink("  " + text.substr(first));
}

}  // namespace prs
