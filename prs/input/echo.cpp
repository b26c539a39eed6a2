#include "prs/input/echo.h"

#include "prs/input/described_file.h"

namespace prs::input {
namespace {

/// Lists the values of one map next to what was written of them (null where nothing was).
class Lister {
 public:
  explicit Lister(std::vector<EchoEntry>& entries) : entries_(entries) {}

  void list(const Node* map, const std::string& path, const MapValue& value) {
    value.for_each([&](const Field& field) {
      if (!field.presence.allowed || !field.has_value()) return;
      list(map ? find(*map, field.key) : nullptr,
           path.empty() ? std::string(field.key) : fmt::format("{}.{}", path, field.key),
           field.value());
    });
  }

 private:
  void list(const Node* node, const std::string& path, const Value& value) {
    std::visit([&](const auto& v) { list(node, path, v); }, value.as);
  }

  /// One value that stands on one line.
  void list_line(const Node* node, const std::string& path, const Value& value) {
    EchoEntry& entry = entries_.emplace_back();
    entry = {path, text_of(value), node == nullptr};
    if (node) entry.written = node->kind == Node::Kind::scalar ? node->text : flow_text(*node);
  }
  template <class Kind, class T>
  void list(const Node* node, const std::string& path, const Leaf<Kind, T>& leaf) {
    list_line(node, path, {leaf});
    if constexpr (std::is_same_v<T, double>) put_number(leaf.value, leaf.kind);
  }
  void put_number(double value, const Number&) { entries_.back().number = value; }
  void put_number(double value, const Quantity& kind) {
    entries_.back().number = value;
    entries_.back().dimension = &kind.dimension;
  }
  void put_number(double value, const Held& held) {
    if (std::isfinite(value) && value > 0.0) put_number(value, Quantity{held.dimension});
  }

  void list(const Node* node, const std::string& path, const ChoiceValue& choice) {
    list_line(node, path, {choice});
  }
  void list(const Node* node, const std::string& path, const ChoiceUnderKey& under) {
    list(node, fmt::format("{}.{}", path, under.key), under.choice);
  }
  void list(const Node* node, const std::string& path, const ListValue& items) {
    if (items.size() == 0 && items.least == 0) entries_.push_back({path, "[]", node == nullptr});
    for (std::size_t i = 0; i < items.size(); ++i)
      list(node ? &node->children[i] : nullptr, fmt::format("{}[{}]", path, i), items.entry(i));
  }
  void list(const Node* node, const std::string& path, const OneOr& value) {
    using Form = OneOr::Form;
    const bool several = node && is_several(*node, value);
    if (value.form == Form::ends || value.form == Form::word)
      return list(several ? node : nullptr, path, value.several());
    const Value shown = several ? value.several() : value.one();
    if (value.form != Form::levels && !(value.form == Form::range && several))
      return list(node, path, shown);
    list_line(node, path, shown);
    if (value.form == Form::range) put_farther_end(std::get<MapValue>(shown.as));
  }
  void put_farther_end(const MapValue& range) {
    range.for_each([&](const Field& end) {
      const Value value = end.value();
      const auto* const leaf = std::get_if<Leaf<Quantity, double>>(&value.as);
      const std::optional<double>& number = entries_.back().number;
      if (leaf && (!number || std::abs(leaf->value) > std::abs(*number)))
        put_number(leaf->value, leaf->kind);
    });
  }

  std::vector<EchoEntry>& entries_;
};

}  // namespace

std::vector<EchoEntry> echo_of(const Node& root, const Value& description) {
  std::vector<EchoEntry> entries;
  Lister(entries).list(&root, "", std::get<MapValue>(description.as));
  return entries;
}

std::vector<EchoEntry> echo(CaseFile file, const Node& root) {
  std::optional<Lubricant>& lubricant = file.values.lubricant;
  if (lubricant) lubricant = resolved(*lubricant);
  std::vector<EchoEntry> entries =
      echo_of(root, {map_of([&](const Fields& io) { fields(io, file); })});
  constexpr std::string_view block = "lubricant.";
  if (lubricant && lubricant->name)
    for (EchoEntry& entry : entries)
      if (entry.is_default && entry.path.starts_with(block))
        entry.origin =
            origin_of(std::string_view(entry.path).substr(block.size()), *lubricant->name);
  return entries;
}

}  // namespace prs::input
