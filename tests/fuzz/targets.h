#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

/// What is fuzzed: each target takes any bytes and throws `Finding`, or what the engine should not
/// have thrown, where the engine did what it must not do with them. It tells whether they were
/// taken: neither refused nor left out.
namespace prs::fuzz {

class Finding : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline void expect(bool holds, const std::string& what) {
  if (!holds) throw Finding(what);
}

/// A file through a command and all forms of its result. The first line, `# slip`, names the
/// command; the rest is YAML. Files that ask for much work are left out.
bool documents(std::string_view input);

/// A force history of lesson 14's kind through `life`: lines of a CSV.
bool force_history(std::string_view input);

/// Readings of a bench, lines of a CSV, through `fit`.
bool measured_curves(std::string_view input);

/// Up to three journals of shards of one study, each behind its length: read, continued, merged.
bool journals(std::string_view input);

/// What a cache holds for the matrices of `influence`, in the order in which a small screw asks for
/// them, each behind its length.
bool matrix_cache(std::string_view input);
/// How many of the two, one sector and the full mechanism, solve with that.
std::size_t solved_with(std::string_view input);
/// The input with which both do, computed.
std::string whole_matrices();

/// `--set` arguments, a line each, on a case with most blocks.
bool overrides(std::string_view input);

struct Target {
  const char* name;  ///< Name of its function, its program and its corpus.
  bool (*run)(std::string_view input);
  /// Changes an input at random into another one that is mostly sound; at most `most` bytes. Null:
  /// bytes are changed as they come.
  std::string (*mutate)(std::string_view input, std::size_t most, std::uint32_t seed) = nullptr;
};

std::string mutated_document(std::string_view input, std::size_t most, std::uint32_t seed);
std::string mutated_overrides(std::string_view input, std::size_t most, std::uint32_t seed);
std::string mutated_journals(std::string_view input, std::size_t most, std::uint32_t seed);
std::string mutated_cache(std::string_view input, std::size_t most, std::uint32_t seed);

/// The longest input, as scripts/fuzz.sh has it.
inline constexpr std::size_t kLongest = 16'000;

inline constexpr Target kTargets[] = {
    {"documents", documents, mutated_document}, {"force_history", force_history},
    {"journals", journals, mutated_journals},   {"matrix_cache", matrix_cache, mutated_cache},
    {"measured_curves", measured_curves},       {"overrides", overrides, mutated_overrides},
};

}  // namespace prs::fuzz
