#include "prs/input/schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "prs/input/case_fields.h"
#include "prs/input/value_text.h"

namespace prs::input {

namespace {

using Json = nlohmann::ordered_json;

/// Texts of a quantity within bounds, as far as its sign tells; of inches also with a fraction.
std::string quantity_pattern(const Bounds& bounds, const Dimension& dimension) {
  const bool sign_free = bounds.least < 0.0;
  const bool no_zero = bounds.zero_excluded || !bounds.contain(0.0);
  const std::string start =
      fmt::format("^{}{}", sign_free ? "[+-]?" : "\\+?", no_zero ? "(?=[0-9.]*[1-9])" : "");
  const std::string decimal =
      "([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+-]?[0-9]+)? *" + unit_pattern(dimension);
  if (&dimension != &unit::length) return start + decimal + "$";
  return fmt::format("{}({}|([0-9]+[ -])?[0-9]+/[1-9][0-9]* *(in|ft))$", start, decimal);
}

template <class T>
Json schema_of(T&, const Quantity& q) {
  const Bounds& bounds = zero_depends_on_unit(q.dimension) ? unbounded : q.bounds;
  const std::string limits = text_of_bounds(q.bounds, q);
  return {{"type", "string"},
          {"pattern", quantity_pattern(bounds, q.dimension)},
          {"description",
           fmt::format("In {}{}{}", unit_list(q.dimension), limits.empty() ? "" : ";", limits)},
          {"examples", Json::array({q.dimension.example})}};
}

template <class T>
Json schema_of(T& value, const EitherQuantity& kind) {
  return {{"oneOf", Json::array({schema_of(value, kind.first), schema_of(value, kind.second)})}};
}

template <class T>
Json schema_of(T& value, const Held& held) {
  Json words = Json::array({"rigid"});
  if (held.may_be_free) words.push_back("free");
  return {{"oneOf", Json::array({Json{{"enum", words}},
                                 schema_of(value, Quantity{held.dimension, held.least})})}};
}

template <class T>
Json schema_of(T&, const Number& number) {
  const Bounds& b = number.bounds;
  Json json{{"type", "number"}};
  if (std::isfinite(b.least)) json[b.least_excluded ? "exclusiveMinimum" : "minimum"] = b.least;
  if (std::isfinite(b.greatest))
    json[b.greatest_excluded ? "exclusiveMaximum" : "maximum"] = b.greatest;
  return json;
}

template <class T>
Json schema_of(T&, const Whole& whole) {
  return {{"type", "integer"}, {"minimum", whole.least}, {"maximum", whole.greatest}};
}

template <class T>
Json schema_of(T&, const Flag&) {
  return {{"type", "boolean"}};
}

template <class T>
Json schema_of(T&, const Text&) {
  return {{"type", "string"},
          {"minLength", 1},
          {"maxLength", kLongestText},
          {"pattern", "^[^\\x00-\\x1F]*$"}};
}

/// Anything but nothing.
template <class T>
Json schema_of(T&, const Verbatim&) {
  return {{"type", {"string", "number", "boolean", "object", "array"}}};
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

/// Puts meaning and condition around what a schema says of its value, and the parts for references.
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

Json default_of(bool value, const Flag&) { return value; }
template <std::signed_integral T>
Json default_of(T value, const Whole&) {
  return value;
}
Json default_of(double value, const Number&) { return value; }
template <class T, class Kind>
Json default_of(const T& value, const Kind& kind) {
  return text_of(value, kind);
}

/// Whether a kind has a default of its own; that of a map is the defaults of its keys.
template <class Kind>
concept Simple = std::same_as<Kind, Quantity> || std::same_as<Kind, Number> ||
    std::same_as<Kind, Whole> || std::same_as<Kind, Held> || std::same_as<Kind, EitherQuantity> ||
    std::same_as<Kind, Flag> || std::same_as<Kind, Choice>;

/// Visits the keys of a map.
class Properties : public Visitor {
 public:
  template <class T, class Kind>
  void field(std::string_view key, T& value, const Kind& kind, Presence presence,
             std::string_view meaning);

  Json object() && { return object_schema(std::move(properties_), std::move(required_)); }

 private:
  Json properties_ = Json::object();
  Json required_ = Json::array();
};

template <class T>
Json schema_of(T& value, const Block& kind);

/// Visits the alternatives of a choice.
class Alternatives : public Visitor {
 public:
  template <class E>
  void word(std::string_view name, E&, E, std::string_view meaning) {
    words_.push_back(name);
    meanings_.push_back(fmt::format("{}: {}", name, meaning));
  }
  template <class E, class T, class Kind>
  void map(std::string_view name, E&, E, T& content, const Kind& kind, std::string_view meaning) {
    Json content_schema = schema_of(content, kind);
    describe(content_schema, meaning);
    maps_.push_back(one_key(name, std::move(content_schema)));
  }

  Json words() const {
    return {{"enum", words_}, {"description", fmt::format("{}", fmt::join(meanings_, "; "))}};
  }
  const Json& maps() const { return maps_; }
  Json all() const {
    if (maps_.empty()) return words();
    Json all = Json::array({words()});
    all.insert(all.end(), maps_.begin(), maps_.end());
    return {{"oneOf", std::move(all)}};
  }

 private:
  Json words_ = Json::array();
  Json maps_ = Json::array();
  std::vector<std::string> meanings_;
};

template <class T>
Json schema_of(T& value, const Choice&) {
  Alternatives choice;
  alternatives(choice, value);
  return choice.all();
}

template <class T>
Json schema_of(T& value, const Listed&) {
  return schema_of(value, Choice{});
}

template <class T, class Kind>
Json map_schema(T& value, const Kind& kind) {
  Properties properties;
  list_keys(properties, value, kind);
  return std::move(properties).object();
}

template <class T>
Json schema_of(T& value, const Block& kind) {
  return map_schema(value, kind);
}
template <class T, class L>
Json schema_of(T& value, const Keys<L>& kind) {
  return map_schema(value, kind);
}
template <class T, class Kind>
Json schema_of(T& value, const Each<Kind>& kind) {
  return map_schema(value, kind);
}
template <class T, class Kind>
Json schema_of(T& value, const OneOrEach<Kind>& kind) {
  return {{"oneOf", Json::array({schema_of(value.screw, kind.kind),
                                 map_schema(value, Each{kind.kind, required})})}};
}
template <class T>
Json schema_of(T& value, const ChoiceUnder& kind) {
  Alternatives choice;
  alternatives(choice, value);
  Json all = choice.maps();
  all.push_back(map_schema(value, kind));
  return {{"oneOf", std::move(all)}};
}
template <class T>
Json schema_of(T& value, const OneOrRange& kind) {
  return {{"oneOf", Json::array({schema_of(value.from, kind.quantity), map_schema(value, kind)})}};
}
template <class T, class Kind>
Json schema_of(std::vector<T>&, const List<Kind>& kind) {
  T item{};
  Json json{{"type", "array"}, {"minItems", kind.least}, {"items", schema_of(item, kind.kind)}};
  if (kind.greatest < std::numeric_limits<int>::max()) json["maxItems"] = kind.greatest;
  return json;
}
template <class T, class Kind>
Json schema_of(T& value, const ForEachRoller<Kind>& kind) {
  return {{"oneOf", Json::array({schema_of(value.one, kind.kind),
                                 schema_of(value.many, List{kind.kind, 1})})}};
}
template <class T, class Kind>
Json schema_of(PerEnd<T>& value, const OneOrEnds<Kind>& kind) {
  return {{"oneOf", Json::array({schema_of(value.near, kind.kind), map_schema(value, kind)})}};
}
template <class T>
Json schema_of(T& value, const WordOrBlock& kind) {
  return {
      {"oneOf", Json::array({schema_of(selector_of(value), Choice{}), map_schema(value, kind)})}};
}
template <class T>
Json schema_of(T&, const ListOrRange& kind) {
  WrittenRange range;
  std::vector<std::string> list;
  return {{"oneOf", Json::array({schema_of(list, List{Verbatim{}, 1}), map_schema(range, kind)})}};
}

template <class T, class Kind>
void Properties::field(std::string_view key, T& value, const Kind& kind, Presence presence,
                       std::string_view meaning) {
  Json json;
  if constexpr (is_optional<T>) {
    typename T::value_type content{};
    json = schema_of(content, kind);
  } else {
    json = schema_of(value, kind);
    if constexpr (Simple<Kind>)
      if (!presence.required && presence.condition.empty())
        json["default"] = default_of(value, kind);
  }
  describe(json, meaning, presence.condition);
  properties_[std::string(key)] = std::move(json);
  if (presence.required && presence.condition.empty()) required_.push_back(key);
}

void add_keys(const Json& schema, const std::string& path, std::vector<InputKey>& keys) {
  const Json properties = schema.value("properties", Json::object());
  for (const auto& [key, property] : properties.items()) {
    const std::string own = path.empty() ? key : path + "." + key;
    if (std::ranges::find(keys, own, &InputKey::path) == keys.end())
      keys.push_back({own, property.value("description", "")});
    add_keys(property, own, keys);
  }
  for (const Json& alternative : schema.value("oneOf", Json::array()))
    add_keys(alternative, path, keys);
  if (schema.contains("items")) add_keys(schema["items"], path + "[0]", keys);
}

}  // namespace

const std::vector<InputKey>& input_keys() {
  static const std::vector<InputKey> keys = [] {
    std::vector<InputKey> all;
    add_keys(schema(), "", all);
    return all;
  }();
  return keys;
}

Json schema() {
  CaseFile file;
  Json json{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
            {"title", "Input of prs, a program for planetary roller screws"}};
  json.update(schema_of(file, Block{}));
  return json;
}

}  // namespace prs::input
