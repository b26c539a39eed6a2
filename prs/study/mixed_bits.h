#pragma once

#include <cstdint>

namespace prs {

/// Step of a counter whose values are mixed: 2^64 over the golden ratio.
inline constexpr std::uint64_t kGoldenStep = 0x9E3779B97F4A7C15U;

/// SplitMix64's finaliser (Steele et al. 2014): a permutation of the 64-bit numbers whose output
/// looks random.
constexpr std::uint64_t mixed_bits(std::uint64_t x) {
  x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
  x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
  return x ^ (x >> 31U);
}

}  // namespace prs
