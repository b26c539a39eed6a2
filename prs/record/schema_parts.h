#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "prs/json_type.h"

/// Parts of JSON Schemas, draft 2020-12.
namespace prs::schema_parts {

inline constexpr std::string_view kDialect = "https://json-schema.org/draft/2020-12/schema";

/// A map with these keys and no other.
inline Json object(Json properties, std::vector<std::string> required, std::string_view description = {}) {
  Json json{{"type", "object"}};
  if (!description.empty()) json["description"] = description;
  json["properties"] = std::move(properties);
  if (!required.empty()) json["required"] = std::move(required);
  json["additionalProperties"] = false;
  return json;
}

/// A map with any keys.
inline Json map_of(Json values, std::string_view description = {}) {
  Json json{{"type", "object"}};
  if (!description.empty()) json["description"] = description;
  json["additionalProperties"] = std::move(values);
  return json;
}

inline Json list(Json items) { return {{"type", "array"}, {"items", std::move(items)}}; }
inline Json link(std::string_view definition) { return {{"$ref", std::string("#/$defs/").append(definition)}}; }
inline Json type(const char* name) { return {{"type", name}}; }
inline Json type(const char* name, const char* description) { return {{"type", name}, {"description", description}}; }
inline Json names(const auto& all) { return {{"enum", all}}; }

}  // namespace prs::schema_parts
