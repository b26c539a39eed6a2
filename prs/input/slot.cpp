#include "prs/input/slot.h"

#include <charconv>
#include <cmath>
#include <string>
#include <type_traits>

namespace prs::input {

namespace {

/// The first step of a path, a key or an index, and what follows.
struct Path {
  std::string_view text;

  bool ends() const { return text.empty(); }
  std::string_view key() const { return text.substr(0, text.find_first_of(".[")); }
  std::optional<std::size_t> index() const {
    if (!text.starts_with('[')) return std::nullopt;
    std::size_t index = 0;
    const char* const last = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + 1, last, index);
    if (error != std::errc{} || stop == last || *stop != ']') return std::nullopt;
    return index;
  }
  Path rest() const {
    std::string_view rest = text.substr(
        text.starts_with('[') ? text.find(']') + 1 : std::min(key().size(), text.size()));
    if (rest.starts_with('.')) rest.remove_prefix(1);
    return {rest};
  }
};

/// Follows a path through the description of the input.
class SlotFinder : public Visitor {
 public:
  SlotFinder(Path path, Slot& slot) : path_(path), slot_(slot) {}

  template <class T, class Kind>
  void field(std::string_view key, T& value, const Kind& kind, Presence, std::string_view) {
    if (path_.key() != key) return;
    const SlotFinder next(path_.rest(), slot_);
    if constexpr (is_optional<T>) {
      if (!value) value = typename T::value_type{};
      next.find(*value, kind);
    } else {
      next.find(value, kind);
    }
  }

  template <class E>
  void word(std::string_view, E&, E, std::string_view) {}
  template <class E, class T, class Kind>
  void map(std::string_view name, E& selector, E value, T& content, const Kind& kind,
           std::string_view) {
    if (path_.key() == name && selector == value)
      SlotFinder(path_.rest(), slot_).find(content, kind);
  }

 private:
  template <class T, class Kind>
  void find(T&, const Kind&) const {
    find_other();
  }
  void find_other() const {
    if (path_.ends()) slot_.kind = Slot::Kind::other;
  }

  void find(double& value, const Quantity& q) const {
    if (path_.ends()) add(value, &q.dimension, q.bounds);
  }
  void find(double& value, const Held& held) const {
    if (path_.ends()) add(value, &held.dimension, held.least);
  }
  void find(double& value, const Number& n) const {
    if (path_.ends()) add(value, nullptr, n.bounds);
  }
  void find(int& value, const Whole& w) const {
    if (!path_.ends()) return;
    slot_.kind = Slot::Kind::whole;
    slot_.bounds = {.least = static_cast<double>(w.least),
                    .greatest = static_cast<double>(w.greatest)};
    slot_.whole = &value;
  }

  template <class T>
  void find(T& value, const Choice&) const {
    find_other();
    SlotFinder choice = *this;
    alternatives(choice, value);
  }
  template <class T>
  void find(T& value, const ChoiceUnder& kind) const {
    const Path path = path_.key() == kind.key ? path_.rest() : path_;
    SlotFinder(path, slot_).find(value, Choice{});
  }

  template <class T>
  void find(T& value, const Block& kind) const {
    find_key(value, kind);
  }
  template <class T, class L>
  void find(T& value, const Keys<L>& kind) const {
    find_key(value, kind);
  }
  template <class T, class Kind>
  void find(T& value, const Each<Kind>& kind) const {
    find_key(value, kind);
  }
  template <class T, class Kind>
  void find(T& value, const OneOrEach<Kind>& kind) const {
    const std::string_view key = path_.key();
    if (key == "screw" || key == "roller" || key == "nut")
      return find_key(value, Each{kind.kind, required});
    for (const Part part : kParts) find(value[part], kind.kind);
  }
  /// The number of steps decides on how many load cases there are.
  void find(Range& range, const OneOrRange& kind) const {
    if (path_.ends()) {
      find(range.from, kind.quantity);
      find(range.to, kind.quantity);
    } else if (path_.key() == "steps") {
      slot_.kind = Slot::Kind::other;
    } else if (range.steps.value_or(1) > 1) {
      find_key(range, kind);
    }
  }
  template <class T, class Kind>
  void find(std::vector<T>& items, const List<Kind>& kind) const {
    if constexpr (std::is_same_v<Kind, Quantity>) {
      if (path_.ends()) {
        slot_.kind = Slot::Kind::numbers;
        slot_.dimension = &kind.kind.dimension;
        slot_.bounds = kind.kind.bounds;
        slot_.list = &items;
        return;
      }
    }
    const std::optional<std::size_t> index = path_.index();
    if (index && *index < items.size())
      SlotFinder(path_.rest(), slot_).find(items[*index], kind.kind);
    find_other();
  }

  template <class T, class Kind>
  void find(OneOrMany<T>& value, const ForEachRoller<Kind>& kind) const {
    if (value.many.empty())
      find(value.one, kind.kind);
    else
      find(value.many, List{kind.kind, 1});
  }
  template <class T, class Kind>
  void find(PerEnd<T>& value, const OneOrEnds<Kind>& kind) const {
    const std::string_view key = path_.key();
    if (key == "near" || key == "far" || value.near != value.far) return find_key(value, kind);
    find(value.near, kind.kind);
    if (!path_.ends()) find(value.far, kind.kind);
  }
  template <class T>
  void find(T& value, const WordOrBlock& kind) const {
    find_key(value, kind);
  }

  template <class T, class Kind>
  void find_key(T& value, const Kind& kind) const {
    find_other();
    SlotFinder keys = *this;
    list_keys(keys, value, kind);
  }

  void add(double& value, const Dimension* dimension, const Bounds& bounds) const {
    slot_.kind = Slot::Kind::number;
    slot_.dimension = dimension;
    slot_.bounds = bounds;
    slot_.numbers.push_back(&value);
  }

  Path path_;
  Slot& slot_;
};

std::optional<double> within(const Bounds& bounds, std::optional<double> value) {
  return value && bounds.contain(*value) ? value : std::nullopt;
}

}  // namespace

Slot find_slot(CaseFile& file, std::string_view path) {
  Slot slot;
  if (Path{path}.key() == "study") return slot;
  SlotFinder finder(Path{path}, slot);
  fields(finder, file);
  return slot;
}

std::optional<double> slot_value(const Slot& slot, double number, const Unit* unit) {
  if (!std::isfinite(number)) return std::nullopt;
  return within(slot.bounds, unit ? to_si(number, *unit) : number);
}

std::optional<double> slot_value(const Slot& slot, std::string_view text) {
  if (slot.kind == Slot::Kind::whole) {
    int value = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc{} && stop == text.data() + text.size();
    return whole ? within(slot.bounds, static_cast<double>(value)) : std::nullopt;
  }
  return within(slot.bounds,
                slot.dimension ? parse_quantity(text, *slot.dimension).value : parse_number(text));
}

void set(const Slot& slot, double value) {
  for (double* const number : slot.numbers) *number = value;
  if (slot.whole) *slot.whole = static_cast<int>(value);
}

}  // namespace prs::input
