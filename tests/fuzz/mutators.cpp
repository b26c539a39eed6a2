#include "tests/fuzz/mutators.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "prs/input/document.h"
#include "prs/input/schema.h"
#include "prs/input/units.h"
#include "prs/run/analyses.h"
#include "tests/fuzz/targets.h"

namespace prs::fuzz {
namespace {

using Json = nlohmann::ordered_json;

bool one_in(std::size_t count, Random& random) { return below(count, random) == 0; }

template <class List>
const auto& any_of(const List& list, Random& random) {
  return list[below(std::size(list), random)];
}

/// Type that the schema allows; empty if there are several.
std::string type_of(const Json& schema) {
  const auto type = schema.find("type");
  return type != schema.end() && type->is_string() ? type->get<std::string>() : "";
}

/// A number near the given one, occasionally far from it.
double moved(double x, Random& random) {
  const double u = static_cast<double>(below(2001, random)) / 1000.0 - 1.0;  // -1 .. 1
  if (random.gentle) return x * (1.0 + (one_in(2, random) ? 0.02 : 0.3) * u);
  switch (below(12, random)) {
    case 0:
      return 0.0;
    case 1:
      return -x;
    case 2:
      return std::nextafter(x, one_in(2, random) ? 1e300 : -1e300);
    case 3:
      return x * std::pow(10.0, 6.0 * u);
    case 4:
      return x * 2.0;
    case 5:
      return x / 2.0;
    case 6:
      return std::round(x);
    default:
      return x == 0.0 ? u : x * (1.0 + 0.3 * u);
  }
}

/// Another unit of the same dimension.
std::string_view other_unit(std::string_view unit, Random& random) {
  for (const input::Dimension* dimension : input::dimensions())
    if (input::find_unit(unit, *dimension)) return any_of(any_of(dimension->units, random).spellings, random);
  return unit;
}

std::string moved_quantity(const std::string& text, Random& random) {
  const auto split = input::split_unit(text);
  if (!split) return text;
  const bool keep = random.gentle || !one_in(8, random);
  const std::string_view unit = keep ? split->unit : other_unit(split->unit, random);
  return fmt::format("{:.10g} {}", moved(split->number, random), unit.empty() ? "mm" : unit);
}

Json random_number(const Json& schema, Random& random) {
  const double least = schema.value("minimum", schema.value("exclusiveMinimum", -10.0));
  const double most = schema.value("maximum", schema.value("exclusiveMaximum", std::max(10.0, least + 10.0)));
  double x = 0.0;
  switch (below(6, random)) {
    case 0:
      x = least;
      break;
    case 1:
      x = most;
      break;
    default:
      x = least + std::min(most - least, 12.0) * static_cast<double>(below(1001, random)) / 1000.0;
  }
  if (type_of(schema) == "integer") return static_cast<std::int64_t>(std::round(x));
  return x;
}

/// Paths of factors and responses of studies.
constexpr const char* kPaths[] = {"mechanism.lead",
                                  "mechanism.rollers",
                                  "mechanism.flank_angle",
                                  "mechanism.contacts_per_roller",
                                  "mechanism.centre_distance",
                                  "mechanism.profile.roller",
                                  "load_cases[0].axial_force",
                                  "deviations.crowning",
                                  "structure.nut.outer_diameter",
                                  "materials.youngs_modulus",
                                  "axial_stiffness_N_per_um",
                                  "screw.peak_pressure_MPa.max",
                                  "nut.load_rate_percent[0]",
                                  "slip.efficiency",
                                  "contact.nut.backlash_mm",
                                  "measures.mass_kg",
                                  "flight.csv",
                                  "5 mm",
                                  "9"};

Json random_text(const Json& schema, Random& random) {
  std::string text = any_of(kPaths, random);
  if (const auto examples = schema.find("examples"); examples != schema.end())
    text = any_of(*examples, random).get<std::string>();
  if (!schema.contains("pattern")) return text;
  return one_in(3, random) ? text : moved_quantity(text, random);
}

Json random_object(const Json& schema, Random& random) {
  Json object = Json::object();
  const Json required = schema.value("required", Json::array());
  for (const auto& [key, child] : schema.at("properties").items())
    if (std::find(required.begin(), required.end(), key) != required.end() || one_in(4, random))
      object[key] = random_value(child, random);
  return object;
}

Json random_list(const Json& schema, Random& random) {
  Json list = Json::array();
  const std::size_t least = schema.value("minItems", std::size_t{0});
  for (std::size_t left = least + below(3, random); left > 0; --left)
    list.push_back(random_value(schema.at("items"), random));
  return list;
}

void change_object(Json& value, const Json& schema, Random& random) {
  const Json& properties = schema.at("properties");
  std::vector<std::string> present;
  for (const auto& [key, child] : value.items())
    if (properties.contains(key)) present.push_back(key);
  if (present.empty() || (!random.gentle && one_in(8, random))) {
    auto added = properties.begin();
    std::advance(added, static_cast<std::ptrdiff_t>(below(properties.size(), random)));
    value[added.key()] = random_value(added.value(), random);
    return;
  }
  const std::string& key = any_of(present, random);
  if (!random.gentle && one_in(12, random))
    value.erase(key);
  else
    change(value[key], properties.at(key), random);
}

void change_list(Json& value, const Json& schema, Random& random) {
  const std::size_t size = value.size();
  const auto at = static_cast<std::ptrdiff_t>(below(std::max<std::size_t>(size, 1), random));
  if (size == 0 || (size < 6 && one_in(6, random)))
    value.push_back(size > 0 && one_in(2, random) ? value[static_cast<std::size_t>(at)]
                                                  : random_value(schema.at("items"), random));
  else if (one_in(8, random))
    value.erase(value.begin() + at);
  else
    change(value[static_cast<std::size_t>(at)], schema.at("items"), random);
}

bool is_of_type(const Json& value, const Json& schema) {
  if (schema.contains("enum"))
    return std::find(schema["enum"].begin(), schema["enum"].end(), value) != schema["enum"].end();
  const std::string type = type_of(schema);
  if (type == "object") {
    const auto properties = schema.find("properties");
    return value.is_object() && std::ranges::all_of(value.items(), [&](const auto& item) {
             return properties != schema.end() && properties->contains(item.key());
           });
  }
  return type.empty() || (type == "array" && value.is_array()) || (type == "string" && value.is_string()) ||
         (type == "boolean" && value.is_boolean()) || (type == "integer" && value.is_number_integer()) ||
         (type == "number" && value.is_number());
}

/// A value as JSON: numbers unchanged, words in quotes.
Json json_of(const input::Node& node) {
  if (node.kind == input::Node::Kind::null) return nullptr;
  if (node.kind == input::Node::Kind::scalar) switch (scalar_type(node)) {
      case input::ScalarType::text:
        return node.text;
      case input::ScalarType::boolean:
        return node.text == "true";
      case input::ScalarType::number:
        return Json::accept(node.text) ? Json::parse(node.text) : Json(*input::parse_number(node.text));
    }
  const bool is_map = node.kind == input::Node::Kind::map;
  Json json = is_map ? Json::object() : Json::array();
  for (const input::Node& child : node.children)
    if (is_map)
      json[child.key] = json_of(child);
    else
      json.push_back(json_of(child));
  return json;
}

std::optional<Json> parsed(std::string_view text) try {
  const input::Source source = input::source_of_text("case.yaml", std::string(text), {});
  input::ErrorList errors(source);
  return json_of(input::read_document(source, errors));
} catch (const input::InputError&) {
  return std::nullopt;
}

constexpr const char* kCommands[] = {"check",    "contact",  "solve",    "solve",  "slip",  "compare",
                                     "life",     "measures", "study",    "report", "write", "preload",
                                     "optimize", "export",   "response", "fit"};

const Json& requirement() {
  static const Json schema = other_files().front().schema();
  return schema;
}

std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace

std::size_t below(std::size_t count, Random& random) {
  return count == 0 ? 0 : std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
}

const Json& case_schema() {
  static const Json schema = input::schema();
  return schema;
}

const Json& taken_by(const Json& schema, const Json& value, Random& random) {
  if (!schema.contains("oneOf")) return schema;
  std::vector<const Json*> fitting;
  for (const Json& one : schema["oneOf"])
    if (is_of_type(value, one)) fitting.push_back(&one);
  return taken_by(fitting.empty() ? any_of(schema["oneOf"], random) : *any_of(fitting, random), value, random);
}

Json random_value(const Json& schema, Random& random) {
  if (schema.contains("oneOf")) return random_value(any_of(schema["oneOf"], random), random);
  if (schema.contains("enum")) return any_of(schema["enum"], random);
  const std::string type = type_of(schema);
  if (type == "object") return random_object(schema, random);
  if (type == "array") return random_list(schema, random);
  if (type == "boolean") return one_in(2, random);
  if (type == "integer" || type == "number") return random_number(schema, random);
  return random_text(schema, random);
}

void change(Json& value, const Json& schema, Random& random) {
  const Json& one = taken_by(schema, value, random);
  const std::string type = type_of(one);
  if (!is_of_type(value, one) || (!random.gentle && one_in(20, random)))
    value = random_value(schema, random);
  else if (type == "object" && one.contains("properties") && !value.empty())
    change_object(value, one, random);
  else if (type == "array")
    change_list(value, one, random);
  else if (value.is_string() && type.empty())
    value = moved_quantity(value.get<std::string>(), random);
  else if (type == "string" && !one.contains("enum") && !one_in(8, random))
    value = moved_quantity(value.get<std::string>(), random);
  else if (type == "number")
    value = moved(value.get<double>(), random);
  else if (type == "integer" && !one_in(4, random))
    value = value.get<std::int64_t>() + static_cast<std::int64_t>(below(5, random)) - 2;
  else
    value = random_value(schema, random);
}

std::string mutated_document(std::string_view input, std::size_t most, std::uint32_t seed) {
  Random random(seed);
  std::string first = fmt::format("# {}", any_of(kCommands, random));
  const std::string_view line = input.substr(0, input.find('\n'));
  if (line.starts_with("# ") && !one_in(6, random)) first = line;
  random.gentle = one_in(2, random);
  const Json& schema = first == "# size" ? requirement() : case_schema();
  std::optional<Json> json = parsed(input);
  if (!json || !json->is_object()) json = random_value(schema, random);
  for (std::size_t left = 1 + below(4, random); left > 0; --left) change(*json, schema, random);
  const std::string text = first + '\n' + dumped(*json) + '\n';
  return text.size() <= most ? text : std::string(input);
}

std::string mutated_overrides(std::string_view input, std::size_t most, std::uint32_t seed) {
  Random random(seed);
  random.gentle = one_in(2, random);
  std::vector<std::string> lines;
  while (!input.empty()) {
    lines.emplace_back(input.substr(0, input.find('\n')));
    input.remove_prefix(std::min(lines.back().size() + 1, input.size()));
  }
  if (random.gentle) lines.resize(below(std::min<std::size_t>(lines.size(), 3) + 1, random));
  if (!lines.empty() && one_in(3, random))
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(below(lines.size(), random)));
  // Descends the schema to some value.
  const Json* schema = &case_schema();
  std::string path;
  while (schema->contains("properties") && !schema->at("properties").empty() && (path.empty() || !one_in(5, random))) {
    auto child = schema->at("properties").begin();
    std::advance(child, static_cast<std::ptrdiff_t>(below(schema->at("properties").size(), random)));
    path += (path.empty() ? "" : ".") + child.key();
    schema = &child.value();
    if (schema->contains("oneOf")) schema = &any_of(schema->at("oneOf"), random);
    if (type_of(*schema) == "array" && !one_in(4, random)) {
      path += fmt::format("[{}]", below(3, random));
      schema = &schema->at("items");
    }
  }
  const Json value = random_value(*schema, random);
  lines.push_back(path + '=' + (value.is_string() ? value.get<std::string>() : dumped(value)));
  std::string text;
  for (const std::string& each : lines)
    if (text.size() + each.size() < most) text += each + '\n';
  return text;
}

}  // namespace prs::fuzz
