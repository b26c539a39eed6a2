#include "prs/input/schema.h"

#include <algorithm>
#include <regex>

#include "prs/indices.h"
#include "prs/input/described_file.h"

namespace prs::input {
namespace {

using Json = nlohmann::ordered_json;

/// Pattern of texts of a quantity within bounds, as far as its sign allows; for inches also with a fraction.
std::string quantity_pattern(const Bounds& bounds, const Dimension& dimension) {
  const bool sign_free = bounds.least < 0.0;
  const bool no_zero = bounds.zero_excluded || !bounds.contain(0.0);
  const std::string start = fmt::format("^{}{}", sign_free ? "[+-]?" : "\\+?", no_zero ? "(?=[0-9.]*[1-9])" : "");
  const std::string decimal = "([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+-]?[0-9]+)? *" + unit_pattern(dimension);
  if (&dimension != &unit::length) return start + decimal + "$";
  return fmt::format("{}({}|([0-9]+[ -])?[0-9]+/[1-9][0-9]* *(in|ft))$", start, decimal);
}

Json schema_of(const Quantity& q) {
  const Bounds& bounds = zero_depends_on_unit(q.dimension) ? unbounded : q.bounds;
  const std::string limits = text_of_bounds(q.bounds, q);
  return {{"type", "string"},
          {"pattern", quantity_pattern(bounds, q.dimension)},
          {"description", fmt::format("In {}{}{}", unit_list(q.dimension), limits.empty() ? "" : ";", limits)},
          {"examples", Json::array({q.example.empty() ? q.dimension.example : q.example})}};
}

Json schema_of(const EitherQuantity& kind) {
  return {{"oneOf", Json::array({schema_of(kind.first), schema_of(kind.second)})}};
}

Json schema_of(const Held& held) {
  Json words = Json::array({"rigid"});
  if (held.may_be_free) words.push_back("free");
  return {{"oneOf", Json::array({Json{{"enum", words}}, schema_of(Quantity{held.dimension, held.least})})}};
}

Json schema_of(const Number& number) {
  const Bounds& b = number.bounds;
  Json json{{"type", "number"}};
  if (std::isfinite(b.least)) json[b.least_excluded ? "exclusiveMinimum" : "minimum"] = b.least;
  if (std::isfinite(b.greatest)) json[b.greatest_excluded ? "exclusiveMaximum" : "maximum"] = b.greatest;
  return json;
}

Json schema_of(const Whole& whole) {
  return {{"type", "integer"}, {"minimum", whole.least}, {"maximum", whole.greatest}};
}

Json schema_of(const Flag&) { return {{"type", "boolean"}}; }

Json schema_of(const Text&) {
  return {{"type", "string"}, {"minLength", 1}, {"maxLength", kLongestText}, {"pattern", "^[^\\x00-\\x1F]*$"}};
}

/// Any value except null.
Json schema_of(const Verbatim&) { return {{"type", {"string", "number", "boolean", "object", "array"}}}; }

template <class Kind, class T>
Json schema_of(const Leaf<Kind, T>& leaf) {
  return schema_of(leaf.kind);
}

Json object_schema(Json properties, Json required_keys) {
  Json json{{"type", "object"}, {"additionalProperties", false}};
  if (!required_keys.empty()) json["required"] = std::move(required_keys);
  json["properties"] = std::move(properties);
  return json;
}

Json one_key(std::string_view key, Json content) {
  Json properties = Json::object();
  properties[std::string(key)] = std::move(content);
  return object_schema(std::move(properties), Json::array({key}));
}

/// Adds meaning and condition to the schema of a value, and the same as separate keys for references.
void describe(Json& json, std::string_view meaning, std::string_view condition = {}) {
  std::string description(meaning);
  if (json.contains("description")) {
    json["x-value"] = json["description"];
    description += ". " + json["description"].get<std::string>();
  }
  if (!condition.empty()) {
    json["x-condition"] = condition;
    description += fmt::format(" ({})", condition);
  }
  json["description"] = description;
  json["x-meaning"] = meaning;
}

Json schema_of(const Value& value);

struct ChoiceSchema {
  Json words = Json::array(), maps = Json::array();
  std::vector<std::string> meanings;

  explicit ChoiceSchema(const ChoiceValue& choice) {
    for (const Alternative& a : choice.alternatives()) {
      if (!a.content) {
        words.push_back(a.name);
        meanings.push_back(fmt::format("{}: {}", a.name, a.meaning));
        continue;
      }
      if (a.map) {
        maps.push_back(schema_of({a.map()}));
        continue;
      }
      Json content = schema_of(a.content());
      describe(content, a.meaning);
      maps.push_back(one_key(a.name, std::move(content)));
    }
  }
};

Json schema_of(const ChoiceValue& choice) {
  const ChoiceSchema of(choice);
  const Json words{{"enum", of.words}, {"description", fmt::format("{}", fmt::join(of.meanings, "; "))}};
  if (of.maps.empty()) return words;
  Json all = Json::array({words});
  append(all, of.maps);
  return {{"oneOf", std::move(all)}};
}

/// Default of a key, if it has one; for a map the defaults of its keys.
template <class Kind, class T>
Json default_of(const Leaf<Kind, T>& leaf) {
  if constexpr (std::is_same_v<T, std::string>)
    return Json();
  else if constexpr (std::is_same_v<Kind, Flag> || std::is_same_v<Kind, Number> || std::is_same_v<Kind, Whole>)
    return leaf.value;
  else
    return text_of({leaf});
}
Json default_of(const ChoiceValue& choice) { return choice.command.empty() ? Json(text_of({choice})) : Json(); }
template <class T>
Json default_of(const T&) {
  return Json();
}
Json default_of(const OneOr& value) {
  if (value.form != OneOr::Form::parts) return Json();
  return std::visit([](const auto& v) { return default_of(v); }, value.one().as);
}

Json schema_of(const MapValue& map) {
  Json properties = Json::object(), required_keys = Json::array();
  map.for_each([&](const Field& field) {
    const Presence& presence = field.presence;
    Json json = field.sample([](const Value& value) { return schema_of(value); });
    if (!field.is_optional() && !presence.required && presence.condition.empty()) {
      const Value value = field.value();
      Json known = std::visit([](const auto& v) { return default_of(v); }, value.as);
      if (!known.is_null()) json["default"] = std::move(known);
    }
    describe(json, field.meaning, presence.condition);
    properties[std::string(field.key)] = std::move(json);
    if (presence.required && presence.condition.empty()) required_keys.push_back(field.key);
  });
  return object_schema(std::move(properties), std::move(required_keys));
}

Json schema_of(const ChoiceUnderKey& under) {
  Json all = ChoiceSchema(under.choice).maps;
  all.push_back(schema_of(under.map));
  return {{"oneOf", std::move(all)}};
}

Json schema_of(const ListValue& list) {
  Json json{{"type", "array"},
            {"minItems", list.least},
            {"items", sample_entry(list, [](const Value& v) { return schema_of(v); })}};
  if (list.greatest < std::numeric_limits<int>::max()) json["maxItems"] = list.greatest;
  return json;
}

Json schema_of(const OneOr& value) {
  return {{"oneOf", Json::array({schema_of(value.one()), schema_of(value.several())})}};
}

Json schema_of(const Value& value) {
  return std::visit([](const auto& v) { return schema_of(v); }, value.as);
}

void add_keys(const Json& schema, const std::string& path, std::vector<InputKey>& keys) {
  const Json properties = schema.value("properties", Json::object());
  for (const auto& [key, property] : properties.items()) {
    const std::string own = path.empty() ? key : path + "." + key;
    if (std::ranges::find(keys, own, &InputKey::path) == keys.end())
      keys.push_back({own, property.value("description", "")});
    add_keys(property, own, keys);
  }
  for (const Json& alternative : schema.value("oneOf", Json::array())) add_keys(alternative, path, keys);
  if (schema.contains("items")) add_keys(schema["items"], path + "[0]", keys);
}

}  // namespace

std::string without_places(std::string_view path) {
  std::string plain;
  bool inside = false;
  for (const char c : path) {
    inside = c == '[' || (inside && c != ']');
    if (!inside && c != ']') plain += c;
  }
  return plain;
}

const std::vector<InputKey>& input_keys() {
  static const std::vector<InputKey> keys = input_keys(schema());
  return keys;
}

std::vector<InputKey> input_keys(const Json& schema) {
  std::vector<InputKey> all;
  add_keys(schema, "", all);
  return all;
}

Json schema_of(std::string_view title, const Value& description) {
  Json json{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", title}};
  json.update(schema_of(description));
  return json;
}

Json schema() {
  CaseFile file;
  return schema_of("Input of prs, a program for planetary roller screws", value_of(file, Block{}));
}

namespace {

std::string text_of(double value, const Quantity& q) { return format_quantity(value, q.dimension); }
std::string text_of(const LeastLife& life, const EitherQuantity& kind) {
  return life.duration ? fmt::format("{:.12g} h", *life.duration / 3600.0)
                       : text_of(life.travel.value_or(0.0), kind.second);
}
std::string text_of(double value, const Held& held) {
  if (value == kRigid) return "rigid";
  return value == 0.0 ? "free" : format_quantity(value, held.dimension);
}
template <class T, class Kind>
std::string text_of(const T& value, const Kind&) {
  return fmt::format("{}", value);
}
template <class Kind, class T>
std::string text_of(const Leaf<Kind, T>& leaf) {
  return text_of(leaf.value, leaf.kind);
}

std::string text_of(const ChoiceValue& choice) {
  for (const Alternative& a : choice.alternatives())
    if (a.holds)
      return a.map       ? input::text_of({a.map()})
             : a.content ? fmt::format("{{{}: {}}}", a.name, input::text_of(a.content()))
                         : std::string(a.name);
  return {};
}
/// A word needs the key; a block with a name of its own replaces it.
std::string text_of(const ChoiceUnderKey& under) {
  const std::string choice = text_of(under.choice);
  return choice.starts_with('{') ? choice : fmt::format("{{{}: {}}}", under.key, choice);
}

std::string text_of(const MapValue& map) {
  std::string text;
  map.for_each([&](const Field& field) {
    if (!stands(field)) return;
    const Value value = field.value();
    const auto* const list = std::get_if<ListValue>(&value.as);
    if (list && list->size() == 0 && list->least > 0) return;  // Written like an absent value.
    text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", field.key, input::text_of(value));
  });
  return fmt::format("{{{}}}", text);
}

std::string text_of(const ListValue& list) {
  std::string text;
  for (const auto i : indices(list)) text += fmt::format("{}{}", i > 0 ? ", " : "", input::text_of(list.entry(i)));
  return fmt::format("[{}]", text);
}

std::string text_of(const OneOr& value) { return input::text_of(value.are_several ? value.several() : value.one()); }

/// Text of a bound: `1e12` and `1e-6`, not 1000000000000 and 1e-06.
std::string text_of_bound(double value, const Number&) {
  return std::regex_replace(fmt::format("{:.{}g}", value, std::abs(value) < 1e7 ? 15 : 9), std::regex("e\\+?(-?)0*"),
                            "e$1");
}
/// Text of a bound with its unit; 0 has none if it is the same in each.
std::string text_of_bound(double value, const Quantity& q) {
  if (value == 0.0 && !zero_depends_on_unit(q.dimension)) return "0";
  const std::string_view unit = q.dimension.canonical;
  return fmt::format("{} {}", text_of_bound(*number_in(text_of(value, q), unit), Number{}), unit);
}

template <class Kind>
std::string bounds_text(const Bounds& b, const Kind& kind) {
  if (b.zero_excluded) return " other than 0";
  std::string text;
  if (std::isfinite(b.least)) text = fmt::format(" {} {}", b.least_excluded ? ">" : ">=", text_of_bound(b.least, kind));
  if (std::isfinite(b.greatest))
    text += fmt::format("{} {} {}", text.empty() ? "" : " and",
                        b.greatest_excluded ? "<" : "<=", text_of_bound(b.greatest, kind));
  return text;
}

}  // namespace

bool stands(const Field& field) {
  if (!field.presence.allowed || !field.has_value()) return false;
  const Value value = field.value();
  const auto* const quantity = std::get_if<Leaf<Quantity, double>>(&value.as);
  return field.presence.required || !quantity || quantity->kind.bounds.contain(quantity->value);
}

std::string text_of(const Value& value) {
  return std::visit([](const auto& v) { return text_of(v); }, value.as);
}

std::string block_text(std::string_view key, const Value& block, const LineRemark& remark) {
  std::string lines;
  std::get<MapValue>(block.as).for_each([&](const Field& field) {
    if (!stands(field)) return;
    const Value value = field.value();
    const auto* const list = std::get_if<ListValue>(&value.as);
    if (list && list->size() == 0) return;
    const std::string text = list ? "" : text_of(value);
    const std::optional<std::string> comment = remark ? remark(field.key, text) : "";
    if (!comment) return;
    lines += fmt::format("  {}:{}{}{}{}\n", field.key, list ? "" : " ", text, comment->empty() ? "" : "  # ", *comment);
    for (std::size_t i = 0; list && i < list->size(); ++i) lines += fmt::format("    - {}\n", text_of(list->entry(i)));
  });
  return lines.empty() ? "" : fmt::format("{}:\n{}", key, lines);
}

std::string text_of_bounds(const Bounds& b, const Quantity& q) { return bounds_text(b, q); }
std::string text_of_bounds(const Bounds& b, const Number& n) { return bounds_text(b, n); }

bool is_several(const Node& node, const OneOr& value) {
  if (value.form == OneOr::Form::parts) return is_per_part(node);
  if (value.form == OneOr::Form::number) return !node.quoted && parse_number(node.text);
  if (value.form != OneOr::Form::rollers) return node.kind == Node::Kind::map;
  if (node.kind != Node::Kind::sequence) return false;
  return !std::holds_alternative<ListValue>(value.one().as) ||
         (!node.children.empty() && node.children[0].kind == Node::Kind::sequence);
}

}  // namespace prs::input
