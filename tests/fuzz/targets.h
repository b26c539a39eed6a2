#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

/// Fuzzing targets: each takes any bytes and throws `Finding`, or an exception that the engine should not throw, if the
/// engine misbehaves. It returns whether the input was used: neither refused nor left out.
namespace prs::fuzz {

class Finding : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline void expect(bool holds, const std::string& what) {
  if (!holds) throw Finding(what);
}

/// A file through a command and all forms of its result. The first line, `# slip`, names the command; the rest is YAML.
/// Files that need long computations are left out.
bool documents(std::string_view input);

/// A force history of lesson 14's kind through `life`: lines of a CSV.
bool force_history(std::string_view input);

/// Readings of a bench, lines of a CSV, through `fit`.
bool measured_curves(std::string_view input);

/// Up to three journals of shards of one study, each after its length: read, continued, merged.
bool journals(std::string_view input);

/// Contents of a cache for the matrices of `influence`, in the order in which a small screw requests them, each after
/// its length.
bool matrix_cache(std::string_view input);
/// Number of the two, one sector and the full mechanism, that can be solved with the input.
std::size_t solved_with(std::string_view input);
/// Input with which both can be solved, computed.
std::string whole_matrices();

/// `--set` arguments, one per line, on a case with most blocks.
bool overrides(std::string_view input);

struct Target {
  const char* name;  ///< Name of its function, its program and its corpus.
  bool (*run)(std::string_view input);
  /// Changes an input at random into another one that is mostly valid; at most `most` bytes. Null: bytes are changed
  /// arbitrarily.
  std::string (*mutate)(std::string_view input, std::size_t most, std::uint32_t seed) = nullptr;
};

std::string mutated_document(std::string_view input, std::size_t most, std::uint32_t seed);
std::string mutated_overrides(std::string_view input, std::size_t most, std::uint32_t seed);
std::string mutated_journals(std::string_view input, std::size_t most, std::uint32_t seed);
std::string mutated_cache(std::string_view input, std::size_t most, std::uint32_t seed);

/// Length of the longest input, as in scripts/fuzz.sh.
inline constexpr std::size_t kLongest = 16'000;

inline constexpr Target kTargets[] = {
    {"documents", documents, mutated_document}, {"force_history", force_history},
    {"journals", journals, mutated_journals},   {"matrix_cache", matrix_cache, mutated_cache},
    {"measured_curves", measured_curves},       {"overrides", overrides, mutated_overrides},
};

}  // namespace prs::fuzz
