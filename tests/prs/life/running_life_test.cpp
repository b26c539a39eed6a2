#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "prs/input/reader.h"
#include "prs/life/analyze_life.h"
#include "prs/life/contact_loads.h"

namespace prs {
namespace {

/// The screw of 25 mm x 5 mm that `prs new` designs for 20 kN, bodies of bars.
Case base() {
  const auto all =
      nlohmann::json::parse(std::ifstream(PRS_SOURCE_DIR "/tests/prs/slip/running_cases.json"));
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

double life_over_static(Direction d) {
  Case c = base();
  c.life->spectrum[0].direction = d;
  const double at_rest = analyze_life(c).system_life;
  c.model.loads = ModelOptions::Loads::running;
  return analyze_life(c).system_life / at_rest;
}

TEST(RunningLife, FallsWhereTheScrewDrives) {
  EXPECT_NEAR(life_over_static(Direction::tension), 1.0 - 0.346, 5e-4);
  EXPECT_NEAR(life_over_static(Direction::compression), 1.0 - 0.262, 5e-4);
}

TEST(RunningLife, LargestLoadsStayThoseAtRest) {
  Case c = base();
  c.model.loads = ModelOptions::Loads::running;
  const Contacts contacts = checked_contacts(c, Detail::numbers);
  const LifeModel model{c, contacts, contact_laws(c, contacts), DrivenBy::load};
  Case rest = c;
  rest.model.loads = ModelOptions::Loads::at_rest;
  const LifeModel still{rest, contacts, model.laws};
  const auto loads = contact_solvers(model, {true, false}).tension(20e3);
  const auto at_rest = contact_solvers(still, {true, false}).tension(20e3);
  ASSERT_TRUE(loads && at_rest);
  EXPECT_EQ(loads->largest.tension.screw, at_rest->largest.tension.screw);
  EXPECT_LT(loads->rated.front(), at_rest->rated.front());
}

}  // namespace
}  // namespace prs
