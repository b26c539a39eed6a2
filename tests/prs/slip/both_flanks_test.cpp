#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>

#include "prs/heat/analyze_heat.h"
#include "prs/input/reader.h"
#include "prs/losses/slip_table.h"
#include "prs/slip/slip.h"
#include "prs/slip/slip_at_speed.h"
#include "prs/slip/slip_pictures.h"
#include "support/parsed_csv.h"

namespace prs {
namespace {

using nlohmann::json;

json preloaded_screw() {
  const json all = json::parse(std::ifstream(PRS_SOURCE_DIR "/tests/prs/slip/running_cases.json"));
  json input = all["cases"][3]["input"];
  input.erase("deviations");
  input["friction"] = {{"model", {{"coulomb", 0.1}}}};
  input["operation"] = {{"speed", "300 rpm"}};
  return input;
}

Case read(const json& input, Command command = Command::slip) {
  return input::read_case_text(input.dump(), "case", {}, command);
}

LoadCaseResult solved(const json& input) {
  LoadCaseResult r = analyze_slip(read(input)).load_cases.at(0);
  EXPECT_TRUE(r.converged() && r.slip && r.slip->converged());
  return r;
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// Axial load of all rollers on the flank that the load names, and on the other one.
std::pair<double, double> axial(const LoadCaseResult& r, Interface i, int rollers) {
  return {rollers * sum((*r.threads)[i].axial_load), rollers * sum(r.other_flank->threads[i].axial_load)};
}

TEST(BothFlanks, TensionLessCompressionIsTheLoad) {
  for (const char* loads : {"static", "running"})
    for (const char* arrangement : {"single_nut"})
      for (const char* direction : {"tension", "compression"}) {
        json input = preloaded_screw();
        input["model"]["loads"] = loads;
        input["preload"]["arrangement"] = arrangement;
        input["load_cases"][0]["direction"] = direction;
        input["load_cases"][0]["axial_force"] = "1.5 kN";
        const LoadCaseResult r = solved(input);
        for (const Interface i : kInterfaces) {
          const auto [named, other] = axial(r, i, 11);
          EXPECT_GT(other, 100.0);
          EXPECT_NEAR(named - other, 1500.0, 1e-6) << loads << ' ' << direction;
        }
        EXPECT_NEAR(r.slip->power_loss_input_output / r.slip->power.total(), 1.0, 1e-8);
        EXPECT_NEAR(r.slip->torque_screw / -r.slip->torque_nut, 1.0, 1e-9);
      }
}

/// Without a load both flanks push alike, the torque is that of the preload alone.
TEST(BothFlanks, PreloadDragsWithoutALoad) {
  json input = preloaded_screw();
  input["load_cases"][0]["axial_force"] = "0 N";
  for (const char* loads : {"static", "running"}) {
    input["model"]["loads"] = loads;
    const LoadCaseResult r = solved(input);
    for (const Interface i : kInterfaces) {
      const auto [named, other] = axial(r, i, 11);
      EXPECT_NEAR(named / other, 1.0, 1e-9);
    }
    EXPECT_FALSE(r.axial_stiffness);
    EXPECT_FALSE(r.slip->efficiency);
    EXPECT_EQ(r.slip->driven_by, DrivenBy::screw);
    EXPECT_GT(r.slip->torque_screw, 0.0);
    EXPECT_NEAR(r.slip->power.total() / (r.slip->torque_screw * r.slip->speed), 1.0, 1e-8);
  }
  input["model"]["loads"] = "static";
  EXPECT_NEAR(axial(solved(input), Interface::screw, 11).first, 2000.0, 2e-3);
}

TEST(BothFlanks, RunningLoadsAreThoseAtRestWithoutFriction) {
  json input = preloaded_screw();
  input["load_cases"][0]["axial_force"] = "1.5 kN";
  input["model"]["loads"] = "static";
  const LoadCaseResult rest = solved(input);
  input["model"]["loads"] = "running";
  double before = 0.0;
  for (const double friction : {1e-6, 1e-3}) {
    input["friction"] = {{"model", {{"coulomb", friction}}}};
    const LoadCaseResult r = solved(input);
    double change = 0.0;
    for (const Interface i : kInterfaces)
      for (std::size_t k = 0; k < 20; ++k)
        change = std::max(
            {change, std::abs((*r.threads)[i].normal_load[k] - (*rest.threads)[i].normal_load[k]),
             std::abs(r.other_flank->threads[i].normal_load[k] - rest.other_flank->threads[i].normal_load[k])});
    if (before > 0.0) {
      EXPECT_NEAR(change / before / 1e3, 1.0, 0.01);
    }
    before = change;
  }
  EXPECT_LT(before, 1.0);
}

/// Far above the opening load the other flank is open, and the screw is one without preload.
TEST(BothFlanks, OpenFlankLeavesTheScrewWithoutPreload) {
  json input = preloaded_screw();
  input["load_cases"][0]["axial_force"] = "40 kN";
  for (const char* loads : {"static", "running"}) {
    input["model"]["loads"] = loads;
    const LoadCaseResult with = solved(input);
    json alone = input;
    alone.erase("preload");
    const LoadCaseResult without = solved(alone);
    EXPECT_EQ(axial(with, Interface::screw, 11).second, 0.0);
    for (std::size_t k = 0; k < 20; ++k)
      EXPECT_NEAR(with.threads->screw.normal_load[k] / without.threads->screw.normal_load[k], 1.0, 0.02);
    EXPECT_NEAR(with.slip->power.total() / without.slip->power.total(), 1.0, 0.01);
  }
}

/// Two nuts, of which 6 kN open one and 1 kN none; lengths as in the comment of lesson 12.
json double_nut(const char* force, const char* direction) {
  json input = preloaded_screw();
  input["preload"] = {{"arrangement", "double_nut"},
                      {"force", "3 kN"},
                      {"position", "29.1666667 mm"},
                      {"spacer", {{"length", "10 mm"}, {"inner_diameter", "36 mm"}, {"outer_diameter", "46 mm"}}},
                      {"distance", "68.3333333 mm"},
                      {"load", {{"from", "-6 kN"}, {"to", "6 kN"}}}};
  input["load_cases"][0]["axial_force"] = force;
  input["load_cases"][0]["direction"] = direction;
  input["lubricant"] = {{"name", "iso-vg-100"}, {"temperature", "60 degC"}};
  input["roughness"] = "0.2 um";
  return input;
}

class DoubleNut : public testing::TestWithParam<std::tuple<const char*, const char*, const char*>> {
 protected:
  json input() const {
    const auto [force, direction, loads] = GetParam();
    json input = double_nut(force, direction);
    input["model"]["loads"] = loads;
    return input;
  }
};

TEST_P(DoubleNut, CurvesOverSpeedMeetTheSlipOfTheCase) {
  json mixed = input();
  mixed["friction"] = {{"model", {{"mixed", {{"boundary", 0.11}}}}}};
  const Case c = read(mixed);
  const Result result = analyze_slip(c);
  const SlipResult& slip = *result.load_cases[0].slip;
  ASSERT_TRUE(slip.converged());
  const StribeckCurve curve = stribeck_curve(c, result, 0);
  ASSERT_EQ(curve.speed.size(), 41u);
  EXPECT_NEAR(curve.speed[30] / slip.speed, 1.0, 1e-12);
  EXPECT_NEAR(curve.power[30] / slip.power.total(), 1.0, 1e-8);
  ASSERT_EQ(curve.efficiency[30].has_value(), slip.efficiency.has_value());
  EXPECT_NEAR(curve.efficiency[30].value_or(1.0) / slip.efficiency.value_or(1.0), 1.0, 1e-8);
  const InterfaceSlip& nut = slip.of_nut_that_carries(result.load_cases[0].load_case).threads.nut;
  const auto most = std::ranges::max_element(nut.dynamic_normal_load) - nut.dynamic_normal_load.begin();
  EXPECT_NEAR(curve.friction.nut[30] / nut.friction_coefficient.at(static_cast<std::size_t>(most)), 1.0, 1e-8);
}

TEST_P(DoubleNut, TheMomentVanishesAtTheSlipRatioOfTheNutThatCarries) {
  const Case c = read(input());
  const Result result = analyze_slip(c);
  const SlipPictures pictures = slip_pictures(c, result, 0);
  const SlipResult& nut = result.load_cases[0].slip->of_nut_that_carries(result.load_cases[0].load_case);
  const ResidueCurve& curve = pictures.residue_near_root;
  const auto after = std::ranges::find_if(curve.moments, [&](const RollerMoments& m) {
    return std::signbit(m.residue()) != std::signbit(curve.moments.front().residue());
  });
  ASSERT_NE(after, curve.moments.end());
  const auto k = static_cast<std::size_t>(after - curve.moments.begin());
  EXPECT_GE((nut.slip_ratio - curve.slip_ratio[k - 1]) * (curve.slip_ratio[k] - nut.slip_ratio), 0.0);
}

/// N in a row is F_a/(cos psi +- mu sin psi) of the same row, psi = 45 deg and mu <= 0.1, for the threads of both nuts.
TEST_P(DoubleNut, RowsOfThreadsAreThoseOfOneNut) {
  const Result result = analyze_slip(read(input()));
  const auto rows = ::test::parse(slip_threads_csv(result, {.digits = CsvStyle::kAllDigits}));
  ASSERT_EQ(rows.size(), 80u);
  EXPECT_NE(slip_chart(result.load_cases[0]).find("█"), std::string::npos);  // Power of the nut that carries.
  double least = HUGE_VAL, largest = 0.0;
  for (const auto& row : rows) {
    const double axial = std::stod(row.at("axial_load_N"));
    if (axial == 0.0) continue;
    const double ratio = std::stod(row.at("dynamic_normal_load_N")) / axial;
    least = std::min(least, ratio), largest = std::max(largest, ratio);
  }
  EXPECT_GT(least, 1.41 / 1.1);
  EXPECT_LT(largest, 1.42 / 0.9);
}

INSTANTIATE_TEST_SUITE_P(BothFlanks, DoubleNut,
                         testing::Combine(testing::Values("1 kN", "6 kN"), testing::Values("tension", "compression"),
                                          testing::Values("static", "running")));

/// At rest the carrier is pressed by the rollers of the nut that carries.
TEST(BothFlanks, ADoubleNutAtRestPressesOnItsCarrier) {
  json one = double_nut("20 kN", "tension");
  one["operation"]["speed"] = "0 rpm";
  const auto carrier = [](const json& input) {
    const RollerForces f = analyze_slip(read(input)).load_cases[0].slip->holding->against_load.forces;
    return std::hypot(f.carrier_x, f.carrier_y);
  };
  const double of_two = carrier(one);
  one.erase("preload");
  EXPECT_NEAR(of_two / carrier(one), 1.0, 1e-9);
}

TEST(BothFlanks, EqualSharesNeedNoStructure) {
  json input = preloaded_screw();
  input.erase("structure");
  for (json& load : input["load_cases"]) load["share"] = "equal";
  const Result with = analyze_slip(read(input));
  input.erase("preload");
  const Result without = analyze_slip(read(input));
  ASSERT_FALSE(with.load_cases.empty());
  EXPECT_EQ(with.load_cases[0].slip->slip_ratio, without.load_cases[0].slip->slip_ratio);
  EXPECT_EQ(with.load_cases[0].slip->efficiency, without.load_cases[0].slip->efficiency);
}

TEST(BothFlanks, ZeroLoadNeedsPreload) {
  json input = preloaded_screw();
  input["load_cases"][0]["axial_force"] = "0 N";
  EXPECT_THROW(read(input, Command::solve), std::exception);
  input.erase("preload");
  EXPECT_THROW(read(input), std::exception);
}

json with_heat(json input) {
  input["materials"]["thermal_expansion"] = "11.5 um/m/K";
  input["heat"] = {
      {"ambient", "20 degC"},
      {"conductance",
       {{"screw_ambient", "2 W/K"}, {"nut_ambient", "8 W/K"}, {"screw_rollers", "20 W/K"}, {"rollers_nut", "30 W/K"}}}};
  return input;
}

/// Preload at the temperatures of a load case is that of the parts at the temperatures from `heat`.
TEST(WarmParts, PreloadHasTheTemperaturesOfItsLoadCase) {
  json input = with_heat(preloaded_screw());
  const PreloadResult warm = analyze_warm_preload(read(input, Command::preload));
  ASSERT_TRUE(warm.converged());
  EXPECT_EQ(*warm.load_case, "a");
  const HeatResult heat = *analyze_heat(read(input)).load_cases.at(0).heat;
  for (const Part p : kParts) EXPECT_NEAR((*warm.temperature)[p], heat.temperature[p], 1e-6);
  EXPECT_NEAR(warm.reference_force, 2000.0, 2e-3);
  Case stated = read(input, Command::preload);
  stated.heat.reset();
  stated.deviations.temperature = heat.temperature;
  EXPECT_NEAR(warm.force() / analyze_preload(stated).force(), 1.0, 1e-7);
}

json with_life(json input) {
  input.erase("preload");
  input["life"] = {{"position", "29.1666667 mm"},
                   {"spectrum",
                    {{{"force", "5 kN"}, {"direction", "tension"}, {"share", 0.25}},
                     {{"force", "2 kN"}, {"direction", "tension"}, {"share", 0.75}}}}};
  return input;
}

/// One load all the time: the temperatures of its load case. Two loads: those from the mean heat of both.
TEST(WarmParts, LifeHasTheTemperaturesOfTheMeanHeat) {
  json input = with_life(with_heat(preloaded_screw()));
  input["load_cases"][0]["axial_force"] = "5 kN";
  const LifeResult both = analyze_warm_life(read(input, Command::life));
  ASSERT_TRUE(both.converged());
  input["life"]["spectrum"] = {{{"force", "5 kN"}, {"direction", "tension"}, {"share", 1.0}}};
  const LifeResult one = analyze_warm_life(read(input, Command::life));
  const HeatResult heat = *analyze_heat(read(input)).load_cases.at(0).heat;
  for (const Part p : kParts) {
    EXPECT_NEAR((*one.temperature)[p], heat.temperature[p], 1e-6);
    EXPECT_LT((*both.temperature)[p], (*one.temperature)[p]);
  }
  input["life"]["temperatures"] = "reference";
  const LifeResult cold = analyze_warm_life(read(input, Command::life));
  EXPECT_FALSE(cold.temperature);
  EXPECT_NE(cold.system_life, one.system_life);
}

}  // namespace
}  // namespace prs
