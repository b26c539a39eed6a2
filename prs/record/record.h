#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "prs/json_type.h"
#include "prs/model/units.h"

/// The table of results. A result type has one list of quantities, `record_of<Type>()`, from which documents, CSV,
/// tables, responses of studies, titles, Python's records and docs/reference are made.

namespace prs {

using Json = nlohmann::ordered_json;

/// The unit at the end of a key, `MPa` of `peak_pressure_MPa`; kNoUnit if there is none, as in `share_of_revolutions`.
constexpr const ShownUnit& unit_of(std::string_view key) {
  for (const ShownUnit& unit : kShownUnits)
    if (key.ends_with(unit.suffix))
      return key.substr(0, key.size() - unit.suffix.size()).ends_with("_of") ? kNoUnit : unit;
  return kNoUnit;
}

/// Whether a number is a ratio, even if other numbers of its record have a unit: `energy_J.residual_relative`.
constexpr bool is_ratio(std::string_view key) { return key.ends_with("_relative"); }

/// The unit of the number at a path, that of the last key with one: `MPa` of
/// `screw.peak_pressure_MPa.max`. A ratio has none.
const ShownUnit& unit_at(std::string_view path);

/// Kind of value under a key of a document.
enum class Kind {
  number,
  series,  ///< An array of numbers.
  matrix,
  count,
  flag,
  text,
  texts,
  record,   ///< An object with quantities of its own.
  records,  ///< An array of such objects.
};

/// Details of a quantity in a schema besides its kind.
struct Form {
  bool required = false;  ///< Whether every document has it.
  bool finite = false;    ///< Whether a series has no gaps.
  bool whole = false;     ///< Whether a series has integers.
  bool in_rows = false;   ///< Whether a series is split into rows if there are several rollers.
  bool by_key = false;    ///< Whether it is an object with any keys; the kind is that of its values.
  bool optional = false;  ///< Whether only some cases define it.
};

/// The values of an object with any keys, in their order.
template <class T>
using ByKey = std::vector<std::pair<std::string, T>>;

/// Results in which a quantity is available as a response.
enum class Reach {
  numbers,   ///< Every result, also with Detail::numbers.
  complete,  ///< Results with Detail::complete only.
  document,  ///< The document of a run only: about the solution, not the design.
};

template <class Owner>
struct Quantity;
struct RecordInfo;

/// Record of a result type: `Record<T> record_of(Type<T>)` is defined once for each, see PRS_RECORD.
template <class Owner>
struct Record {
  std::string_view name;     ///< Name in Python and in the reference.
  std::string_view meaning;  ///< A sentence, with the source if there is one.
  std::span<const Quantity<Owner>> quantities;
};

template <class Owner>
struct Type {};

/// Defines a record: PRS_RECORD(T, name, meaning, quantities);
#define PRS_RECORD(T, ...)                                        \
  Record<T> record_of(Type<T>) { return Record<T>{__VA_ARGS__}; } \
  static_assert(true)

template <class Owner>
Record<Owner> record_of() {
  return record_of(Type<Owner>());
}

/// Reads a number as documents show it.
template <class Owner>
struct Reader {
  std::function<std::optional<double>(const Owner&)> read;
  Reach delivery = Reach::numbers;
};

/// Access to a quantity of its owner: made by `of`, see record_table.h.
template <class Owner>
struct Getter {
  Kind kind = Kind::number;
  /// SI value; absent if the case does not define it.
  std::optional<double> (*number)(const Owner&) = nullptr;
  /// One number per thread, SI; empty if the case does not define them.
  std::span<const double> (*series)(const Owner&) = nullptr;
  /// Any other value; null if the case does not define it.
  Json (*json)(const Owner&, const ShownUnit&) = nullptr;
  const RecordInfo& (*record)() = nullptr;  ///< Record of kinds record and records.
  /// Reader of a number in the result of `json`, behind the key, `.max`, `[2].thread`, ..; none if there cannot be one.
  std::optional<Reader<Owner>> (*reader)(std::string_view path, const ShownUnit&) = nullptr;
  Form form = {};
};

/// One row of the table.
template <class Owner>
struct Quantity {
  /// Key with its unit: `peak_pressure_MPa`. The quantities of a record without key are listed among those of its
  /// owner.
  std::string_view key;
  Getter<Owner> value;
  std::string_view meaning = {};   ///< A sentence or a formula; `a | b`: all possible words of a text.
  std::string_view source = {};    ///< Paper and equation, or a standard.
  std::string_view title = {};     ///< Title in tables; default: the words of the key.
  std::string_view group = {};     ///< Heading above neighbouring quantities.
  std::string_view validity = {};  ///< Limits of validity that a reader must know.
  Reach delivery = Reach::numbers;
  const ShownUnit& unit = unit_of(key);  ///< kNoUnit: that of the enclosing record, if any.

  const ShownUnit& shown_in(const ShownUnit& inherited) const {
    return unit.suffix.empty() && !is_ratio(key) ? inherited : unit;
  }
};

/// A quantity whose numbers are already in the unit of its key.
template <class Owner>
constexpr Quantity<Owner> as_shown(const Quantity<Owner>& q) {
  return {q.key, q.value, q.meaning, q.source, q.title, q.group, q.validity, q.delivery, kNoUnit};
}

/// A row without its owner.
struct QuantityInfo {
  std::string_view key;
  Kind kind = Kind::number;
  std::string title;
  std::string_view unit, meaning, source, group, validity;
  const RecordInfo& (*record)() = nullptr;
  Reach delivery = Reach::numbers;
  Form form = {};
};

struct RecordInfo {
  std::string_view name, meaning;
  std::vector<QuantityInfo> quantities;
};

/// Lower-case words of a key, without unit: `peak pressure` of `peak_pressure_MPa`.
std::string words_of(std::string_view key);

/// Removes `[k]` from the head of a path and returns k.
std::optional<std::size_t> take_index(std::string_view& path);

/// Operation that `[k]`, `.max`, `.min` or `.mean` after the key of a series does on its values, in the shown unit;
/// false for other words.
struct SeriesReader {
  enum class Word { none, one, largest, smallest, mean };

  Word word = Word::none;
  double factor = 1.0;    ///< Factor to the shown unit.
  std::size_t index = 0;  ///< Index of `one`.

  explicit operator bool() const { return word != Word::none; }
  std::optional<double> operator()(std::span<const double> values) const;
};
SeriesReader summary_named(std::string_view word, double factor);

/// Splits `[j][k]` into j and `[k]`; other words stay as they are.
struct RowOfWord {
  std::optional<std::size_t> row;
  std::string_view place;
};
RowOfWord split_row(std::string_view word);

/// The quantity with this key, which must exist.
template <class Owner>
const Quantity<Owner>& quantity(std::string_view key) {
  for (const Quantity<Owner>& q : record_of<Owner>().quantities)
    if (q.key == key) return q;
  throw std::logic_error(std::string("no quantity ").append(key));
}

template <class Owner>
std::string title_of(const Quantity<Owner>& q) {
  return q.title.empty() ? words_of(q.key) : std::string(q.title);
}

/// The number as documents show it.
template <class Owner>
std::optional<double> shown_number(const Quantity<Owner>& q, const Owner& owner, const ShownUnit& inherited = kNoUnit) {
  const std::optional<double> si = q.value.number(owner);
  if (!si || !std::isfinite(*si)) return std::nullopt;
  return *si * q.shown_in(inherited).factor;
}

}  // namespace prs
