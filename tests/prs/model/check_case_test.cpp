#include "prs/model/check_case.h"
#include "prs/bodies/body_models.h"
#include "prs/model/motor_duty.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace prs {
namespace {

/// The screw of Abevi 2015 in CONFIG 1, and a case with equal shares.
Case abevi_case() {
  Case c;
  c.mechanism.lead = 0.005;
  c.mechanism.starts = {3, 1};
  c.mechanism.flank_angle = {std::numbers::pi / 4, std::numbers::pi / 4, std::numbers::pi / 4};
  c.mechanism.pitch_diameter = {0.021, 0.007, 0.035};
  c.mechanism.centre_distance = 0.014;
  c.mechanism.profile.roller = {Profile::Shape::convex, 4.949747468e-3};
  c.mechanism.rollers = 11;
  c.mechanism.contacts_per_roller = 20;
  c.structure = Structure{
      {0.006, 0.010}, {0.005, 0.005, {}}, {0.090, 0.046, {{0.0, 0.010, 0.062}, {0.080, 0.090, 0.062}}, {0.010, 0.080}}};
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

/// Paths of the problems, joined.
std::string paths(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& p : problems) text += (text.empty() ? "" : " ") + p.path;
  return text;
}

TEST(CheckCase, AbeviIsSound) {
  EXPECT_EQ(paths(check_case(abevi_case())), "");
  EXPECT_EQ(paths(missing(abevi_case(), Command::solve)), "");
}

TEST(CheckCase, OnlyBarsTakeTheThicknessOfThreads) {
  Case c = abevi_case();
  c.mechanism.thread.roller = ThreadHeight{0.2e-3, 0.2e-3, 0.8e-3};
  EXPECT_EQ(paths(check_case(c)), "");
  c.model.bodies = &kRefined;
  EXPECT_EQ(paths(check_case(c)), "mechanism.thread.roller.thickness");
}

TEST(CheckCase, ContactsMayEndAtTheNutsFaces) {
  Case c = abevi_case();
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

/// abevi_case() with another model of its bodies.
Case with_bodies(ModelOptions::Bodies bodies) {
  Case c = abevi_case();
  c.model.bodies = bodies;
  return c;
}

TEST(CheckCase, AShoulderMustMeetAFaceOfTheNut) {
  for (const auto bodies : {&kRefined, &kInfluence}) {
    Case c = with_bodies(bodies);
    c.structure->nut.shoulder = {0.050, 0.062};
    EXPECT_EQ(paths(check_case(c)), "");
    c.structure->nut.thrust.tension = 0.0099;
    EXPECT_EQ(paths(check_case(c)), "structure.nut.shoulder");
    c.structure->nut.shoulder.reset();
    EXPECT_EQ(paths(check_case(c)), "");
    c.structure->nut.thrust.tension = 0.010;
    c.structure->nut.shoulder = {0.036, 0.046};
    EXPECT_EQ(paths(check_case(c)), "structure.nut.shoulder");
    c.structure->nut.shoulder = {0.062, 0.070};
    EXPECT_NE(paths(check_case(c)), "");
    c.structure->nut.shoulder = {0.060, 0.050};
    EXPECT_NE(paths(check_case(c)), "");
  }
}

TEST(CheckCase, ThreadedWallsMustCarry) {
  Case c = with_bodies(&kInfluence);
  c.structure->screw.bore = 0.0195;
  EXPECT_EQ(paths(check_case(c)), "structure.screw.bore");
  c.model.bodies = &kRefined;
  EXPECT_EQ(paths(check_case(c)), "");
  c.structure->screw.bore = 0.0204;
  EXPECT_EQ(paths(check_case(c)), "structure.screw.bore");
  c.model.bodies = &kBars;
  EXPECT_EQ(paths(check_case(c)), "");

  c = with_bodies(&kInfluence);
  c.structure->nut.flanges.clear();
  c.structure->nut.thrust = {.tension = 0.0, .compression = 0.090};
  c.structure->nut.outer_diameter = 0.0365;
  EXPECT_EQ(paths(check_case(c)), "structure.nut.outer_diameter");
  c.model.bodies = &kRefined;
  EXPECT_EQ(paths(check_case(c)), "");
  c.structure->nut.outer_diameter = 0.0353;
  EXPECT_EQ(paths(check_case(c)), "structure.nut.outer_diameter");
}

TEST(CheckCase, WallsUnderFlangesMustCarry) {
  for (const bool stated : {false, true}) {
    Case c = with_bodies(&kRefined);
    if (stated)
      for (const Part part : kParts) c.mechanism.thread[part] = ThreadHeight{0.25e-3, 0.30e-3};
    const auto paths_at = [&](double diameter) {
      c.structure->nut.flanges = {{0.0, 0.010, 0.062}, {0.087, 0.088, diameter}};
      return paths(check_case(c));
    };
    c.structure->nut.thrust.compression = 0.010;
    const std::string path = "structure.nut.flanges[1].outer_diameter";
    // 0.1 of the pitch 5/3 mm outside the pitch diameter of 35 mm.
    EXPECT_EQ(paths_at(0.0351), path);
    EXPECT_EQ(paths_at(0.03533), path);
    EXPECT_EQ(paths_at(0.03534), "");
    EXPECT_EQ(paths_at(0.036), "");
    c.model.bodies = &kBars;
    EXPECT_EQ(paths_at(0.0351), "");
    // A mesh needs 0.42 of it below the roots.
    c.model.bodies = &kInfluence;
    const double root = stated ? 0.30e-3 : 0.23 * 5e-3 / 3, least = 0.42 * 5e-3 / 3;
    EXPECT_EQ(paths_at(0.035 + 2.0 * (root + least) - 1e-5), path);
    EXPECT_EQ(paths_at(0.035 + 2.0 * (root + least) + 1e-5), "");
  }
}

TEST(CheckCase, TeethMustHaveHeightAndFlanksThatHaveNotMet) {
  Case c = with_bodies(&kInfluence);
  c.mechanism.thread.roller = ThreadHeight{0.01e-3, 0.30e-3};
  EXPECT_EQ(paths(check_case(c)), "mechanism.thread.roller.addendum");
  c.mechanism.thread.roller = ThreadHeight{0.25e-3, 0.45e-3};
  EXPECT_EQ(paths(check_case(c)), "mechanism.thread.roller.dedendum");
  c.model.bodies = &kBars;
  EXPECT_EQ(paths(check_case(c)), "");
}

TEST(CheckCase, OptionsOfOtherBodiesAreRefused) {
  Case c = with_bodies(&kInfluence);
  c.mechanism.rollers = 1;
  EXPECT_EQ(paths(check_case(c)), "mechanism.rollers");
  c.mechanism.rollers = 2;
  c.model.roller = ModelOptions::Roller::rigid_bending;
  EXPECT_EQ(paths(check_case(c)), "model.roller");
  c.model.bodies = &kRefined;
  EXPECT_EQ(paths(check_case(c)), "");
  c.model.roller_shear = true;
  EXPECT_EQ(paths(check_case(c)), "model.roller_shear");
  c = abevi_case();
  c.model.tooth_compliance = {ModelOptions::ToothCompliance::Kind::yamamoto, 1e-12};
  EXPECT_EQ(paths(check_case(c)), "model.tooth_compliance.yamamoto");
}

TEST(CheckCase, FlangesMayTouchInAnyOrder) {
  Case c = abevi_case();
  c.structure->nut.flanges = {{0.080, 0.090, 0.062}, {0.0, 0.010, 0.062}, {0.010, 0.020, 0.050}};
  EXPECT_EQ(paths(check_case(c)), "");
  c.structure->nut.flanges[2].from = 0.0099;
  EXPECT_EQ(paths(check_case(c)), "structure.nut.flanges[2]");
}

TEST(CheckCase, PublishedNegativeBacklashIsSound) {
  Case c = abevi_case();
  for (double offset : {-0.2e-3, -0.064e-3, 0.107e-3}) {
    c.mechanism.centre_distance = 0.014 + offset;
    EXPECT_EQ(paths(check_case(c)), "") << offset;
  }
}

TEST(CheckCase, PartsThatCannotMeetAreRefused) {
  Case c = abevi_case();
  c.mechanism.centre_distance = 0.016;
  EXPECT_EQ(paths(check_case(c)), "mechanism.centre_distance mechanism.pitch_diameter.nut");
}

TEST(CheckCase, AsManyRollersAsFitAreSound) {
  Case c = abevi_case();
  c.mechanism.rollers = 11;
  EXPECT_EQ(paths(check_case(c)), "");
  c.mechanism.rollers = 12;  // 28 mm sin(15 deg) = 7.25 mm < 7 mm + 0.3 p.
  EXPECT_EQ(paths(check_case(c)), "mechanism.rollers");
}

/// Contradictory blocks `motor`, each with its place.
TEST(CheckCase, AMotorIsHeldAgainstItselfAndTheLoadCases) {
  const Case c = abevi_case();
  MotorDuty duty;
  duty.motor.rated_torque = 5.0;
  duty.motor.peak_torque = 4.0;
  duty.driven_back = "nobody";
  duty.cycle.resize(2);
  duty.cycle[0].load_case = "none";
  duty.cycle[1].load_case = "pull";
  EXPECT_EQ(paths(check_motor(duty, c)), "motor.peak_torque motor.driven_back motor.cycle[0].load_case");
  duty.motor.peak_torque = 5.0;
  duty.driven_back = "pull";
  duty.cycle.erase(duty.cycle.begin());
  EXPECT_EQ(paths(check_motor(duty, c)), "");
}

TEST(CheckCase, DesignModeIsJudgedByWhatIsGiven) {
  Case c = abevi_case();
  c.mechanism.geometry = Mechanism::Geometry::design;
  c.mechanism.pitch_diameter = {0.021, {}, {}};
  c.mechanism.centre_distance.reset();
  EXPECT_EQ(paths(check_case(c)), "");
  c.structure.reset();
  c.mechanism.lead = 0.130;
  EXPECT_EQ(paths(check_case(c)), "mechanism.lead");
}

TEST(CheckCase, EachPathHasOneProblem) {
  Case c = abevi_case();
  LoadCase& pull = c.load_cases[0];
  pull.axial_force = -1.0;
  c.load_cases.push_back(pull);
  c.load_cases.back().name = "pull[1]";
  EXPECT_EQ(paths(check_case(c)), "load_cases[0].axial_force");
}

TEST(CheckRequirements, FollowTheCommand) {
  Case c;
  c.mechanism = abevi_case().mechanism;
  for (Command command : {Command::check, Command::contact, Command::measures})
    EXPECT_EQ(paths(missing(c, command)), "");
  EXPECT_EQ(paths(missing(c, Command::solve)), "load_cases materials");
  EXPECT_EQ(paths(missing(c, Command::slip)), "load_cases materials friction");
}

TEST(CheckRequirements, EqualSharesNeedNoStructure) {
  Case c = abevi_case();
  c.structure.reset();
  EXPECT_EQ(paths(missing(c, Command::solve)), "structure");
  c.load_cases.erase(c.load_cases.begin());
  EXPECT_EQ(paths(missing(c, Command::solve)), "");
}

TEST(CheckRequirements, JacodNeedsALubricantAndSlipASpeed) {
  Case c = abevi_case();
  c.load_cases.pop_back();
  c.friction = Friction{};
  EXPECT_EQ(paths(missing(c, Command::slip)), "lubricant operation");
  c.friction->kind = contact::kind_of<contact::Mixed>;
  EXPECT_EQ(paths(missing(c, Command::slip)), "lubricant roughness operation");
  c.friction->kind = contact::kind_of<contact::Coulomb>;
  c.load_cases[0].speed = 40.0;
  EXPECT_EQ(paths(missing(c, Command::slip)), "");
}

TEST(CheckRequirements, ScrewOrLoadMayDriveAndAFilmHoldsNothingAtRest) {
  Case c = abevi_case();
  c.friction = friction_by(contact::Coulomb{at_both(0.1)});
  for (const double lead : {0.005, -0.005})
    for (const double speed : {40.0, -40.0}) {
      c.mechanism.lead = lead;
      c.operation = Operation{speed, {}};
      EXPECT_EQ(paths(missing(c, Command::slip)), "") << lead << " " << speed;
    }
  c.load_cases.resize(1);
  c.load_cases[0].speed = 0.0;
  EXPECT_EQ(paths(missing(c, Command::slip)), "");
  c.friction = Friction{};
  c.lubricant.emplace().viscosity = 0.1;
  const std::vector<Problem> problems = missing(c, Command::slip);
  ASSERT_EQ(paths(problems), "load_cases[0].speed");
  EXPECT_NE(problems[0].message.find("case `pull`"), std::string::npos);
  EXPECT_NE(problems[0].message.find("other than 0"), std::string::npos);
  c.load_cases[0].speed.reset();
  c.operation = Operation{0.0, {}};
  EXPECT_EQ(paths(missing(c, Command::slip)), "operation.speed");
}

TEST(CheckRequirements, ABearingNeedsALubricantWithAnyFriction) {
  Case c = abevi_case();
  c.load_cases.pop_back();
  c.friction = friction_by(contact::Coulomb{at_both(0.1)});
  c.operation = Operation{40.0, {}};
  c.carrier.bearing = HeadBearing{{0.004, 0.005, 15e-6}};
  EXPECT_EQ(paths(missing(c, Command::slip)), "lubricant");
  c.lubricant.emplace().viscosity = 0.1;
  EXPECT_EQ(paths(missing(c, Command::slip)), "");
}

TEST(CheckCase, BearingsAreThinFilmsAndShort) {
  Case c = abevi_case();
  HeadBearing& b = c.carrier.bearing.emplace();
  b = {{0.010, 0.005, 0.499e-3}};
  EXPECT_EQ(paths(check_case(c)), "");
  b = {{0.0101, 0.005, 0.501e-3}};
  EXPECT_EQ(paths(check_case(c)), "carrier.bearing.radial_clearance carrier.bearing.length");
  b = {{0.004, 0.005, 15e-6}};
  c.carrier.roller_torque = 1e-3;
  EXPECT_EQ(paths(check_case(c)), "carrier.roller_torque");
}

/// 100 mm^2/s at 40 degC and 11 mm^2/s at 100 degC, used at 60 degC.
Lubricant oil() {
  Lubricant l;
  l.pressure_viscosity = 30e-9;
  l.eyring_stress = 12e6;
  l.temperature = 333.15;
  l.density = 870.0;
  l.viscosity_at = {{313.15, {}, 100e-6}, {373.15, {}, 11e-6}};
  return l;
}

TEST(CheckCase, ALineThroughTwoPointsFalls) {
  Case c = abevi_case();
  c.lubricant = oil();
  EXPECT_EQ(paths(check_case(c)), "");
  std::swap(c.lubricant->viscosity_at[0], c.lubricant->viscosity_at[1]);
  EXPECT_EQ(paths(check_case(c)), "");
  c.lubricant->viscosity_at[0].kinematic_viscosity = 100e-6;
  EXPECT_EQ(paths(check_case(c)), "lubricant.viscosity_at[0].kinematic_viscosity");
  c.lubricant->viscosity_at[0].temperature = 313.15;
  EXPECT_EQ(paths(check_case(c)), "lubricant.viscosity_at[1].temperature");
  c.lubricant->viscosity_at.pop_back();
  EXPECT_EQ(paths(check_case(c)), "lubricant.viscosity_at");
}

TEST(CheckCase, DensityIsNeededWhereAViscosityIsKinematic) {
  Case c = abevi_case();
  c.lubricant = oil();
  c.lubricant->density.reset();
  EXPECT_EQ(paths(check_case(c)), "lubricant.density");
  c.lubricant->viscosity_at = {{313.15, 87e-3, {}}, {373.15, 9.57e-3, {}}};
  EXPECT_EQ(paths(check_case(c)), "");
  c.lubricant->viscosity_at.clear();
  c.lubricant->walther = contact::WaltherLine{9.5, 3.7};
  EXPECT_EQ(paths(check_case(c)), "lubricant.density");
}

TEST(InOperation, AViscosityAsGivenIsTaken) {
  Lubricant l;
  l.viscosity = 0.1665;
  l.pressure_viscosity = 30e-9;
  l.eyring_stress = 12e6;
  const contact::Lubricant in = in_operation(l);
  EXPECT_EQ(in.viscosity, 0.1665);
  EXPECT_EQ(in.pressure_viscosity, 30e-9);
  EXPECT_EQ(in.eyring_stress, 12e6);
}

TEST(InOperation, ViscosityFollowsTheTemperature) {
  // nu(60 degC) by the formula of ASTM D341, computed independently: 39.66495 mm^2/s for 0.87 kg/dm^3.
  const double by_points = in_operation(oil()).viscosity;
  const double y_40 = std::log10(std::log10(100.7)), y_100 = std::log10(std::log10(11.7));
  const double y = y_40 + (y_100 - y_40) * std::log10(333.15 / 313.15) / std::log10(373.15 / 313.15);
  EXPECT_NEAR(by_points / (870e-6 * (std::pow(10.0, std::pow(10.0, y)) - 0.7)), 1.0, 1e-12);

  Lubricant line = oil();
  line.viscosity_at.clear();
  line.walther = contact::walther_line(313.15, 100e-6, 373.15, 11e-6);
  EXPECT_NEAR(in_operation(line).viscosity / by_points, 1.0, 1e-13);

  Lubricant mixed = oil();
  mixed.viscosity_at[0] = {313.15, 100e-6 * 870.0, {}};
  EXPECT_NEAR(in_operation(mixed).viscosity / by_points, 1.0, 1e-13);

  for (const auto& [temperature, kinematic] : {std::pair{313.15, 100e-6}, {373.15, 11e-6}}) {
    Lubricant at = oil();
    at.temperature = temperature;
    EXPECT_NEAR(in_operation(at).viscosity / (870.0 * kinematic), 1.0, 1e-12);
  }
}

TEST(InOperation, TheDensityBetweenDynamicViscositiesHardlyMatters) {
  Lubricant l = oil();
  l.viscosity_at = {{313.15, 87e-3, {}}, {373.15, 9.57e-3, {}}};
  for (const double temperature : {313.15, 333.15, 353.15, 373.15, 393.15}) {
    l.temperature = temperature;
    l.density.reset();
    const double unknown = in_operation(l).viscosity;
    for (const double density : {783.0, 957.0}) {
      l.density = density;
      EXPECT_NEAR(in_operation(l).viscosity / unknown, 1.0, 5e-3) << temperature << density;
    }
  }
}

TEST(CheckCase, TheDirectionOfALoadNeedsItsThrustSection) {
  Case c = abevi_case();
  c.structure->nut.thrust.tension.reset();
  EXPECT_EQ(paths(check_case(c)), "structure.nut.thrust.tension");
}

/// The screw of Abevi with a spacer between two nuts.
Case two_nuts() {
  Case c = abevi_case();
  Preload& p = c.preload.emplace();
  p.arrangement = Preload::Arrangement::double_nut;
  p.force = 3e3;
  p.position = 0.029;
  p.spacer = Spacer{0.010, 0.037, 0.046};
  p.distance = 0.068;
  p.load = {-9e3, 9e3, 3};
  return c;
}

TEST(CheckCase, BothNutsOfAPreloadHoldTheirRollers) {
  Case c = two_nuts();
  EXPECT_EQ(paths(check_case(c)), "");
  EXPECT_EQ(paths(missing(c, Command::preload)), "");
  // The distance from the first nut's last contact to its end, over the spacer; the second may be anywhere.
  const double span = 19 * axial_pitch(c.mechanism);
  const double least = 0.090 - 0.029 - span + 0.010;
  for (const double distance : {least, least + 0.090 - span}) {
    c.preload->distance = distance;
    EXPECT_EQ(paths(check_case(c)), "") << distance;
  }
  for (const double distance : {least - 1e-9, least + 0.090 - span + 1e-9}) {
    c.preload->distance = distance;
    EXPECT_EQ(paths(check_case(c)), "preload.distance") << distance;
  }
  c.preload->position = 0.0584;
  EXPECT_EQ(paths(check_case(c)), "preload.position");
}

TEST(CheckCase, RollersOfBothNutsKeepApart) {
  Case c = two_nuts();
  const double span = 19 * axial_pitch(c.mechanism);
  c.preload->position = 0.090 - span;
  c.preload->spacer->length = 0.002;
  const double clear = axial_pitch(c.mechanism) + 2 * 0.005;
  c.preload->distance = clear;
  EXPECT_EQ(paths(check_case(c)), "");
  c.preload->distance = clear - 1e-9;
  EXPECT_EQ(paths(check_case(c)), "preload.distance");
}

TEST(CheckCase, ASpacerMeetsTheFacesOfTheNuts) {
  Case c = two_nuts();
  c.preload->spacer = Spacer{0.010, 0.045, 0.045};
  EXPECT_EQ(paths(check_case(c)), "preload.spacer.inner_diameter");
  c.preload->spacer = Spacer{0.010, 0.046, 0.050};
  EXPECT_EQ(paths(check_case(c)), "preload.spacer.inner_diameter");
  c.preload->spacer = Spacer{0.010, 0.030, 0.035};
  EXPECT_EQ(paths(check_case(c)), "preload.spacer.outer_diameter");
  c.preload->spacer = Spacer{0.010, *c.mechanism.pitch_diameter.screw, 0.046};
  EXPECT_EQ(paths(check_case(c)), "preload.spacer.inner_diameter");
}

TEST(CheckCase, APreloadNamesALoadCaseOrARangeOfThem) {
  Case c = two_nuts();
  c.load_cases = {{}, {}};
  c.load_cases[0].name = "push", c.load_cases[1].name = "pull[0]";
  for (const auto& [name, wrong] : {std::pair{"push", ""},
                                    {"pull", ""},
                                    {"pull[0]", ""},
                                    {"pu", "preload.load_case"},
                                    {"pus", "preload.load_case"}}) {
    c.preload->load_case = name;
    const std::string found = paths(check_case(c));
    EXPECT_EQ(found.find("preload.load_case") != found.npos, *wrong != 0) << name << ": " << found;
  }
}

TEST(CheckCase, APreloadIsHeldSomewhereAndWithinTheThreads) {
  Case c = two_nuts();
  c.load_cases.clear();
  c.structure->nut.thrust = {{}, 0.010};
  EXPECT_EQ(paths(check_case(c)), "");
  c.structure->nut.thrust = {};
  EXPECT_EQ(paths(check_case(c)), "structure.nut.thrust");
  c = two_nuts();
  c.preload->interference = 0.26 * axial_pitch(c.mechanism);
  c.preload->backlash = 0.26 * axial_pitch(c.mechanism);
  c.preload->load = {1.0, 1.0, 2};
  EXPECT_EQ(paths(check_case(c)), "preload.interference preload.backlash preload.load.to");
}

TEST(CheckRequirements, PreloadNeedsPartsAndOneDimensionalBodies) {
  Case c;
  c.mechanism = abevi_case().mechanism;
  EXPECT_EQ(paths(missing(c, Command::preload)), "preload materials structure");
  c = two_nuts();
  c.model.bodies = &kInfluence;
  EXPECT_EQ(paths(missing(c, Command::preload)), "model.bodies");
  EXPECT_EQ(paths(missing(c, Command::check)), "");
}

}  // namespace
}  // namespace prs
