#include "prs/run/document_schema.h"

#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "prs/input/schema.h"
#include "prs/model/command.h"
#include "prs/record/figure_json.h"
#include "prs/record/record_table.h"
#include "prs/record/schema_parts.h"
#include "prs/run/commands.h"
#include "prs/run/results_schema.h"

namespace prs {
namespace {
namespace documents {

using schema_parts::Json, schema_parts::link, schema_parts::list, schema_parts::map_of,
    schema_parts::names, schema_parts::object, schema_parts::type;

Json text() { return type("string"); }
Json number() { return type("number"); }
Json count() { return type("integer"); }
Json flag() { return type("boolean"); }
Json maybe() { return {{"type", {"number", "null"}}}; }

Json value_schema(const QuantityInfo& q) {
  switch (q.kind) {
    case Kind::number:
      return number();
    case Kind::series:  // Of all rollers one below the other.
      return {{"anyOf", Json::array({list(maybe()), list(list(maybe()))})}};
    case Kind::matrix:
      return list(list(maybe()));
    case Kind::count:
      return count();
    case Kind::flag:
      return flag();
    case Kind::text:
      return text();
    case Kind::texts:
      return list(text());
    case Kind::record:
      return link(q.record().name);
    case Kind::records:
      break;
  }
  return list(link(q.record().name));
}

/// Adds a record and those in it, which stand before it.
void define(Json& definitions, const RecordInfo& record) {
  if (definitions.contains(record.name)) return;
  Json properties = Json::object();
  for (const QuantityInfo& q : record.quantities) {
    if (q.record) define(definitions, q.record());
    Json value = value_schema(q);
    value["title"] = q.title;
    if (!q.unit.empty()) value["unit"] = q.unit;
    if (!q.meaning.empty()) value["description"] = q.meaning;
    properties[std::string(q.key)] = std::move(value);
  }
  definitions[record.name] = object(std::move(properties), {}, record.meaning);
}

/// A document as it grows: keys behind the head, and what they refer to.
struct Parts {
  Json properties, definitions = Json::object();
  std::vector<std::string> required;

  void put(const std::string& key, Json value) {
    properties[key] = std::move(value);
    required.push_back(key);
  }
  void put_record(const std::string& key, const RecordInfo& record) {
    define(definitions, record);
    put(key, link(record.name));
  }
  void leave_open(std::string_view key) { std::erase(required, key); }
};

/// The records of an analysis.
void put_records(Parts& d, std::span<const Place> places) {
  for (const DocumentRecord& at : records_at(places)) {
    const bool is_list = at.path.ends_with("[]");
    const std::string key(at.path.substr(0, at.path.find('[')));
    d.put_record(key, at.record);
    if (is_list) d.properties[key] = list(std::move(d.properties[key]));
    if (!at.required) d.leave_open(key);
  }
}

void put_check(Parts& d) {
  d.put("commands", map_of(object({{"ready", flag()},
                                   {"missing", list(type("string", "What to add"))},
                                   {"wrong", list(type("string", "What to change"))}},
                                  {"ready"}),
                           "By their names"));
  d.put("input", list(object({{"path", text()},
                              {"value", text()},
                              {"default", flag()},
                              {"written", type("string", "As the file has it")},
                              {"origin", type("string", "Of a default that a name stands for")},
                              {"basis", type("string",
                                             "given, assumed (as a comment of the file "
                                             "says) or default")},
                              {"reason", type("string", "Why it was assumed")}},
                             {"path", "value", "default", "basis"})));
  d.put("derived", object({{"axial_pitch_mm", number()},
                           {"contact_length_mm", number()},
                           {"roller_spacing_mm", number()}},
                          {"axial_pitch_mm", "contact_length_mm", "roller_spacing_mm"}));
}

// Studies.

Json level() {
  return object({{"value", text()}, {"number", number()}}, {"value"},
                "As in the file; the number in the unit of the factor");
}
Json responses() { return map_of(number(), "By the paths of the responses"); }

void define_factors(Parts& d) {
  const Json interval = object({{"from", number()}, {"to", number()}}, {"from", "to"});
  d.definitions["Factor"] = object(
      {{"path", text()},
       {"label", text()},
       {"unit", text()},
       {"base", level()},
       {"distribution", object({{"uniform", interval},
                                {"log_uniform", interval},
                                {"normal", object({{"mean", number()}, {"deviation", number()}},
                                                  {"mean", "deviation"})},
                                {"levels", flag()}},
                               {})},
       {"with", list(link("Factor"))}},
      {"path", "label"}, "An input that varies; `with`: those that change with it");
}

Json statistics() {
  Json probabilities = map_of(number(), "By their probability");
  return map_of(object({{"count", count()},
                        {"mean", number()},
                        {"standard_deviation", number()},
                        {"min", number()},
                        {"min_design", count()},
                        {"max", number()},
                        {"max_design", count()},
                        {"quantiles", std::move(probabilities)},
                        {"quantiles_from", type("integer", "Values that they are taken from")},
                        {"histogram",
                         object({{"from", number()}, {"to", number()}, {"counts", list(count())}},
                                {"from", "to", "counts"})}},
                       {"count"}),
                "By the paths of the responses");
}

Json surface() {
  const Json effect = object({{"path", text()},
                              {"contribution_percent", number()},
                              {"coefficient", number()},
                              {"standard_error", number()}},
                             {"path", "contribution_percent", "coefficient"});
  return object({{"designs", count()},
                 {"reason", text()},
                 {"responses", map_of(object({{"r_squared", number()},
                                              {"adjusted_r_squared", number()},
                                              {"intercept", number()},
                                              {"factors", list(effect)}},
                                             {"r_squared", "intercept", "factors"}))}},
                {"designs"}, "A plane through the responses over the ranges of the factors");
}

Json sobol_indices() {
  const Json estimate = object({{"value", number()}, {"half_width_95", number()}}, {"value"});
  return map_of(
      object({{"samples", count()},
              {"samples_left_out", count()},
              {"variance", number()},
              {"factors", list(object({{"path", text()}, {"first", estimate}, {"total", estimate}},
                                      {"path", "first", "total"}))}},
             {"samples", "samples_left_out", "variance", "factors"}));
}

Json envelope() {
  const Json map = list(list(maybe()));
  const Json axis = object({{"path", text()}, {"unit", text()}, {"numbers", list(number())}},
                           {"path", "numbers"});
  const Json measure = object({{"response", text()},
                               {"weight", number()},
                               {"rms", number()},
                               {"normalised_by", number()},
                               {"designs_without", count()},
                               {"normalised", map}},
                              {"response", "weight", "rms", "normalised_by", "designs_without"});
  const Json point = object({{"name", text()},
                             {"reason", text()},
                             {"design", count()},
                             {"settings", map_of(level(), "By the paths of the inputs")},
                             {"responses", responses()},
                             {"normalised", responses()},
                             {"envelope", number()}},
                            {"name"});
  return object({{"combine", text()},
                 {"normalise", text()},
                 {"axes", list(axis)},
                 {"measures", list(measure)},
                 {"rms", number()},
                 {"designs_without", count()},
                 {"max", number()},
                 {"max_design", count()},
                 {"values", map},
                 {"maps_in", type("string", "The file with maps that are too large for here")},
                 {"points", list(point)}},
                {"combine", "normalise", "axes", "measures", "points"});
}

void put_study(Parts& d) {
  define_factors(d);
  d.put("study", object({{"command", text()},
                         {"plan", text()},
                         {"samples", count()},
                         {"seed", count()},
                         {"factors", list(link("Factor"))},
                         {"responses", list(text())}},
                        {"command", "plan", "factors", "responses"}));
  d.put("summary", object({{"designs", count()},
                           {"refused", count()},
                           {"not_converged", count()},
                           {"statistics", statistics()},
                           {"response_surface", surface()},
                           {"sobol_indices", sobol_indices()}},
                          {"designs", "refused", "not_converged", "statistics"}));
  d.put("envelope", envelope());
  d.leave_open("envelope");
  d.put("designs_shown", type("integer", "Where not all are; study.csv has all"));
  d.leave_open("designs_shown");
  d.put("designs", list(object({{"settings", map_of(level(), "By the paths of the inputs")},
                                {"base", type("boolean", "As in the file")},
                                {"converged", flag()},
                                {"status", text()},
                                {"reason", text()},
                                {"responses", responses()}},
                               {"settings", "base", "converged", "status", "responses"})));
}

void put_derivatives(Parts& d) {
  const Json by = object({{"path", text()},
                          {"unit", text()},
                          {"at", type("number", "In this unit")},
                          {"derivative", number()},
                          {"percent_per_percent", number()},
                          {"error", type("number", "Of the derivative, estimated")},
                          {"reason", type("string", "Why there is none")}},
                         {"path"});
  d.put("derivatives", list(object({{"response", text()}, {"value", number()}, {"by", list(by)}},
                                   {"response", "by"})));
}

// Optimizations.

void put_optimize(Parts& d) {
  const Json constraint = object({{"name", text()},
                                  {"constraint", text()},
                                  {"value", number()},
                                  {"limit", number()},
                                  {"satisfied", flag()}},
                                 {"name", "constraint", "satisfied"});
  const Json design{{"variables", map_of(level(), "By the paths of the inputs")},
                    {"status", text()},
                    {"reason", text()},
                    {"feasible", flag()},
                    {"violation", number()},
                    {"responses", responses()}};
  const std::vector<std::string> always{"variables", "status", "feasible", "responses"};
  const auto with = [&](Json more, std::vector<std::string> required) {
    required.insert(required.end(), always.begin(), always.end());
    more.update(design);
    return object(std::move(more), std::move(required));
  };
  const Json numbered{{"design", type("integer", "Its number in history.csv")}};
  Json chosen = numbered;
  chosen["algorithm"] = type("string", "That found it");
  chosen["change_percent"] = map_of(number(), "Against the file's own design");
  chosen["constraints"] = list(constraint);
  chosen["set"] = list(type("string", "What `--set` takes for it"));
  d.definitions["Chosen"] =
      with(chosen, {"design", "algorithm", "change_percent", "constraints", "set"});
  d.definitions["Search"] = object({{"algorithm", text()},
                                    {"designs", count()},
                                    {"feasible", count()},
                                    {"without_answer", count()},
                                    {"front", list(with(numbered, {"design"}))}},
                                   {"algorithm", "designs", "feasible", "without_answer", "front"});
  const Json variable = object({{"path", text()},
                                {"label", text()},
                                {"unit", text()},
                                {"values", list(text())},
                                {"from", number()},
                                {"to", number()},
                                {"with", list(text())}},
                               {"path", "label"});
  d.put("optimize",
        object({{"command", text()},
                {"variables", list(variable)},
                {"objectives", list(object({{"minimize", text()}, {"maximize", text()}}, {}))},
                {"algorithm", text()},
                {"check", text()},
                {"population", count()},
                {"generations", count()},
                {"seed", count()},
                {"compromise",
                 object({{"by", text()}, {"weights", list(number())}, {"of", text()}}, {"by"})}},
               {"command", "variables", "objectives", "algorithm", "population", "generations",
                "seed", "compromise"}));
  d.put("initial", with({{"constraints", list(constraint)}}, {"constraints"}));
  d.put("front", list(type("integer", "Its number in history.csv")));
  for (const char* key : {"compromise", "nearest", "search", "check", "comparison"})
    d.put(key,
          link(std::string_view(key) == "search" || std::string_view(key) == "check" ? "Search"
                                                                                     : "Chosen"));
  d.properties["comparison"] = object({{"hypervolume", number()},
                                       {"check_hypervolume", number()},
                                       {"best", list(object({{"objective", text()},
                                                             {"value", number()},
                                                             {"check_value", number()},
                                                             {"difference_percent", number()}},
                                                            {"objective"}))}},
                                      {"hypervolume", "check_hypervolume", "best"});
  for (const char* key : {"compromise", "nearest", "check", "comparison"}) d.leave_open(key);
}

void put_configurations(Parts& d) {
  define(d.definitions, describe<PerPart<double>>());
  const Json starts =
      object({{"screw", count()}, {"roller", count()}}, {"screw", "roller"}, "Of the threads");
  const Json parts = link(describe<PerPart<double>>().name);
  const Json rollers = object(
      {{"most", type("integer", "That fit with the gap")},
       {"chosen", count()},
       {"crest_gap_mm", type("number", "Between neighbours")},
       {"indexing_angle_deg", type("number", "By which each is turned against its neighbour")},
       {"alike", list(count())}},
      {"most", "chosen", "alike"}, "alike: numbers of rollers that all go in turned the same way");
  const Json gears = object({{"roller_teeth", count()},
                             {"body_teeth", count()},
                             {"module_mm", number()},
                             {"series", type("integer", "Of the standard modules")},
                             {"working_pressure_angle_deg", number()},
                             {"profile_shift", number()},
                             {"most_rollers", count()}},
                            {"roller_teeth", "body_teeth", "module_mm", "series"});
  d.put("configurations", list(object({{"number", count()},
                                       {"type", names(std::vector{"standard", "inverted"})},
                                       {"starts", starts},
                                       {"pitch_mm", number()},
                                       {"rolling_diameter_mm", parts},
                                       {"pitch_diameter_mm", parts},
                                       {"centre_distance_mm", number()},
                                       {"gear_ratio", number()},
                                       {"lead_mm", parts},
                                       {"helix_angle_deg", parts},
                                       {"roller_hand", names(std::vector{"right", "left"})},
                                       {"roller_profile_radius_mm", number()},
                                       {"rollers", rollers},
                                       {"gears", list(gears)}},
                                      {"number", "type", "starts", "rollers", "gears"})));
  d.put("left_out",
        list(object({{"type", text()}, {"starts", starts}, {"reason", text()}, {"detail", text()}},
                    {"type", "starts", "reason"})));
}

/// Of `prs compare FILE OTHER`.
void put_case_comparison(Parts& d) {
  const Json change = type("number", "From the value to the other, of the value");
  d.put("other",
        object({{"case_file", text()}, {"input_sha256", text()}, {"warnings", list(text())}},
               {"case_file", "input_sha256", "warnings"}));
  d.put("inputs", list(object({{"path", text()},
                               {"value", text()},
                               {"other_value", text()},
                               {"change_percent", change}},
                              {"path"})));
  d.put("results", list(object({{"command", text()},
                                {"load_case", text()},
                                {"path", text()},
                                {"value", number()},
                                {"other_value", number()},
                                {"change_percent", change}},
                               {"command", "path"})));
}

struct Document {
  std::string_view command;
  void (*put)(Parts&);
};

/// What documents have besides records.
constexpr Document kMore[] = {{"check", put_check}};

/// Documents without records, and other forms.
constexpr Document kForms[] = {
    {"compare", put_case_comparison},
    {"study", put_study},
    {"study", put_derivatives},
    {"optimize", put_optimize},
    {"configurations", put_configurations},
};

/// What every document begins with, and the pictures of `--figures`.
Json whole(Parts d, std::string_view command) {
  Json properties{
      {"prs_version", text()},
      {"schema_version", type("string", "Of the input")},
      {"command", {{"const", command}}},
      {"case_file", type("string", "As it was given")},
      {"input_sha256", {{"type", "string"}, {"pattern", "^[0-9a-f]{64}$"}}},
      {"overrides", list(type("string", "PATH=VALUE"))},
      {"warnings", list(text())},
      {"resolved_input", link("Input")},
  };
  std::vector<std::string> required{"prs_version", "schema_version", "command", "warnings"};
  if (command != "configurations")
    for (const char* key : {"case_file", "input_sha256", "resolved_input"})
      required.emplace_back(key);
  properties.update(d.properties);
  required.insert(required.end(), d.required.begin(), d.required.end());
  properties["figures"] = list(link("Figure"));
  return object(std::move(properties), std::move(required));
}

}  // namespace documents
}  // namespace

std::span<const std::string_view> documented_commands() {
  static const std::vector<std::string_view> commands = [] {
    std::vector<std::string_view> names;
    for (const AnyAnalysis& analysis : analyses()) names.push_back(name(analysis.command));
    names.push_back("configurations");
    return names;
  }();
  return commands;
}

nlohmann::ordered_json document_schema(std::string_view command) {
  using documents::Json;
  Json schema{{"$schema", schema_parts::kDialect},
              {"title", std::string("What `prs ").append(command).append(" --json` prints")}};
  Json definitions = Json::object(), forms = Json::array();
  const auto add_form = [&](documents::Parts parts) {
    definitions.update(parts.definitions);
    forms.push_back(whole(std::move(parts), command));
  };
  for (const AnyAnalysis& analysis : analyses())
    if (name(analysis.command) == command && !analysis.places.empty()) {
      documents::Parts parts;
      for (const documents::Document& more : documents::kMore)
        if (more.command == command) more.put(parts);
      put_records(parts, analysis.places);
      add_form(std::move(parts));
    }
  for (const documents::Document& form : documents::kForms)
    if (form.command == command) {
      documents::Parts parts;
      form.put(parts);
      add_form(std::move(parts));
    }
  if (forms.size() == 1)
    schema.update(forms[0]);
  else
    schema["oneOf"] = std::move(forms);
  // Definitions of a schema in a schema move up to where its references find them.
  Json figure = figure_schema();
  definitions.update(figure["$defs"]);
  Json input = input::schema();
  for (Json* part : {&figure, &input})
    for (const char* key : {"$schema", "$defs"}) part->erase(key);
  definitions["Figure"] = std::move(figure);
  definitions["Input"] = std::move(input);
  schema["$defs"] = std::move(definitions);
  return schema;
}

}  // namespace prs
