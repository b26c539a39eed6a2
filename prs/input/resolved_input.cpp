#include "prs/input/resolved_input.h"

#include <nlohmann/json.hpp>

#include "prs/input/described_file.h"
#include "prs/input/document.h"
#include "prs/input/field.h"
#include "prs/input/force_history.h"
#include "prs/input/reader.h"
#include "prs/sha256.h"

namespace prs::input {
namespace {

using Json = nlohmann::ordered_json;

/// A value as it was written.
Json written_json(const Node& node) {
  if (node.kind == Node::Kind::scalar) switch (scalar_type(node)) {
      case ScalarType::text:
        return node.text;
      case ScalarType::boolean:
        return node.text[0] == 't' || node.text[0] == 'T';
      case ScalarType::number:
        return Json::accept(node.text) ? Json::parse(node.text) : Json(*parse_number(node.text));
    }
  const bool is_map = node.kind == Node::Kind::map;
  Json json = is_map ? Json::object() : Json::array();
  for (const Node& child : node.children)
    if (is_map)
      json[child.key] = written_json(child);
    else
      json.push_back(written_json(child));
  return node.kind == Node::Kind::null ? Json() : json;
}

Json json_of(const Node* node, const Value& value);

/// In the unit that the file has: studies vary it in this unit.
template <class Kind, class T>
Json json_of(const Node* node, const Leaf<Kind, T>& leaf) {
  if constexpr (std::is_same_v<Kind, Verbatim>)
    return node ? written_json(*node) : Json();
  else if constexpr (std::is_same_v<Kind, Quantity> || std::is_same_v<Kind, EitherQuantity> ||
                     std::is_same_v<Kind, Held>)
    return node ? node->text : text_of({leaf});
  else
    return leaf.value;
}

Json json_of(const Node* node, const ChoiceValue& choice) {
  for (const Alternative& a : choice.alternatives())
    if (a.holds && a.content)
      return {{a.name, json_of(node ? find(*node, a.name) : nullptr, a.content())}};
    else if (a.holds)
      return a.name;
  return Json();
}

Json json_of(const Node* node, const MapValue& map) {
  Json json = Json::object();
  map.for_each([&](const Field& field) {
    if (!field.presence.allowed || !field.has_value()) return;
    const Node* own = node ? find(*node, field.key) : nullptr;
    Json value = json_of(own, field.value());
    if (field.is_optional() || own || !value.empty()) json[field.key] = std::move(value);
  });
  return json;
}

Json json_of(const Node* node, const ChoiceUnderKey& under) {
  const Node* choice = node ? find(*node, under.key) : nullptr;
  return {{under.key, json_of(choice ? choice : node, under.choice)}};
}

Json json_of(const Node* node, const ListValue& items) {
  Json list = Json::array();
  for (std::size_t i = 0; i < items.size(); ++i)
    list.push_back(json_of(node ? &node->children[i] : nullptr, items.entry(i)));
  return list;
}

Json json_of(const Node* node, const OneOr& value) {
  const bool several = node && is_several(*node, value);
  if (value.form == OneOr::Form::word) return json_of(several ? node : nullptr, value.several());
  return json_of(node, several ? value.several() : value.one());
}

Json json_of(const Node* node, const Value& value) {
  return std::visit([&](const auto& v) { return json_of(node, v); }, value.as);
}

/// The text of the file that a case names; none where it cannot be read, as only `life` needs it.
std::optional<std::string> history_text(const HistorySource& history, const Source& source) {
  try {
    return force_history_text(history, source);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// The history that a source names.
std::optional<HistorySource> history_of(const Source& source) {
  ErrorList errors(source);
  const CaseFile file = read_case_file(read_document(source, errors), errors);
  return file.values.life ? file.values.life->history : std::nullopt;
}

/// The history with the place of its file, wherever the case is written to, and its hash.
Json located(const Json& history, const HistorySource& read, const Source& source) {
  const std::optional<std::string> text = history_text(read, source);
  Json whole;
  for (const auto& [key, value] : history.items()) {
    whole[key] = value;
    if (key != "file" || !text) continue;
    whole[key] = place_of_history(read, source).string();
    whole["sha256"] = sha256(*text);
  }
  return whole;
}

}  // namespace

Json resolved(const Node& root, const Value& description) { return json_of(&root, description); }

Json resolved_input(const Source& source) {
  ErrorList errors(source);
  const Node root = read_document(source, errors);
  CaseFile file = read_case_file(root, errors);
  errors.throw_if_any();
  Json json = json_of(&root, value_of(file, Block{}));
  if (file.values.life && file.values.life->history) {
    Json& history = json["life"]["history"];
    history = located(history, *file.values.life->history, source);
  }
  return json;
}

std::string input_sha256(const Source& source) {
  const std::optional<HistorySource> history = history_of(source);
  const std::optional<std::string> text =
      history ? history_text(*history, source) : std::optional<std::string>();
  return input_sha256(source, text ? std::vector{*text} : std::vector<std::string>());
}

std::string input_sha256(const Source& source, const std::vector<std::string>& files) {
  std::string all = source.text;
  for (const std::string& override : source.overrides) all.append(1, '\0').append(override);
  for (const std::string& text : files) all.append(1, '\0').append(sha256(text));
  return sha256(all);
}

}  // namespace prs::input
