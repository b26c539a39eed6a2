#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "prs/input/reader.h"
#include "prs/life/analyze_life.h"
#include "prs/life/contact_loads.h"
#include "prs/life/load_history.h"
#include "prs/slip/slip.h"

namespace prs {
namespace {

/// The screw of 25 mm x 5 mm that `prs new` designs for 20 kN, bodies of bars.
Case base() {
  const auto all = nlohmann::json::parse(std::ifstream(PRS_SOURCE_DIR "/tests/prs/slip/running_cases.json"));
  nlohmann::json input = all["cases"][0]["input"];
  input["mechanism"]["contacts_per_roller"] = 50;
  input["structure"]["nut"]["length"] = "73 mm";
  input["structure"]["nut"]["thrust"]["compression"] = "73 mm";
  input["operation"]["speed"] = "3000 rpm";
  Case c = input::read_case_text(input.dump(), "case", {}, Command::slip);
  c.life.emplace();
  c.life->position = 12e-3;
  c.life->spectrum = {{}};
  c.life->spectrum[0].force = 20e3;
  c.life->spectrum[0].share = 1.0;
  return c;
}

/// Life on running loads over that on static ones.
double life_over_static(Direction d, DrivenBy by) {
  Case c = base();
  c.life->spectrum[0].direction = d;
  c.life->spectrum[0].driven_by = by;
  const LifeResult running = analyze_life(c);
  EXPECT_EQ(running.loads, ModelOptions::Loads::running);
  c.model.loads = ModelOptions::Loads::at_rest;
  const LifeResult at_rest = analyze_life(c);
  EXPECT_FALSE(at_rest.life_at_rest);
  EXPECT_EQ(running.life_at_rest, at_rest.system_life);
  EXPECT_EQ(running.static_safety(), at_rest.static_safety());
  return running.system_life / at_rest.system_life;
}

TEST(RunningLife, FollowsWhoDrives) {
  EXPECT_NEAR(life_over_static(Direction::tension, DrivenBy::screw), 1.0 - 0.346, 5e-4);
  EXPECT_NEAR(life_over_static(Direction::compression, DrivenBy::screw), 1.0 - 0.262, 5e-4);
  EXPECT_NEAR(life_over_static(Direction::tension, DrivenBy::load), 1.0 + 0.358, 5e-4);
  EXPECT_NEAR(life_over_static(Direction::compression, DrivenBy::load), 1.0 + 0.256, 5e-4);
}

TEST(RunningLife, LargestLoadsAndPressuresAreThoseOfTheRunningScrew) {
  const Case c = base();
  const LifeResult life = analyze_life(c);
  const FlankLife& flank = *life.flanks.tension;
  Case one = c;
  one.life.reset();
  one.load_cases = {driven_load_case(c, c.mechanism.lead, Direction::tension, DrivenBy::screw)};
  one.load_cases[0].axial_force = 20e3;
  const Result slip = analyze_slip(one);
  for (const Interface i : kInterfaces) {
    const InterfaceLoads& threads = (*slip.load_cases[0].threads)[i];
    EXPECT_NEAR(*flank.running_peak_pressure[i] / std::ranges::max(threads.peak_pressure), 1.0, 1e-9);
    EXPECT_GE(*flank.peak_pressure[i], *flank.running_peak_pressure[i]);
    // Under one load its mean is no larger.
    EXPECT_GE(std::ranges::max(flank.threads[i].largest_load) * (1.0 + 1e-9),
              std::ranges::max(flank.threads[i].equivalent_load));
  }
}

/// With play nothing touches without a load, and under one the other flanks stay open where guides hold the rollers:
/// the life is that of the same screw without the block `preload`.
TEST(RunningLife, WithPlayIsThatOfOneFlank) {
  Case c = base();
  c.structure->roller.guidance = {};
  const double alone = analyze_life(c).system_life;
  Preload& preload = c.preload.emplace();
  preload.position = *c.life->position;
  preload.load = {-20e3, 20e3, 2};
  for (const double backlash : {10e-6, 200e-6}) {
    preload.backlash = backlash;
    const LifeResult r = analyze_life(c);
    ASSERT_TRUE(r.converged()) << *r.failure;
    EXPECT_NEAR(r.system_life / alone, 1.0, 1e-9) << backlash;
  }
}

/// A preload that warm parts have lost: nothing touches, nothing rubs.
TEST(RunningLife, ALoosePreloadedNutTurnsFreely) {
  Case c = base();
  c.life.reset();
  c.materials->nut.thermal_expansion = c.materials->screw.thermal_expansion = c.materials->roller.thermal_expansion =
      11.5e-6;
  c.deviations.temperature = PerPart<double>{293.15, 293.15, 353.15};
  Preload& preload = c.preload.emplace();
  preload.position = 12e-3;
  preload.load = {-20e3, 20e3, 2};
  preload.force = 500.0;
  LoadCase rest;
  rest.name = "rest";
  rest.direction = Direction::tension;
  rest.position = 12e-3;
  c.load_cases = {rest};
  const LoadCaseResult r = analyze_slip(c).load_cases.front();
  ASSERT_TRUE(r.threads && r.slip);
  EXPECT_TRUE(r.running->converged());
  EXPECT_EQ(std::ranges::max(r.threads->screw.normal_load), 0.0);
  EXPECT_FALSE(r.threads->screw.running_over_static);
  EXPECT_EQ(r.slip->power.total(), 0.0);
}

/// Damage of both senses adds up: 2/L = 1/L_screw + 1/L_load, thread by thread before all of them.
TEST(RunningLife, OfBothSensesLiesBetweenThem) {
  Case c = base();
  c.life->spectrum.push_back(c.life->spectrum[0]);
  for (SpectrumLoad& load : c.life->spectrum) load.share = 0.5;
  const auto life_of = [&](DrivenBy first, DrivenBy second) {
    c.life->spectrum[0].driven_by = first;
    c.life->spectrum[1].driven_by = second;
    return analyze_life(c).flanks.tension->threads.screw.life.front();
  };
  const double screw = life_of(DrivenBy::screw, DrivenBy::screw);
  const double load = life_of(DrivenBy::load, DrivenBy::load);
  EXPECT_NEAR(life_of(DrivenBy::screw, DrivenBy::load), 2.0 / (1.0 / screw + 1.0 / load), 1e-9 * screw);
}

/// Position grows as the screw moves out at its loaded end, along tension.
TEST(RunningLife, TravelTellsWhoDrives) {
  LoadHistory h;
  h.force = {10e3, 10e3, -10e3};
  h.position = {0.0, 5e-3, 10e-3};
  using By = HistorySource::DrivenBy;
  const auto driven = [&](By by) {
    std::vector<double> share;
    for (const LoadStep& step : load_steps(h, 5e-3, {}, by)) share.push_back(step.driven_by_load / step.revolutions);
    return share;
  };
  EXPECT_EQ(driven(By::travel), (std::vector<double>{1.0, 1.0, 0.0}));
  EXPECT_EQ(driven(By::screw), (std::vector<double>{0.0, 0.0, 0.0}));
  EXPECT_EQ(driven(By::load), (std::vector<double>{1.0, 1.0, 1.0}));
  // F omega l < 0 is driven by the load; omega l > 0 pulls the screw in.
  h.position.clear();
  h.interval = 1.0;
  h.speed = {-10.0, -10.0, -10.0};
  EXPECT_EQ(driven(By::travel), (std::vector<double>{1.0, 1.0, 0.0}));
}

}  // namespace
}  // namespace prs
