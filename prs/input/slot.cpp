#include "prs/input/slot.h"

#include <charconv>
#include <cmath>
#include <string>
#include <variant>

#include "prs/input/field.h"

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
class SlotFinder {
 public:
  SlotFinder(Path path, Slot& slot) : path_(path), slot_(slot) {}

  void find(const MapValue& map) const {
    find_other();
    map.for_each([this](const Field& field) {
      if (path_.key() != field.key) return;
      if (!field.has_value()) field.renew();
      SlotFinder(path_.rest(), slot_).find(field.value());
    });
  }

 private:
  void find(const Value& value) const {
    std::visit([this](const auto& v) { find(v); }, value.as);
  }
  void find_other() const {
    if (path_.ends()) slot_.kind = Slot::Kind::other;
  }

  template <class Kind, class T>
  void find(const Leaf<Kind, T>&) const {
    find_other();
  }
  void find(const Leaf<Quantity, double>& leaf) const {
    add(leaf.value, &leaf.kind.dimension, leaf.kind.bounds);
  }
  void find(const Leaf<Held, double>& leaf) const {
    add(leaf.value, &leaf.kind.dimension, leaf.kind.least);
  }
  void find(const Leaf<Number, double>& leaf) const { add(leaf.value, nullptr, leaf.kind.bounds); }
  void find(const Leaf<Whole, int>& leaf) const {
    if (!path_.ends()) return;
    slot_.kind = Slot::Kind::whole;
    slot_.bounds = {.least = static_cast<double>(leaf.kind.least),
                    .greatest = static_cast<double>(leaf.kind.greatest)};
    slot_.whole = &leaf.value;
  }

  void find(const ChoiceValue& choice) const {
    find_other();
    for (const Alternative& a : choice.alternatives())
      if (a.content && a.holds && a.name == path_.key())
        SlotFinder(path_.rest(), slot_).find(a.content());
  }
  void find(const ChoiceUnderKey& under) const {
    SlotFinder(path_.key() == under.key ? path_.rest() : path_, slot_).find(under.choice);
  }

  void find(const ListValue& list) const {
    if (list.numbers && path_.ends()) {
      slot_.kind = Slot::Kind::numbers;
      sample_entry(list, [&](const Value& entry) {
        const Quantity& kind = std::get<Leaf<Quantity, double>>(entry.as).kind;
        slot_.dimension = &kind.dimension;
        slot_.bounds = kind.bounds;
        return true;
      });
      slot_.list = list.numbers;
      return;
    }
    const std::optional<std::size_t> index = path_.index();
    if (index && *index < list.size()) SlotFinder(path_.rest(), slot_).find(list.entry(*index));
    find_other();
  }

  void find(const OneOr& value) const {
    using Form = OneOr::Form;
    const std::string_view key = path_.key();
    const Value several = value.several(), one = value.one();
    switch (value.form) {
      case Form::levels:
        return find_other();
      case Form::word:
        return find(several);
      case Form::rollers:
        return find(value.are_several ? several : one);
      case Form::parts:
        return key == "screw" || key == "roller" || key == "nut" ? find(several)
                                                                 : find_all(several);
      case Form::ends:
        if (key == "near" || key == "far" || value.are_several) return find(several);
        return path_.ends() ? find(one) : find_all(several);
      case Form::range:  // The number of steps decides on how many load cases there are.
        if (path_.ends()) return find_all(several);
        if (key == "steps")
          slot_.kind = Slot::Kind::other;
        else if (value.are_several)
          find(several);
    }
  }
  /// One value that holds for all of them.
  void find_all(const Value& values) const {
    std::get<MapValue>(values.as).for_each([this](const Field& field) {
      if (field.key != "steps") find(field.value());
    });
  }

  void add(double& value, const Dimension* dimension, const Bounds& bounds) const {
    if (!path_.ends()) return;
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
  SlotFinder(Path{path}, slot).find(map_of([&](const Fields& io) { fields(io, file); }));
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
