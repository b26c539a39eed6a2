#pragma once

#include <bit>
#include <xsimd/xsimd.hpp>

#include "simd/dual.h"
#include "simd/inlined.h"

namespace simd {

/// asinh(x) for a batch of numbers x >= 0, accurate to 1e-15 relative: with u = x + sqrt(1 + x^2) = 2^k m and m near 1,
///
///     asinh x = k ln 2 + 2 artanh(s),   s = (m - 1)/(m + 1), or x/(1 + sqrt(1 + x^2)) for k = 0,
///
/// and for the remainder of artanh the polynomial of fdlibm's logarithm (Sun Microsystems 1993).
template <class Arch>
PRS_INLINED inline xsimd::batch<double, Arch> asinh_of_positive(const xsimd::batch<double, Arch>& x,
                                                                const xsimd::batch<double, Arch>& root) {
  using Batch = xsimd::batch<double, Arch>;
  using Bits = xsimd::batch<std::uint64_t, Arch>;
  constexpr std::uint64_t kOne = 0x3ff0000000000000, kRootOfHalf = 0x3fe6a09e667f3bcd, kFraction = 0x000fffffffffffff,
                          kTwoTo52 = 0x4330000000000000;
  const Bits bits = std::bit_cast<Bits>(Batch(x + root)) + Bits(kOne - kRootOfHalf);
  const Batch exponent = std::bit_cast<Batch>((bits >> 52) | Bits(kTwoTo52)) - Batch(4503599627370496.0 + 1023.0);
  const Batch m = std::bit_cast<Batch>((bits & Bits(kFraction)) + Bits(kRootOfHalf));
  const auto small = exponent == Batch(0.0);
  const Batch s = select(small, x, m - 1.0) / (select(small, root, m) + 1.0);
  const Batch z = s * s;
  const Batch w = z * z;
  const Batch even = ((w * 1.531383769920937332e-01 + 2.222219843214978396e-01) * w + 3.999999999940941908e-01) * w;
  const Batch odd = (((w * 1.479819860511658591e-01 + 1.818357216161805012e-01) * w + 2.857142874366239149e-01) * w +
                     6.666666666666735130e-01) *
                    z;
  const Batch found = exponent * 0.693147180559945309417 + (2.0 * s + s * (even + odd));
  return select(x < Batch(1e300), found, x);
}

template <class Batch>
PRS_INLINED inline Batch asinh_of_positive(const Batch& x) {
  return asinh_of_positive(x, select(x < Batch(1e150), sqrt(x * x + 1.0), x));
}
template <class Batch>
PRS_INLINED inline Dual<Batch> asinh_of_positive(const Dual<Batch>& x) {
  const Batch root = select(x.value < Batch(1e150), sqrt(x.value * x.value + 1.0), x.value);
  return {asinh_of_positive(x.value, root), x.slope / root};
}

}  // namespace simd
