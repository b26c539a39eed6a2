#pragma once

#include <gtest/gtest.h>

#include <cstddef>

#include "prs/study/design_engine.h"
#include "tests/support/allocations.h"

namespace test {

/// Checks that 1024 designs allocate memory as often as 64 do, after earlier ones have left some.
inline void expect_no_memory_per_design(const prs::DesignEngine& engine) {
  const auto allocations_of = [&](std::size_t designs) {
    const std::size_t before = allocations();
    const prs::RowBlock block = engine.evaluate(1, designs);
    EXPECT_TRUE(block.failures.empty());
    return allocations() - before;
  };
  allocations_of(1024);
  EXPECT_EQ(allocations_of(64), allocations_of(1024));
}

}  // namespace test
