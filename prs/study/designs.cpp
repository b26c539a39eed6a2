#include "prs/study/designs.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <boost/math/special_functions/erf.hpp>
#include <boost/random/sobol.hpp>
#include <cassert>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>

#include "prs/indices.h"

namespace prs {
namespace {

constexpr unsigned kBits = 32;  // Bits of the index of a Sobol point.

/// Purpose of drawn numbers: each has separate streams.
enum class Purpose : std::uint64_t { monte_carlo, strata, within_stratum, shift };

constexpr std::uint64_t key_of(std::uint64_t seed, std::size_t dimension, Purpose purpose) {
  const std::uint64_t stream = 4 * dimension + static_cast<std::uint64_t>(purpose);
  return mixed_bits(seed + (stream + 1) * kGoldenStep);
}

constexpr std::uint64_t random_bits(std::uint64_t key, std::uint64_t k) {
  return mixed_bits(key + (k + 1) * kGoldenStep);
}

/// Middle of the cell of width 2^-52 given by the highest bits: never 0, never 1.
constexpr double in_unit_interval(std::uint64_t bits) { return (static_cast<double>(bits >> 12U) + 0.5) * 0x1p-52; }

/// Direction numbers of each dimension, that of the lowest bit of the index first. In Gray-code
/// order the point 2^b is the exclusive or of the numbers b and b - 1.
std::vector<std::uint64_t> direction_numbers() {
  std::vector<std::uint64_t> numbers(kMostSobolDimensions * kBits);
  boost::random::sobol points(kMostSobolDimensions);
  for (unsigned b = 0; b < kBits; ++b) {
    points.seed((std::uint64_t{1} << b) - 1);  // Boost leaves out the point 0.
    for (const auto d : up_to(kMostSobolDimensions)) {
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

double latin_hypercube_number(std::uint64_t seed, std::size_t dimension, std::uint64_t k, std::uint64_t n) {
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
  for (std::uint64_t bits = k ^ (k >> 1U); bits != 0; bits &= bits - 1) fraction ^= own[std::countr_zero(bits)];
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

namespace {

/// A design of a sampled plan: the sample, and the factors from Saltelli's second matrix.
struct Sample {
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  static constexpr std::size_t kAll = static_cast<std::size_t>(-2);

  std::size_t index = 0;
  std::size_t from_second = kNone;  ///< Block.
  std::size_t halved = kNone;       ///< Block whose deviation is halved, see `halved_blocks`.
};

/// Designs of each sample: one, or for `sobol_indices` A, B, and A with each column from B in turn (Saltelli et al.
/// 2010, Computer Physics Communications 181, table 2). For `tolerances` with all drawn, and with each block halved in
/// turn.
std::size_t designs_per_sample(const Study& study) {
  if (study.plan == Plan::tolerances) return 1 + halved_blocks(study).size();
  return study.plan == Plan::sobol_indices ? blocks_of(study).size() + 2 : 1;
}

Sample sample_of(const Study& study, std::size_t k) {
  const std::size_t each = designs_per_sample(study);
  const std::size_t which = (k - 1) % each;
  if (study.plan == Plan::tolerances)
    return {(k - 1) / each, Sample::kNone, which == 0 ? Sample::kNone : halved_blocks(study)[which - 1]};
  const std::size_t from_second = which == 0 ? Sample::kNone : which == 1 ? Sample::kAll : which - 2;
  return {(k - 1) / each, from_second, Sample::kNone};
}

/// Number in (0, 1) at which a factor lies in its distribution.
double share(const Study& study, std::size_t factor, std::size_t block, const Sample& sample) {
  switch (study.plan) {
    case Plan::latin_hypercube:
      return latin_hypercube_number(study.seed, factor, sample.index, study.samples);
    case Plan::monte_carlo:
    case Plan::tolerances:
      return monte_carlo_number(study.seed, factor, sample.index);
    case Plan::sobol_indices: {
      const bool second = sample.from_second == Sample::kAll || sample.from_second == block;
      return sobol_number(study.seed, factor + (second ? study.factors.size() : 0), sample.index);
    }
    default:
      return sobol_number(study.seed, factor, sample.index);
  }
}

Draw drawn(const Factor& factor, double share) {
  const auto& [kind, first, second] = factor.distribution;
  switch (kind) {
    case Distribution::Kind::uniform:
      return {.kind = Draw::Kind::number, .number = first + (second - first) * share};
    case Distribution::Kind::log_uniform:
      return {.kind = Draw::Kind::number, .number = first * std::pow(second / first, share)};
    case Distribution::Kind::normal:
      return {.kind = Draw::Kind::number, .number = first + second * normal_quantile(share)};
    case Distribution::Kind::levels:
      break;
  }
  const auto count = static_cast<double>(factor.levels.size());
  const auto level = static_cast<std::size_t>(share * count);
  return {.kind = Draw::Kind::level, .level = std::min(level, factor.levels.size() - 1)};
}

/// Draws the factor that varies in design k of `one_at_a_time`, and its level.
void draw_one(const Study& study, std::size_t k, std::vector<Draw>& draws) {
  std::size_t level = k - 1;
  std::size_t factor = 0;
  while (level >= study.factors[factor].levels.size()) level -= study.factors[factor++].levels.size();
  draws[factor] = {.kind = Draw::Kind::level, .level = level};
}

void draw_combination(const Study& study, std::size_t k, std::vector<Draw>& draws) {
  std::size_t combination = k - 1;
  for (std::size_t i = study.factors.size(); i-- > 0;) {
    const std::size_t count = study.factors[i].levels.size();
    draws[i] = {.kind = Draw::Kind::level, .level = combination % count};
    combination /= count;
  }
}

bool is_same(const Level& level, const std::optional<Level>& base) {
  if (!base) return false;
  return level.text == base->text || (level.number && level.number == base->number);
}

std::string override_text(const Factor& factor, const Level& level) {
  return fmt::format("{}={}", factor.path, level.text);
}

/// Removes a whole number from the head of a text and returns it.
std::optional<std::size_t> take_number(std::string_view& text) {
  std::size_t number = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{}) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  return number;
}

/// Possible words of a factor, that of the file among them.
std::vector<std::string> words_of(const Factor& factor) {
  std::vector<std::string> words;
  if (factor.is_numeric()) return words;
  for (const Level& level : factor.levels) words.push_back(level.text);
  if (factor.base && !contains(words, factor.base->text)) words.push_back(factor.base->text);
  return words;
}

FactorColumn column_of(const Factor& factor) {
  FactorColumn column{factor.path, words_of(factor), kNoResponse};
  if (column.is_numeric() && !factor.unit.empty()) column.name += "_" + unit_key(factor.unit);
  if (!factor.base) return column;
  if (column.is_numeric())
    column.base = factor.base->number.value_or(kNoResponse);
  else
    column.base = static_cast<double>(std::ranges::find(column.words, factor.base->text) - column.words.begin());
  return column;
}

double value_of(const Factor& factor, const FactorColumn& column, const Draw& draw) {
  switch (draw.kind) {
    case Draw::Kind::number:
      return draw.number;
    case Draw::Kind::level:
      return column.is_numeric() ? *factor.levels[draw.level].number : static_cast<double>(draw.level);
    case Draw::Kind::as_in_file:
      break;
  }
  return column.base;
}

}  // namespace

namespace {

std::string of_list(const Study& study, std::size_t factor, const std::string& of_entry) {
  const bool several = factor + 1 < study.factors.size() && study.factors[factor + 1].with_previous;
  return several ? of_entry.substr(0, of_entry.rfind('[')) : of_entry;
}

}  // namespace

std::string path_of_block(const Study& study, std::size_t factor) {
  return of_list(study, factor, study.factors[factor].path);
}
std::string label_of_block(const Study& study, std::size_t factor) {
  return of_list(study, factor, study.factors[factor].label);
}

std::vector<std::size_t> halved_blocks(const Study& study) {
  const std::vector<std::size_t> blocks = blocks_of(study);
  std::vector<std::size_t> halved;
  for (const auto b : indices(blocks))
    if (!study.factors[blocks[b]].kept) halved.push_back(b);
  return halved;
}

std::size_t design_count(const Study& study) {
  if (study.plan == Plan::derivatives) return 1;
  if (is_sampled(study.plan)) return 1 + study.samples * designs_per_sample(study);
  const bool grid = study.plan == Plan::grid;
  std::size_t count = grid ? 1 : 0;
  for (const Factor& factor : study.factors) count = grid ? count * factor.levels.size() : count + factor.levels.size();
  return 1 + count;
}

std::vector<Draw> draws(const Study& study, std::size_t k) {
  std::vector<Draw> draws;
  set_draws(study, k, draws);
  return draws;
}

void set_draws(const Study& study, std::size_t k, std::vector<Draw>& draws) {
  assert(k < design_count(study));
  draws.assign(study.factors.size(), {});
  if (k == 0) return;
  if (study.plan == Plan::one_at_a_time) {
    draw_one(study, k, draws);
  } else if (study.plan == Plan::grid) {
    draw_combination(study, k, draws);
  } else {
    const Sample sample = sample_of(study, k);
    std::size_t block = 0;
    for (const auto i : indices(draws)) {
      const Factor& factor = study.factors[i];
      if (i > 0 && !factor.with_previous) ++block;
      draws[i] = drawn(factor, share(study, i, block, sample));
      if (block == sample.halved && factor.base && factor.base->number)
        draws[i].number = *factor.base->number + 0.5 * (draws[i].number - *factor.base->number);
    }
  }
}

std::optional<Level> value_in(const Factor& input, const Draw& draw) {
  switch (draw.kind) {
    case Draw::Kind::number:
      return Level{fmt::format(FMT_COMPILE("{}{}{}"), draw.number, input.unit.empty() ? "" : " ", input.unit),
                   draw.number};
    case Draw::Kind::level:
      return input.levels[draw.level];
    case Draw::Kind::as_in_file:
      break;
  }
  return input.base;
}

Design design(const Study& study, std::size_t k) { return design(study, draws(study, k)); }

Design design(const Study& study, const std::vector<Draw>& draws) {
  assert(draws.size() == study.factors.size());
  Design design;
  design.settings.reserve(draws.size());
  for (const auto i : indices(draws)) {
    if (draws[i].kind == Draw::Kind::as_in_file) continue;
    const Factor& factor = study.factors[i];
    Setting setting{i, *value_in(factor, draws[i]), {}};
    for (const Factor& companion : factor.companions) setting.companions.push_back(*value_in(companion, draws[i]));
    design.settings.push_back(std::move(setting));
  }
  return design;
}

bool is_base(const Study& study, const Design& design) {
  return std::ranges::all_of(design.settings, [&](const Setting& setting) {
    const Factor& factor = study.factors[setting.factor];
    if (!is_same(setting.level, factor.base)) return false;
    for (const auto k : indices(factor.companions))
      if (!is_same(setting.companions[k], factor.companions[k].base)) return false;
    return true;
  });
}

std::vector<std::string> overrides(const Study& study, const Design& design) {
  std::vector<std::string> texts;
  for (const Setting& setting : design.settings) {
    const Factor& factor = study.factors[setting.factor];
    texts.push_back(override_text(factor, setting.level));
    for (const auto k : indices(factor.companions))
      texts.push_back(override_text(factor.companions[k], setting.companions[k]));
  }
  return texts;
}

std::vector<std::string> overrides(const Study& study, const std::vector<Draw>& draws) {
  return overrides(study, design(study, draws));
}

std::optional<Shard> parse_shard(std::string_view text) {
  const std::optional<std::size_t> index = take_number(text);
  if (!index || !text.starts_with('/')) return std::nullopt;
  text.remove_prefix(1);
  const std::optional<std::size_t> count = take_number(text);
  if (!count || !text.empty()) return std::nullopt;
  if (*index < 1 || *index > *count || *count > kMostShards) return std::nullopt;
  return Shard{*index - 1, *count};
}

std::string name(Shard shard) { return fmt::format("{}/{}", shard.index + 1, shard.count); }

DesignRange part(std::size_t designs, Shard shard) {
  const std::size_t share = designs / shard.count;
  const std::size_t longer = designs % shard.count;  // The first shards have one more.
  const std::size_t first = shard.index * share + std::min(shard.index, longer);
  return {first, share + (shard.index < longer ? 1 : 0)};
}

std::vector<DesignRange> missing(DesignRange all, std::vector<DesignRange> ranges) {
  std::ranges::sort(ranges, {}, &DesignRange::first);
  std::vector<DesignRange> gaps;
  std::size_t next = all.first;
  for (const DesignRange& range : ranges) {
    const std::size_t stop = std::min(range.first, all.end());
    if (stop > next) gaps.push_back({next, stop - next});
    next = std::max(next, range.end());
  }
  if (next < all.end()) gaps.push_back({next, all.end() - next});
  return gaps;
}

std::size_t count(const std::vector<DesignRange>& ranges) {
  std::size_t sum = 0;
  for (const DesignRange& range : ranges) sum += range.count;
  return sum;
}

std::string unit_key(const std::string& unit) {
  if (unit == "%") return "percent";
  std::string key;
  for (const char c : unit.starts_with("1/") ? unit.substr(1) : unit) {
    if (c == '/')
      key += key.empty() ? "per_" : "_per_";
    else if (c == '.')
      key += '_';
    else if (c != ' ' && c != '^')
      key += c;
  }
  return key;
}

std::vector<FactorColumn> factor_columns(const Study& study) {
  std::vector<FactorColumn> columns;
  std::map<std::string, int> uses;
  for (const std::string& response : study.responses) ++uses[response];
  for (const DrawnInput& drawn : drawn_inputs(study)) {
    FactorColumn& column = columns.emplace_back(column_of(*drawn.input));
    if (const int use = ++uses[column.name]; use > 1) column.name += fmt::format("_{}", use);
  }
  return columns;
}

std::vector<double> factor_values(const Study& study, const std::vector<FactorColumn>& columns, std::size_t first,
                                  std::size_t count) {
  const std::vector<DrawnInput> inputs = drawn_inputs(study);
  std::vector<double> values;
  values.reserve(count * columns.size());
  std::vector<Draw> drawn;
  for (std::size_t k = first; k < first + count; ++k) {
    set_draws(study, k, drawn);
    for (const auto f : indices(columns))
      values.push_back(value_of(*inputs[f].input, columns[f], drawn[inputs[f].factor]));
  }
  return values;
}

DesignStatus RowBlock::status(std::size_t row) const {
  const auto failure = std::ranges::lower_bound(failures, row, {}, &Failure::row);
  return failure != failures.end() && failure->row == row ? failure->status : DesignStatus{};
}

}  // namespace prs
