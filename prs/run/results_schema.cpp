#include "prs/run/results_schema.h"

#include "prs/run/commands.h"

namespace prs {
namespace {

std::string_view name(Kind kind) {
  constexpr std::array kNames{"number", "series", "matrix", "count",  "flag",
                              "text",   "texts",  "record", "records"};
  return kNames.at(static_cast<std::size_t>(kind));
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
  if (q.form.optional) json["optional"] = true;
  return json;
}

/// A record and those in it, which stand before it.
void put_record(Json& records, const RecordInfo& record) {
  for (const QuantityInfo& q : record.quantities)
    if (q.record) put_record(records, q.record());
  if (records.contains(record.name)) {  // Of another type, which may lack others.
    for (std::size_t k = 0; k < record.quantities.size(); ++k)
      if (record.quantities[k].form.optional)
        records[record.name]["quantities"][k]["optional"] = true;
    return;
  }
  Json& json = records[record.name];
  json["meaning"] = record.meaning;
  for (const QuantityInfo& q : record.quantities) json["quantities"].push_back(quantity_json(q));
}

Json analysis_json(const AnyAnalysis& analysis) {
  std::string of_word(name(analysis.command));
  of_word[0] = static_cast<char>(of_word[0] - 'a' + 'A');
  Json json{{"name", name(analysis.command)},
            {"help", analysis.help},
            {"class", analysis.result_class.empty() ? of_word + "Result" : analysis.result_class},
            {"places", Json::array()}};
  for (const Place& place : analysis.places) json["places"].push_back(place.path);
  return json;
}

/// Those of all analyses.
const std::vector<DocumentRecord>& all_records() {
  static const std::vector<DocumentRecord> all = [] {
    std::vector<Place> places;
    for (const AnyAnalysis& analysis : analyses())
      for (const Place& place : analysis.places)
        if (std::ranges::find(places, place.path, &Place::path) == places.end())
          places.push_back(place);
    for (const OtherFile& file : other_files()) places.push_back({name(file.command), file.record});
    return records_at(places);
  }();
  return all;
}

}  // namespace

std::vector<DocumentRecord> records_at(std::span<const Place> places) {
  std::vector<DocumentRecord> records;
  for (const Place& place : places) {
    const auto is_within = [&](const DocumentRecord& r) {
      return place.path.starts_with(r.path) && place.path.substr(r.path.size()).starts_with('.');
    };
    const auto whole = std::ranges::find_if(records, is_within);
    if (whole == records.end()) {
      records.push_back({place.path, place.record(), place.required});
      continue;
    }
    const std::string_view key = place.path.substr(whole->path.size() + 1);
    QuantityInfo& added = whole->record.quantities.emplace_back();
    added.key = key;
    added.kind = Kind::record;
    added.title = words_of(key);
    added.meaning = place.meaning;
    added.record = place.record;
    added.form.optional = true;
  }
  return records;
}

Json results_schema() {
  Json schema;
  schema["documents"] = Json::array();
  schema["records"] = Json::object();
  for (const DocumentRecord& at : all_records()) {
    schema["documents"].push_back({{"path", at.path}, {"record", at.record.name}});
    put_record(schema["records"], at.record);
  }
  for (const AnyAnalysis& analysis : analyses())
    schema["analyses"].push_back(analysis_json(analysis));
  for (const OtherFile& file : other_files())
    schema["analyses"].push_back({{"name", name(file.command)},
                                  {"help", file.help},
                                  {"class", file.result_class},
                                  {"takes", file.name},
                                  {"places", Json::array({name(file.command)})}});
  return schema;
}

const RecordInfo* record_at(std::string_view path) {
  const auto found = std::ranges::find(all_records(), path, &DocumentRecord::path);
  return found == all_records().end() ? nullptr : &found->record;
}

}  // namespace prs
