#include "prs/input/field.h"

namespace prs::input {
namespace {

std::string text_of(double value, const Quantity& q) { return format_quantity(value, q.dimension); }
std::string text_of(const LeastLife& life, const EitherQuantity& kind) {
  return life.duration ? text_of(*life.duration, kind.first)
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
      return a.content ? fmt::format("{{{}: {}}}", a.name, input::text_of(a.content()))
                       : std::string(a.name);
  return {};
}
std::string text_of(const ChoiceUnderKey& under) { return text_of(under.choice); }

std::string text_of(const MapValue& map) {
  std::string text;
  map.for_each([&](const Field& field) {
    if (!field.has_value()) return;
    const Value value = field.value();
    const auto* const list = std::get_if<ListValue>(&value.as);
    if (list && list->size() == 0 && list->least > 0) return;  // As if it were not there.
    text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", field.key, input::text_of(value));
  });
  return fmt::format("{{{}}}", text);
}

std::string text_of(const ListValue& list) {
  std::string text;
  for (std::size_t i = 0; i < list.size(); ++i)
    text += fmt::format("{}{}", i > 0 ? ", " : "", input::text_of(list.entry(i)));
  return fmt::format("[{}]", text);
}

std::string text_of(const OneOr& value) {
  return input::text_of(value.are_several ? value.several() : value.one());
}

/// A bound; 0 needs no unit where it is the same in each.
std::string text_of_bound(double value, const Quantity& q) {
  return value == 0.0 && !zero_depends_on_unit(q.dimension) ? "0" : text_of(value, q);
}
std::string text_of_bound(double value, const Number&) { return fmt::format("{}", value); }

template <class Kind>
std::string bounds_text(const Bounds& b, const Kind& kind) {
  if (b.zero_excluded) return " other than 0";
  std::string text;
  if (std::isfinite(b.least))
    text = fmt::format(" {} {}", b.least_excluded ? ">" : ">=", text_of_bound(b.least, kind));
  if (std::isfinite(b.greatest))
    text += fmt::format("{} {} {}", text.empty() ? "" : " and",
                        b.greatest_excluded ? "<" : "<=", text_of_bound(b.greatest, kind));
  return text;
}

}  // namespace

std::string text_of(const Value& value) {
  return std::visit([](const auto& v) { return text_of(v); }, value.as);
}

std::string block_text(std::string_view key, const Value& block) {
  std::string text = fmt::format("{}:\n", key);
  std::get<MapValue>(block.as).for_each([&](const Field& field) {
    if (!field.has_value() || !field.presence.allowed) return;
    const Value value = field.value();
    const auto* const list = std::get_if<ListValue>(&value.as);
    if (list && list->size() == 0) return;
    text += fmt::format("  {}:{}\n", field.key, list ? "" : " " + text_of(value));
    for (std::size_t i = 0; list && i < list->size(); ++i)
      text += fmt::format("    - {}\n", text_of(list->entry(i)));
  });
  return text;
}

std::string text_of_bounds(const Bounds& b, const Quantity& q) { return bounds_text(b, q); }
std::string text_of_bounds(const Bounds& b, const Number& n) { return bounds_text(b, n); }

bool is_several(const Node& node, const OneOr& value) {
  if (value.form == OneOr::Form::parts) return is_per_part(node);
  if (value.form != OneOr::Form::rollers) return node.kind == Node::Kind::map;
  if (node.kind != Node::Kind::sequence) return false;
  return !std::holds_alternative<ListValue>(value.one().as) ||
         (!node.children.empty() && node.children[0].kind == Node::Kind::sequence);
}

}  // namespace prs::input
