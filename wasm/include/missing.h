#pragma once

/// Parts of C++20 that the libraries of emscripten lack: std::from_chars of double, which libc++ has as of 20; in
/// libc++ 13 of Debian 12 also the algorithms of std::ranges that this project uses, std::bit_cast and comparison of
/// texts by
/// `<=>`. Included before every source, by emscripten only.

#include <algorithm>
#include <charconv>
#include <compare>
#include <concepts>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <ranges>
#include <string>
#include <string_view>
#include <utility>

#include <fast_float/fast_float.h>

namespace std {

#if _LIBCPP_VERSION < 200000
inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  // Both functions accept `inf`, `nan` and no leading `+`.
  const auto [end, error] = fast_float::from_chars(first, last, value);
  return {end, error};
}
#endif

#if _LIBCPP_VERSION < 16000
template <class To, class From>
constexpr To bit_cast(const From& value) noexcept {
  return __builtin_bit_cast(To, value);
}

constexpr strong_ordering operator<=>(string_view a, string_view b) noexcept { return a.compare(b) <=> 0; }
inline strong_ordering operator<=>(const string& a, const string& b) noexcept { return a.compare(b) <=> 0; }

namespace ranges {

namespace prs_missing {

template <class P>
constexpr auto projected_to(auto& predicate, P& projection) {
  return [&](auto&& value) -> bool {
    return std::invoke(predicate, std::invoke(projection, std::forward<decltype(value)>(value)));
  };
}

template <class C, class P>
constexpr auto compared_by(C& compare, P& projection) {
  return [&](auto&& a, auto&& b) -> bool {
    return std::invoke(compare, std::invoke(projection, std::forward<decltype(a)>(a)),
                       std::invoke(projection, std::forward<decltype(b)>(b)));
  };
}

/// An algorithm NAME with a predicate, by that on iterators.
#define PRS_OF_PREDICATE(NAME)                                                   \
  struct NAME##_fn {                                                             \
    template <class R, class F, class P = std::identity>                         \
    constexpr auto operator()(R&& r, F f, P p = {}) const {                      \
      return std::NAME(ranges::begin(r), ranges::end(r), projected_to(f, p));    \
    }                                                                            \
    template <std::input_or_output_iterator I, class F, class P = std::identity> \
    constexpr auto operator()(I first, I last, F f, P p = {}) const {            \
      return std::NAME(first, last, projected_to(f, p));                         \
    }                                                                            \
  };
PRS_OF_PREDICATE(all_of)
PRS_OF_PREDICATE(any_of)
PRS_OF_PREDICATE(none_of)
PRS_OF_PREDICATE(find_if)
PRS_OF_PREDICATE(count_if)
#undef PRS_OF_PREDICATE

/// An algorithm NAME with an order, by that on iterators.
#define PRS_OF_ORDER(NAME)                                                   \
  struct NAME##_fn {                                                         \
    template <class R, class C = ranges::less, class P = std::identity>      \
    constexpr auto operator()(R&& r, C c = {}, P p = {}) const {             \
      return std::NAME(ranges::begin(r), ranges::end(r), compared_by(c, p)); \
    }                                                                        \
  };
PRS_OF_ORDER(is_sorted)
PRS_OF_ORDER(max_element)
PRS_OF_ORDER(min_element)
PRS_OF_ORDER(sort)
PRS_OF_ORDER(stable_sort)
#undef PRS_OF_ORDER

/// An algorithm NAME of a range with further arguments, by that on iterators.
#define PRS_OF_RANGE(NAME)                                                       \
  struct NAME##_fn {                                                             \
    template <class R, class... A>                                               \
    constexpr auto operator()(R&& r, A&&... a) const {                           \
      return std::NAME(ranges::begin(r), ranges::end(r), std::forward<A>(a)...); \
    }                                                                            \
  };
PRS_OF_RANGE(adjacent_find)
PRS_OF_RANGE(copy)
PRS_OF_RANGE(copy_if)
PRS_OF_RANGE(fill)
PRS_OF_RANGE(for_each)
PRS_OF_RANGE(move)
PRS_OF_RANGE(replace)
PRS_OF_RANGE(replace_if)
PRS_OF_RANGE(reverse)
PRS_OF_RANGE(transform)
#undef PRS_OF_RANGE

struct minmax_element_fn {
  template <class R, class C = ranges::less, class P = std::identity>
  constexpr auto operator()(R&& r, C c = {}, P p = {}) const {
    const auto [least, largest] = std::minmax_element(ranges::begin(r), ranges::end(r), compared_by(c, p));
    struct result {
      decltype(ranges::begin(r)) min, max;
    };
    return result{least, largest};
  }
};

template <class R>
using value_of = std::iter_value_t<decltype(ranges::begin(std::declval<R&>()))>;

struct max_fn {
  template <class R, class C = ranges::less, class P = std::identity>
  constexpr value_of<R> operator()(R&& r, C c = {}, P p = {}) const {
    return *max_element_fn{}(r, c, p);
  }
};

struct min_fn {
  template <class R, class C = ranges::less, class P = std::identity>
  constexpr value_of<R> operator()(R&& r, C c = {}, P p = {}) const {
    return *min_element_fn{}(r, c, p);
  }
};

struct minmax_fn {
  template <class R, class C = ranges::less, class P = std::identity>
  constexpr auto operator()(R&& r, C c = {}, P p = {}) const {
    const auto [least, largest] = minmax_element_fn{}(r, c, p);
    struct result {
      value_of<R> min, max;
    };
    return result{*least, *largest};
  }
};

struct find_fn {
  template <class R, class T, class P = std::identity>
  constexpr auto operator()(R&& r, const T& value, P p = {}) const {
    return find_if_fn{}(
        r, [&](const auto& found) { return found == value; }, p);
  }
};

struct count_fn {
  template <class R, class T, class P = std::identity>
  constexpr auto operator()(R&& r, const T& value, P p = {}) const {
    const auto equal = [&](const auto& found) { return found == value; };
    return count_if_fn{}(r, equal, p);
  }
};

struct lower_bound_fn {
  template <class R, class T, class C = ranges::less, class P = std::identity>
  constexpr auto operator()(R&& r, const T& value, C c = {}, P p = {}) const {
    return std::lower_bound(ranges::begin(r), ranges::end(r), value,
                            [&](const auto& a, const T& b) -> bool { return std::invoke(c, std::invoke(p, a), b); });
  }
};

struct upper_bound_fn {
  template <class R, class T, class C = ranges::less, class P = std::identity>
  constexpr auto operator()(R&& r, const T& value, C c = {}, P p = {}) const {
    return std::upper_bound(ranges::begin(r), ranges::end(r), value,
                            [&](const T& a, const auto& b) -> bool { return std::invoke(c, a, std::invoke(p, b)); });
  }
};

struct equal_fn {
  template <class A, class B, class F = ranges::equal_to>
  constexpr bool operator()(A&& a, B&& b, F f = {}) const {
    return std::equal(ranges::begin(a), ranges::end(a), ranges::begin(b), ranges::end(b), f);
  }
};

}  // namespace prs_missing

inline namespace prs_functions {
inline constexpr prs_missing::adjacent_find_fn adjacent_find;
inline constexpr prs_missing::all_of_fn all_of;
inline constexpr prs_missing::any_of_fn any_of;
inline constexpr prs_missing::copy_fn copy;
inline constexpr prs_missing::copy_if_fn copy_if;
inline constexpr prs_missing::count_fn count;
inline constexpr prs_missing::count_if_fn count_if;
inline constexpr prs_missing::equal_fn equal;
inline constexpr prs_missing::fill_fn fill;
inline constexpr prs_missing::find_fn find;
inline constexpr prs_missing::find_if_fn find_if;
inline constexpr prs_missing::for_each_fn for_each;
inline constexpr prs_missing::is_sorted_fn is_sorted;
inline constexpr prs_missing::lower_bound_fn lower_bound;
inline constexpr prs_missing::max_element_fn max_element;
inline constexpr prs_missing::max_fn max;
inline constexpr prs_missing::min_element_fn min_element;
inline constexpr prs_missing::min_fn min;
inline constexpr prs_missing::minmax_element_fn minmax_element;
inline constexpr prs_missing::minmax_fn minmax;
inline constexpr prs_missing::move_fn move;
inline constexpr prs_missing::none_of_fn none_of;
inline constexpr prs_missing::replace_fn replace;
inline constexpr prs_missing::replace_if_fn replace_if;
inline constexpr prs_missing::reverse_fn reverse;
inline constexpr prs_missing::sort_fn sort;
inline constexpr prs_missing::stable_sort_fn stable_sort;
inline constexpr prs_missing::transform_fn transform;
inline constexpr prs_missing::upper_bound_fn upper_bound;
}  // namespace prs_functions

}  // namespace ranges
#endif

}  // namespace std
