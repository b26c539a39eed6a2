#include "prs/loads/warnings.h"

#include <gtest/gtest.h>

#include "prs/life/static_limits.h"

namespace prs {
namespace {

WarningGroup grouped(const std::vector<std::pair<std::string, std::string>>& warnings) {
  WarningGroups groups;
  for (const auto& [text, load_case] : warnings) groups.add(text, load_case);
  const std::vector<WarningGroup> all = std::move(groups).take();
  EXPECT_EQ(all.size(), 1);
  return all.front();
}

TEST(WarningGroups, TheWorstValueIsToldWithItsLoadCase) {
  const WarningGroup group =
      grouped({{"load_cases[0].axial_force: peak pressure 2.57 GPa is above 2.5 GPa", "low"},
               {"load_cases[1].axial_force: peak pressure 3.99 GPa is above 2.5 GPa", "high"},
               {"load_cases[2].axial_force: peak pressure 2.92 GPa is above 2.5 GPa", "pull"}});
  EXPECT_EQ(group.whole(), "load_cases[..].axial_force: peak pressure 3.99 GPa is above 2.5 GPa");
  EXPECT_EQ(group.where(), "in low, high, pull; worst in high");
}

TEST(WarningGroups, OfWhatIsToldAtTheLeastTheSmallestIsWorst) {
  const WarningGroup group =
      grouped({{"film over roughness is 0.80 at the least; take 0.11", "a"},
               {"film over roughness is 0.07 at the least; take 0.11", "b"},
               {"film over roughness is 0.50 at the least; take 0.11", "c"}});
  EXPECT_EQ(group.whole(), "film over roughness is 0.07 at the least; take 0.11");
  EXPECT_EQ(group.worst, "b");
}

TEST(WarningGroups, TheLoadNearestToALimitIsWorst) {
  const auto near = [](double load) { return *flank_edge_near("an ellipse", 42.84e3, 70e3, load); };
  EXPECT_EQ(grouped({{near(40e3), "high"}, {near(30e3), "low"}}).where(),
            "in high, low; worst in high");
  const auto beyond = [](double load, double limit) {
    return *beyond_static_rating(load, {limit, StaticLimit::flank_edge});
  };
  const WarningGroup group = grouped({{beyond(200e3, 42.84e3), "tension"},
                                      {beyond(200e3, 38.8e3), "compression"},
                                      {beyond(50e3, 40e3), "small"}});
  EXPECT_EQ(group.worst, "compression");
  EXPECT_EQ(group.whole(),
            "the load is 5.155 times the static limit (ellipse at the edge of a flank): 200 kN "
            "above 38.8 kN; reduce it");
}

/// The second command tells the same of the same load cases.
TEST(WarningGroups, EqualTextsHaveNoWorstAndCasesStandOnce) {
  const WarningGroup group = grouped({{"high", "a"}, {"high", "b"}, {"high", "a"}, {"high", "b"}});
  EXPECT_EQ(group.where(), "in a, b");
  EXPECT_EQ(grouped({{"about the whole case", ""}}).where(), "");
}

/// A command that names no load case has told it before.
TEST(WarningGroups, TheWorstCaseIsThatOfTheWorstText) {
  EXPECT_EQ(grouped({{"5.42 GPa", ""}, {"5.13 GPa", "pull"}, {"5.42 GPa", "push"}}).where(),
            "in pull, push; worst in push");
}

/// Two commands tell other numbers of one load case, cold and warm.
TEST(WarningGroups, OneCaseIsNotToldTwice) {
  const WarningGroup group = grouped({{"2.57 GPa", "pull"}, {"2.64 GPa", "pull"}});
  EXPECT_EQ(group.where(), "in pull");
  EXPECT_EQ(group.whole(), "2.64 GPa");
}

TEST(WarningGroups, TheFirstCaseMayBeTheWorst) {
  EXPECT_EQ(grouped({{"at 140 degC", "hot"}, {"at 125 degC", "warm"}}).where(),
            "in hot, warm; worst in hot");
}

}  // namespace
}  // namespace prs
