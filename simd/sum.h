#pragma once

namespace simd {

/// Sum of the numbers of a batch: `hadd` of xsimd 8, `reduce_add` since.
template <class Batch>
auto sum(const Batch& x) {
  if constexpr (requires { reduce_add(x); })
    return reduce_add(x);
  else
    return hadd(x);
}

}  // namespace simd
