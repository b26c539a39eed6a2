#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

#include "prs/input/reader.h"
#include "prs/losses/preload_analysis.h"
#include "prs/model/problems.h"
#include "prs/preload/preload_solver.h"
#include "prs/preload/preloaded_mechanism.h"
#include "prs/sector/sector.h"
#include "support/count.h"
#include "support/sanitized.h"
#include "support/sectors.h"
#include "tests/prs/input/abevi.h"

namespace prs {
namespace {

using Arrangement = Preload::Arrangement;

/// A sector and its preload, the first nut held at its thrust section for tension.
struct PreloadCase {
  test::SectorCase c;
  Preload preload;

  double section() const { return *c.structure.nut.thrust.tension; }
  PreloadSector build(Direction sense = Direction::tension) const {
    return build_preload_sector({c.mechanism, c.structure, c.materials, c.options, c.laws, c.deviations, preload},
                                sense, section());
  }
  PreloadSolver solver(Direction sense = Direction::tension) const {
    const PreloadSector s = build(sense);
    return PreloadSolver(fitted(s, find_fit(s, preload)));
  }
};

/// A sector with 5 kN of preload; the second nut's rollers lie on it as those of the first.
PreloadCase preloaded(test::SectorCase c, Arrangement arrangement) {
  PreloadCase p{std::move(c), {}};
  p.preload.arrangement = arrangement;
  p.preload.force = 5e3;
  p.preload.position = p.c.position;
  if (arrangement == Arrangement::single_nut) return p;
  const double nut = *p.c.mechanism.pitch_diameter.nut;
  const double outer = p.c.structure.nut.outer_diameter;
  const double span = (p.c.mechanism.contacts_per_roller - 1) * axial_pitch(p.c.mechanism);
  p.preload.spacer = Spacer{0.3 * nut, 0.5 * (nut + outer), outer};
  p.preload.distance = p.c.structure.nut.length - span + p.preload.spacer->length;
  return p;
}

PreloadPoint solved(PreloadSolver& solver, double force) {
  PreloadPoint point = solver.solve(force);
  EXPECT_TRUE(point.solve.converged()) << force << ' ' << fe::name(point.solve.status);
  return point;
}

double area(double outer, double inner) { return std::numbers::pi / 4 * (outer * outer - inner * inner); }

template <class F>
double bisect(const F& increasing, double low, double high) {
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (increasing(middle) < 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// One thread per roller: bodies are linear springs, without load sharing.
PreloadCase one_thread(Arrangement arrangement) {
  test::SectorCase c = test::abevi();
  c.mechanism.contacts_per_roller = 1;
  c.options.roller = ModelOptions::Roller::rigid_bending;
  c.structure.nut.flanges.clear();
  c.position = 40e-3;
  PreloadCase p = preloaded(c, arrangement);
  p.preload.force = 250.0;
  return p;
}

/// The closed form of the wedged roller: at each interface the two flanks of one tooth,
/// F = n k cos(psi) [<d + x cos(psi)>^1.5 - <d - x cos(psi)>^1.5], in series with the bars.
struct WedgedTooth {
  const test::SectorCase& c;
  PerInterface<double> overlap;  ///< d, along the normal [m]
  double bars = 0.0;             ///< Compliance of screw and nut [m/N]

  WedgedTooth(const PreloadCase& p, double interference) : c(p.c) {
    // k_s d_s^1.5 sin(psi_s) = k_n d_n^1.5 sin(psi_n), d_s/sin(psi_s) + d_n/sin(psi_n) = e.
    const auto& [screw, nut] = c.laws;
    const double ratio = std::pow(
        screw.hertz_constant * std::sin(screw.normal_angle) / (nut.hertz_constant * std::sin(nut.normal_angle)),
        2.0 / 3.0);
    overlap.screw = interference / (1.0 / std::sin(screw.normal_angle) + ratio / std::sin(nut.normal_angle));
    overlap.nut = ratio * overlap.screw;
    bars = c.structure.screw.free_length / (209e9 * area(21e-3, 6e-3)) +
           (c.position - p.section()) / (209e9 * area(46e-3, 35e-3));
  }
  double constant(Interface i) const { return 11 * c.laws[i].hertz_constant * std::cos(c.laws[i].normal_angle); }
  double load(Interface i) const { return constant(i) * std::pow(overlap[i], 1.5); }
  double force(Interface i, double x) const {
    const double w = x * std::cos(c.laws[i].normal_angle);
    return constant(i) * (std::pow(std::max(0.0, overlap[i] + w), 1.5) - std::pow(std::max(0.0, overlap[i] - w), 1.5));
  }
  double displacement(double f) const {
    double u = f * bars;
    for (const Interface i : kInterfaces) u += bisect([&](double x) { return force(i, x) - f; }, -1e-3, 1e-3);
    return u;
  }
  double stiffness_at_zero() const {
    double flexibility = bars;
    for (const Interface i : kInterfaces)
      flexibility += 1.0 / (3.0 * constant(i) * std::cos(c.laws[i].normal_angle) * std::sqrt(overlap[i]));
    return 1.0 / flexibility;
  }
};

TEST(Preload, AWedgedToothFollowsTwoOpposedHertzSprings) {
  const PreloadCase p = one_thread(Arrangement::single_nut);
  const PreloadSector sector = p.build();
  const Fit fit = find_fit(sector, p.preload);
  const WedgedTooth closed(p, interference(sector, fit));
  PreloadSolver solver = p.solver();
  EXPECT_NEAR(closed.load(Interface::screw) / 250.0, 1.0, 1e-10);
  EXPECT_NEAR(*solver.at_rest().tangent_stiffness / closed.stiffness_at_zero(), 1.0, 1e-10);
  for (double f = -1500.0; f <= 1500.0; f += 125.0)
    EXPECT_NEAR(solved(solver, f).axial_displacement, closed.displacement(f), 1e-16) << f;

  const double opening = std::pow(2.0, 1.5) * std::max(closed.load(Interface::screw), closed.load(Interface::nut));
  for (const Direction d : kDirections) EXPECT_NEAR(p.solver(d).opening_force(d).value() / opening, 1.0, 1e-10);
}

TEST(Preload, ManyThreadsOfRigidBodiesOpenAt2To1Point5TimesThePreload) {
  test::SectorCase c = test::abevi();
  c.options.roller = ModelOptions::Roller::rigid_bending;
  for (const Part part : kParts) c.materials[part].youngs_modulus = 1e18;
  const PreloadCase p = preloaded(c, Arrangement::single_nut);
  for (const Direction d : kDirections)
    EXPECT_NEAR(p.solver(d).opening_force(d).value() / (std::pow(2.0, 1.5) * 5e3), 1.0, 1e-5);
}

/// The closed form of two nuts: with h(F) the two Hertz contacts of a nut in series,
///
///     delta = h(F_1) + h(F_2) + F_2 c,   F_2 - F_1 = F,
///
/// c the screw between the contacts, the nuts up to the spacer, and the spacer.
struct TwoNuts {
  const test::SectorCase& c;
  double oversize, loop = 0.0, bars = 0.0;

  TwoNuts(const PreloadCase& p, double spacer_oversize) : c(p.c), oversize(spacer_oversize) {
    const double nut = 209e9 * area(46e-3, 35e-3), screw = 209e9 * area(21e-3, 6e-3);
    const Spacer& spacer = *p.preload.spacer;
    const double second = second_position(c.mechanism, c.structure.nut, p.preload);
    loop = *p.preload.distance / screw + (c.structure.nut.length - c.position + second) / nut +
           spacer.length / (209e9 * area(spacer.outer_diameter, spacer.inner_diameter));
    bars = c.structure.screw.free_length / screw + (c.position - p.section()) / nut;
  }
  double contacts(double force) const {
    double sum = 0.0;
    for (const Interface i : kInterfaces) {
      const double cosine = std::cos(c.laws[i].normal_angle);
      sum += std::pow(force / (11 * cosine * c.laws[i].hertz_constant), 2.0 / 3.0) / cosine;
    }
    return sum;
  }
  /// Load of the first nut at an external load that opens neither.
  double first(double f) const {
    return bisect([&](double f1) { return contacts(f1) + contacts(f1 + f) + (f1 + f) * loop - oversize; },
                  std::max(0.0, -f), 1e6);
  }
  double displacement(double f) const { return contacts(first(0.0)) - contacts(first(f)) + f * bars; }
};

TEST(Preload, TwoNutsFollowTheSpringsInTheirLoop) {
  const PreloadCase p = one_thread(Arrangement::double_nut);
  const PreloadSector sector = p.build();
  const double oversize = interference(sector, find_fit(sector, p.preload));
  const TwoNuts closed(p, oversize);
  PreloadSolver solver = p.solver();
  EXPECT_NEAR(oversize / (2.0 * closed.contacts(250.0) + 250.0 * closed.loop), 1.0, 1e-10);
  // Opening of the first nut: delta = h(F) + F c, of the second: delta = h(F).
  const double in_tension = bisect([&](double f) { return closed.contacts(f) + f * closed.loop - oversize; }, 0.0, 1e6);
  const double in_compression = bisect([&](double f) { return closed.contacts(f) - oversize; }, 0.0, 1e6);
  EXPECT_NEAR(solver.opening_force(Direction::tension).value() / in_tension, 1.0, 1e-10);
  EXPECT_NEAR(solver.opening_force(Direction::compression).value() / in_compression, 1.0, 1e-10);
  for (double share = -0.99; share < 1.0; share += 0.11) {
    const double f = share * (share < 0.0 ? in_compression : in_tension);
    const PreloadPoint point = solved(solver, f);
    EXPECT_NEAR(point.axial_displacement, closed.displacement(f), 1e-16) << f;
    EXPECT_NEAR(point.sides.compression.axial_load.nut, closed.first(f), 1e-8) << f;
    const double h = 1e-3;
    const double slope = 2.0 * h / (closed.displacement(f + h) - closed.displacement(f - h));
    EXPECT_NEAR(*point.tangent_stiffness / slope, 1.0, 1e-6) << f;
  }
}

TEST(Preload, WithoutTheirLoopTwoNutsAreTheTwoSpringsOfTextbooks) {
  PreloadCase p = one_thread(Arrangement::double_nut);
  for (const Part part : kParts) p.c.materials[part].youngs_modulus = 1e18;
  PreloadSolver solver = p.solver();
  for (const Direction d : kDirections)
    EXPECT_NEAR(solver.opening_force(d).value() / (std::pow(2.0, 1.5) * 250.0), 1.0, 1e-6);
}

/// The Abevi screw in CONFIG 1 to 3, bars and refined.
std::vector<PreloadCase> real_cases(Arrangement arrangement) {
  std::vector<PreloadCase> cases;
  for (const auto bodies : {&kBars, &kRefined})
    for (const double position : {54.3333333e-3, 29.1666667e-3, 4e-3}) {
      test::SectorCase c = test::abevi();
      c.options.bodies = bodies;
      c.position = position;
      cases.push_back(preloaded(c, arrangement));
    }
  test::SectorCase rings = test::abevi();
  rings.options.bodies = &kRefined;
  rings.options.roller_contacts = ModelOptions::RollerContacts::half_pitch_apart;
  cases.push_back(preloaded(rings, arrangement));
  return cases;
}

class Arrangements : public testing::TestWithParam<Arrangement> {};
INSTANTIATE_TEST_SUITE_P(Preload, Arrangements, testing::Values(Arrangement::single_nut, Arrangement::double_nut),
                         [](const auto& test) {
                           return test.param == Arrangement::single_nut ? "SingleNut" : "DoubleNut";
                         });

TEST_P(Arrangements, ForceAndInterferenceAreInverse) {
  SKIP_UNDER_SANITIZERS();
  for (const PreloadCase& p : real_cases(GetParam())) {
    const PreloadSector sector = p.build();
    PreloadCase other = p;
    other.preload.force.reset();
    other.preload.interference = interference(sector, find_fit(sector, p.preload));
    const PreloadSolver by_force = p.solver(), by_interference = other.solver();
    EXPECT_NEAR(by_force.at_rest().sides.tension.axial_load.screw / 5e3, 1.0, 1e-10);
    EXPECT_NEAR(by_interference.at_rest().sides.tension.axial_load.screw / 5e3, 1.0, 1e-10);
  }
}

TEST_P(Arrangements, TheSidesBalanceTheExternalLoad) {
  SKIP_UNDER_SANITIZERS();
  for (const PreloadCase& p : real_cases(GetParam())) {
    PreloadSolver solver = p.solver();
    for (double f = -45e3; f <= 45e3; f += 5e3) {
      const PreloadPoint point = solved(solver, f);
      for (const Interface i : kInterfaces)
        EXPECT_NEAR((point.sides.tension.axial_load[i] - point.sides.compression.axial_load[i] - f) / 45e3, 0.0, 1e-10)
            << f;
    }
  }
}

TEST_P(Arrangements, TheSectionThatIsHeldDoesNotMatterAtRest) {
  PreloadCase p = real_cases(GetParam())[1];
  const PreloadSector sector = p.build();
  const Fit fit = find_fit(sector, p.preload);
  p.c.structure.nut.thrust.tension = 80e-3;
  const PreloadSolver there(fitted(p.build(Direction::compression), fit));
  for (const Direction d : kDirections)
    EXPECT_NEAR(there.at_rest().sides[d].axial_load.nut / p.solver().at_rest().sides[d].axial_load.nut, 1.0, 1e-10);
}

TEST_P(Arrangements, TheCurveIsContinuousAndItsSlopeIsTheTangent) {
  for (const PreloadCase& p : real_cases(GetParam())) {
    PreloadSolver solver = p.solver();
    const double pulled = solver.opening_force(Direction::tension).value_or(30e3);
    const double pushed = -solver.opening_force(Direction::compression).value_or(30e3);
    for (const double f : {0.0, 0.5 * pulled, pulled, 1.5 * pulled, 0.5 * pushed, pushed}) {
      const double h = 1e-3;
      const PreloadPoint before = solved(solver, f - h), here = solved(solver, f), after = solved(solver, f + h);
      const double flexibility = 1.0 / *here.tangent_stiffness;
      // The stiffness of a contact that opens goes as a square root: the slope changes most there.
      EXPECT_NEAR((here.axial_displacement - before.axial_displacement) / (h * flexibility), 1.0, 5e-4) << f;
      EXPECT_NEAR((after.axial_displacement - here.axial_displacement) / (h * flexibility), 1.0, 5e-4) << f;
    }
  }
}

/// In the refined CONFIG 3 the nut's last threads keep the rollers wedged under any tension.
bool opens(const PreloadCase& p, PreloadSolver& solver, Direction d) {
  const bool opens = solver.opening_force(d).has_value();
  EXPECT_TRUE(opens || p.c.options.bodies == &kRefined);
  return opens;
}

TEST_P(Arrangements, ASideOpensAtItsOpeningForce) {
  SKIP_UNDER_SANITIZERS();
  for (const PreloadCase& p : real_cases(GetParam()))
    for (const Direction d : kDirections) {
      PreloadSolver solver = p.solver(d);
      if (!opens(p, solver, d)) continue;
      const double opening = (d == Direction::tension ? 1.0 : -1.0) * *solver.opening_force(d);
      const PreloadPoint before = solved(solver, opening * (1.0 - 1e-6));
      const SideLoads& last = before.sides[opposite(d)];
      EXPECT_GT(std::max(last.max_normal_load.screw, last.max_normal_load.nut), 0.0);
      EXPECT_LT(last.axial_load.screw, 1e-3);
      const PreloadPoint after = solved(solver, opening * (1.0 + 1e-9));
      EXPECT_EQ(after.sides[opposite(d)].max_normal_load, PerInterface<double>{});
    }
}

/// With straight rollers tension and compression differ only in sign.
TEST(Preload, AStraightRollerMirrorsTheCurve) {
  test::SectorCase c = test::abevi();
  c.options.roller = ModelOptions::Roller::rigid_bending;
  PreloadSolver solver = preloaded(c, Arrangement::single_nut).solver();
  EXPECT_NEAR(*solver.opening_force(Direction::tension) / *solver.opening_force(Direction::compression), 1.0, 1e-12);
  for (const double f : {1e3, 5e3, 12e3, 30e3}) {
    const PreloadPoint pulled = solved(solver, f), pushed = solved(solver, -f);
    EXPECT_NEAR(pulled.axial_displacement / -pushed.axial_displacement, 1.0, 1e-11);
    EXPECT_NEAR(pulled.sides.compression.axial_load.nut, pushed.sides.tension.axial_load.nut, 1e-8);
  }
}

/// Beyond the opening the screw behaves as in `prs solve`, shifted by the displacement at the preload.
TEST_P(Arrangements, BeyondTheOpeningTheOtherSideCarriesAsAlone) {
  SKIP_UNDER_SANITIZERS();
  const bool single = GetParam() == Arrangement::single_nut;
  for (const PreloadCase& p : real_cases(GetParam()))
    for (const Direction d : kDirections) {
      if (!single && d == Direction::tension) continue;  // then the second nut carries
      test::SectorCase alone = p.c;
      alone.direction = d;
      alone.structure.nut.thrust = {p.section(), p.section()};
      SectorSolver reference(alone.build());
      PreloadSolver solver = p.solver(d);
      if (!opens(p, solver, d)) continue;
      const double sign = d == Direction::tension ? 1.0 : -1.0;
      const double f = 1.01 * *solver.opening_force(d);
      const PreloadPoint low = solved(solver, sign * f), high = solved(solver, sign * 2.0 * f);
      const LoadDistribution one = reference.solve(f), two = reference.solve(2.0 * f);
      for (const Interface i : kInterfaces)
        EXPECT_NEAR(
            high.sides[d].max_normal_load[i] / *std::max_element(two.normal_load[i].begin(), two.normal_load[i].end()),
            1.0, 1e-10);
      const double offset = f * reference.sector().offset_compliance / reference.sector().rollers;
      EXPECT_NEAR(sign * (high.axial_displacement - low.axial_displacement) /
                      (two.axial_displacement - one.axial_displacement - offset),
                  1.0, 1e-10);
    }
}

TEST(Preload, RollersOfASingleNutFloat) {
  for (const PreloadCase& p : real_cases(Arrangement::single_nut)) {
    const PreloadSolver solver = p.solver();
    PerInterface<double> radial;
    for (const Interface i : kInterfaces)
      for (const Direction d : kDirections)
        radial[i] += solver.at_rest().sides[d].axial_load[i] * std::tan(p.c.laws[i].normal_angle);
    EXPECT_NEAR(radial.screw / radial.nut, 1.0, 1e-9);
  }
}

TEST_P(Arrangements, PlayIsADeadZone) {
  for (PreloadCase p : real_cases(GetParam())) {
    p.preload.force.reset();
    p.preload.backlash = 0.0;
    PreloadSolver tight = p.solver();
    p.preload.backlash = 30e-6;
    PreloadSolver loose = p.solver();
    EXPECT_FALSE(loose.opening_force(Direction::tension));
    EXPECT_EQ(solved(loose, 0.0).axial_displacement, 0.0);
    EXPECT_FALSE(solved(loose, 0.0).tangent_stiffness);
    const double f = 2e3;
    const auto travel = [&](PreloadSolver& s) {
      return solved(s, f).axial_displacement - solved(s, -f).axial_displacement;
    };
    EXPECT_NEAR(travel(loose) - travel(tight), 30e-6, 1e-15);
    EXPECT_NEAR(solved(loose, f).sides.tension.max_normal_load.nut / solved(tight, f).sides.tension.max_normal_load.nut,
                1.0, 1e-9);
  }
}

TEST_P(Arrangements, RandomSectorsConverge) {
  SKIP_UNDER_SANITIZERS();
  std::mt19937_64 random(20261121);
  for (int k = 0; k < test::samples(20, 300); ++k) {
    test::SectorCase c = test::random_sector(random);
    const double heavy = test::random_force(c, random);
    PreloadCase p = preloaded(std::move(c), GetParam());
    p.preload.force = 0.2 * heavy;
    PreloadSolver solver = p.solver();
    ASSERT_TRUE(solver.at_rest().solve.converged()) << k;
    ASSERT_NEAR(solver.at_rest().sides.tension.axial_load.screw / *p.preload.force, 1.0, 1e-8) << k;
    for (const Direction d : kDirections) ASSERT_GE(solver.opening_force(d).value_or(HUGE_VAL), *p.preload.force) << k;
    double last = -HUGE_VAL;
    for (double share = -1.0; share <= 1.0; share += 0.1) {
      const PreloadPoint point = solver.solve(share * heavy);
      ASSERT_TRUE(point.solve.converged()) << k << ' ' << share << ' ' << fe::name(point.solve.status);
      ASSERT_NEAR((point.sides.tension.axial_load.nut - point.sides.compression.axial_load.nut) / heavy, share, 1e-9)
          << k;
      ASSERT_GT(point.axial_displacement, last) << k << ' ' << share;
      last = point.axial_displacement;
    }
  }
}

Case with_preload(const std::string& preload, std::vector<std::string> overrides = {}) {
  return input::read_case_text(input::kAbevi + "preload: " + preload + "\n", "case.yaml", std::move(overrides),
                               Command::preload);
}

TEST(AnalyzePreload, EachSenseOfTheLoadRestsOnItsOwnSection) {
  const std::string block =
      "{arrangement: single_nut, force: 5 kN, position: 29 mm, load: {from: -20 kN, to: 20 kN, "
      "steps: 9}}";
  Case c = with_preload(block);
  const PreloadResult apart = analyze_preload(c);
  c.structure->nut.thrust.compression = c.structure->nut.thrust.tension;
  const PreloadResult same = analyze_preload(c);
  c.structure->nut.thrust.compression.reset();
  const PreloadResult one = analyze_preload(c);
  ASSERT_TRUE(apart.converged() && same.converged() && one.converged());
  EXPECT_EQ(apart.curve.points[4].axial_displacement, 0.0);
  EXPECT_EQ(same.section.compression, 0.010);
  EXPECT_EQ(same.curve.stiffness_at_zero.tension, same.curve.stiffness_at_zero.compression);
  EXPECT_NE(apart.curve.stiffness_at_zero.tension, apart.curve.stiffness_at_zero.compression);
  EXPECT_EQ(apart.curve.points[8].axial_displacement, same.curve.points[8].axial_displacement);
  EXPECT_EQ(one.curve.points[0].axial_displacement, same.curve.points[0].axial_displacement);
}

TEST(AnalyzePreload, LostMotionIsTheTravelBetweenBothSensesOfItsLoad) {
  const PreloadResult r = analyze_preload(
      with_preload("{arrangement: single_nut, force: 5 kN, position: 29 mm, load: {from: -20 kN, to: 10 kN, "
                   "steps: 31}, lost_motion_load: 3 kN}"));
  EXPECT_EQ(r.lost_motion_load, 3e3);
  EXPECT_NEAR(r.curve.lost_motion.value(),
              r.curve.points[23].axial_displacement - r.curve.points[17].axial_displacement, 1e-17);
  EXPECT_LT(r.curve.lost_motion, r.without_preload->lost_motion);
  const PreloadResult by_default = analyze_preload(
      with_preload("{arrangement: single_nut, force: 5 kN, position: 29 mm, load: {from: -20 kN, to: 10 kN}}"));
  EXPECT_EQ(by_default.lost_motion_load, 1e3);
  EXPECT_EQ(by_default.curve.points.size(), 41u);
}

/// Beyond the play all threads share a small load, and the approach is that of Hertz alone: the
/// travel grows as its 2/3rd power, the stiffness as its cube root.
TEST(AnalyzePreload, LostMotionOfSmallLoadsIsThePlayAndHertzApproach) {
  const auto travel = [](const std::string& load) {
    const PreloadResult r = analyze_preload(
        with_preload("{arrangement: single_nut, backlash: 20 um, position: 29 mm, load: {from: -20 kN, to: 20 "
                     "kN, steps: 3}, lost_motion_load: " +
                     load + "}"));
    EXPECT_TRUE(r.converged()) << load;
    EXPECT_TRUE(std::ranges::none_of(sentences(r.warnings), [](const std::string& text) {
      return text.find("not converged") != std::string::npos;
    }));
    return r.curve.lost_motion.value_or(0.0) - 20e-6;
  };
  const double micronewton = travel("1e-6 N");
  EXPECT_GT(micronewton, 0.0);
  EXPECT_NEAR(travel("1e-3 N") / micronewton, 100.0, 0.5);
  EXPECT_NEAR(micronewton / travel("1e-9 N"), 100.0, 0.1);
}

/// An approach of 1e-18 of the play is beyond the numbers.
TEST(AnalyzePreload, WhatDoesNotConvergeSaysWhy) {
  const PreloadResult r = analyze_preload(
      with_preload("{arrangement: single_nut, backlash: 20 um, position: 29 mm, load: {from: -20 kN, to: 20 "
                   "kN, steps: 3}, lost_motion_load: 1e-30 N}",
                   {"mechanism.contacts_per_roller=4"}));
  EXPECT_FALSE(r.converged());
  EXPECT_FALSE(r.curve.lost_motion);
  for (const std::string start : {"at 1e-30 N: not converged: ", "at -1e-30 N: not converged: "})
    EXPECT_TRUE(std::ranges::any_of(sentences(r.warnings), [&](const std::string& text) {
      return text.starts_with(start);
    })) << start;
}

TEST(AnalyzePreload, AForceThatNoFitGivesIsRefused) {
  const Case c =
      with_preload("{arrangement: single_nut, force: 1e6 kN, position: 29 mm, load: {from: -20 kN, to: 20 kN}}");
  EXPECT_THROW(analyze_preload(c), CaseError);
}

TEST(PreloadJson, HasUnitsInItsKeysAndNothingThatIsNotDefined) {
  const auto document = [](const std::string& fit) {
    return document_of(
        preload_analysis(),
        analyze_preload(with_preload("{arrangement: double_nut, position: 29 mm, spacer: {length: 10 mm, "
                                     "inner_diameter: 37 mm, outer_diameter: 46 mm}, distance: 68 mm, load: "
                                     "{from: -9 kN, to: 9 kN, steps: 3}, " +
                                     fit + "}")),
        {})["preload"];
  };
  const auto json = document("force: 3 kN");
  EXPECT_NEAR(json["preload_force_N"].get<double>(), 3e3, 1e-6);
  EXPECT_GT(json["interference_um"].get<double>(), 1.0);
  for (const char* sense : {"tension", "compression"}) {
    EXPECT_GT(json["opening_force_N"][sense].get<double>(), 3e3);
    EXPECT_GT(json["stiffness_at_zero_N_per_um"][sense].get<double>(), 0.0);
    EXPECT_NEAR(json["loads"][1]["sides"][sense]["axial_load_N"].get<double>(), 3e3, 1e-6);
  }
  EXPECT_EQ(json["loads"][2]["axial_force_N"], 9e3);
  EXPECT_EQ(json["loads"][1]["axial_displacement_um"], 0.0);
  EXPECT_GT(json["without_preload"]["lost_motion_um"], json["lost_motion_um"]);

  const auto play = document("backlash: 20 um");
  EXPECT_NEAR(play["backlash_um"].get<double>(), 20.0, 1e-12);
  for (const char* key : {"interference_um", "without_preload"}) EXPECT_FALSE(play.contains(key));
  EXPECT_TRUE(play["opening_force_N"].empty());
  EXPECT_FALSE(play["loads"][1].contains("tangent_stiffness_N_per_um"));
}

}  // namespace
}  // namespace prs
