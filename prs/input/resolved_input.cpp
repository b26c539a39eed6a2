#include "prs/input/resolved_input.h"

#include <concepts>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "prs/input/case_fields.h"
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

/// In the unit that the file has: studies vary it in this unit.
Json value_of(const Node* node, double value, const Quantity& q) {
  return node ? node->text : text_of(value, q);
}
Json value_of(const Node* node, const LeastLife& value, const EitherQuantity& kind) {
  return node ? node->text : text_of(value, kind);
}
Json value_of(const Node* node, double value, const Held& held) {
  return node ? node->text : text_of(value, held);
}
Json value_of(const Node*, double value, const Number&) { return value; }
template <std::signed_integral T>
Json value_of(const Node*, T value, const Whole&) {
  return value;
}
Json value_of(const Node*, bool value, const Flag&) { return value; }
Json value_of(const Node*, const std::string& value, const Text&) { return value; }
Json value_of(const Node* node, const std::string&, const Verbatim&) {
  return node ? written_json(*node) : Json();
}

/// Visits the keys of a map.
class Values : public Visitor {
 public:
  explicit Values(const Node* written) : written_(written) {}

  template <class T, class Kind>
  void field(std::string_view key, T& value, const Kind& kind, Presence presence, std::string_view);

  Json take() && { return std::move(json_); }

 private:
  const Node* written_;
  Json json_ = Json::object();
};

template <class T>
Json value_of(const Node* node, T& value, const Block& kind);

/// Visits the alternatives of a choice for the one that holds.
struct ChosenValue : Visitor {
  const Node* written;
  Json json;

  explicit ChosenValue(const Node* node) : written(node) {}

  template <class E>
  void word(std::string_view name, E& selector, E value, std::string_view) {
    if (selector == value) json = name;
  }
  template <class E, class T, class Kind>
  void map(std::string_view name, E& selector, E value, T& content, const Kind& kind,
           std::string_view) {
    if (selector != value) return;
    const Node* node = written ? find(*written, name) : nullptr;
    json = {{name, value_of(node, content, kind)}};
  }
};

template <class T>
Json value_of(const Node* node, T& value, const Choice&) {
  ChosenValue chosen(node);
  alternatives(chosen, value);
  return chosen.json;
}

template <class T>
Json value_of(const Node*, const T& value, const Listed& kind) {
  return text_of(value, kind);
}

template <class T, class Kind>
Json map_of(const Node* node, T& value, const Kind& kind) {
  Values values(node);
  list_keys(values, value, kind);
  return std::move(values).take();
}

template <class T>
Json value_of(const Node* node, T& value, const Block& kind) {
  return map_of(node, value, kind);
}
template <class T, class L>
Json value_of(const Node* node, T& value, const Keys<L>& kind) {
  return map_of(node, value, kind);
}
template <class T, class Kind>
Json value_of(const Node* node, T& value, const Each<Kind>& kind) {
  return map_of(node, value, kind);
}
template <class T>
Json value_of(const Node* node, T& value, const ChoiceUnder& kind) {
  const Node* choice = node ? find(*node, kind.key) : nullptr;
  return {{kind.key, value_of(choice ? choice : node, value, Choice{})}};
}
template <class T, class Kind>
Json value_of(const Node* node, T& value, const OneOrEach<Kind>& kind) {
  return node && is_per_part(*node) ? map_of(node, value, Each{kind.kind, required})
                                    : value_of(node, value.screw, kind.kind);
}
Json value_of(const Node* node, Range& value, const OneOrRange& kind) {
  return value.steps ? map_of(node, value, kind) : value_of(node, value.from, kind.quantity);
}
template <class T, class Kind>
Json value_of(const Node* node, std::vector<T>& items, const List<Kind>& kind) {
  Json list = Json::array();
  for (std::size_t i = 0; i < items.size(); ++i)
    list.push_back(value_of(node ? &node->children[i] : nullptr, items[i], kind.kind));
  return list;
}
template <class T, class Kind>
Json value_of(const Node* node, OneOrMany<T>& value, const ForEachRoller<Kind>& kind) {
  return value.many.empty() ? value_of(node, value.one, kind.kind)
                            : value_of(node, value.many, List{kind.kind, 1});
}
template <class T, class Kind>
Json value_of(const Node* node, PerEnd<T>& value, const OneOrEnds<Kind>& kind) {
  return node && node->kind == Node::Kind::map ? map_of(node, value, kind)
                                               : value_of(node, value.near, kind.kind);
}
template <class T>
Json value_of(const Node* node, T& value, const WordOrBlock& kind) {
  return map_of(node && node->kind == Node::Kind::map ? node : nullptr, value, kind);
}
Json value_of(const Node* node, WrittenValues& values, const ListOrRange& kind) {
  return values.range ? map_of(node, *values.range, kind)
                      : value_of(node, values.list, List{Verbatim{}});
}

template <class T, class Kind>
void Values::field(std::string_view key, T& value, const Kind& kind, Presence presence,
                   std::string_view) {
  if (!presence.allowed) return;
  const Node* node = written_ ? find(*written_, key) : nullptr;
  if constexpr (is_optional<T>) {
    if (value) json_[key] = value_of(node, *value, kind);
  } else if (Json json = value_of(node, value, kind); node || !json.empty()) {
    json_[key] = std::move(json);
  }
}

}  // namespace

Json resolved_input(const Source& source) {
  ErrorList errors(source);
  const Node root = read_document(source, errors);
  CaseFile file = read_case_file(root, errors);
  errors.throw_if_any();
  return value_of(&root, file, Block{});
}

}  // namespace prs::input
