#include "prs/loads/case_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "prs/life/static_limits.h"
#include "prs/loads/load_case_result.h"

namespace prs {
namespace {

Warning in(const std::string& load_case, Warning warning) {
  warning.load_case = load_case;
  return warning;
}

WarningGroup group_of(const std::vector<Warning>& warnings) {
  const std::vector<WarningGroup> all = grouped(warnings);
  EXPECT_EQ(all.size(), 1);
  return all.front();
}

Warning running(double gigapascals, int load_case = 0) {
  return *running_pressure_warning("load_cases[" + std::to_string(load_case) + "].axial_force", Interface::screw,
                                   gigapascals * 1e9, Contacts{});
}

Warning high(double value) { return Warning{"", "high", "high: {value}"}.with(value); }

/// 4 GPa, valid for steel, is not the limit of another material, which has the one stated in its case, or none.
TEST(Warning, PressureIsHeldAgainstTheLimitOfTheMaterials) {
  Contacts contacts;
  EXPECT_FALSE(static_pressure_warning("a", Interface::screw, 3.9e9, contacts));
  EXPECT_TRUE(static_pressure_warning("a", Interface::screw, 4.1e9, contacts));
  contacts.interfaces.screw.pressure_limit = 1e9;
  EXPECT_THAT(sentence(*static_pressure_warning("a", Interface::screw, 1.2e9, contacts)),
              testing::HasSubstr("1.2 GPa exceeds 1 GPa"));
  EXPECT_FALSE(running_pressure_warning("a", Interface::screw, 3e9, contacts));
  contacts.interfaces.screw.pressure_limit.reset();
  EXPECT_FALSE(static_pressure_warning("a", Interface::screw, 9e9, contacts));
}

TEST(Warning, ItsTextHasPathNumbersAndFix) {
  const Warning warning = Warning{"a.b", "code", "{value} exceeds {limit}", "lower it"}.with(4.0449e9, 4e9, "GPa"_unit);
  EXPECT_EQ(sentence(warning), "a.b: 4.04 GPa exceeds 4 GPa; lower it");
  EXPECT_EQ(sentence(Warning{"", "code", "plain"}), "plain");
}

TEST(Warning, AValueNextToItsLimitHasTheDigitsThatTellThemApart) {
  EXPECT_EQ(sentence(Warning{"", "", "{value}, {limit}"}.with(3.500123, 3.5)), "3.5001, 3.5");
  EXPECT_EQ(sentence(Warning{"", "", "{value}, {limit}"}.with(3.5, 3.5)), "3.5, 3.5");
  EXPECT_EQ(sentence(Warning{"", "", "{value}"}.with(150345.0, {}, "N m"_unit)), "150345 N m");
  EXPECT_EQ(sentence(Warning{"", "", "{value}"}.with(-1.25e-5, {}, "mm"_unit)), "-0.0125 mm");
}

TEST(WarningGroups, TheWorstValueIsToldWithItsLoadCase) {
  const WarningGroup group =
      group_of({in("low", running(2.57, 0)), in("high", running(3.99, 1)), in("pull", running(2.92, 2))});
  EXPECT_NE(group.text().find("load_cases[1].axial_force: roller-screw peak pressure 3.99 GPa"), std::string::npos)
      << group.text();
  EXPECT_NE(group.text().find("4 GPa is the limit at rest"), std::string::npos) << group.text();
  EXPECT_EQ(group.where(), "worst in high, and 2 other load cases");
}

/// The order must not matter.
TEST(WarningGroups, TheOrderDoesNotMatter) {
  std::vector<double> peaks = {2.57, 2.92, 3.3, 3.99};
  do {
    std::vector<Warning> warnings;
    for (const double peak : peaks) warnings.push_back(in(std::to_string(peak), running(peak)));
    const WarningGroup group = group_of(warnings);
    EXPECT_DOUBLE_EQ(group.worst.value.value(), 3.99e9);
    EXPECT_EQ(group.where(), "worst in " + std::to_string(3.99) + ", and 3 other load cases");
  } while (std::ranges::next_permutation(peaks).found);
}

TEST(WarningGroups, OtherInterfacesAndPathsAreOtherGroups) {
  Warning nut = running(3.0);
  nut.code = "nut_running_pressure";
  Warning spectrum = running(3.0);
  spectrum.path = "life.spectrum";
  EXPECT_EQ(grouped({running(3.0), nut, spectrum}).size(), 3);
}

TEST(WarningGroups, WhereLessIsWorseTheSmallestIsWorst) {
  const auto film = [](double ratio) {
    return Warning{"roughness", "film", "film over roughness is {value}"}.with(ratio, 3.0, {}, Warning::Worse::smaller);
  };
  const WarningGroup group = group_of({in("a", film(0.8)), in("b", film(0.07)), in("c", film(0.5))});
  EXPECT_EQ(group.text(), "roughness: film over roughness is 0.07");
  EXPECT_EQ(group.worst.load_case, "b");
}

TEST(WarningGroups, TheLoadNearestToItsLimitIsWorst) {
  const auto near = [](double load) { return *flank_edge_near("an ellipse", 42.84e3, 70e3, load); };
  EXPECT_EQ(group_of({in("high", near(40e3)), in("low", near(30e3))}).where(), "worst in high, and 1 other load case");
  const auto beyond = [](double load, double limit) {
    return *beyond_static_rating(load, {limit, StaticLimit::given});
  };
  const WarningGroup group = group_of({in("tension", beyond(200e3, 42.84e3)), in("compression", beyond(200e3, 38.8e3)),
                                       in("small", beyond(50e3, 40e3))});
  EXPECT_EQ(group.worst.load_case, "compression");
  EXPECT_EQ(group.text(),
            "the load is 5.155 times the static limit (stated static capacity): 200 kN "
            "above 38.8 kN; reduce it");
}

/// The second command gives the same warning for the same load cases.
TEST(WarningGroups, EqualTextsHaveNoWorstAndCasesStandOnce) {
  const Warning warning{"", "high", "high"};
  const WarningGroup group = group_of({in("a", warning), in("b", warning), in("a", warning), in("b", warning)});
  EXPECT_EQ(group.where(), "in a, b");
  EXPECT_EQ(group_of({warning}).where(), "");
}

/// A command that names no load case gave the warning before.
TEST(WarningGroups, TheWorstCaseIsThatOfTheWorstText) {
  EXPECT_EQ(group_of({high(5.42), in("pull", high(5.13)), in("push", high(5.42))}).where(),
            "worst in push, and 1 other load case");
}

/// Two commands give different numbers for one load case, cold and warm.
TEST(WarningGroups, OneCaseIsNotToldTwice) {
  const WarningGroup group = group_of({in("pull", high(2.57)), in("pull", high(2.64))});
  EXPECT_EQ(group.where(), "in pull");
  EXPECT_EQ(group.text(), "high: 2.64");
}

}  // namespace
}  // namespace prs
