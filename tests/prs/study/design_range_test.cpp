#include "prs/study/designs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace prs {
namespace {

TEST(Shard, IsReadFromOneToCount) {
  EXPECT_EQ(parse_shard("1/1"), (Shard{0, 1}));
  EXPECT_EQ(parse_shard("3/8"), (Shard{2, 8}));
  EXPECT_EQ(name(Shard{2, 8}), "3/8");
  for (const char* text : {"", "3", "/8", "3/", "0/8", "9/8", "-1/8", "3/8x", " 3/8", "3 /8", "1.5/8", "a/b", "1/0",
                           "1/1000001", "1/99999999999999999999999"})
    EXPECT_EQ(parse_shard(text), std::nullopt) << text;
}

TEST(Shard, PartsFollowEachOtherAndDifferByOneAtMost) {
  for (const std::size_t designs : {0, 1, 5, 7, 100, 1001})
    for (const std::size_t shards : {1, 2, 3, 7, 100}) {
      std::size_t next = 0;
      for (std::size_t k = 0; k < shards; ++k) {
        const DesignRange range = part(designs, {k, shards});
        EXPECT_EQ(range.first, next);
        EXPECT_LE(range.count - designs / shards, 1u);
        next = range.end();
      }
      EXPECT_EQ(next, designs);
    }
}

TEST(Missing, IsWhatNoRangeHolds) {
  std::mt19937 random(1);
  const auto draw = [&](std::size_t most) { return random() % (most + 1); };
  for (int round = 0; round < 200; ++round) {
    const DesignRange all{draw(10), draw(40)};
    std::vector<DesignRange> ranges(draw(6));
    for (DesignRange& range : ranges) range = {draw(50), 1 + draw(12)};
    std::vector<bool> absent(100, false);
    for (std::size_t k = all.first; k < all.end(); ++k) absent[k] = true;
    for (const DesignRange& range : ranges)
      for (std::size_t k = range.first; k < range.end(); ++k) absent[k] = false;

    const std::vector<DesignRange> gaps = missing(all, ranges);
    std::vector<bool> told(100, false);
    for (std::size_t g = 0; g < gaps.size(); ++g) {
      EXPECT_GT(gaps[g].count, 0u);
      EXPECT_TRUE(g == 0 || gaps[g].first > gaps[g - 1].end());
      for (std::size_t k = gaps[g].first; k < gaps[g].end(); ++k) told[k] = true;
    }
    EXPECT_EQ(told, absent);
    EXPECT_EQ(count(gaps), static_cast<std::size_t>(std::ranges::count(absent, true)));
  }
}

}  // namespace
}  // namespace prs
