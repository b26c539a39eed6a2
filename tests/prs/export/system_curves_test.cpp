#include "prs/export/system_model.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "prs/input/reader.h"
#include "prs/loads/analyze.h"
#include "prs/preload/preloaded_mechanism.h"
#include "prs/slip/slip.h"
#include "support/sanitized.h"

namespace prs {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

Case lesson_case(const std::string& name, Command command, const std::vector<std::string>& overrides = {}) {
  return input::read_case(PRS_SOURCE_DIR "/configs/" + name, overrides, command);
}

struct Evaluated {
  double force = 0.0, stiffness = 0.0;
  int beyond = 0;
};

Evaluated at(const SystemCurves& curves, double deflection) {
  const PrsCurves view = curves.view();
  Evaluated e;
  e.force = prs_force(&view, deflection, &e.stiffness, &e.beyond);
  return e;
}

/// Forces between the nodes, tension > 0; and `drawn` random ones.
std::vector<double> forces_up_to(double largest, int drawn = 0) {
  std::vector<double> forces;
  std::mt19937 random(7);
  for (int k = 0; k < drawn; ++k) forces.push_back(largest * std::uniform_real_distribution(-1.0, 1.0)(random));
  for (const double share : {0.0007, 0.0048, 0.013, 0.07, 0.19, 0.41, 0.66, 0.93})
    for (const double sign : {1.0, -1.0}) forces.push_back(sign * share * largest);
  return forces;
}

TEST(SystemCurves, HaveTheForcesOfSolveBetweenTheirNodes) {
  Case c = lesson_case("05_standard_screw.yaml", Command::solve);
  const SystemCurves curves = system_curves(c, {.force = 50e3});
  const LoadCase pattern = c.load_cases.front();
  c.load_cases.clear();
  for (const double force : forces_up_to(50e3, 100)) {
    c.load_cases.push_back(pattern);
    c.load_cases.back().axial_force = std::abs(force);
    c.load_cases.back().direction = force > 0.0 ? Direction::tension : Direction::compression;
  }
  const double stiffest = at(curves, 1.0).stiffness;
  for (const LoadCaseResult& r : analyze(c).load_cases) {
    const double sign = r.load_case.direction == Direction::tension ? 1.0 : -1.0;
    const Evaluated e = at(curves, sign * *r.axial_displacement);
    EXPECT_NEAR(e.force, sign * r.load_case.axial_force, kForceTolerance * 50e3);
    EXPECT_NEAR(e.stiffness, *r.tangent_stiffness, kStiffnessTolerance * stiffest);
  }
}

/// Between the nodes of a full mechanism whose load acts off the axis.
TEST(SystemCurves, OfAnEccentricForceAreThoseOfSolve) {
  SKIP_UNDER_SANITIZERS();
  Case c = lesson_case("25_side_load.yaml", Command::solve,
                       {"load_cases=[{axial_force: 45 kN, direction: tension, position: "
                        "29.1666667 mm, eccentricity: {y: 3 mm}}]",
                        "mechanism.rollers=4", "mechanism.contacts_per_roller=8"});
  const SystemCurves curves = system_curves(c, {.force = 45e3});
  for (const Direction d : kDirections) EXPECT_LE(curves.senses[d].at.size(), kMostNodes);
  const LoadCase pattern = c.load_cases.front();
  c.load_cases.clear();
  for (const double share : {0.03, 0.17, 0.29, 0.47, 0.61, 0.83, 0.97}) {
    c.load_cases.push_back(pattern);
    c.load_cases.back().axial_force = share * 45e3;
  }
  const double stiffest = at(curves, 1.0).stiffness;
  for (const LoadCaseResult& r : analyze(c).load_cases) {
    const Evaluated e = at(curves, *r.axial_displacement);
    EXPECT_NEAR(e.force, r.load_case.axial_force, kForceTolerance * 45e3);
    EXPECT_NEAR(e.stiffness, *r.tangent_stiffness, kStiffnessTolerance * stiffest);
  }
}

TEST(SystemCurves, ReproduceTheirNodes) {
  const SystemCurves curves = system_curves(lesson_case("05_standard_screw.yaml", Command::solve), {});
  for (const Direction d : kDirections) {
    const BranchTable& branch = curves.senses[d];
    const double sign = d == Direction::tension ? 1.0 : -1.0;
    for (std::size_t k = 1; k < branch.at.size(); ++k) {
      const Evaluated e = at(curves, sign * branch.deflection(k));
      EXPECT_NEAR(e.force, sign * branch.force[k], 1e-12 * branch.force.back());
      EXPECT_NEAR(e.stiffness, branch.stiffness(k), 1e-12 * branch.stiffness(k));
      EXPECT_EQ(e.beyond, 0);
    }
  }
}

/// One thread by itself is a Hertz contact: F ~ u^1.5 and dF/du = 1.5 F/u, down to the first touch.
TEST(SystemCurves, StartAsHertzContactsDo) {
  const SystemCurves curves = system_curves(lesson_case("05_standard_screw.yaml", Command::solve), {});
  EXPECT_EQ(at(curves, 0.0).force, 0.0);
  EXPECT_EQ(at(curves, 0.0).stiffness, 0.0);
  const double small = 1e-5 * curves.senses.tension.deflection(curves.senses.tension.at.size() - 1);
  const Evaluated e = at(curves, small);
  EXPECT_NEAR(e.stiffness, 1.5 * e.force / small, 0.01 * e.stiffness);
  EXPECT_NEAR(at(curves, 4.0 * small).force, 8.0 * e.force, 0.01 * 8.0 * e.force);
}

TEST(SystemCurves, RiseEverywhereAndGoOnStraight) {
  const SystemCurves curves = system_curves(lesson_case("12_preload.yaml", Command::preload), {});
  const BranchTable& tension = curves.senses.tension;
  const double end = tension.deflection(tension.at.size() - 1);
  double last = at(curves, -1.2 * end).force;
  for (double u = -1.199 * end; u < 1.2 * end; u += 1e-3 * end) {
    const double force = at(curves, u).force;
    EXPECT_GT(force, last);
    last = force;
  }
  const Evaluated beyond = at(curves, end + 2e-6);
  EXPECT_EQ(beyond.beyond, 1);
  EXPECT_NEAR(beyond.force, tension.force.back() + 2e-6 * tension.slope.back(), 1e-6);
}

TEST(SystemCurves, OfAPreloadedNutAreThoseOfPreload) {
  Case c = lesson_case("12_preload.yaml", Command::preload);
  const SystemCurves curves = system_curves(c, {});
  const double largest = curves.senses.tension.force.back();
  c.preload->load = {-0.97 * largest, 0.97 * largest, 98};
  for (const Direction d : kDirections) EXPECT_LE(curves.senses[d].at.size(), kMostNodes);
  const double stiffest = std::ranges::max(curves.senses.tension.slope);
  const PreloadResult preloaded = analyze_preload(c);
  for (const PreloadPoint& point : preloaded.curve.points) {
    const Evaluated e = at(curves, point.axial_displacement);
    EXPECT_NEAR(e.force, point.axial_force, kForceTolerance * largest);
    EXPECT_NEAR(e.stiffness, *point.tangent_stiffness, kStiffnessTolerance * stiffest);
  }
  EXPECT_NEAR(at(curves, 0.0).stiffness, *preloaded.at_rest.tangent_stiffness,
              1e-9 * *preloaded.at_rest.tangent_stiffness);
}

TEST(SystemCurves, WarningsNameTheForceAndItsSense) {
  const Case c = lesson_case("01_config_1_to_3.yaml", Command::solve);
  const std::vector<std::string> warnings = sentences(system_curves(c, {.force = 60e3}).warnings);
  for (const char* sense : {"tension", "compression"})
    EXPECT_THAT(warnings, testing::Contains(testing::AllOf(HasSubstr("exceeds 4 GPa"),
                                                           HasSubstr(std::string("at 60 kN in ") + sense))));
}

TEST(SystemCurves, OfAPreloadedNutSayWhatALoadCaseChanges) {
  const auto warnings = [](const std::string& load_cases, const std::optional<std::string>& asked) {
    const Case c = lesson_case("12_preload.yaml", Command::preload, {"load_cases=" + load_cases});
    return sentences(system_curves(c, {.load_case = asked}).warnings);
  };
  const std::string one = "[{name: far, axial_force: 8 kN, direction: tension, position: 20 mm}]";
  EXPECT_THAT(warnings(one, "far"), testing::Contains(HasSubstr("load case `far`")));
  EXPECT_THAT(warnings(one, std::nullopt), Not(testing::Contains(HasSubstr("changes nothing"))));
}

/// At the position of its force, if no load case is chosen; under a load that leaves both flanks closed.
TEST(SystemCurves, TorqueOfAPreloadedNutIsThatAtItsPosition) {
  const auto torque = [](const std::string& position, const CurveOptions& options) {
    const Case c =
        lesson_case("12_preload.yaml", Command::preload,
                    {"friction={coulomb: 0.08}", "operation={speed: 300 rpm}",
                     "load_cases=[{name: far, axial_force: 8 kN, direction: tension, position: " + position + "}]"});
    const SystemCurves curves = system_curves(c, options);
    EXPECT_EQ(std::ranges::any_of(sentences(curves.warnings),
                                  [](const std::string& warning) {
                                    return warning.find("at the position of load case `far`") != std::string::npos;
                                  }),
              options.load_case.has_value());
    const PrsCurves view = curves.view();
    int beyond = 0;
    return prs_torque(&view, 1e3, 30.0, &beyond);
  };
  EXPECT_EQ(torque("10 mm", {}), torque("30 mm", {}));
  EXPECT_NE(torque("2 mm", {.load_case = "far"}), torque("30 mm", {.load_case = "far"}));
}

/// Both flanks of a nut with play touch after half of it each.
TEST(SystemCurves, OfANutWithPlayAreZeroWithinIt) {
  const Case c = lesson_case("12_preload.yaml", Command::preload,
                             {"preload={arrangement: single_nut, backlash: 10 um, position: 10 mm, "
                              "load: {from: -20 kN, to: 20 kN}}"});
  const SystemCurves curves = system_curves(c, {});
  const double tension = curves.senses.tension.origin, compression = curves.senses.compression.origin;
  EXPECT_NEAR(tension + compression, 10e-6, 1e-9);
  EXPECT_EQ(at(curves, 0.9 * tension).force, 0.0);
  EXPECT_EQ(at(curves, -0.9 * compression).force, 0.0);
  EXPECT_GT(at(curves, tension + 1e-6).force, 0.0);
  EXPECT_LT(at(curves, -compression - 1e-6).force, 0.0);
}

Case of_friction(const std::string& friction) {
  return lesson_case("09_slip_and_dissipation.yaml", Command::slip, {"friction=" + friction});
}

double largest_torque(const PrsCurves& curves) {
  double largest = 0.0;
  for (const double* table : {curves.forward, curves.backward})
    for (std::size_t k = 0; k < curves.forces * curves.speeds; ++k) largest = std::max(largest, std::abs(table[k]));
  return largest + std::abs(20e3 * curves.lead) / (2.0 * std::numbers::pi);
}

void expect_torque_of_slip(Case c) {
  const SystemCurves curves = system_curves(c, {.force = 20e3});
  const PrsCurves view = curves.view();
  const double largest = largest_torque(view);
  const LoadCase pattern = c.load_cases.front();
  c.load_cases.clear();
  std::vector<double> forces;
  for (const double force : forces_up_to(20e3))
    for (const double speed : {0.3, -17.0}) {
      LoadCase load = pattern;
      load.axial_force = std::abs(force);
      load.direction = force > 0.0 ? Direction::tension : Direction::compression;
      load.speed = speed;
      if (std::abs(force) < 0.001 * 20e3) continue;  // Below, friction is that of a larger force.
      c.load_cases.push_back(load);
      forces.push_back(force);
    }
  const Result slip = analyze_slip(c);
  for (std::size_t k = 0; k < forces.size(); ++k) {
    int beyond = 0;
    const double speed = *slip.load_cases[k].load_case.speed;
    EXPECT_NEAR(prs_torque(&view, forces[k], speed, &beyond), slip.load_cases[k].slip->torque_screw,
                kTorqueTolerance * largest)
        << forces[k] << " N " << speed << " rad/s";
    EXPECT_EQ(beyond, 0);
  }
}

TEST(SystemCurves, TorqueIsThatOfSlip) { expect_torque_of_slip(of_friction("{coulomb: 0.08}")); }

TEST(SystemCurves, TorqueThatDoesNotDependOnTheSpeedIsThatOfSlipAtEach) {
  Case c = of_friction("{coulomb: 0.08}");
  c.carrier = {};
  expect_torque_of_slip(std::move(c));
}

TEST(SystemCurves, SpeedWithoutEquilibriumIsAnErrorThatSaysHowSlipEnded) {
  const Case c = of_friction("{coulomb: 0.08}");
  try {
    system_curves(c, {.force = 20e3, .speed = 1e8});
    FAIL();
  } catch (const CaseError& e) {
    EXPECT_THAT(e.what(), ::testing::HasSubstr("running loads end as iteration_limit"));
    EXPECT_THAT(e.what(), ::testing::HasSubstr("rpm"));
  }
}

/// Friction costs power: torque x speed is more than force x travel, in both senses of both.
TEST(SystemCurves, FrictionTakesPower) {
  const SystemCurves curves = system_curves(of_friction("{coulomb: 0.08}"), {.force = 20e3});
  const PrsCurves view = curves.view();
  for (const double force : {-15e3, -200.0, 300.0, 19e3})
    for (const double speed : {-20.0, -0.1, 0.1, 20.0}) {
      int beyond = 0;
      EXPECT_GT(prs_torque(&view, force, speed, &beyond) * speed,
                force * curves.lead / (2.0 * std::numbers::pi) * speed);
      EXPECT_EQ(beyond, 0);
    }
}

TEST(SystemCurves, WithoutFrictionTheTorqueIsThatOfTheLead) {
  const SystemCurves curves = system_curves(lesson_case("05_standard_screw.yaml", Command::solve), {});
  const PrsCurves view = curves.view();
  int beyond = 0;
  EXPECT_NEAR(prs_torque(&view, 1e3, 7.0, &beyond), 1e3 * curves.lead / (2.0 * std::numbers::pi), 1e-12);
  EXPECT_THAT(sentences(curves.warnings), testing::Contains(HasSubstr("without friction")));
}

/// A table needs a speed; that of a screw at rest has none.
TEST(SystemCurves, AtRestTheirTorqueIsToldToBeWithoutFriction) {
  Case at_rest = of_friction("{coulomb: 0.08}");
  at_rest.operation->speed = 0.0;
  for (LoadCase& load : at_rest.load_cases) load.speed.reset();
  EXPECT_THAT(sentences(system_curves(at_rest, {.force = 20e3}).warnings),
              testing::Contains(testing::AllOf(HasSubstr("operation.speed"), HasSubstr("without friction"))));
}

TEST(SystemCurves, ReadBackFromTheirData) {
  const SystemCurves curves = system_curves(of_friction("{coulomb: 0.08}"), {.force = 20e3});
  std::vector<double> data = curves.data();
  PrsCurves read;
  ASSERT_EQ(prs_read_curves(data.data(), data.size(), &read), 1);
  const PrsCurves view = curves.view();
  for (const double u : {-12e-6, 0.0, 3e-7, 15e-6}) {
    Evaluated a, b;
    EXPECT_EQ(prs_force(&read, u, &a.stiffness, &a.beyond), prs_force(&view, u, &b.stiffness, &b.beyond));
    EXPECT_EQ(prs_torque(&read, 1e9 * u, 3.0, &a.beyond), prs_torque(&view, 1e9 * u, 3.0, &b.beyond));
  }
  EXPECT_EQ(prs_read_curves(data.data(), data.size() - 1, &read), 0);
  for (std::size_t k = 0; k < data.size(); k += 7) EXPECT_EQ(prs_read_curves(data.data(), k, &read), 0);
  data[0] = 2.0;
  EXPECT_EQ(prs_read_curves(data.data(), data.size(), &read), 0);
}

}  // namespace
}  // namespace prs
