#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <vector>

#include "support/count.h"
#include "support/temporary_directory.h"
#include "tests/fuzz/files.h"
#include "tests/fuzz/targets.h"

namespace prs::fuzz {
namespace {

namespace fs = std::filesystem;

const fs::path kCorpus = PRS_SOURCE_DIR "/tests/fuzz/corpus";

std::vector<fs::path> corpus_of(const Target& target) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(kCorpus / target.name)) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

class FuzzCorpus : public testing::TestWithParam<Target> {};

TEST_P(FuzzCorpus, HoldsNoFinding) {
  const std::vector<fs::path> files = corpus_of(GetParam());
  EXPECT_FALSE(files.empty());
  std::size_t taken = 0;
  for (const fs::path& file : files) EXPECT_NO_THROW(taken += GetParam().run(test::content_of(file))) << file;
  EXPECT_GE(10 * taken, files.size());
}

class FuzzMutations : public testing::TestWithParam<Target> {};

/// Mutations of part of the corpus, as a fuzzer makes them, without its coverage. Most must differ from their source,
/// and not all may be refused: otherwise the mutator, or the code after it, would not be tested.
TEST_P(FuzzMutations, AreNoFinding) {
  const auto runs = static_cast<std::size_t>(test::samples(40, 2000));
  std::vector<std::string> inputs;
  for (const fs::path& file : corpus_of(GetParam()))
    if (inputs.size() < runs && GetParam().run(test::content_of(file))) inputs.push_back(test::content_of(file));
  ASSERT_FALSE(inputs.empty());
  std::size_t changed = 0, taken = 0;
  for (std::uint32_t seed = 0; seed < runs; ++seed) {
    const std::string& given = inputs[seed % inputs.size()];
    const std::string input = GetParam().mutate(given, kLongest, seed);
    changed += input != given;
    EXPECT_NO_THROW(taken += GetParam().run(input)) << "seed " << seed << " of\n" << given;
  }
  EXPECT_GE(4 * changed, 3 * runs);
  EXPECT_GE(8 * taken, runs);
}

/// Targets with mutators of their own; bytes of the others are left to libFuzzer.
std::vector<Target> mutated_targets() {
  std::vector<Target> targets;
  std::ranges::copy_if(kTargets, std::back_inserter(targets),
                       [](const Target& target) { return target.mutate != nullptr; });
  return targets;
}

const auto kNameOfTarget = [](const auto& target) { return std::string(target.param.name); };
INSTANTIATE_TEST_SUITE_P(Targets, FuzzCorpus, testing::ValuesIn(kTargets), kNameOfTarget);
INSTANTIATE_TEST_SUITE_P(Targets, FuzzMutations, testing::ValuesIn(mutated_targets()), kNameOfTarget);

TEST(FuzzedCache, WholeMatricesSolveSectorAndFullMechanism) {
  const fs::path file = kCorpus / "matrix_cache" / "whole";
  if (std::getenv("PRS_WRITE_CORPUS")) write_bytes(file, whole_matrices());
  EXPECT_EQ(solved_with(test::content_of(file)), 2u)
      << "the solve asks for other matrices now; write them anew with PRS_WRITE_CORPUS=1";
}

}  // namespace
}  // namespace prs::fuzz
