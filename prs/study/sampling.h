#pragma once

#include "prs/model/study.h"

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

/// Numbers of the open unit interval for sampled plans. Each is a pure function of the seed, the
/// dimension (one per factor) and the sample's index, without a stream of states, so that samples
/// can be drawn in any order, in parts and again.

/// Independent numbers: the counter k of each dimension's own stream through the finaliser of
/// SplitMix64 (Steele, Lea & Flood 2014, OOPSLA, fig. 16).
double monte_carlo_number(std::uint64_t seed, std::size_t dimension, std::uint64_t k);

/// Latin hypercube of n samples, k < n: (pi(k) + xi)/n with a random permutation pi of the n strata
/// in each dimension and xi random within the stratum (McKay, Beckman & Conover 1979).
double latin_hypercube_number(std::uint64_t seed, std::size_t dimension, std::uint64_t k,
                              std::uint64_t n);

/// A random permutation of 0 .. n - 1 that a random key chooses, at k < n, in constant time and
/// memory: a Feistel network over the next power of two, repeated until it falls below n (Black &
/// Rogaway 2002, CT-RSA, "cycle walking").
std::uint64_t permuted(std::uint64_t key, std::uint64_t k, std::uint64_t n);

inline constexpr std::uint64_t kMostSobolSamples = std::uint64_t{1} << 32U;

/// Point k of Sobol's sequence in Gray-code order, 0 first, as a fraction of 2^64, with Boost's
/// direction numbers. dimension < kMostSobolDimensions, k < kMostSobolSamples.
std::uint64_t sobol_fraction(std::size_t dimension, std::uint64_t k);

/// The same, shifted digit by digit (exclusive or) by a random number of the seed and dimension:
/// every block of 2^m points remains a net, and each number on its own is uniform (L'Ecuyer &
/// Lemieux 2002).
double sobol_number(std::uint64_t seed, std::size_t dimension, std::uint64_t k);

/// Inverse of the standard normal distribution, 0 < u < 1.
double normal_quantile(double u);

}  // namespace prs
