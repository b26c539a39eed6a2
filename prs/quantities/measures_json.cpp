#include "prs/quantities/measures_json.h"

#include <nlohmann/json.hpp>

#include "prs/quantities/json_values.h"
#include "prs/quantities/measure_quantities.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

Json measures_json(const Measures& measures) {
  Json json = Json::object();
  for (const DesignMeasure& q : kDesignMeasures) put(json, q.key, q.value(measures), q.factor);
  return json;
}

Json measures_json(const LoadMeasures& measures) {
  Json json = Json::object();
  for (const LoadMeasure& q : kLoadMeasures) put(json, q.key, q.value(measures), q.factor);
  for (const LimitMeasure& q : kLimitMeasures)
    if (const auto limit = measures.*q.value) json[q.key] = name(*limit);
  for (const ThreadMeasure& q : kThreadMeasures)
    if (!(measures.*q.values).empty()) json[q.key] = shown(measures.*q.values, q.factor);
  return json;
}

Json explanation(const auto& q, std::string_view of) {
  return {{"key", q.key},           {"of", of},          {"title", q.title}, {"formula", q.formula},
          {"validity", q.validity}, {"source", q.source}};
}

}  // namespace

Json measures_json(const MeasuresResult& result, const DocumentInfo& info) {
  Json document = to_json(result.analysis, info);
  document["measures"] = measures_json(result.measures);
  for (std::size_t k = 0; k < result.load_measures.size(); ++k)
    if (result.load_measures[k])
      document["load_cases"][k]["measures"] = measures_json(*result.load_measures[k]);
  return document;
}

Json measure_explanations_json() {
  Json list = Json::array();
  for (const DesignMeasure& q : kDesignMeasures) list.push_back(explanation(q, "mechanism"));
  for (const LoadMeasure& q : kLoadMeasures) list.push_back(explanation(q, "load case"));
  for (const LimitMeasure& q : kLimitMeasures) list.push_back(explanation(q, "load case"));
  for (const ThreadMeasure& q : kThreadMeasures) list.push_back(explanation(q, "thread"));
  return list;
}

}  // namespace prs
