#include "prs/input/echo.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "prs/input/value_text.h"

namespace prs::input {

namespace {

/// Lists the values of one map next to what was written of them (null where nothing was).
class Lister : public Visitor {
 public:
  Lister(const Node* written, std::string path, std::vector<EchoEntry>& entries)
      : written_(written), path_(std::move(path)), entries_(entries) {}

  template <class T, class Kind>
  void field(std::string_view key, T& value, const Kind& kind, Presence presence,
             std::string_view) {
    if (!presence.allowed) return;
    const Node* node = written_ ? find(*written_, key) : nullptr;
    std::string path = path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
    if constexpr (is_optional<T>) {
      if (value) list(node, path, *value, kind);
    } else {
      list(node, path, value, kind);
    }
  }

 private:
  /// One value that stands on one line.
  template <class T, class Kind>
  void list(const Node* node, const std::string& path, const T& value, const Kind& kind) {
    EchoEntry& entry = entries_.emplace_back();
    entry = {path, text_of(value, kind), node == nullptr};
    if (node) entry.written = node->kind == Node::Kind::scalar ? node->text : flow_text(*node);
    put_number(entry, value, kind);
  }

  template <class T, class Kind>
  static void put_number(EchoEntry&, const T&, const Kind&) {}
  static void put_number(EchoEntry& entry, double value, const Number&) { entry.number = value; }
  static void put_number(EchoEntry& entry, double value, const Quantity& kind) {
    entry.number = value;
    entry.dimension = &kind.dimension;
  }
  static void put_number(EchoEntry& entry, double value, const Held& held) {
    if (std::isfinite(value) && value > 0.0) put_number(entry, value, Quantity{held.dimension});
  }
  static void put_number(EchoEntry& entry, const Range& range, const OneOrRange& kind) {
    const bool last = range.steps && std::abs(range.to) > std::abs(range.from);
    put_number(entry, last ? range.to : range.from, kind.quantity);
  }

  template <class T>
  void list(const Node* node, const std::string& path, T& value, const Block& kind) {
    list_map(node, path, value, kind);
  }
  template <class T, class L>
  void list(const Node* node, const std::string& path, T& value, const Keys<L>& kind) {
    list_map(node, path, value, kind);
  }
  template <class T, class Kind>
  void list(const Node* node, const std::string& path, T& value, const Each<Kind>& kind) {
    list_map(node, path, value, kind);
  }
  template <class T>
  void list(const Node* node, const std::string& path, T& value, const ChoiceUnder& kind) {
    list(node, fmt::format("{}.{}", path, kind.key), std::as_const(value), Choice{});
  }
  template <class T, class Kind>
  void list(const Node* node, const std::string& path, T& value, const OneOrEach<Kind>& kind) {
    if (node && is_per_part(*node))
      list_map(node, path, value, Each{kind.kind, required});
    else
      list(node, path, value.screw, kind.kind);
  }
  template <class T, class Kind>
  void list(const Node* node, const std::string& path, std::vector<T>& items,
            const List<Kind>& kind) {
    if (items.empty() && kind.least == 0) entries_.push_back({path, "[]", node == nullptr});
    for (std::size_t i = 0; i < items.size(); ++i)
      list(node ? &node->children[i] : nullptr, fmt::format("{}[{}]", path, i), items[i],
           kind.kind);
  }

  template <class T, class Kind>
  void list(const Node* node, const std::string& path, OneOrMany<T>& value,
            const ForEachRoller<Kind>& kind) {
    if (!value.many.empty())
      list(node, path, value.many, List{kind.kind, 1});
    else
      list(node, path, value.one, kind.kind);
  }
  template <class T, class Kind>
  void list(const Node* node, const std::string& path, PerEnd<T>& value,
            const OneOrEnds<Kind>& kind) {
    list_map(node && node->kind == Node::Kind::map ? node : nullptr, path, value, kind);
  }
  template <class T>
  void list(const Node* node, const std::string& path, T& value, const WordOrBlock& kind) {
    list_map(node && node->kind == Node::Kind::map ? node : nullptr, path, value, kind);
  }

  template <class T, class Kind>
  void list_map(const Node* node, const std::string& path, T& value, const Kind& kind) {
    Lister keys(node, path, entries_);
    list_keys(keys, value, kind);
  }

  const Node* written_;
  std::string path_;
  std::vector<EchoEntry>& entries_;
};

}  // namespace

std::vector<EchoEntry> echo(CaseFile file, const Node& root) {
  std::optional<Lubricant>& lubricant = file.values.lubricant;
  if (lubricant) lubricant = resolved(*lubricant);
  std::vector<EchoEntry> entries;
  Lister keys(&root, "", entries);
  fields(keys, file);
  constexpr std::string_view block = "lubricant.";
  if (lubricant && lubricant->name)
    for (EchoEntry& entry : entries)
      if (entry.is_default && entry.path.starts_with(block))
        entry.origin =
            origin_of(std::string_view(entry.path).substr(block.size()), *lubricant->name);
  return entries;
}

}  // namespace prs::input
