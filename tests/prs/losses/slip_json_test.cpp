#include "prs/losses/slip_analysis.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "prs/loads/load_analysis.h"
#include "prs/record/record_table.h"
#include "tests/support/sample_slip.h"

namespace prs {
namespace {

using test::equal_share_case;
using test::failed_case;
using test::sample_slip;
using test::solved_case;
using test::with_slip;
using test::without_equilibrium;

SlipResult sample() { return sample_slip(solved_case("a", 45e3, Direction::tension)); }

TEST(SlipJson, ValuesHaveTheUnitOfTheirKey) {
  const SlipResult slip = sample();
  const auto json = object_of(slip);
  EXPECT_EQ(json.at("converged"), true);
  EXPECT_EQ(json.at("status"), "converged");
  EXPECT_EQ(json.at("evaluations"), 41);
  EXPECT_DOUBLE_EQ(json.at("speed_rpm"), 400.0);
  EXPECT_EQ(json.at("gear_ratio"), 3.0);
  EXPECT_EQ(json.at("slip_ratio"), 0.372956);
  EXPECT_EQ(json.at("ideal_slip_ratio"), 0.373134);
  EXPECT_DOUBLE_EQ(json.at("optimality_percent"), 99.5);
  EXPECT_DOUBLE_EQ(json.at("efficiency"), 0.8);
  EXPECT_EQ(json.at("efficiency_fit"), 0.79);
  EXPECT_EQ(json.at("power_loss_W"), slip.power.total());
  EXPECT_EQ(json.at("power_loss_input_output_W"), slip.power_loss_input_output);
  EXPECT_EQ(json.at("torque_screw_Nm"), 12.5);
  EXPECT_EQ(json.at("torque_nut_Nm"), -12.25);
  EXPECT_EQ(json.at("bearing_eccentricity_ratio"), 0.25);
  EXPECT_EQ(json.at("slip_ratio_estimates").at("simple"), 0.375);
  EXPECT_EQ(json.at("slip_ratio_estimates").at("jones"), 0.3742);
  EXPECT_DOUBLE_EQ(json.at("roller_moments_Nmm").at("contacts"), 30.0);
  EXPECT_DOUBLE_EQ(json.at("roller_moments_Nmm").at("gears"), -4.0);
  EXPECT_EQ(json.at("roller_forces_N").at("carrier_y"), -6.0);
  const auto& equal = json.at("equal_shares");
  EXPECT_EQ(equal.at("slip_ratio"), 0.372950);
  EXPECT_EQ(equal.at("power_loss_W"), slip.equal_shares->power_loss);
  EXPECT_DOUBLE_EQ(equal.at("max_power_density_W_per_mm2"), slip.equal_shares->max_power_density * 1e-6);
}

TEST(SlipJson, TheLoadThatDrivesSaysWhatHoldsIt) {
  SlipResult slip = sample();
  auto json = object_of(slip);
  EXPECT_EQ(json.at("driven_by"), "screw");
  for (const char* key : {"self_locking", "holding_torque_Nm"}) EXPECT_FALSE(json.contains(key));
  slip.driven_by = DrivenBy::load;
  slip.efficiency.reset();
  slip.self_locking = true;
  slip.holding_torque = 1.5;
  json = object_of(slip);
  EXPECT_EQ(json.at("driven_by"), "load");
  EXPECT_EQ(json.at("self_locking"), true);
  EXPECT_EQ(json.at("holding_torque_Nm"), 1.5);
  EXPECT_FALSE(json.contains("efficiency"));
}

TEST(SlipJson, ThreadsOfAllRollersStandInRows) {
  SlipResult slip = sample();
  slip.threads.nut.threads_per_roller = 5;
  slip.hottest = {Interface::nut, 7};
  const auto json = object_of(slip);
  const auto& power = json.at("nut").at("power_W");
  ASSERT_EQ(power.size(), 4u);
  EXPECT_EQ(power[1][2], slip.threads.nut.power[7]);
  EXPECT_EQ(json.at("hottest_thread").at("roller"), 2);
  EXPECT_EQ(json.at("hottest_thread").at("thread"), 3);
  EXPECT_EQ(json.at("screw").at("power_W")[7], slip.threads.screw.power[7]);
}

TEST(SlipJson, ThreadsHaveTheUnitOfTheirKey) {
  const SlipResult slip = sample();
  const InterfaceSlip& threads = slip.threads.nut;
  const auto json = object_of(slip);
  const auto& nut = json.at("nut");
  EXPECT_EQ(nut.at("power_W").size(), 20);
  EXPECT_EQ(nut.at("power_W")[1], threads.power[1]);
  EXPECT_DOUBLE_EQ(nut.at("power_density_W_per_mm2")[1], threads.power_density[1] * 1e-6);
  EXPECT_EQ(nut.at("friction_coefficient")[1], threads.friction_coefficient[1]);
  EXPECT_DOUBLE_EQ(nut.at("spin_torque_Nmm")[1], threads.spin_torque[1] * 1e3);
  EXPECT_DOUBLE_EQ(nut.at("sliding_speed_mm_per_s")[1], threads.sliding_speed[1] * 1e3);
  EXPECT_DOUBLE_EQ(nut.at("max_sliding_speed_mm_per_s")[1], threads.max_sliding_speed[1] * 1e3);
  EXPECT_DOUBLE_EQ(nut.at("film_thickness_nm")[1], 310.0);
  EXPECT_DOUBLE_EQ(nut.at("central_film_nm")[1], 260.0);
  EXPECT_EQ(nut.at("film_ratio")[1], 0.62);
  EXPECT_EQ(nut.at("dynamic_normal_load_N")[1], threads.dynamic_normal_load[1]);
}

TEST(SlipJson, SharesSumToAHundred) {
  double sum = 0.0;
  const auto json = object_of(sample()).at("share_percent");
  for (const char* key : {"screw", "nut", "carrier_roller", "carrier_screw", "carrier_nut"})
    sum += json.at(key).get<double>();
  EXPECT_NEAR(sum, 100.0, 1e-12);
  EXPECT_EQ(json.size(), 5);
}

TEST(SlipJson, HottestThreadCountsFromOne) {
  const SlipResult slip = sample();
  const auto json = object_of(slip).at("hottest_thread");
  EXPECT_EQ(json.at("interface"), "screw");
  EXPECT_EQ(json.at("thread"), 1);
  EXPECT_EQ(json.at("power_W"), slip.threads.screw.power[0]);
  EXPECT_DOUBLE_EQ(json.at("power_density_W_per_mm2"), slip.threads.screw.power_density[0] * 1e-6);
}

TEST(SlipJson, WhatTheCaseDoesNotDefineIsAbsent) {
  SlipResult slip = sample();
  slip.efficiency.reset();
  slip.efficiency_fit.reset();
  slip.bearing_eccentricity.reset();
  slip.estimates.jones.reset();
  slip.equal_shares->efficiency = std::numeric_limits<double>::quiet_NaN();
  slip.power = {};
  for (const Interface i : kInterfaces) slip.threads[i].film_thickness.clear();
  const auto json = object_of(slip);
  for (const char* key :
       {"efficiency", "efficiency_fit", "bearing_eccentricity_ratio", "share_percent", "not_computed"})
    EXPECT_FALSE(json.contains(key)) << key;
  EXPECT_FALSE(json.at("slip_ratio_estimates").contains("jones"));
  EXPECT_FALSE(json.at("equal_shares").contains("efficiency"));
  EXPECT_FALSE(json.at("roller_forces_N").contains("centrifugal"));
  EXPECT_FALSE(json.at("screw").contains("film_thickness_nm"));
  EXPECT_EQ(json_text(json).find("null"), std::string::npos);
  slip.equal_shares.reset();
  EXPECT_FALSE(object_of(slip).contains("equal_shares"));
}

TEST(SlipJson, ImposedSlipRatioCountsAsConverged) {
  SlipResult slip = sample();
  slip.status = SlipStatus::imposed;
  const auto json = object_of(slip);
  EXPECT_EQ(json.at("converged"), true);
  EXPECT_EQ(json.at("status"), "imposed");
}

TEST(SlipJson, SlipWithoutEquilibriumKeepsHowItEnded) {
  const auto json = object_of(*without_equilibrium(solved_case("a", 45e3, Direction::tension)).slip);
  EXPECT_EQ(json.at("converged"), false);
  EXPECT_EQ(json.at("status"), "no_equilibrium");
  EXPECT_EQ(json.at("evaluations"), 2);
  EXPECT_EQ(json.at("relative_residue"), 0.25);
  EXPECT_EQ(json.size(), 4);
}

TEST(SlipJson, StandsInTheLoadCaseWhereItWasAskedFor) {
  Result result;
  result.load_cases = {with_slip(solved_case("a", 45e3, Direction::tension)), equal_share_case("b"), failed_case("c")};
  const auto cases = document_of(slip_analysis(), result, {"1", "1", ""}).at("load_cases");
  EXPECT_EQ(cases.at(0).at("slip").at("slip_ratio"), 0.372956);
  EXPECT_TRUE(cases.at(0).contains("screw"));
  EXPECT_FALSE(cases.at(1).contains("slip"));
  EXPECT_FALSE(cases.at(2).contains("slip"));
}

}  // namespace
}  // namespace prs
