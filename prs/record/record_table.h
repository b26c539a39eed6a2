#pragma once

#include <concepts>
#include <nlohmann/json.hpp>

#include "prs/record/csv_writer.h"
#include "prs/record/record.h"

namespace prs {

/// Sources that several tables of quantities cite.
namespace source {
inline constexpr std::string_view kHertz = "Hertz with exact ellipticity";
inline constexpr std::string_view kLife = "Jung 2017, (8.25); ISO 281";
}  // namespace source

/// Adds quantities of an object to a document, without absent and non-finite values.
template <class Owner>
void put_quantities(Json& document, std::span<const Quantity<Owner>> quantities, const Owner& owner,
                    const ShownUnit& inherited = kNoUnit);

/// Adds all quantities.
template <class Owner>
void put_object(Json& document, const Owner& owner) {
  put_quantities(document, record_of<Owner>().quantities, owner);
}

/// The document of an object.
template <class Owner>
Json object_of(const Owner& owner, const ShownUnit& inherited = kNoUnit);

/// The number at a path of the object's document: `slip.screw.power_W.max`.
template <class Owner>
std::optional<Reader<Owner>> reader_of(std::string_view path, const ShownUnit& inherited = kNoUnit);

/// The table as text.
template <class Owner>
const RecordInfo& describe();
template <class Owner>
RecordInfo described(std::string_view name, std::string_view meaning, std::span<const Quantity<Owner>> quantities);

namespace detail {

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;
template <class T>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<std::vector<T>> = true;
template <class T>
inline constexpr bool is_by_key = false;
template <class T>
inline constexpr bool is_by_key<ByKey<T>> = true;
template <class T>
inline constexpr bool is_whole_series = false;
template <std::integral T>
inline constexpr bool is_whole_series<std::vector<T>> = true;

template <class T>
concept Text = std::convertible_to<T, std::string_view> || std::is_enum_v<T>;
template <class T>
concept Numbers = requires(const T& values) {
  { *values.begin() } -> std::convertible_to<double>;
}
&&!Text<T>;

/// Pointer to the value; null if there is none.
template <class T>
const auto* pointer_to(const T& value) {
  if constexpr (is_optional<T>)
    return value ? &*value : nullptr;
  else if constexpr (std::is_pointer_v<T> && !Text<T>)
    return value;
  else
    return &value;
}

/// An empty object with capacity for this many entries; growing would copy them.
Json object_for(std::size_t entries);

Json array_of(std::span<const double> si, const ShownUnit& unit);
/// Array of rows of the given length; 0: one row.
Json arrays_of(std::span<const double> si, std::size_t row, const ShownUnit& unit);

/// Type held by an optional or a pointer.
template <class T>
using Held = std::remove_cvref_t<decltype(*pointer_to(std::declval<const T&>()))>;

template <class Owner>
concept HasRows = requires(const Owner& owner) {
  owner.threads_per_roller;
};

/// Length of the rows into which the owner's series are split; 0: one row.
template <class Owner>
std::size_t row_length(const Owner& owner) {
  if constexpr (HasRows<Owner>)
    return static_cast<std::size_t>(owner.threads_per_roller);
  else
    return 0;
}

template <class T>
Json json_of(const T& value, const ShownUnit& unit) {
  if constexpr (is_by_key<T>) {
    Json object = object_for(value.size());
    for (const auto& [key, held] : value)
      if (const auto* item = pointer_to(held))
        if (auto json = json_of(*item, unit); !json.is_null()) object[key] = std::move(json);
    return object;
  } else if constexpr (std::is_integral_v<T> || is_whole_series<T> || std::is_same_v<T, std::vector<std::string>>) {
    return value;
  } else if constexpr (std::is_floating_point_v<T>) {
    return std::isfinite(value) ? Json(value * unit.factor) : nullptr;
  } else if constexpr (std::is_enum_v<T>) {
    return std::string(name(value));
  } else if constexpr (Text<T>) {
    return std::string(value);
  } else if constexpr (Numbers<T>) {
    return array_of(std::vector<double>(value.begin(), value.end()), unit);
  } else if constexpr (is_vector<T>) {
    auto array = Json::array();
    for (const auto& item : value) array.push_back(json_of(item, unit));
    return array;
  } else {
    return object_of(value, unit);
  }
}

template <class T>
constexpr Kind kind_of() {
  if constexpr (is_by_key<T>)
    return kind_of<Held<typename T::value_type::second_type>>();
  else if constexpr (std::is_same_v<T, bool>)
    return Kind::flag;
  else if constexpr (std::is_integral_v<T>)
    return Kind::count;
  else if constexpr (std::is_floating_point_v<T>)
    return Kind::number;
  else if constexpr (Text<T>)
    return Kind::text;
  else if constexpr (std::is_same_v<T, std::vector<std::string>>)
    return Kind::texts;
  else if constexpr (Numbers<T>)
    return Kind::series;
  else if constexpr (is_vector<T>)
    return Numbers<typename T::value_type> ? Kind::matrix : Kind::records;
  else
    return Kind::record;
}

/// Reads a series with the word after it, see `summary_named`.
template <class T>
std::optional<Reader<T>> series_reader(std::string_view word, double factor) {
  const SeriesReader read = summary_named(word, factor);
  if (!read) return std::nullopt;
  return Reader<T>{[read](const T& values) { return read({values.data(), static_cast<std::size_t>(values.size())}); }};
}

/// Reads rows of numbers: `[j]` and a word for one of them, or a word for all.
template <class T>
std::optional<Reader<T>> matrix_reader(std::string_view path, double factor) {
  const std::optional<std::size_t> row = take_index(path);
  const SeriesReader read = row || !path.starts_with('[') ? summary_named(path, factor) : SeriesReader();
  if (!read) return std::nullopt;
  return Reader<T>{[read, row](const T& rows) -> std::optional<double> {
    if (row) return *row < rows.size() ? read(rows[*row]) : std::nullopt;
    std::vector<double> all;
    for (const auto& values : rows) all.insert(all.end(), values.begin(), values.end());
    return read(all);
  }};
}

/// The number at the path after the key of an item: `.screw.max`, `[2].thread`, or empty.
template <class T>
std::optional<Reader<T>> item_reader(std::string_view path, const ShownUnit& unit) {
  if constexpr (is_by_key<T> || std::is_same_v<T, bool> || Text<T> || std::is_same_v<T, std::vector<std::string>>) {
    return std::nullopt;
  } else if constexpr (std::is_integral_v<T>) {
    if (!path.empty()) return std::nullopt;
    return Reader<T>{[](const T& value) { return std::optional(static_cast<double>(value)); }};
  } else if constexpr (is_whole_series<T>) {
    const SeriesReader read = summary_named(path, 1.0);
    if (!read) return std::nullopt;
    return Reader<T>{[read](const T& values) { return read(std::vector<double>(values.begin(), values.end())); }};
  } else if constexpr (Numbers<T>) {
    return series_reader<T>(path, unit.factor);
  } else if constexpr (is_vector<T>) {
    using Inner = typename T::value_type;
    if constexpr (Numbers<Inner>) {
      return matrix_reader<T>(path, unit.factor);
    } else {
      const std::optional<std::size_t> index = take_index(path);
      std::optional<Reader<Inner>> inner = index ? item_reader<Inner>(path, unit) : std::optional<Reader<Inner>>();
      if (!inner) return std::nullopt;
      return Reader<T>{[index, read = std::move(inner->read)](const T& items) {
                         return *index < items.size() ? read(items[*index]) : std::nullopt;
                       },
                       inner->delivery};
    }
  } else {
    return path.starts_with('.') ? reader_of<T>(path.substr(1), unit) : std::nullopt;
  }
}

/// Result of `get` for an owner, if `guard` is true of it.
template <auto get, auto guard, bool always, class Owner>
struct Access {
  using Given = std::invoke_result_t<decltype(get), const Owner&>;
  using Item = Held<std::remove_cvref_t<Given>>;

  static constexpr bool kGuarded = !std::is_null_pointer_v<std::remove_cv_t<decltype(guard)>>;
  static constexpr bool kOptional = kGuarded || !std::is_same_v<Item, std::remove_cvref_t<Given>>;

  static bool defined(const Owner& owner) {
    if constexpr (!kGuarded)
      return true;
    else
      return std::invoke(guard, owner);
  }

  /// Result of `use` for the item; `otherwise` if there is none.
  template <class T>
  static T used(const Owner& owner, T otherwise, const auto& use) {
    if (!defined(owner)) return otherwise;
    const auto& given = std::invoke(get, owner);
    const auto* item = pointer_to(given);
    return item ? use(*item) : otherwise;
  }

  static std::optional<double> number(const Owner& owner) {
    return used(owner, std::optional<double>(), [](double value) { return std::optional(value); });
  }

  static std::span<const double> series(const Owner& owner) {
    return used(owner, std::span<const double>(), [](const std::vector<double>& values) { return std::span(values); });
  }

  static Json json(const Owner& owner, const ShownUnit& unit) {
    return used(owner, Json(), [&](const Item& item) { return json_of(item, unit); });
  }

  static std::optional<Reader<Owner>> reader(std::string_view path, const ShownUnit& unit) {
    const std::optional<Reader<Item>> inner = item_reader<Item>(path, unit);
    if (!inner) return std::nullopt;
    return Reader<Owner>{
        [read = inner->read](const Owner& owner) { return used(owner, std::optional<double>(), read); },
        inner->delivery};
  }

  static constexpr Getter<Owner> getter() {
    constexpr Kind kind = kind_of<Item>();
    // An array that outlives the call is read in place.
    constexpr bool in_place = std::is_same_v<Item, std::vector<double>> && std::is_reference_v<Given>;
    Getter<Owner> getter{kind};
    getter.form = {.required = always && !kGuarded,
                   .finite = always,
                   .whole = is_whole_series<Item>,
                   .in_rows = in_place && HasRows<Owner>,
                   .by_key = is_by_key<Item>,
                   .optional = kOptional};
    if constexpr (kind == Kind::number && !is_by_key<Item>) {
      getter.number = number;
    } else if constexpr (kind == Kind::series && in_place) {
      getter.series = series;
    } else {
      getter.json = json;
      getter.reader = reader;
      if constexpr (is_by_key<Item>) {
        if constexpr (kind == Kind::record) getter.record = describe<Held<typename Item::value_type::second_type>>;
      } else if constexpr (kind == Kind::record) {
        getter.record = describe<Item>;
      } else if constexpr (kind == Kind::records) {
        getter.record = describe<typename Item::value_type>;
      }
    }
    return getter;
  }
};

template <auto get, auto guard, bool always = false>
struct Of {
  template <class Owner>
  constexpr operator Getter<Owner>() const {
    return Access<get, guard, always, Owner>::getter();
  }
};

template <const auto& quantities, class T>
Json json_by(const T& value, const ShownUnit& unit) {
  if constexpr (is_by_key<T>) {
    Json object = object_for(value.size());
    for (const auto& [key, held] : value) object[key] = json_by<quantities>(held, unit);
    return object;
  } else if constexpr (is_vector<T>) {
    auto array = Json::array();
    for (const auto& held : value) array.push_back(json_by<quantities>(held, unit));
    return array;
  } else {
    Json object = object_for(std::size(quantities));
    put_quantities<T>(object, quantities, value, unit);
    return object;
  }
}

template <class Owner, std::size_t n>
Owner owner_of(const Quantity<Owner> (&)[n]);

template <const auto& quantities, auto get, auto guard, bool always>
struct OfTable {
  template <class Owner>
  constexpr operator Getter<Owner>() const {
    using All = Access<get, guard, always, Owner>;
    using Item = typename All::Item;
    Getter<Owner> getter{is_vector<Item> && !is_by_key<Item> ? Kind::records : Kind::record};
    getter.form = {.required = always, .by_key = is_by_key<Item>, .optional = All::kOptional};
    getter.json = [](const Owner& owner, const ShownUnit& unit) {
      return All::used(owner, Json(), [&](const Item& item) { return json_by<quantities>(item, unit); });
    };
    getter.record = []() -> const RecordInfo& {
      static const RecordInfo info = described<decltype(owner_of(quantities))>({}, {}, quantities);
      return info;
    };
    return getter;
  }
};

}  // namespace detail

/// Getter `of<&InterfaceLoads::axial_load>`, or of a function of the owner; not defined where `guard` is false. The
/// type decides the kind: a number in SI, a vector with one number per thread, a text, an enum that has a `name`, a
/// result type with a list of its own, std::optional of these, ..
template <auto get, auto guard = nullptr>
inline constexpr detail::Of<get, guard> of;

/// Like `of`, for quantities of every document; with a guard: a series without missing numbers.
template <auto get, auto guard = nullptr>
inline constexpr detail::Of<get, guard, true> always;

template <auto get>
inline constexpr auto is_filled = [](const auto& owner) { return !std::invoke(get, owner).empty(); };

/// Like `of`; absent if it is empty.
template <auto get>
inline constexpr auto filled = of<get, is_filled<get>>;

/// Getter of a record that occurs in one place only and has a list of quantities but no type of its own: an object, a
/// vector or values by key of the list's owner; by default of the owner itself.
template <const auto& quantities, auto get = std::identity{}, auto guard = nullptr>
inline constexpr detail::OfTable<quantities, get, guard, false> of_table;
template <const auto& quantities, auto get = std::identity{}>
inline constexpr detail::OfTable<quantities, get, nullptr, true> always_table;
template <const auto& quantities, auto get>
inline constexpr auto filled_table = of_table<quantities, get, is_filled<get>>;

/// Results of a function or a member for each item.
template <class F>
auto each(const auto& items, F f) {
  std::vector<std::decay_t<std::invoke_result_t<F, decltype(*std::begin(items))>>> all;
  for (const auto& item : items) all.push_back(std::invoke(f, item));
  return all;
}

/// A part of a result together with the whole, which has its names.
template <class Whole, class T>
struct Within {
  const Whole* whole = nullptr;
  const T* item = nullptr;
};
template <class Whole, class T>
std::vector<Within<Whole, T>> within(const Whole& whole, const std::vector<T>& items) {
  return each(items, [&](const T& item) { return Within<Whole, T>{&whole, &item}; });
}

/// Getter for the part: `of<its<&FactorEffect::coefficient>>`.
template <auto get>
inline constexpr auto its = [](const auto& part) -> decltype(auto) { return std::invoke(get, *part.item); };

/// Pairs of keys and values.
template <class T>
ByKey<T> by_key(const std::vector<std::string>& keys, const std::vector<T>& values) {
  ByKey<T> all;
  for (std::size_t k = 0; k < values.size(); ++k) all.emplace_back(keys[k], values[k]);
  return all;
}

/// Column for one part, interface or direction.
template <auto member, auto side>
inline constexpr auto of_side = of<[](const auto& owner) { return (owner.*member)[side]; }>;

template <class Owner>
void put_quantities(Json& document, std::span<const Quantity<Owner>> quantities, const Owner& owner,
                    const ShownUnit& inherited) {
  for (const Quantity<Owner>& q : quantities) {
    if (q.value.number) {
      if (const auto value = shown_number(q, owner, inherited)) document[q.key] = *value;
    } else if (q.value.series) {
      if (const auto series = q.value.series(owner); !series.empty())
        document[q.key] = detail::arrays_of(series, detail::row_length(owner), q.shown_in(inherited));
    } else if (Json json = q.value.json(owner, q.shown_in(inherited)); q.key.empty() && !json.is_null()) {
      document.update(json);
    } else if (!json.is_null()) {
      document[q.key] = std::move(json);
    }
  }
}

template <class Owner>
Json object_of(const Owner& owner, const ShownUnit& inherited) {
  const std::span<const Quantity<Owner>> quantities = record_of<Owner>().quantities;
  Json object = detail::object_for(quantities.size());
  put_quantities(object, quantities, owner, inherited);
  return object;
}

template <class Owner>
std::optional<Reader<Owner>> reader_of(std::string_view path, const ShownUnit& inherited) {
  for (const Quantity<Owner>& q : record_of<Owner>().quantities) {
    const ShownUnit& unit = q.shown_in(inherited);
    if (q.key.empty()) {
      if (!q.value.reader) continue;
      if (auto reader = q.value.reader("." + std::string(path), unit)) return reader;
      continue;
    }
    if (!path.starts_with(q.key)) continue;
    std::string_view rest = path.substr(q.key.size());
    if (!rest.empty() && rest.front() != '.' && rest.front() != '[') continue;
    if (q.value.number && rest.empty())
      return Reader<Owner>{[&q, &inherited](const Owner& owner) { return shown_number(q, owner, inherited); },
                           q.delivery};
    if (q.value.series) {
      const auto [row, place] = split_row(rest);
      if (const SeriesReader summary = summary_named(place, unit.factor))
        return Reader<Owner>{[&q, summary, row = row, indexed = place.starts_with('[')](const Owner& owner) {
                               const std::span<const double> values = q.value.series(owner);
                               const std::size_t length = detail::row_length(owner);
                               if (!row && (!indexed || length == 0)) return summary(values);
                               const bool there = row && length > 0 && *row < values.size() / length;
                               return there ? summary(values.subspan(*row * length, length)) : std::nullopt;
                             },
                             q.delivery};
    }
    std::optional<Reader<Owner>> reader;
    if (q.value.reader) reader = q.value.reader(rest, unit);
    if (reader) reader->delivery = std::max(reader->delivery, q.delivery);
    return reader;
  }
  return std::nullopt;
}

template <class Owner>
RecordInfo described(std::string_view name, std::string_view meaning, std::span<const Quantity<Owner>> quantities) {
  RecordInfo info{name, meaning, {}};
  for (const Quantity<Owner>& q : quantities)
    if (q.key.empty())
      for (QuantityInfo among : q.value.record().quantities) {
        among.form.required = among.form.required && q.value.form.required;
        among.form.optional = among.form.optional || q.value.form.optional;
        info.quantities.push_back(std::move(among));
      }
    else
      info.quantities.push_back({q.key, q.value.kind, title_of(q), q.unit.text, q.meaning, q.source, q.group,
                                 q.validity, q.value.record, q.delivery, q.value.form});
  return info;
}

template <class Owner>
const RecordInfo& describe() {
  static const RecordInfo info = [] {
    const Record<Owner> record = record_of<Owner>();
    return described(record.name, record.meaning, record.quantities);
  }();
  return info;
}

}  // namespace prs
