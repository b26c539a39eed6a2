#include "prs/input/resolved_input.h"

#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "prs/input/described_file.h"
#include "prs/input/document.h"
#include "prs/input/reader.h"
#include "prs/input/value_text.h"

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

}  // namespace

Json resolved(const Node& root, const Value& description) { return json_of(&root, description); }

Json resolved_input(const Source& source) {
  ErrorList errors(source);
  const Node root = read_document(source, errors);
  CaseFile file = read_case_file(root, errors);
  errors.throw_if_any();
  return json_of(&root, value_of(file, Block{}));
}

}  // namespace prs::input
