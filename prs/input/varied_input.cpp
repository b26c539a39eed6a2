#include "prs/input/varied_input.h"

#include <algorithm>
#include <charconv>

#include "prs/indices.h"
#include "prs/input/field.h"
#include "prs/input/reader.h"

namespace prs::input {

Node scalar(std::string text, Place place) {
  return {.kind = Node::Kind::scalar, .text = std::move(text), .place = place};
}

void take_indices(const Node& root, std::string& path, std::optional<std::string>& label) {
  std::string indexed = with_indices(root, path);
  if (indexed != path && !label) label = path;
  path = std::move(indexed);
}

bool is_part_of(std::string_view path, std::string_view whole) {
  return path.size() > whole.size() && path.starts_with(whole) &&
         (path[whole.size()] == '.' || path[whole.size()] == '[');
}

void check_paths(const std::vector<SetPath>& paths, std::string_view noun, bool one_at_a_time, const Node& root,
                 ErrorList& errors) {
  for (const auto i : indices(paths))
    for (const auto k : up_to(i)) {
      const SetPath &own = paths[i], &other = paths[k];
      const bool together = own.factor == other.factor || !one_at_a_time;
      if (other.path == own.path && (together || (!own.companion && !other.companion)))
        refuse(root, own.at,
               fmt::format("got {} a second time; expected each path once; put all its values into "
                           "one {}",
                           shown(own.path), noun),
               errors);
      else if (together && (is_part_of(own.path, other.path) || is_part_of(other.path, own.path)))
        refuse(root, own.at,
               fmt::format("got {} as well as {}; expected {}s of which none is a part of another; "
                           "delete one of them",
                           shown(own.path), shown(other.path), noun),
               errors);
    }
}

void VariedInput::refuse_at(std::string_view key, std::string_view message) const {
  refuse(root_, fmt::format("{}.{}", path_, key), message, errors_);
}

bool VariedInput::check_outside(std::string_view key, std::string_view path) const {
  for (const std::string_view block : {"study", "optimize", "fit", "references"})
    if (path == block || is_part_of(path, block)) {
      refuse_at(key, fmt::format("got {}; expected a value outside `{}`; write for example `path: "
                                 "mechanism.rollers`",
                                 shown(path), block));
      return false;
    }
  return true;
}

std::optional<Node> VariedInput::base_value(std::string_view path, const std::vector<EchoEntry>& fields) const {
  if (const Node* node = find_path(base_, path)) return *node;
  const auto entry = std::ranges::find(fields, path, &EchoEntry::path);
  return entry == fields.end() ? std::nullopt : std::optional(scalar(entry->value, {}));
}

bool VariedInput::check_in_place(const std::string& path, const Node& value) const {
  const Place at = locate(root_, path_ + ".path");
  ErrorList found(source_);
  Node design = base_;
  if (set_value(design, path, value, at, found)) read_case_file(design, found);
  errors_.take(found, [&](Place place) { return place == at || stands_in(value, place) ? place : value.place; });
  return found.empty();
}

std::optional<VariedInput::Ends> VariedInput::read_ends(std::string_view prefix, std::string_view written_from,
                                                        std::string_view written_to, bool ascending) const {
  const auto refuse = [&](std::string_view key, std::string_view message) {
    refuse_at(fmt::format("{}{}", prefix, key), message);
    return std::nullopt;
  };
  const std::optional<NumberAndUnit> from = split_unit(written_from), to = split_unit(written_to);
  if (!from || !to)
    return refuse(from ? "to" : "from", fmt::format("got {}; expected a number with its unit as in the file; of words "
                                                    "write a list `values: [.., ..]`",
                                                    shown(from ? written_to : written_from)));
  if (!from->unit.empty() && !is_unit(from->unit) && from->unit != to->unit)
    return refuse("from", fmt::format("got {}; expected a number with its unit; `{}` is not a "
                                      "known unit; write both ends in the same unit",
                                      shown(written_from), from->unit));
  if (from->unit != to->unit)
    return refuse("to", fmt::format("got {}; expected the unit of `from`, {}; write both ends in the same "
                                    "unit",
                                    shown(written_to), from->unit.empty() ? "none" : shown(from->unit)));
  if (from->number == to->number)
    return refuse("to", fmt::format("got {}; expected another value than that of `from`; write a "
                                    "list for a single value",
                                    shown(written_to)));
  if (ascending && from->number > to->number)
    return refuse("to", fmt::format("got {}; expected more than `from`, {}; swap the two", shown(written_to),
                                    shown(written_from)));
  return Ends{*from, *to};
}

namespace {

/// The first step of a path, a key or an index, and the rest.
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
    std::string_view rest =
        text.substr(text.starts_with('[') ? text.find(']') + 1 : std::min(key().size(), text.size()));
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
  void find(const Leaf<Quantity, double>& leaf) const { add(leaf.value, &leaf.kind.dimension, leaf.kind.bounds); }
  void find(const Leaf<Held, double>& leaf) const { add(leaf.value, &leaf.kind.dimension, leaf.kind.least); }
  void find(const Leaf<Number, double>& leaf) const { add(leaf.value, nullptr, leaf.kind.bounds); }
  void find(const Leaf<Whole, int>& leaf) const {
    if (!path_.ends()) return;
    slot_.kind = Slot::Kind::whole;
    slot_.bounds = {.least = static_cast<double>(leaf.kind.least), .greatest = static_cast<double>(leaf.kind.greatest)};
    slot_.whole = &leaf.value;
  }

  void find(const ChoiceValue& choice) const {
    find_other();
    for (const Alternative& a : choice.alternatives())
      if (a.map && a.holds && !path_.ends())
        find(a.map());
      else if (a.content && a.holds && a.name == path_.key())
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
      case Form::number:
      case Form::signal:
        return find(value.are_several ? several : one);
      case Form::parts:
        return key == "screw" || key == "roller" || key == "rollers" || key == "nut" ? find(several)
                                                                                     : find_all(several);
      case Form::ends:
        if (key == "near" || key == "far" || value.are_several) return find(several);
        return path_.ends() ? find(one) : find_all(several);
      case Form::range:  // The number of steps determines the number of load cases.
        if (path_.ends()) return find_all(several);
        if (key == "steps")
          slot_.kind = Slot::Kind::other;
        else if (value.are_several)
          find(several);
    }
  }
  /// Finds one value that applies to all of several.
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
  return within(slot.bounds, slot.dimension ? parse_quantity(text, *slot.dimension).value : parse_number(text));
}

void set(const Slot& slot, double value) {
  for (double* const number : slot.numbers) *number = value;
  if (slot.whole) *slot.whole = static_cast<int>(value);
}

}  // namespace prs::input
