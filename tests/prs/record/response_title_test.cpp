#include "prs/record/response_title.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "prs/record/record.h"

namespace prs {
namespace {

TEST(ShownUnit, IsTheLongestThatAKeyEndsIn) {
  EXPECT_EQ(unit_of("tangent_stiffness_N_per_um").text, "N/µm");
  EXPECT_EQ(unit_of("spin_torque_Nmm").text, "N mm");
  EXPECT_EQ(unit_of("hertz_constant_N_per_mm1_5").text, "N/mm^1.5");
  EXPECT_DOUBLE_EQ(unit_of("speed_rpm").factor * 2.0 * std::numbers::pi, 60.0);
  EXPECT_EQ(unit_of("friction_coefficient").text, "");
  EXPECT_EQ(unit_of("share_of_revolutions").text, "");
}

TEST(ResponseTitle, HasTheWordsOfCataloguesThenThePartAndTheThread) {
  EXPECT_EQ(response_title("screw.peak_pressure_MPa.max").name, "largest peak pressure, screw");
  EXPECT_EQ(response_title("screw.peak_pressure_MPa.max").unit, "MPa");
  EXPECT_EQ(response_title("slip.nut.power_W[2]").name, "power, nut, thread 3");
  EXPECT_EQ(response_title("screw.normal_load_N[3][0]").name, "normal load, screw, roller 4, thread 1");
  EXPECT_EQ(response_title("nut.roller_share_percent[3]").name, "roller share, nut, roller 4");
  EXPECT_EQ(response_title("screw.load_rate_percent.max").name, "largest share of the load, screw");
  EXPECT_EQ(response_title("measures.solved_static_safety").name, "static safety");
  EXPECT_EQ(response_title("measures.static_safety").name, "static safety (estimate)");
  EXPECT_EQ(response_title("load_cases[1].measures.l10_hours").name, "load cases[1] measures L10 in time (estimate)");
  for (const char* key :
       {"efficiency", "back_driving_efficiency", "l10_revolutions", "l10_travel_km", "drive_torque_Nm"})
    EXPECT_TRUE(response_title(fmt::format("measures.{}", key)).name.ends_with(" (estimate)")) << key;
  EXPECT_EQ(response_title("life.static_safety").name, "life static safety");
  EXPECT_EQ(response_title("life.system.l10_hours").name, "life L10 in time, mechanism");
  EXPECT_EQ(response_title("life.catalogue.l10_revolutions").name, "life L10 in turns, by the catalogue's formula");
  EXPECT_EQ(response_title("heat.temperature_degC.nut").name, "temperature, nut");
  EXPECT_EQ(response_title("slip.viscosity_mPas").unit, "mPa s");
  EXPECT_EQ(response_title("response.energy_J.residual").unit, "J");
  EXPECT_EQ(response_title("response.energy_J.residual_relative").unit, "");
}

}  // namespace
}  // namespace prs
