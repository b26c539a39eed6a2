#pragma once

#include <limits>

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

/// Independent numbers in the open unit interval: the counter k of each dimension's own stream through the finaliser of
/// SplitMix64 (Steele, Lea & Flood 2014, OOPSLA, fig. 16).
double monte_carlo_number(std::uint64_t seed, std::size_t dimension, std::uint64_t k);

/// Latin hypercube of n samples, k < n: (pi(k) + xi)/n with a random permutation pi of the n strata
/// in each dimension and xi random within the stratum (McKay, Beckman & Conover 1979).
double latin_hypercube_number(std::uint64_t seed, std::size_t dimension, std::uint64_t k, std::uint64_t n);

/// A random permutation of 0 .. n - 1 that a random key chooses, at k < n, in constant time and
/// memory: a Feistel network over the next power of two, repeated until it falls below n (Black &
/// Rogaway 2002, CT-RSA, "cycle walking").
std::uint64_t permuted(std::uint64_t key, std::uint64_t k, std::uint64_t n);

inline constexpr std::uint64_t kMostSobolSamples = std::uint64_t{1} << 32U;

/// Point k of Sobol's sequence in Gray-code order, 0 first, as a fraction of 2^64, with Boost's
/// direction numbers. dimension < kMostSobolDimensions, k < kMostSobolSamples.
std::uint64_t sobol_fraction(std::size_t dimension, std::uint64_t k);

/// Point of Sobol's sequence, shifted digit by digit (exclusive or) by a random number of the seed and dimension: every
/// block of 2^m points remains a net, and each number on its own is uniform (L'Ecuyer & Lemieux 2002).
double sobol_number(std::uint64_t seed, std::size_t dimension, std::uint64_t k);

/// Inverse of the standard normal distribution, 0 < u < 1.
double normal_quantile(double u);

/// Value of a response that a design does not have.
inline constexpr double kNoResponse = std::numeric_limits<double>::quiet_NaN();

/// Path or label of a factor, for a block that of its list.
std::string path_of_block(const Study& study, std::size_t factor);
std::string label_of_block(const Study& study, std::size_t factor);

/// Blocks that a plan of tolerances halves, see `blocks_of`.
std::vector<std::size_t> halved_blocks(const Study& study);

/// Number of designs, the base case included.
std::size_t design_count(const Study& study);

/// Values of design k, one per factor; the base case is the first. A pure function of the study, so
/// that designs can be run in any order, in parts and again.
std::vector<Draw> draws(const Study& study, std::size_t k);
/// Values of design k, written into memory that is kept.
void set_draws(const Study& study, std::size_t k, std::vector<Draw>& draws);

/// The value of an input after a draw, as in a file; the file's own if the draw leaves it, absent if the file has none
/// either.
std::optional<Level> value_in(const Factor& input, const Draw& draw);

/// Settings of design k, with the values as texts.
Design design(const Study& study, std::size_t k);
Design design(const Study& study, const std::vector<Draw>& draws);

/// Whether every value of a design is that of the file.
bool is_base(const Study& study, const Design& design);

/// The settings as `--set` takes them: `mechanism.rollers=9`.
std::vector<std::string> overrides(const Study& study, const Design& design);
std::vector<std::string> overrides(const Study& study, const std::vector<Draw>& draws);

/// A factor or companion as a column of a file: numbers in its unit or, if its values are words, their indices.
struct FactorColumn {
  std::string name;                ///< Path with the unit: `mechanism.lead_mm`
  std::vector<std::string> words;  ///< Empty if the values are numbers.
  double base = 0.0;               ///< Value in the file; NaN if there is none.

  bool is_numeric() const { return words.empty(); }
};

/// A column for each of `drawn_inputs`; a number distinguishes it from a response or another one of the same name.
std::vector<FactorColumn> factor_columns(const Study& study);

/// Values set in designs [first, first + count): count x columns.
std::vector<double> factor_values(const Study& study, const std::vector<FactorColumn>& columns, std::size_t first,
                                  std::size_t count);

/// A unit in the form of keys: `N/mm^1.5` is `N_per_mm1_5`.
std::string unit_key(const std::string& unit);

/// Designs [first, first + count) of a study.
struct DesignRange {
  std::size_t first = 0;
  std::size_t count = 0;

  std::size_t end() const { return first + count; }
  bool operator==(const DesignRange&) const = default;
};

/// One of `count` equal parts of a study, which run independently.
struct Shard {
  std::size_t index = 0;  ///< Index from 0; people and files count from 1.
  std::size_t count = 1;

  bool operator==(const Shard&) const = default;
};

inline constexpr std::size_t kMostShards = 1'000'000;

/// Shard of a text `3/8`, the third of eight, from 1/8 to 8/8. Absent for other texts.
std::optional<Shard> parse_shard(std::string_view text);

/// `3/8`
std::string name(Shard shard);

/// Designs of a shard: consecutive ones, as many as those of any other shard or one more.
DesignRange part(std::size_t designs, Shard shard);

/// Designs of `all` that are in none of the ranges. These may overlap and be in any order.
std::vector<DesignRange> missing(DesignRange all, std::vector<DesignRange> ranges);

/// Number of designs in disjoint ranges.
std::size_t count(const std::vector<DesignRange>& ranges);

/// Outcome of a design.
struct DesignStatus {
  /// `refused` (the case describes no mechanism), `failed` (unknown reason), or the outcome of the first load case that
  /// did not converge.
  std::string name = "converged";
  std::string reason = {};  ///< Empty if converged.

  bool converged() const { return name == "converged"; }
};

/// Results of consecutive designs of a study.
struct RowBlock {
  /// A design without a result.
  struct Failure {
    std::size_t row = 0;  ///< Row in the block.
    DesignStatus status;
  };

  std::size_t first = 0;          ///< Index of the first design.
  std::size_t rows = 0;           ///< Number of designs.
  std::vector<double> responses;  ///< rows x responses; NaN if a design has none.
  std::vector<Failure> failures;  ///< Ascending; all other designs converged.

  DesignStatus status(std::size_t row) const;
};

}  // namespace prs
