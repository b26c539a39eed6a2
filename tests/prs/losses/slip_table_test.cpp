#include "prs/losses/slip_table.h"

#include <gtest/gtest.h>

#include "support/sample_slip.h"
#include "support/text_lines.h"

namespace prs {
namespace {

using test::contains;
using test::equal_share_case;
using test::failed_case;
using test::lines;
using test::solved_case;
using test::widest_line;
using test::with_slip;
using test::without_equilibrium;

Result result_of(std::vector<LoadCaseResult> load_cases) {
  Result result;
  result.load_cases = std::move(load_cases);
  return result;
}

Result sweep(int points) {
  Result result;
  test::add_sweep(result, "sweep", Direction::tension, points);
  for (LoadCaseResult& load_case : result.load_cases) load_case = with_slip(std::move(load_case));
  return result;
}

TEST(SlipTable, BlockHoldsWhatADesignerAsksFirst) {
  const std::string table = slip_table(result_of({with_slip(solved_case("config1", 45e3, Direction::tension))}), true);
  for (const char* part :
       {"config1: 45.000 kN, tension, thread loads at rest, 400 rpm", "0.372956", "0.373134", "optimality 99.5 %",
        "80.00", "Sandu's fit 79.00 %", "12.50", "-12.25", "roller-screw", "carrier-screw", "film by Sandu, nm", "310",
        "central film, nm", "260", "hottest thread", "screw 1", "thread loads", "+2.04 %"})
    EXPECT_TRUE(contains(table, part)) << part << " in\n" << table;
  EXPECT_FALSE(contains(table, "carrier-nut"));
  EXPECT_LE(widest_line(table), 100);
}

TEST(SlipTable, OneEfficiencyUnlessAllIsAskedFor) {
  const std::string table = slip_table(result_of({with_slip(solved_case("config1", 45e3, Direction::tension))}));
  for (const char* part : {"Sandu's fit", "of the case", "+2.04 %"})
    EXPECT_FALSE(contains(table, part)) << part << " in\n" << table;
  EXPECT_TRUE(contains(table, "efficiency, %"));
}

TEST(SlipTable, AbsentQuantitiesHaveNoLine) {
  LoadCaseResult load_case = with_slip(equal_share_case("equal"));
  SlipResult& slip = *load_case.slip;
  slip.efficiency.reset();
  slip.driven_by = DrivenBy::load;
  slip.self_locking = true;
  slip.holding_torque = 1.25;
  slip.estimates.jones.reset();
  slip.equal_shares.reset();
  for (const Interface i : kInterfaces) slip.threads[i].film_thickness = slip.threads[i].central_film = {};
  const std::string table = slip_table(result_of({load_case}));
  EXPECT_TRUE(contains(table, "self-locking"));
  EXPECT_TRUE(contains(table, "1.250   releases the screw"));
  EXPECT_TRUE(contains(table, "equal thread loads"));
  for (const char* part : {"Jones", "of the case", "film by Sandu", "central film", "NaN", "nan"})
    EXPECT_FALSE(contains(table, part)) << part << " in\n" << table;
}

TEST(SlipTable, WhatRoundsToZeroHasNoMinus) {
  LoadCaseResult load_case = with_slip(solved_case("a", 45e3, Direction::tension));
  SlipResult& slip = *load_case.slip;
  slip.equal_shares->power_loss = (1.0 + 1e-6) * slip.power.total();
  slip.equal_shares->efficiency = *slip.efficiency + 1e-6;
  slip.torque_nut = -1e-9;
  const std::string table = slip_table(result_of({load_case}), true);
  EXPECT_TRUE(contains(table, "+0.00 %"));
  EXPECT_FALSE(contains(table, "-0.00")) << table;
}

TEST(SlipTable, SmallForcesShowTheirDigits) {
  LoadCaseResult load_case = with_slip(solved_case("a", 0.4321, Direction::tension));
  EXPECT_TRUE(contains(slip_table(result_of({load_case})), "0.000432 kN"));
}

TEST(SlipTable, ImposedSlipRatioShowsTheMomentLeft) {
  LoadCaseResult load_case = with_slip(equal_share_case("equal"));
  load_case.slip->status = SlipStatus::imposed;
  load_case.slip->moments = {0.5, 0.0, 0.0, 0.0};
  EXPECT_TRUE(contains(slip_table(result_of({load_case})), "imposed; moment left on a roller 500.0"));
}

TEST(SlipTable, FailedCaseStandsOut) {
  const std::string table =
      slip_table(result_of({without_equilibrium(equal_share_case("none")), failed_case("hopeless")}));
  EXPECT_TRUE(contains(table, "NOT CONVERGED (no_equilibrium), residue 2.5e-01"));
  EXPECT_TRUE(contains(table, "NOT CONVERGED (line_search_failed)"));
}

TEST(SlipTable, OpenThreadsAreNoPartOfRanges) {
  LoadCaseResult load_case = with_slip(solved_case("a", 45e3, Direction::tension, 3));
  InterfaceSlip& screw = load_case.slip->threads.screw;
  screw.friction_coefficient = {0.111, 0.105, 0.0};
  screw.dynamic_normal_load = {300.0, 200.0, 0.0};
  EXPECT_TRUE(contains(slip_table(result_of({load_case})), "0.1050–0.1110"));
}

TEST(SlipTable, EachNutOfADoubleNutHasItsRanges) {
  LoadCaseResult load_case = with_slip(solved_case("double", 45e3, Direction::tension));
  SecondNut second{*load_case.slip};
  for (double& value : second.threads.nut.friction_coefficient) value = 0.0123;
  second.threads.nut.power_density[1] = 9e9;
  second.hottest = {Interface::nut, 1};
  load_case.slip->second_nut = std::make_shared<SecondNut>(second);
  const std::string table = slip_table(result_of({load_case}));
  EXPECT_TRUE(contains(table, "threads of the first nut"));
  const std::size_t at = table.find("threads of the second nut");
  ASSERT_NE(at, std::string::npos) << table;
  EXPECT_TRUE(contains(table.substr(at), "0.0123")) << table;
  EXPECT_FALSE(contains(table, "over the threads"));
  EXPECT_TRUE(contains(table, "nut 2, second nut")) << table;
}

TEST(SlipTable, RangeHasARowACaseAndFits) {
  Result result = sweep(9);
  result.load_cases[4] = failed_case("sweep[4]");
  result.warnings = {Warning{"", "backlash", "negative backlash"}};
  const std::string table = slip_table(result);
  EXPECT_EQ(lines(table).size(), 2 + 9 + 1 + 2);
  EXPECT_TRUE(contains(table, "NOT CONVERGED"));
  EXPECT_TRUE(contains(table, "Warnings\n  negative backlash\n"));
  EXPECT_LE(widest_line(table), 100);
  EXPECT_EQ(lines(slip_table(sweep(45))).size(), 2 + 3 + 1);
}

TEST(SlipTable, ControlCharactersDoNotReachTheTerminal) {
  const std::string name = "a\x1b[31m\nb" + std::string(200, 'x');
  const std::string table = slip_table(result_of({with_slip(equal_share_case(name))}));
  EXPECT_FALSE(contains(table, "\x1b"));
  EXPECT_LE(widest_line(table), 100);
}

TEST(SlipChart, OneBarAThreadAndTheLargestIsLongest) {
  const std::string chart = slip_chart(with_slip(solved_case("a", 45e3, Direction::tension)));
  EXPECT_EQ(lines(chart).size(), 2 + 20);
  EXPECT_TRUE(contains(lines(chart).at(2), "  1  ████████████████████████████████████ "));
  EXPECT_TRUE(contains(lines(chart).at(2), " W"));
  EXPECT_LE(widest_line(chart), 100);
}

TEST(SlipChart, FailedCaseSaysWhy) {
  EXPECT_EQ(slip_chart(without_equilibrium(equal_share_case("b"))), "b: no power at the threads (no_equilibrium)\n");
}

}  // namespace
}  // namespace prs
