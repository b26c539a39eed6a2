#include "prs/study/sampling.h"

#include <bit>
#include <boost/math/special_functions/erf.hpp>
#include <boost/random/sobol.hpp>
#include <cassert>
#include <numbers>

namespace prs {
namespace {

constexpr unsigned kBits = 32;  // Bits of the index of a Sobol point.

/// What numbers are drawn for: each purpose has streams of its own.
enum class Purpose : std::uint64_t { monte_carlo, strata, within_stratum, shift };

constexpr std::uint64_t key_of(std::uint64_t seed, std::size_t dimension, Purpose purpose) {
  const std::uint64_t stream = 4 * dimension + static_cast<std::uint64_t>(purpose);
  return mixed_bits(seed + (stream + 1) * kGoldenStep);
}

constexpr std::uint64_t random_bits(std::uint64_t key, std::uint64_t k) {
  return mixed_bits(key + (k + 1) * kGoldenStep);
}

/// The middle of the cell of width 2^-52 that the highest bits name: never 0, never 1.
constexpr double in_unit_interval(std::uint64_t bits) {
  return (static_cast<double>(bits >> 12U) + 0.5) * 0x1p-52;
}

/// Direction numbers of each dimension, that of the lowest bit of the index first. In Gray-code
/// order the point 2^b is the exclusive or of the numbers b and b - 1.
std::vector<std::uint64_t> direction_numbers() {
  std::vector<std::uint64_t> numbers(kMostSobolDimensions * kBits);
  boost::random::sobol points(kMostSobolDimensions);
  for (unsigned b = 0; b < kBits; ++b) {
    points.seed((std::uint64_t{1} << b) - 1);  // Boost leaves out the point 0.
    for (std::size_t d = 0; d < kMostSobolDimensions; ++d) {
      std::uint64_t* const own = &numbers[d * kBits];
      own[b] = points() ^ (b > 0 ? own[b - 1] : 0);
    }
  }
  return numbers;
}

}  // namespace

double monte_carlo_number(std::uint64_t seed, std::size_t dimension, std::uint64_t k) {
  return in_unit_interval(random_bits(key_of(seed, dimension, Purpose::monte_carlo), k));
}

std::uint64_t permuted(std::uint64_t key, std::uint64_t k, std::uint64_t n) {
  assert(k < n);
  if (n == 1) return 0;
  const auto bits = static_cast<unsigned>(std::bit_width(n - 1));
  const unsigned low_bits = (bits + 1) / 2;
  const std::uint64_t low_mask = (std::uint64_t{1} << low_bits) - 1;
  const std::uint64_t high_mask = (std::uint64_t{1} << (bits - low_bits)) - 1;
  const std::uint64_t rounds = bits < 8 ? 32 : 8;  // Short numbers mix slowly.
  do {
    std::uint64_t low = k & low_mask, high = k >> low_bits;
    for (std::uint64_t round = 0; round < rounds; round += 2) {
      low ^= mixed_bits(key + ((high << 5U) | round) * kGoldenStep) & low_mask;
      high ^= mixed_bits(key + ((low << 5U) | (round + 1)) * kGoldenStep) & high_mask;
    }
    k = (high << low_bits) | low;
  } while (k >= n);
  return k;
}

double latin_hypercube_number(std::uint64_t seed, std::size_t dimension, std::uint64_t k,
                              std::uint64_t n) {
  const std::uint64_t stratum = permuted(key_of(seed, dimension, Purpose::strata), k, n);
  const std::uint64_t bits = random_bits(key_of(seed, dimension, Purpose::within_stratum), k);
  // 32 bits within the stratum: the sum with its index does not round up to the next one.
  const double within = (static_cast<double>(bits >> 32U) + 0.5) * 0x1p-32;
  return (static_cast<double>(stratum) + within) / static_cast<double>(n);
}

std::uint64_t sobol_fraction(std::size_t dimension, std::uint64_t k) {
  assert(dimension < kMostSobolDimensions && k < kMostSobolSamples);
  static const std::vector<std::uint64_t> numbers = direction_numbers();
  const std::uint64_t* const own = &numbers[dimension * kBits];
  std::uint64_t fraction = 0;
  for (std::uint64_t bits = k ^ (k >> 1U); bits != 0; bits &= bits - 1)
    fraction ^= own[std::countr_zero(bits)];
  return fraction;
}

double sobol_number(std::uint64_t seed, std::size_t dimension, std::uint64_t k) {
  const std::uint64_t shift = key_of(seed, dimension, Purpose::shift);
  return in_unit_interval(sobol_fraction(dimension, k) ^ shift);
}

double normal_quantile(double u) {
  namespace policies = boost::math::policies;
  constexpr policies::policy<policies::promote_double<false>> in_double;
  return -std::numbers::sqrt2 * boost::math::erfc_inv(2.0 * u, in_double);
}

}  // namespace prs
