#include "prs/loads/case_table.h"

#include <gtest/gtest.h>

#include "support/sample_result.h"

namespace prs {
namespace {

using test::solved_case;

TEST(CaseGroups, PointsOfARangeFold) {
  EXPECT_EQ(folded_names({"a[0]", "b", "a[1]", "a[2]", "a[7]", "c[x]"}), "a[0–2, 7], b, c[x]");
}

TEST(CaseGroups, LongListsAreCutShort) {
  std::vector<std::string> names;
  for (int k = 0; k < 15; ++k) names.push_back("case " + std::to_string(k));
  EXPECT_TRUE(folded_names(names).ends_with("case 11, and 3 more"));
}

TEST(CaseGroups, DirectionsOfOneConfigurationFindEachOther) {
  const std::vector<LoadCaseResult> results = {
      solved_case("c-tension", 1e3, Direction::tension), solved_case("c-compression", 1e3, Direction::compression),
      solved_case("tension", 1e3, Direction::tension), solved_case("c-compression", 1e3, Direction::tension)};
  const auto found = loaded_configurations(results, 1, [](const LoadCaseResult&) { return true; });
  ASSERT_EQ(found.size(), 3);
  EXPECT_EQ(found[0].name, "c");
  EXPECT_EQ(found[0].groups.size(), 2);
  EXPECT_EQ(found[1].name, "tension");
  EXPECT_EQ(found[2].name, "c-compression");
}

}  // namespace
}  // namespace prs
