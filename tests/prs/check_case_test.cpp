#include "prs/check_case.h"

#include <gtest/gtest.h>

#include <numbers>

namespace prs {
namespace {

/// The screw of Abevi 2015 in CONFIG 1, and a case with equal shares.
Case abevi() {
  Case c;
  c.mechanism.lead = 0.005;
  c.mechanism.starts = {3, 1};
  c.mechanism.flank_angle = {std::numbers::pi / 4, std::numbers::pi / 4, std::numbers::pi / 4};
  c.mechanism.pitch_diameter = {0.021, 0.007, 0.035};
  c.mechanism.centre_distance = 0.014;
  c.mechanism.profile.roller = {Profile::Shape::convex, 4.949747468e-3};
  c.mechanism.rollers = 11;
  c.mechanism.contacts_per_roller = 20;
  c.structure =
      Structure{{0.006, 0.010},
                {0.005, 0.005, {}},
                {0.090, 0.046, {{0.0, 0.010, 0.062}, {0.080, 0.090, 0.062}}, {0.010, 0.080}}};
  c.materials = Materials{{209e9, 0.3, {}}, {209e9, 0.3, {}}, {209e9, 0.3, {}}};
  LoadCase pull;
  pull.name = "pull";
  pull.axial_force = 45e3;
  pull.direction = Direction::tension;
  pull.position = 0.0543333333;
  pull.input_path = "load_cases[0]";
  LoadCase equal;
  equal.name = "equal";
  equal.axial_force = -45e3;
  equal.share = LoadCase::Share::equal;
  equal.input_path = "load_cases[1]";
  c.load_cases = {pull, equal};
  return c;
}

/// Paths of the problems, one after the other.
std::string paths(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& p : problems) text += (text.empty() ? "" : " ") + p.path;
  return text;
}

TEST(CheckCase, AbeviIsSound) {
  EXPECT_EQ(paths(check_case(abevi())), "");
  EXPECT_EQ(paths(check_requirements(abevi(), Command::solve)), "");
}

TEST(CheckCase, ContactsMayEndAtTheNutsFaces) {
  Case c = abevi();
  const double last = 0.090 - 19 * axial_pitch(c.mechanism);
  for (double position : {0.0, last, -1e-12, last + 1e-12}) {
    c.load_cases[0].position = position;
    EXPECT_EQ(paths(check_case(c)), "") << position;
  }
  for (double position : {-1e-9, last + 1e-9}) {
    c.load_cases[0].position = position;
    EXPECT_EQ(paths(check_case(c)), "load_cases[0].position") << position;
  }
}

TEST(CheckCase, FlangesMayTouchInAnyOrder) {
  Case c = abevi();
  c.structure->nut.flanges = {{0.080, 0.090, 0.062}, {0.0, 0.010, 0.062}, {0.010, 0.020, 0.050}};
  EXPECT_EQ(paths(check_case(c)), "");
  c.structure->nut.flanges[2].from = 0.0099;
  EXPECT_EQ(paths(check_case(c)), "structure.nut.flanges[2]");
}

TEST(CheckCase, PublishedNegativeBacklashIsSound) {
  Case c = abevi();
  for (double offset : {-0.2e-3, -0.064e-3, 0.107e-3}) {
    c.mechanism.centre_distance = 0.014 + offset;
    EXPECT_EQ(paths(check_case(c)), "") << offset;
  }
}

TEST(CheckCase, PartsThatCannotMeetAreRefused) {
  Case c = abevi();
  c.mechanism.centre_distance = 0.016;
  EXPECT_EQ(paths(check_case(c)), "mechanism.centre_distance mechanism.pitch_diameter.nut");
}

TEST(CheckCase, AsManyRollersAsFitAreSound) {
  Case c = abevi();
  c.mechanism.rollers = 12;
  EXPECT_EQ(paths(check_case(c)), "");
  c.mechanism.rollers = 13;
  EXPECT_EQ(paths(check_case(c)), "mechanism.rollers");
}

TEST(CheckCase, DesignModeIsJudgedByWhatIsGiven) {
  Case c = abevi();
  c.mechanism.geometry = Mechanism::Geometry::design;
  c.mechanism.pitch_diameter = {0.021, {}, {}};
  c.mechanism.centre_distance.reset();
  EXPECT_EQ(paths(check_case(c)), "");
  c.structure.reset();
  c.mechanism.lead = 0.130;
  EXPECT_EQ(paths(check_case(c)), "mechanism.lead");
}

TEST(CheckCase, EachPathHasOneProblem) {
  Case c = abevi();
  LoadCase& pull = c.load_cases[0];
  pull.axial_force = -1.0;
  c.load_cases.push_back(pull);
  c.load_cases.back().name = "pull[1]";
  EXPECT_EQ(paths(check_case(c)), "load_cases[0].axial_force");
}

TEST(CheckRequirements, FollowTheCommand) {
  Case c;
  c.mechanism = abevi().mechanism;
  for (Command command : {Command::check, Command::contact, Command::measures})
    EXPECT_EQ(paths(check_requirements(c, command)), "");
  EXPECT_EQ(paths(check_requirements(c, Command::solve)), "load_cases materials");
  EXPECT_EQ(paths(check_requirements(c, Command::slip)), "load_cases materials friction");
}

TEST(CheckRequirements, EqualSharesNeedNoStructure) {
  Case c = abevi();
  c.structure.reset();
  EXPECT_EQ(paths(check_requirements(c, Command::solve)), "structure");
  c.load_cases.erase(c.load_cases.begin());
  EXPECT_EQ(paths(check_requirements(c, Command::solve)), "");
}

TEST(CheckRequirements, JacodNeedsALubricantAndSlipASpeed) {
  Case c = abevi();
  c.load_cases.pop_back();
  c.friction = Friction{};
  EXPECT_EQ(paths(check_requirements(c, Command::slip)), "lubricant operation");
  c.friction->model = Friction::Model::coulomb;
  c.load_cases[0].speed = 40.0;
  EXPECT_EQ(paths(check_requirements(c, Command::slip)), "");
}

TEST(CheckRequirements, ForceAndSpeedHaveOneSign) {
  Case c = abevi();
  c.friction = Friction{Friction::Model::coulomb, 0.1};
  c.operation = Operation{40.0};
  EXPECT_EQ(paths(check_requirements(c, Command::slip)), "load_cases[1]");
  c.load_cases[1].speed = -40.0;
  EXPECT_EQ(paths(check_requirements(c, Command::slip)), "");
  c.load_cases[0].speed = 0.0;
  const std::vector<Problem> problems = check_requirements(c, Command::slip);
  EXPECT_EQ(paths(problems), "load_cases[0].speed");
  EXPECT_NE(problems[0].message.find("case `pull`"), std::string::npos);
  c.load_cases[0].direction = Direction::compression;
  c.load_cases[0].speed = -1.0;
  EXPECT_EQ(paths(check_requirements(c, Command::slip)), "");
}

TEST(CheckCase, TheDirectionOfALoadNeedsItsThrustSection) {
  Case c = abevi();
  c.structure->nut.thrust.tension.reset();
  EXPECT_EQ(paths(check_case(c)), "structure.nut.thrust.tension");
}

}  // namespace
}  // namespace prs
