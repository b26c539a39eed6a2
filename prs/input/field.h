#pragma once

#include <concepts>
#include <variant>

#include "prs/input/case_file.h"
#include "prs/input/document.h"
#include "prs/input/units.h"

/// The vocabulary in which case_fields.cpp describes the input. A description is a function that
/// names each key of a block once:
///
///     io("lead", m.lead, Quantity{unit::length, not_zero}, required, "Lead of the screw");
///
/// Key, member, how its value is written (if left out: as `kind_of` says), whether it must stand (if left out: it may),
/// meaning. Of each key a `Field` is made, without types of its own, which is read (reader.cpp), written into
/// the schema (schema.cpp) or listed (echo.cpp).
namespace prs::input {

/// Whether a key is required. An absent key leaves its member as the struct initialises it.
struct Presence {
  bool required = false;
  bool allowed = true;
  std::string_view condition = {};  ///< Condition in words: `only with geometry: design`.
};

inline constexpr Presence required{.required = true};
inline constexpr Presence optional{};

/// Required if the condition holds, refused otherwise.
constexpr Presence required_only_if(bool holds, std::string_view condition) { return {holds, holds, condition}; }
/// Optional if the condition holds, refused otherwise.
constexpr Presence optional_only_if(bool holds, std::string_view condition) { return {false, holds, condition}; }
/// Required unless the condition holds; optional then.
constexpr Presence required_unless(bool holds, std::string_view condition) { return {!holds, true, condition}; }

// How a value is written ------------------------------------------------------------------------

/// `5 mm`
struct Quantity {
  const Dimension& dimension;
  Bounds bounds = unbounded;
  std::string_view example = {};  ///< Example for messages, in place of the dimension's.
};

/// `20000 h` or `500 km`: a quantity of one of two dimensions, each with a member of its own.
struct EitherQuantity {
  Quantity first, second;
};

/// `rigid`, `free` where allowed, or a stiffness. A stiffness below `least` is refused: one newton would move it by a
/// kilometre, and micrometres would be lost to rounding.
struct Held {
  const Dimension& dimension;
  bool may_be_free = false;

  static constexpr Bounds least{.least = 1e-3};  ///< [N/m], [N m/rad]
};

/// `0.3`, without dimension
struct Number {
  Bounds bounds = unbounded;
  std::string_view example = "0.3";
};

/// `11`, ends included
struct Whole {
  std::int64_t least;
  std::int64_t greatest;
  std::string_view reason = {};  ///< Reason for the limits, in messages: "as .."
};

/// `true` or `false`
struct Flag {};

/// A line of 1 to 100 bytes.
struct Text {
  std::string_view example = "\"case-1\"";  ///< Text as in a file.
};

/// One of the words or of the maps with one key that `alternatives(io, value)` lists:
/// `straight` or `{convex: 3 mm}`.
struct Choice {};

/// One of many words that `alternatives(io, value)` lists; messages refer to a command that lists them.
struct Listed {
  std::string_view command;  ///< `prs list lubricants`
};

/// A choice under a key of its own, which may be omitted if the choice is a map: `{model: jacod}`, `{model: {coulomb:
/// 0.11}}` or `{coulomb: 0.11}`.
struct ChoiceUnder {
  std::string_view key;
};

/// A map with the keys that `fields(io, value)` lists.
struct Block {
  std::string_view example = {};  ///< Example for messages, if no key is required.
};

/// A map whose keys are described in place, by `list(io)`.
template <class List>
struct Keys {
  List list;
};
template <class List>
Keys(List) -> Keys<List>;

/// A map {screw, roller, nut} or {screw, nut} with the same kind of value for each.
template <class Kind>
struct Each {
  Kind kind;
  Presence presence;
};
template <class Kind>
Each(Kind, Presence) -> Each<Kind>;

/// One value for all parts, or a map {screw, roller, nut}; {screw, nut} for interfaces.
template <class Kind>
struct OneOrEach {
  Kind kind;
};
template <class Kind>
OneOrEach(Kind) -> OneOrEach<Kind>;

/// `[.., ..]`
template <class Kind>
struct List {
  Kind kind;
  int least = 0;  ///< Number of items.
  int greatest = std::numeric_limits<int>::max();
};
template <class Kind>
List(Kind, int, int) -> List<Kind>;
template <class Kind>
List(Kind, int) -> List<Kind>;
template <class Kind>
List(Kind) -> List<Kind>;

/// A value for all rollers or a list with one for each, as two members.
template <class T>
struct OneOrMany {
  T& one;
  std::vector<T>& many;
};
template <class T>
OneOrMany(T&, std::vector<T>&) -> OneOrMany<T>;
template <class Kind>
struct ForEachRoller {
  Kind kind;
};
template <class Kind>
ForEachRoller(Kind) -> ForEachRoller<Kind>;

/// One value for both ends of the rollers, or a map {near, far}.
template <class Kind>
struct OneOrEnds {
  Kind kind;
};
template <class Kind>
OneOrEnds(Kind) -> OneOrEnds<Kind>;

/// A word of the choice under `key`, or a map with the keys that `fields(io, value)` lists.
struct WordOrBlock {
  std::string_view key;
};

inline constexpr int kMostSteps = 100'000;

/// `5 kN` or `{from: 1 kN, to: 45 kN, steps: 45}`
struct OneOrRange {
  Quantity quantity;
};

/// A constant, one of the forms of `SignalTerm`, or a list of these.
struct OneOrSum {
  Quantity quantity;
};

/// Any value, kept as the text that `--set` takes for it.
struct Verbatim {
  std::string_view example = "5 mm";
};

/// `[20 mm, 25 mm]` or `{from: 10 mPa s, to: 1 Pa s, steps: 9, spacing: logarithmic}`
struct ListOrRange {};

// Values without their types --------------------------------------------------------------------

struct Value;

/// A single value and how it is written.
template <class Kind, class T>
struct Leaf {
  T& value;
  Kind kind;
};

struct MapValue;

/// A word, or a map with one key and possibly further ones.
struct Alternative {
  std::string_view name;
  std::string_view meaning;
  bool holds;  ///< Whether it is the current choice.
  std::function<void()> choose;
  std::function<Value()> content;  ///< Value of the key; none for a word.
  std::function<MapValue()> map;   ///< The key with further ones; none without further keys.
};

struct ChoiceValue {
  std::function<std::vector<Alternative>()> alternatives;
  std::string_view command = {};  ///< Command that lists the alternatives if they are many.
};

struct Field;
struct MapValue {
  /// Calls the function with each key in turn; some depend on values of previous ones.
  std::function<void(const std::function<void(const Field&)>&)> for_each;
  std::string_view example = {};
};

struct ChoiceUnderKey {
  std::string_view key;
  ChoiceValue choice;
  MapValue map;
};

struct ListValue {
  int least, greatest;
  std::function<std::size_t()> size;
  std::function<void(std::size_t)> resize;
  std::function<Value(std::size_t)> entry;
  std::vector<double>* numbers = nullptr;  ///< The entries, if they are quantities.
};

/// One value or several.
struct OneOr {
  enum class Form { parts, ends, range, rollers, word, number, levels, signal };

  Form form;
  std::function<Value()> one, several;
  std::string others = {};                              ///< Description of the form with several values.
  std::function<void()> spread = [] {};                 ///< Copies the single value to all.
  bool are_several = false;                             ///< Whether the value currently has several.
  std::function<bool()> is_odd = [] { return false; };  ///< Whether several contradict each other.
};

struct Value {
  std::variant<Leaf<Quantity, double>, Leaf<EitherQuantity, LeastLife>, Leaf<Held, double>, Leaf<Number, double>,
               Leaf<Whole, int>, Leaf<Whole, std::int64_t>, Leaf<Flag, bool>, Leaf<Text, std::string>,
               Leaf<Verbatim, std::string>, ChoiceValue, ChoiceUnderKey, MapValue, ListValue, OneOr>
      as;
};

/// A key of a map, valid for the time of a call.
struct Field {
  std::string_view key;
  Presence presence;
  std::string_view meaning;
  void* member;
  const void* kind;
  Value (*value_of)(void* member, const void* kind);
  bool (*stands)(const void* member) = nullptr;      ///< Whether there is a value; null if there always is.
  void (*make)(void* member, bool there) = nullptr;  ///< Makes a new value, or removes it.

  bool is_optional() const { return stands != nullptr; }
  bool has_value() const { return !stands || stands(member); }
  Value value() const { return value_of(member, kind); }
  void renew() const {
    if (make) make(member, true);
  }

  /// Calls `use` with the value, or with a temporary one.
  template <class Use>
  auto sample(Use use) const {
    if (has_value()) return use(value());
    make(member, true);
    auto result = use(value());
    make(member, false);
    return result;
  }
};

/// Calls `use` with the first entry, or with a temporary one.
template <class Use>
auto sample_entry(const ListValue& list, Use use) {
  if (list.size() > 0) return use(list.entry(0));
  list.resize(1);
  auto result = use(list.entry(0));
  list.resize(0);
  return result;
}

// Values of members ----------------------------------------------------------------------------

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

struct Choices;

/// How values of a type are written where nothing else is stated: a flag, a choice, a block or a list of these.
template <class T>
auto kind_of() {
  if constexpr (std::same_as<T, bool>)
    return Flag{};
  else if constexpr (is_optional<T>)
    return kind_of<typename T::value_type>();
  else if constexpr (requires { typename T::value_type; })
    return List{kind_of<typename T::value_type>()};
  else if constexpr (requires(Choices & io, T & value) { alternatives(io, value); })
    return Choice{};
  else
    return Block{};
}

/// Receives the keys of a block from its description.
class Fields {
 public:
  using Take = std::function<void(const Field&)>;
  explicit Fields(const Take& take) : take_(take) {}

  template <class T, class Kind>
  void operator()(std::string_view key, T& member, const Kind& kind, Presence presence,
                  std::string_view meaning) const {
    const auto of = [](void* at, const void* how) {
      T& found = *static_cast<T*>(at);
      if constexpr (is_optional<T>)
        return value_of(*found, *static_cast<const Kind*>(how));
      else
        return value_of(found, *static_cast<const Kind*>(how));
    };
    Field field{key, presence, meaning, &member, &kind, of};
    if constexpr (is_optional<T>) {
      field.stands = [](const void* at) { return static_cast<const T*>(at)->has_value(); };
      field.make = [](void* at, bool there) {
        T& made = *static_cast<T*>(at);
        there ? void(made = typename T::value_type{}) : made.reset();
      };
    }
    take_(field);
  }
  template <class T, class Kind>
  void operator()(std::string_view key, T& member, const Kind& kind, std::string_view meaning) const {
    (*this)(key, member, kind, optional, meaning);
  }
  template <class T>
  void operator()(std::string_view key, T& member, Presence presence, std::string_view meaning) const {
    (*this)(key, member, kind_of<T>(), presence, meaning);
  }
  template <class T>
  void operator()(std::string_view key, T& member, std::string_view meaning) const {
    (*this)(key, member, optional, meaning);
  }

  /// Receives a key of another description.
  void take(const Field& field) const { take_(field); }

 private:
  const Take& take_;
};

/// Receives the alternatives of a choice from their description: WORD, member, value, meaning, or KEY, member, value,
/// content, kind, meaning.
struct Choices {
  std::vector<Alternative> list;

  template <class E>
  void operator()(std::string_view name, E& member, std::type_identity_t<E> value, std::string_view meaning) {
    list.push_back({name, meaning, member == value, [&member, value] { member = value; }, {}, {}});
  }
  template <class E, class T, class Kind>
  void operator()(std::string_view name, E& member, std::type_identity_t<E> value, T& content, const Kind& kind,
                  std::string_view meaning) {
    (*this)(name, member, value, meaning);
    list.back().content = [&content, kind] { return value_of(content, kind); };
  }
  /// `further` describes the keys allowed beside KEY.
  template <class E, class T, class Kind, class List>
  void operator()(std::string_view name, E& member, std::type_identity_t<E> value, T& content, const Kind& kind,
                  std::string_view meaning, const Keys<List>& further);
};

/// Map made from a description of keys.
template <class Describe>
MapValue map_of(Describe describe) {
  return {[describe](const Fields::Take& take) { describe(Fields(take)); }};
}

template <class E, class T, class Kind, class List>
void Choices::operator()(std::string_view name, E& member, std::type_identity_t<E> value, T& content, const Kind& kind,
                         std::string_view meaning, const Keys<List>& further) {
  (*this)(name, member, value, content, kind, meaning);
  list.back().map = [=, &content] {
    return map_of([=, &content](const Fields& io) {
      io(name, content, kind, required, meaning);
      further.list(io);
    });
  };
}

template <class Kind, class T>
requires std::constructible_from<decltype(Value::as), Leaf<Kind, T>> Value value_of(T& member, const Kind& kind) {
  return {Leaf<Kind, T>{member, kind}};
}

template <class T>
ChoiceValue choice_of(T& member, std::string_view command = {}) {
  return {[&member] {
            Choices io;
            alternatives(io, member);
            return std::move(io.list);
          },
          command};
}
template <class T>
Value value_of(T& member, const Choice&) {
  return {choice_of(member)};
}
template <class T>
Value value_of(T& member, const Listed& kind) {
  return {choice_of(member, kind.command)};
}
template <class T>
Value value_of(T& member, const ChoiceUnder& kind) {
  return {ChoiceUnderKey{kind.key, choice_of(member), map_of([&member, kind](const Fields& io) {
                           io(kind.key, member, Choice{}, required, "The choice");
                         })}};
}

template <class T>
Value value_of(T& block, const Block& kind) {
  MapValue map = map_of([&block](const Fields& io) { fields(io, block); });
  map.example = kind.example;
  return {std::move(map)};
}
template <class T, class L>
Value value_of(T&, const Keys<L>& keys) {
  return {map_of(keys.list)};
}
template <class T, class Kind>
Value value_of(PerPart<T>& parts, const Each<Kind>& each) {
  return {map_of([&parts, each](const Fields& io) {
    io("screw", parts.screw, each.kind, each.presence, "Of the screw");
    io("roller", parts.roller, each.kind, each.presence, "Of the roller");
    io("nut", parts.nut, each.kind, each.presence, "Of the nut");
  })};
}
template <class T, class Kind>
Value value_of(PerInterface<T>& sides, const Each<Kind>& each) {
  return {map_of([&sides, each](const Fields& io) {
    io("screw", sides.screw, each.kind, each.presence, "At the roller-screw interface");
    io("nut", sides.nut, each.kind, each.presence, "At the roller-nut interface");
  })};
}

template <class T, class Kind>
Value value_of(std::vector<T>& items, const List<Kind>& kind) {
  ListValue list{kind.least, kind.greatest, [&] { return items.size(); }, [&](std::size_t size) { items.resize(size); },
                 [&items, entry = kind.kind](std::size_t i) { return value_of(items[i], entry); }};
  if constexpr (std::same_as<Kind, Quantity>) list.numbers = &items;
  return {std::move(list)};
}

template <class T, class Kind>
Value value_of(PerPart<T>& parts, const OneOrEach<Kind>& kind) {
  return {OneOr{OneOr::Form::parts, [&parts, one = kind.kind] { return value_of(parts.screw, one); },
                [&parts, one = kind.kind] {
                  return value_of(parts, Each{one, required});
                },
                ", or one each for {screw, roller, nut}", [&parts] { parts.roller = parts.nut = parts.screw; }}};
}
template <class T, class Kind>
Value value_of(PerInterface<T>& sides, const OneOrEach<Kind>& kind) {
  return {OneOr{OneOr::Form::parts, [&sides, one = kind.kind] { return value_of(sides.screw, one); },
                [&sides, one = kind.kind] {
                  return value_of(sides, Each{one, required});
                },
                ", or one each for {screw, nut}", [&sides] { sides.nut = sides.screw; }, sides.screw != sides.nut}};
}
template <class T, class Kind>
Value value_of(PerEnd<T>& ends, const OneOrEnds<Kind>& kind) {
  return {OneOr{OneOr::Form::ends, [&ends, one = kind.kind] { return value_of(ends.near, one); },
                [&ends, one = kind.kind] {
                  return Value{map_of([&ends, one](const Fields& io) {
                    io("near", ends.near, one, "At the end that faces the loaded end");
                    io("far", ends.far, one, "At the other end");
                  })};
                },
                ", or one each for {near, far}", [&ends] { ends.far = ends.near; }, ends.near != ends.far}};
}
template <class T, class Kind>
Value value_of(OneOrMany<T> value, const ForEachRoller<Kind>& kind) {
  return {OneOr{OneOr::Form::rollers, [value, one = kind.kind] { return value_of(value.one, one); },
                [value, one = kind.kind] {
                  return value_of(value.many, List{one, 1});
                },
                ", or a list with one for each roller", [] {}, !value.many.empty()}};
}
template <class T>
Value value_of(T& block, const WordOrBlock& kind) {
  return {OneOr{OneOr::Form::word, [&block, kind] { return value_of(selector_of(block, kind), Choice{}); },
                [&block] { return value_of(block, Block{}); }, ", or a map with `" + std::string(kind.key) + "`"}};
}
Value value_of(Range& range, const OneOrRange& kind);
Value value_of(WrittenValues& values, const ListOrRange& kind);
Value value_of(Signal& signal, const OneOrSum& kind);
Value value_of(SignalTerm& term, const OneOrSum& kind);

/// Plans of a study by their names.
void alternatives(Choices& io, Plan& p);

/// The whole input, described once: every key, its unit and bounds, whether it is required, its meaning. Defaults are
/// the member initialisers of the structs.
void fields(const Fields& io, CaseFile& file);

/// Whether a key is part of the resolved case. A length that is not stated and has no default is outside its bounds.
bool stands(const Field& field);

/// A value as a person would write it in the input.
std::string text_of(const Value& value);

/// Comment at the end of a key's line; without one the line is omitted.
using LineRemark = std::function<std::optional<std::string>(std::string_view key, const std::string& text)>;

/// A block as lines of a file: one for each value or entry of a list. Empty if no line remains.
std::string block_text(std::string_view key, const Value& block, const LineRemark& remark = {});

/// ` > 0 and <= 5 mm`; empty without bounds.
std::string text_of_bounds(const Bounds& bounds, const Quantity& quantity);
std::string text_of_bounds(const Bounds& bounds, const Number& number);

/// Whether several values were written.
bool is_several(const Node& node, const OneOr& value);

}  // namespace prs::input
