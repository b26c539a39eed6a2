#include "prs/quantities/results_schema.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "prs/quantities/comparison_quantities.h"
#include "prs/quantities/contact_quantities.h"
#include "prs/quantities/heat_quantities.h"
#include "prs/quantities/life_quantities.h"
#include "prs/quantities/measure_quantities.h"
#include "prs/quantities/preload_quantities.h"
#include "prs/quantities/quantities.h"
#include "prs/quantities/record_table.h"
#include "prs/quantities/verdict.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

/// Where the records of documents stand.
struct Place {
  std::string_view path;
  const RecordInfo& (*record)();
};

constexpr Place kPlaces[] = {
    {"contact", describe<Contacts>},
    {"threads", describe<contact::MechanismGeometry>},
    {"load_cases[]", describe<LoadCaseResult>},
    {"heat_cycle", describe<HeatCycle>},
    {"measures", describe<Measures>},
    {"preload", describe<PreloadResult>},
    {"life", describe<LifeResult>},
    {"comparison", describe<ModelComparison>},
    {"verdict", describe<CaseVerdict>},
};

std::string_view name(Kind kind) {
  switch (kind) {
    case Kind::number:
      return "number";
    case Kind::series:
      return "series";
    case Kind::matrix:
      return "matrix";
    case Kind::count:
      return "count";
    case Kind::flag:
      return "flag";
    case Kind::text:
      return "text";
    case Kind::texts:
      return "texts";
    case Kind::record:
      return "record";
    case Kind::records:
      break;
  }
  return "records";
}

Json quantity_json(const QuantityInfo& q) {
  Json json{{"key", q.key}, {"kind", name(q.kind)}, {"title", q.title}};
  const auto put_text = [&](std::string_view key, std::string_view text) {
    if (!text.empty()) json[key] = text;
  };
  put_text("unit", q.unit);
  put_text("group", q.group);
  put_text("meaning", q.meaning);
  put_text("validity", q.validity);
  put_text("source", q.source);
  if (q.record) json["record"] = q.record().name;
  if (q.delivery == Reach::document) json["response"] = false;
  return json;
}

/// A record and those in it, which stand before it.
void put_record(Json& records, const RecordInfo& record) {
  for (const QuantityInfo& q : record.quantities)
    if (q.record) put_record(records, q.record());
  if (records.contains(record.name)) return;
  Json& json = records[record.name];
  json["meaning"] = record.meaning;
  for (const QuantityInfo& q : record.quantities) json["quantities"].push_back(quantity_json(q));
}

}  // namespace

Json results_schema() {
  Json schema;
  schema["documents"] = Json::array();
  schema["records"] = Json::object();
  for (const Place& place : kPlaces) {
    schema["documents"].push_back({{"path", place.path}, {"record", place.record().name}});
    put_record(schema["records"], place.record());
  }
  return schema;
}

const RecordInfo* record_at(std::string_view path) {
  const auto* place = std::ranges::find(kPlaces, path, &Place::path);
  return place == std::end(kPlaces) ? nullptr : &place->record();
}

}  // namespace prs
