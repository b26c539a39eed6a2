#pragma once

#include <type_traits>
#include <utility>

/// Arithmetic that reads alike for a number and for a batch of numbers, one lane per chain.
namespace fe {

template <int I>
using Index = std::integral_constant<int, I>;

/// f(Index<0>), f(Index<1>), .. f(Index<N - 1>), written out by the compiler.
template <int N, class F>
[[gnu::always_inline]] inline void unroll(F&& f) {
  [&]<int... I>(std::integer_sequence<int, I...>) __attribute__((always_inline)) {
    (f(Index<I>{}), ...);
  }
  (std::make_integer_sequence<int, N>{});
}

/// The operations that batches have, for single numbers.
[[gnu::always_inline]] inline double select(bool condition, double a, double b) {
  return condition ? a : b;
}
[[gnu::always_inline]] inline bool any(bool condition) { return condition; }
[[gnu::always_inline]] inline double sqrt(double x) { return __builtin_sqrt(x); }
[[gnu::always_inline]] inline double abs(double x) { return __builtin_fabs(x); }
[[gnu::always_inline]] inline double max(double a, double b) { return a > b ? a : b; }
[[gnu::always_inline]] inline double min(double a, double b) { return a < b ? a : b; }
[[gnu::always_inline]] inline double cbrt(double x) { return __builtin_cbrt(x); }

/// The larger of both; keeps a NaN in `a` or `b`.
template <class Real>
[[gnu::always_inline]] inline Real largest(const Real& a, const Real& b) {
  return select(b <= a, a, select(a <= b, b, a + b));
}

/// Yes or no for each lane.
template <class Real>
using Lanes = decltype(Real() < Real());

template <class Real, int N>
[[gnu::always_inline]] inline void set_zero(Real (&values)[N]) {
  unroll<N>([&](auto i) __attribute__((always_inline)) { values[i] = Real(0.0); });
}

}  // namespace fe
