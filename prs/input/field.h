#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "prs/input/units.h"
#include "prs/model/lateral.h"
#include "prs/model/part.h"

/// The vocabulary in which `case_fields.h` describes the input. A description is a function
/// template `fields(io, block)` that names each key of a block once:
///
///     io.field("lead", m.lead, Quantity{unit::length, not_zero}, required, "Lead of the screw");
///
/// Key, member, how its value is written, whether it must stand, meaning. What happens is up to the
/// visitor `io`: it reads (reader.cpp), writes the schema (schema.cpp) or lists values (echo.cpp).
namespace prs::input {

/// Base of every visitor: its namespace is where `fields` and `alternatives` are looked up.
struct Visitor {};

/// Interval of admissible values, SI.
struct Bounds {
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();
  bool least_excluded = false;
  bool greatest_excluded = false;
  bool zero_excluded = false;

  constexpr bool contain(double v) const {
    return (least_excluded ? v > least : v >= least) &&
           (greatest_excluded ? v < greatest : v <= greatest) && !(zero_excluded && v == 0.0);
  }
};

inline constexpr Bounds unbounded{};
inline constexpr Bounds positive{.least = 0.0, .least_excluded = true};
inline constexpr Bounds not_negative{.least = 0.0};
inline constexpr Bounds not_zero{.zero_excluded = true};

/// Both ends excluded.
constexpr Bounds between(double least, double greatest) {
  return {least, greatest, true, true, false};
}

/// Whether a key must stand. A key that may be absent leaves its member as the struct initialises
/// it.
struct Presence {
  bool required = false;
  bool allowed = true;
  std::string_view condition = {};  ///< On which that depends: `only with geometry: design`.
};

inline constexpr Presence required{.required = true};
inline constexpr Presence optional{};

/// Required where the condition holds, refused elsewhere.
constexpr Presence required_only_if(bool holds, std::string_view condition) {
  return {holds, holds, condition};
}
/// May stand where the condition holds, refused elsewhere.
constexpr Presence optional_only_if(bool holds, std::string_view condition) {
  return {false, holds, condition};
}
/// Required unless the condition holds; may stand in either case.
constexpr Presence required_unless(bool holds, std::string_view condition) {
  return {!holds, true, condition};
}

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

// How a value is written ------------------------------------------------------------------------

/// `5 mm`
struct Quantity {
  const Dimension& dimension;
  Bounds bounds = unbounded;
};

/// `20000 h` or `500 km`: a quantity of one of two dimensions, each with a member of its own.
struct EitherQuantity {
  Quantity first, second;
};

/// `rigid`, `free` where that is allowed, or a stiffness. One below `least` holds nothing: a
/// newton moves it by a kilometre, and displacements of microns drown in it.
struct Held {
  const Dimension& dimension;
  bool may_be_free = false;

  static constexpr Bounds least{.least = 1e-3};  ///< [N/m], [N m/rad]
};

/// `0.3`, without dimension
struct Number {
  Bounds bounds = unbounded;
};

/// `11`, ends included
struct Whole {
  std::int64_t least;
  std::int64_t greatest;
  std::string_view reason = {};  ///< Reason for the limits, for the message: "as .."
};

/// `true` or `false`
struct Flag {};

/// A line of 1 to 100 bytes.
struct Text {
  std::string_view example = "\"case-1\"";  ///< As it would stand in the file.
};
inline constexpr int kLongestText = 100;

/// One of the words or of the maps with one key that `alternatives(io, value)` lists:
/// `straight` or `{convex: 3 mm}`.
struct Choice {};

/// One of many words that `alternatives(io, value)` lists; messages refer to a command that does.
struct Listed {
  std::string_view command;  ///< `prs list lubricants`
};

/// A choice under a key of its own; one that is a map may do without it:
/// `{model: jacod}`, `{model: {coulomb: 0.11}}` or `{coulomb: 0.11}`.
struct ChoiceUnder {
  std::string_view key;
};

/// A map with the keys that `fields(io, value)` lists.
struct Block {};

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

/// One value for screw, roller and nut, or a map {screw, roller, nut}.
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

/// Equidistant values, ends included, as they are written; a single value has no `steps`.
struct Range {
  double from = 0.0;
  double to = 0.0;
  std::optional<int> steps;
};
inline constexpr int kMostSteps = 100'000;

/// `5 kN` or `{from: 1 kN, to: 45 kN, steps: 45}`
struct OneOrRange {
  Quantity quantity;
};

/// Any value, kept as the text that `--set` takes for it.
struct Verbatim {
  std::string_view example = "5 mm";
};

/// Values of any kind as they are written: a list of them, or a range between two numbers that
/// carry the same unit, ends included.
struct WrittenRange {
  enum class Spacing { linear, logarithmic };

  std::string from, to;
  int steps = 2;
  Spacing spacing = Spacing::linear;
};
struct WrittenValues {
  std::vector<std::string> list;
  std::optional<WrittenRange> range;  ///< In place of the list.
};

/// `[20 mm, 25 mm]` or `{from: 10 mPa s, to: 1 Pa s, steps: 9, spacing: logarithmic}`
struct ListOrRange {};

// Kinds that are maps, and their keys -----------------------------------------------------------

template <class Io, class T>
void list_keys(Io& io, T& block, Block) {
  fields(io, block);
}

template <class Io, class T, class L>
void list_keys(Io& io, T&, const Keys<L>& keys) {
  keys.list(io);
}

template <class Io, class T, class Kind>
void list_keys(Io& io, PerPart<T>& parts, const Each<Kind>& each) {
  io.field("screw", parts.screw, each.kind, each.presence, "Of the screw");
  io.field("roller", parts.roller, each.kind, each.presence, "Of the roller");
  io.field("nut", parts.nut, each.kind, each.presence, "Of the nut");
}

template <class Io, class T, class Kind>
void list_keys(Io& io, PerInterface<T>& sides, const Each<Kind>& each) {
  io.field("screw", sides.screw, each.kind, each.presence, "At the roller-screw interface");
  io.field("nut", sides.nut, each.kind, each.presence, "At the roller-nut interface");
}

template <class Io, class T, class Kind>
void list_keys(Io& io, PerEnd<T>& ends, const OneOrEnds<Kind>& kind) {
  io.field("near", ends.near, kind.kind, optional, "At the end that faces the loaded end");
  io.field("far", ends.far, kind.kind, optional, "At the other end");
}

template <class Io, class T>
void list_keys(Io& io, T& value, const WordOrBlock&) {
  fields(io, value);
}

template <class Io, class T>
void list_keys(Io& io, T& choice, const ChoiceUnder& kind) {
  io.field(kind.key, choice, Choice{}, required, "The choice");
}

template <class Io>
void list_keys(Io& io, Range& range, const OneOrRange& kind) {
  io.field("from", range.from, kind.quantity, required, "First value");
  io.field("to", range.to, kind.quantity, required, "Last value");
  io.field("steps", range.steps, Whole{1, kMostSteps}, required, "Number of values, ends included");
}

template <class Io>
void list_keys(Io& io, WrittenRange& range, ListOrRange) {
  io.field("from", range.from, Verbatim{}, required, "First value");
  io.field("to", range.to, Verbatim{}, required, "Last value, in the same unit");
  io.field("steps", range.steps, Whole{2, kMostSteps}, required, "Number of values, ends included");
  io.field("spacing", range.spacing, Choice{}, optional, "What is equidistant");
}

}  // namespace prs::input
