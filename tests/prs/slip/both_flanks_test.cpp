#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>

#include "prs/heat/analyze_heat.h"
#include "prs/input/reader.h"
#include "prs/slip/slip.h"

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
