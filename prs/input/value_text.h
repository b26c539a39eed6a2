#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "prs/input/field.h"
#include "prs/model/limits.h"

/// Values as a person would write them in the input.
namespace prs::input {

inline std::string text_of(double value, const Quantity& q) {
  return format_quantity(value, q.dimension);
}
inline std::string text_of(const LeastLife& life, const EitherQuantity& kind) {
  return life.duration ? text_of(*life.duration, kind.first)
                       : text_of(life.travel.value_or(0.0), kind.second);
}
inline std::string text_of(double value, const Held& held) {
  if (value == kRigid) return "rigid";
  return value == 0.0 ? "free" : format_quantity(value, held.dimension);
}
inline std::string text_of(double value, const Number&) { return fmt::format("{}", value); }
inline std::string text_of(std::int64_t value, const Whole&) { return fmt::format("{}", value); }
inline std::string text_of(bool value, const Flag&) { return value ? "true" : "false"; }
inline std::string text_of(const std::string& value, const Text&) { return value; }

inline std::string text_of(const Range& range, const OneOrRange& kind) {
  const std::string from = text_of(range.from, kind.quantity);
  if (!range.steps) return from;
  return fmt::format("{{from: {}, to: {}, steps: {}}}", from, text_of(range.to, kind.quantity),
                     *range.steps);
}

inline std::string text_of(const std::string& value, const Verbatim&) { return value; }

/// A bound; 0 needs no unit where it is the same in each.
inline std::string text_of_bound(double value, const Quantity& q) {
  return value == 0.0 && !zero_depends_on_unit(q.dimension) ? "0" : text_of(value, q);
}
inline std::string text_of_bound(double value, const Number& n) { return text_of(value, n); }

/// ` > 0 and <= 5 mm`; empty without bounds.
template <class Kind>
std::string text_of_bounds(const Bounds& b, const Kind& kind) {
  if (b.zero_excluded) return " other than 0";
  std::string text;
  if (std::isfinite(b.least))
    text = fmt::format(" {} {}", b.least_excluded ? ">" : ">=", text_of_bound(b.least, kind));
  if (std::isfinite(b.greatest))
    text += fmt::format("{} {} {}", text.empty() ? "" : " and",
                        b.greatest_excluded ? "<" : "<=", text_of_bound(b.greatest, kind));
  return text;
}

/// Visits the alternatives of a choice for the text of the one that holds.
class ChoiceText : public Visitor {
 public:
  std::string text;

  template <class E>
  void word(std::string_view name, E& selector, E value, std::string_view) {
    if (selector == value) text = name;
  }
  template <class E, class T, class Kind>
  void map(std::string_view name, E& selector, E value, T& content, const Kind& kind,
           std::string_view) {
    if (selector == value) text = fmt::format("{{{}: {}}}", name, text_of(content, kind));
  }
};

/// Visits the keys of a block for their values.
class BlockText : public Visitor {
 public:
  std::vector<std::string> items;

  template <class T, class Kind>
  void field(std::string_view key, T& value, const Kind& kind, Presence, std::string_view) {
    items.push_back(fmt::format("{}: {}", key, text_of(value, kind)));
  }
};

template <class T>
std::string text_of(T value, const Block&) {
  BlockText block;
  fields(block, value);
  return fmt::format("{{{}}}", fmt::join(block.items, ", "));
}

template <class T>
std::string text_of(T value, const Choice&) {
  ChoiceText choice;
  alternatives(choice, value);
  return choice.text;
}

template <class T>
std::string text_of(T value, const Listed&) {
  return text_of(value, Choice{});
}

inline std::string text_of(const WrittenValues& values, const ListOrRange&) {
  if (!values.range) return fmt::format("[{}]", fmt::join(values.list, ", "));
  const WrittenRange& range = *values.range;
  return fmt::format("{{from: {}, to: {}, steps: {}, spacing: {}}}", range.from, range.to,
                     range.steps, text_of(range.spacing, Choice{}));
}

}  // namespace prs::input
