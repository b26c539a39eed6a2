#pragma once

#include "simd/inlined.h"
#include "simd/lanes.h"

/// simd/lanes.h with one chain per lane, and loops that the compiler unrolls.
namespace fe {

template <int I>
using Index = std::integral_constant<int, I>;

/// Calls f(Index<0>), f(Index<1>), .. f(Index<N - 1>), unrolled by the compiler.
template <int N, class F>
PRS_INLINED inline void unroll(F&& f) {
  [&]<int... I>(std::integer_sequence<int, I...>) PRS_INLINED { (f(Index<I>{}), ...); }
  (std::make_integer_sequence<int, N>{});
}

using simd::select, simd::any, simd::sqrt, simd::abs, simd::max, simd::min, simd::cbrt;

/// The larger of both; NaN if `a` or `b` is.
template <class Real>
PRS_INLINED inline Real largest(const Real& a, const Real& b) {
  return select(b <= a, a, select(a <= b, b, a + b));
}

using simd::Lanes;

template <class Real, int N>
PRS_INLINED inline void set_zero(Real (&values)[N]) {
  unroll<N>([&](auto i) PRS_INLINED { values[i] = Real(0.0); });
}

}  // namespace fe
