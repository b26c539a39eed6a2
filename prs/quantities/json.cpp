#include "prs/quantities/json.h"

#include <algorithm>

#include "prs/printable.h"
#include "prs/quantities/contact_quantities.h"
#include "prs/quantities/heat_quantities.h"
#include "prs/quantities/life_json.h"
#include "prs/quantities/life_quantities.h"
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

}  // namespace

Json document_head(const DocumentInfo& info, const std::vector<std::string>& warnings) {
  Json document;
  document["prs_version"] = info.version;
  document["schema_version"] = info.schema_version;
  if (!info.command.empty()) document["command"] = info.command;
  if (!info.case_file.empty()) document["case_file"] = info.case_file;
  if (!info.input_sha256.empty()) document["input_sha256"] = info.input_sha256;
  if (!info.overrides.empty()) document["overrides"] = info.overrides;
  document["warnings"] = warnings;
  if (info.resolved_input) document["resolved_input"] = info.resolved_input();
  return document;
}

void put_contacts(Json& document, const Contacts& contacts) {
  document["contact"] = object_of(contacts);
  if (Json threads = object_of(contacts.threads); !threads.empty())
    document["threads"] = std::move(threads);
}

Json to_json(const Result& result, const DocumentInfo& info) {
  Json document = document_head(info, result.warnings);
  if (result.contacts.threads.centre_distance > 0.0) put_contacts(document, result.contacts);
  const auto is_solved = [](const LoadCaseResult& load_case) {
    return load_case.solve.has_value();
  };
  if (std::ranges::any_of(result.load_cases, is_solved)) document["model"] = model_json(result);
  document["load_cases"] = Json::array();
  for (const LoadCaseResult& load_case : result.load_cases) {
    document["load_cases"].push_back(object_of(load_case));
    if (result.load_cases.size() > kMostHistories)
      document["load_cases"].back().erase("newton_history");
  }
  if (result.heat_cycle) document["heat_cycle"] = object_of(*result.heat_cycle);
  return document;
}

Json measures_json(const MeasuresResult& result, const DocumentInfo& info) {
  Json document = to_json(result.analysis, info);
  document["measures"] = object_of(result.measures);
  for (std::size_t k = 0; k < result.load_measures.size(); ++k)
    if (result.load_measures[k])
      document["load_cases"][k]["measures"] = object_of(*result.load_measures[k]);
  return document;
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

std::string json_text(const Json& document) {
  return printable_json(document.dump(2, ' ', false, Json::error_handler_t::replace)) + '\n';
}

}  // namespace prs
