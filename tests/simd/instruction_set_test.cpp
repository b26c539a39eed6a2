#include "simd/instruction_set.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "simd/dispatch.h"

namespace simd {
namespace {

using enum InstructionSet;
using testing::HasSubstr;

/// Set that a kernel ran with.
struct NamesItsSet {
  InstructionSet operator()(Baseline) const { return baseline; }
#if defined(__x86_64__)
  InstructionSet operator()(Avx2) const { return avx2; }
  InstructionSet operator()(Avx512) const { return avx512; }
#endif
};

constexpr InstructionSet kAll[] = {best, scalar, baseline, avx2, avx512};

TEST(InstructionSet, AValueNamesTheWidestThatKernelsTake) {
  EXPECT_EQ(widest_of("baseline"), baseline);
  for (const InstructionSet set : {baseline, avx2, avx512})
    if (available(set)) {
      EXPECT_EQ(widest_of(name(set)), set);
    }
  EXPECT_GE(widest_of(""), widest()) << "without a value: all that is here";
}

TEST(InstructionSet, AnUnknownValueIsRefusedWithThoseThatAreHere) {
  for (const std::string value : {"x", "best", "scalar", "AVX2", "baseline ", "avx1024"}) {
    try {
      widest_of(value);
      FAIL() << value;
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), HasSubstr("PRS_INSTRUCTION_SET: got \"" + value + "\"; expected one of: baseline"));
    }
  }
}

TEST(InstructionSet, KernelsRunOnTheSetAskedForOrTheBestBelowIt) {
  for (const InstructionSet set : kAll) {
    SCOPED_TRACE(name(set));
    EXPECT_EQ(run_kernel(set, NamesItsSet{}), taken(set));
    EXPECT_TRUE(available(taken(set)));
    if (set < baseline) continue;
    EXPECT_LE(taken(set), set);
    EXPECT_EQ(taken(set) == set, available(set));
  }
  EXPECT_EQ(taken(best), widest());
  EXPECT_EQ(taken(scalar), widest());
}

TEST(InstructionSet, BatchesAreThoseOfTheSetThatKernelsRunOn) {
  EXPECT_EQ(batch_size(scalar), 1);
  EXPECT_EQ(batch_size(best), batch_size(widest()));
  for (const InstructionSet set : kAll)
    if (set != scalar) {
      EXPECT_EQ(batch_size(set), batch_size(taken(set))) << name(set);
    }
  EXPECT_EQ(batch_size(avx512) == kWidest, available(avx512));
  EXPECT_LE(batch_size(best), kWidest);
}

}  // namespace
}  // namespace simd
