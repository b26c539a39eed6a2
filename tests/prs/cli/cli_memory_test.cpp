// The program with little memory.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/support/program.h"

namespace {

/// Runs `prs ARGUMENTS` without a cache and with a limit on the memory allocated at once.
test::Outcome run_scarce(const std::string& arguments, std::size_t bytes) {
  return test::run_prs(
      arguments, PRS_SOURCE_DIR,
      "PRS_CACHE_DIR= PRS_LARGEST_ALLOCATION=" + std::to_string(bytes) + " " + test::preloaded(PRS_SCARCE_MEMORY));
}

void expect_out_of_memory(const test::Outcome& run) {
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err, testing::StartsWith("prs: error: out of memory; "));
}

TEST(ScarceMemory, IsToldAlsoOfTheCommandLine) {
  const std::string word = "a=" + std::string(100'000, 'x');
  expect_out_of_memory(run_scarce("solve configs/01_config_1_to_3.yaml --set " + word, 65'536));
  EXPECT_EQ(run_scarce("solve configs/01_config_1_to_3.yaml --quiet", 1u << 30).status, 0);
}

TEST(ScarceMemory, IsNoVerdictOnAMatrix) {
  // Limits from the first arrays to the last factors of the grooved bodies, which CHOLMOD keeps.
  const std::string command = "solve configs/13_three_models.yaml --set model.bodies=influence";
  for (const std::size_t bytes : {100'000, 300'000, 1'000'000, 3'000'000, 10'000'000, 30'000'000}) {
    SCOPED_TRACE(bytes);
    expect_out_of_memory(run_scarce(command, bytes));
  }
}

}  // namespace
