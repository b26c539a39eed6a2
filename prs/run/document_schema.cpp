#include "prs/run/document_schema.h"

#include "modules/module.h"
#include "prs/indices.h"
#include "prs/input/schema.h"
#include "prs/record/schema_parts.h"
#include "prs/run/analyses.h"
#include "prs/run/check.h"

namespace prs {
namespace {

std::string_view name(Kind kind) {
  constexpr std::array kNames{"number", "series", "matrix", "count", "flag", "text", "texts", "record", "records"};
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

/// Adds a record after those nested in it.
void put_record(Json& records, const RecordInfo& record) {
  for (const QuantityInfo& q : record.quantities)
    if (q.record) put_record(records, q.record());
  if (records.contains(record.name)) {  // Same record of another type, which may lack other quantities.
    for (const auto k : indices(record.quantities))
      if (record.quantities[k].form.optional) records[record.name]["quantities"][k]["optional"] = true;
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

/// Records of all analyses.
const std::vector<DocumentRecord>& all_records() {
  static const std::vector<DocumentRecord> all = [] {
    std::vector<Place> places;
    for (const AnyAnalysis& analysis : analyses())
      for (const Place& place : analysis.places)
        if (std::ranges::find(places, place.path, &Place::path) == places.end()) places.push_back(place);
    for (const OtherFile& file : other_files())
      if (file.record) places.push_back({name(file.command), file.record});
    return records_at(places);
  }();
  return all;
}

namespace documents {

using schema_parts::link, schema_parts::list, schema_parts::map_of, schema_parts::names, schema_parts::object,
    schema_parts::type;

Json text() { return type("string"); }

/// Schema with all words of a text if its meaning lists them, `bars | refined`.
Json text_schema(std::string_view meaning) {
  std::vector<std::string> words;
  for (std::size_t end = 0; end != meaning.npos;) {
    end = meaning.find(" | ");
    words.emplace_back(meaning.substr(0, end));
    if (words.back().find_first_of(" ,:;.") != meaning.npos) return text();
    if (end != meaning.npos) meaning.remove_prefix(end + 3);
  }
  return words.size() > 1 ? names(words) : text();
}

/// Contents of a document described so far, with the records that it refers to.
struct Parts {
  Json properties = Json::object(), definitions = Json::object();
  std::vector<std::string> required;

  void put(const RecordInfo& record) {
    for (const QuantityInfo& q : record.quantities) put(q);
  }
  void put(const QuantityInfo& q) {
    const std::string key(q.key);
    Json value = q.form.by_key ? map_of(value_schema(q)) : value_schema(q);
    value["title"] = q.title;
    if (!q.unit.empty()) value["unit"] = q.unit;
    if (!q.meaning.empty()) value["description"] = q.meaning;
    properties[key] = std::move(value);
    if (q.form.required) required.push_back(key);
  }

  Json value_schema(const QuantityInfo& q) {
    switch (q.kind) {
      case Kind::number:
        return type("number");
      case Kind::series: {
        const Json row = list(q.form.whole ? type("integer") : number_in_list(q.form.finite));
        return q.form.in_rows ? Json{{"anyOf", Json::array({row, list(row)})}} : row;
      }
      case Kind::matrix:
        return list(list(number_in_list(false)));
      case Kind::count:
        return type("integer");
      case Kind::flag:
        return type("boolean");
      case Kind::text:
        return text_schema(q.meaning);
      case Kind::texts:
        return list(text());
      case Kind::record:
        return record_schema(q.record());
      case Kind::records:
        break;
    }
    return list(record_schema(q.record()));
  }

  static Json number_in_list(bool finite) { return finite ? type("number") : Json{{"type", {"number", "null"}}}; }

  /// A record without a name occurs in one place only.
  Json record_schema(const RecordInfo& record) {
    if (definitions.contains(record.name)) return link(record.name);
    if (!record.name.empty()) definitions[record.name] = nullptr;  // The record may contain itself.
    Parts within;
    within.definitions.swap(definitions);
    within.put(record);
    definitions.swap(within.definitions);
    Json schema = object(std::move(within.properties), std::move(within.required), record.meaning);
    if (record.name.empty()) return schema;
    definitions[record.name] = std::move(schema);
    return link(record.name);
  }
};

/// The records of an analysis.
void put_records(Parts& d, std::span<const Place> places) {
  for (const DocumentRecord& at : records_at(places)) {
    const std::string key(at.path.substr(0, at.path.find('[')));
    Json record = d.record_schema(at.record);
    d.properties[key] = at.path.ends_with("[]") ? list(std::move(record)) : std::move(record);
    if (at.required) d.required.push_back(key);
  }
}

/// Contents of documents besides the records of their analyses.
constexpr DocumentForm kMore[] = {{"check", describe<CheckResult>}};

/// Schema with the beginning of every document, and the pictures of `--figures`.
Json whole(Parts d, std::string_view command) {
  Json properties{
      {"prs_version", text()},
      {"schema_version", type("string", "Of the input")},
      {"command", {{"const", command}}},
      {"case_file", type("string", "As it was given")},
      {"input_sha256",
       {{"type", "string"},
        {"pattern", "^[0-9a-f]{64}$"},
        {"description",
         "Of the file; with overrides, a history or curves of a fit, of these too: of what was computed"}}},
      {"overrides", list(type("string", "PATH=VALUE"))},
      {"warnings", list(text())},
      {"assumptions", list(type("string", "What the model takes for granted and this case depends on"))},
      {"resolved_input", link("Input")},
  };
  std::vector<std::string> required{"prs_version", "schema_version", "command", "warnings"};
  if (command != "configurations")
    for (const char* key : {"case_file", "input_sha256", "resolved_input"}) required.emplace_back(key);
  properties.update(d.properties);
  required.insert(required.end(), d.required.begin(), d.required.end());
  properties["figures"] = list(link("Figure"));
  return object(std::move(properties), std::move(required));
}

}  // namespace documents

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
  for (const AnyAnalysis& analysis : analyses()) schema["analyses"].push_back(analysis_json(analysis));
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

std::span<const std::string_view> documented_commands() {
  static const std::vector<std::string_view> commands = [] {
    std::vector<std::string_view> names =
        each(analyses(), [](const AnyAnalysis& analysis) { return name(analysis.command); });
    for (const OtherFile& file : other_files()) names.push_back(name(file.command));
    names.push_back("configurations");
    return names;
  }();
  return commands;
}

Json document_schema(std::string_view command) {
  Json schema{{"$schema", schema_parts::kDialect},
              {"title", std::string("What `prs ").append(command).append(" --json` prints")}};
  Json definitions = Json::object(), forms = Json::array();
  const auto add_form = [&](documents::Parts parts) {
    definitions.update(parts.definitions);
    forms.push_back(whole(std::move(parts), command));
  };
  for (const AnyAnalysis& analysis : analyses())
    if (name(analysis.command) == command && !analysis.is_built)
      throw modules::NotBuilt(fmt::format("prs {}", command));
    else if (name(analysis.command) == command && !analysis.places.empty()) {
      documents::Parts parts;
      for (const DocumentForm& more : documents::kMore)
        if (more.command == command) parts.put(more.record());
      put_records(parts, analysis.places);
      add_form(std::move(parts));
    }
  Json input = input::schema();
  for (const OtherFile& file : other_files())
    if (name(file.command) == command) {
      input = file.schema();
      documents::Parts parts;
      parts.put(file.record());
      add_form(std::move(parts));
    }
  for (const DocumentForm& form : document_forms())
    if (form.command == command) {
      documents::Parts parts;
      parts.put(form.record());
      add_form(std::move(parts));
    }
  if (forms.size() == 1)
    schema.update(forms[0]);
  else
    schema["oneOf"] = std::move(forms);
  // Definitions of a nested schema move up to where its references find them.
  Json figure = figure_schema();
  definitions.update(figure["$defs"]);
  for (Json* part : {&figure, &input})
    for (const char* key : {"$schema", "$defs"}) part->erase(key);
  definitions["Figure"] = std::move(figure);
  definitions["Input"] = std::move(input);
  schema["$defs"] = std::move(definitions);
  return schema;
}

}  // namespace prs
