// Effect of the environment variable PRS_INSTRUCTION_SET on the program.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "simd/instruction_set.h"
#include "tests/support/program.h"

namespace {

using testing::StartsWith;

test::Outcome slip_on(const std::string& set) {
  return test::run_prs("slip configs/09_slip_and_dissipation.yaml --json --quiet", PRS_SOURCE_DIR,
                       "PRS_INSTRUCTION_SET=" + set);
}

double power_of_slip(const test::Outcome& run) {
  return nlohmann::json::parse(run.out)["load_cases"][0]["slip"]["power_loss_W"];
}

TEST(InstructionSetOfTheProgram, AnUnknownOneIsWrongInput) {
  const test::Outcome run = slip_on("mmx");
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, StartsWith("prs: error: PRS_INSTRUCTION_SET: got \"mmx\"; expected one of: baseline"));
  EXPECT_EQ(run.out, "");
  const test::Outcome validation = test::run_prs("validate", PRS_SOURCE_DIR, "PRS_INSTRUCTION_SET=mmx");
  EXPECT_EQ(validation.status, 2);
}

TEST(InstructionSetOfTheProgram, NumbersAgreeWhateverIsForced) {
  const test::Outcome unset = slip_on("");
  ASSERT_EQ(unset.status, 0) << unset.err;
  using enum simd::InstructionSet;
  for (const simd::InstructionSet set : {baseline, avx2, avx512}) {
    if (!simd::available(set)) continue;
    const test::Outcome run = slip_on(std::string(simd::name(set)));
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_NEAR(power_of_slip(run) / power_of_slip(unset), 1.0, 1e-9) << simd::name(set);
  }
}

}  // namespace
