#include "prs/slip/slip.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "contact/film.h"
#include "contact/patch.h"
#include "prs/model/problems.h"
#include "prs/slip/slip_at_speed.h"
#include "prs/slip/slip_pictures.h"
#include "prs/slip/slip_warnings.h"
#include "prs/threads/kinematics.h"
#include "tests/support/count.h"
#include "tests/support/sanitized.h"
#include "tests/support/slips.h"

namespace prs {
namespace {

using ::testing::HasSubstr;

SlipResult slip_of(const Case& c) { return *analyze_slip(c).load_cases.at(0).slip; }

void expect_relative(double value, plain::Real expected, double tolerance, const char* what) {
  EXPECT_NEAR(value, static_cast<double>(expected), tolerance * std::abs(static_cast<double>(expected))) << what;
}

/// Compares all results of the plain calculation, thread by thread.
void expect_as_plain(const Case& c, const Result& result, double tolerance) {
  const SlipResult& s = *result.load_cases[0].slip;
  plain::Case p = test::plain_case(c, result);
  if (s.status == SlipStatus::imposed) p.slip_ratio = s.slip_ratio;
  const plain::State t = plain::solve(p);
  EXPECT_NEAR(s.slip_ratio, static_cast<double>(t.slip_ratio), 1e-12);
  expect_relative(s.optimality, t.optimality_percent / 100, tolerance, "optimality");
  expect_relative(s.power.screw, t.power_screw, tolerance, "power, screw");
  expect_relative(s.power.nut, t.power_nut, tolerance, "power, nut");
  expect_relative(s.power.carrier_roller, t.power_carrier_roller, tolerance, "carrier, roller");
  expect_relative(s.power.carrier_screw, t.power_carrier_screw, tolerance, "carrier, screw");
  expect_relative(s.power.carrier_nut, t.power_carrier_nut, tolerance, "carrier, nut");
  expect_relative(s.power_loss_input_output, t.power_loss_input_output, tolerance, "in - out");
  expect_relative(s.torque_screw, t.torque_screw, tolerance, "torque, screw");
  expect_relative(s.torque_nut, t.torque_nut, tolerance, "torque, nut");
  // (3.52) is output over input if the screw drives, its inverse if the load does.
  const bool load_drives = p.force_on_nut * p.speed * p.lead < 0;
  if (s.efficiency)
    expect_relative(*s.efficiency, load_drives ? 1 / t.efficiency : t.efficiency, tolerance, "efficiency");
  else
    EXPECT_TRUE(load_drives && t.efficiency < 0);  // self-locking
  const double scale = std::abs(static_cast<double>(p.force_on_nut)) / p.rollers;
  EXPECT_NEAR(s.forces.contacts_x, static_cast<double>(t.contact_force[0]), tolerance * scale);
  EXPECT_NEAR(s.forces.contacts_y, static_cast<double>(t.contact_force[1]), tolerance * scale);
  EXPECT_NEAR(s.forces.gears_x, static_cast<double>(t.gear_force_x), tolerance * scale);
  EXPECT_NEAR(s.forces.gears_y, static_cast<double>(t.gear_force_y), tolerance * scale);
  EXPECT_NEAR(s.forces.carrier_x, static_cast<double>(t.carrier_force_x), tolerance * scale);
  EXPECT_NEAR(s.forces.carrier_y, static_cast<double>(t.carrier_force_y), tolerance * scale);
  const double arm = scale * static_cast<double>(p.centre_distance);
  EXPECT_NEAR(s.moments.contacts, static_cast<double>(t.residue_contact), tolerance * arm);
  EXPECT_NEAR(s.moments.spin, static_cast<double>(t.residue_spin), tolerance * arm);
  EXPECT_NEAR(s.moments.carrier, static_cast<double>(t.residue_carrier), tolerance * arm);
  EXPECT_NEAR(s.forces.centrifugal, static_cast<double>(t.centrifugal_force), tolerance * scale);
  EXPECT_NEAR(s.moments.gears, static_cast<double>(t.residue_gear), tolerance * arm);
  for (const Interface i : kInterfaces) {
    const auto& threads = i == Interface::screw ? t.screw : t.nut;
    const InterfaceSlip& computed = s.threads[i];
    ASSERT_EQ(computed.power.size(), threads.size());
    const auto sliding = i == Interface::screw ? t.screw_sliding_speed : t.nut_sliding_speed;
    const double speed_scale = std::abs(s.speed) * static_cast<double>(p.centre_distance);
    for (std::size_t k = 0; k < threads.size(); ++k) {
      expect_relative(computed.power[k], threads[k].power, 10 * tolerance, "W");
      expect_relative(computed.friction_coefficient[k], threads[k].friction_coefficient, tolerance, "mu");
      expect_relative(computed.dynamic_normal_load[k], threads[k].normal_load, tolerance, "N");
      EXPECT_NEAR(computed.spin_torque[k], static_cast<double>(threads[k].spin_torque),
                  tolerance * computed.dynamic_normal_load[k] * 1e-3);
      EXPECT_NEAR(computed.sliding_speed[k], static_cast<double>(sliding), 1e-12 * speed_scale);
      EXPECT_NEAR(computed.max_sliding_speed[k], static_cast<double>(threads[k].max_sliding_speed),
                  tolerance * speed_scale);
      EXPECT_EQ(computed.film_thickness.empty(), !c.lubricant);
      if (!c.lubricant) continue;
      expect_relative(computed.film_thickness[k], threads[k].film_thickness, tolerance, "h_c");
      expect_relative(computed.central_film[k], threads[k].central_film, tolerance, "full fit");
      EXPECT_EQ(computed.boundary_share.empty(), !c.roughness);
      if (c.roughness) expect_relative(computed.boundary_share[k], threads[k].boundary_share, tolerance, "share");
    }
  }
}

TEST(Slip, ReferenceExampleOfSandu) {
  const SlipResult s = slip_of(test::sandu_reference());
  EXPECT_EQ(s.status, SlipStatus::converged);
  EXPECT_NEAR(100 * *s.efficiency, 78.6, 0.2);              // section 3.3
  EXPECT_NEAR(s.ideal_slip_ratio, 0.3741, 0.00005);         // (2.18)
  EXPECT_LT(s.slip_ratio, s.ideal_slip_ratio);              // fig. 3.6: closely below
  EXPECT_GT(s.slip_ratio, 0.3730);                          // and above experiment 6
  EXPECT_GT(s.power.screw, 0.9 * s.power.total());          // section 3.3
  EXPECT_NEAR(s.torque_screw / s.torque_nut, -1.0, 1e-12);  // (3.46)
  EXPECT_NEAR(s.power.total() / s.power_loss_input_output, 1.0, 1e-12);
  EXPECT_GT(s.torque_screw, 35e3 * 10e-3 / (2 * std::numbers::pi));  // above the static one (3.18)
  EXPECT_NEAR(*s.efficiency_fit, *s.efficiency, 0.005);              // (3.55)
  // Full fit, computed independently.
  EXPECT_NEAR(s.threads.screw.central_film[0], 372.2e-9, 0.05e-9);
  EXPECT_NEAR(s.threads.nut.central_film[0], 406.2e-9, 0.05e-9);
}

TEST(Slip, FrictionOfFigures28And29) {
  Case c = test::sandu_reference();
  c.operation->slip_ratio = 0.3730;
  const SlipResult s = slip_of(c);
  EXPECT_EQ(s.status, SlipStatus::imposed);
  EXPECT_NEAR(s.threads.screw.friction_coefficient[0], 0.111, 0.0005);
  EXPECT_NEAR(s.threads.nut.friction_coefficient[0], 0.083, 0.0005);
  EXPECT_NEAR(s.threads.screw.film_thickness[0], 438e-9, 1e-9);
  EXPECT_NEAR(s.threads.nut.film_thickness[0], 468e-9, 1e-9);  // printed 495, see SOURCE.md
  EXPECT_NEAR(s.threads.screw.dynamic_normal_load[0], 223, 0.5);
  EXPECT_NEAR(s.threads.nut.dynamic_normal_load[0], 197, 0.5);
  c.model.patch_points = 11;  // as in fig. 2.8
  EXPECT_NEAR(slip_of(c).threads.screw.max_sliding_speed[0], 0.107, 0.0005);
}

/// With the slip ratio imposed the roller is out of balance, and the two power methods differ.
TEST(Slip, PowerMethodsPartWhereTheSlipRatioIsImposed) {
  Case c = test::sandu_reference();
  c.operation->slip_ratio = 0.3730;
  const SlipResult s = slip_of(c);
  EXPECT_GT(std::abs(s.power_loss_input_output / s.power.total() - 1.0), 0.01);
  EXPECT_GT(std::abs(s.torque_screw / s.torque_nut + 1.0), 0.001);
  EXPECT_GT(std::abs(*s.relative_residue), 1e-4);
}

struct Variant {
  std::string name;
  Case values;
};

class SlipVariants : public ::testing::TestWithParam<Variant> {};

TEST_P(SlipVariants, MatchesThePlainCalculation) {
  expect_as_plain(GetParam().values, analyze_slip(GetParam().values), 1e-10);
}

TEST_P(SlipVariants, BothPowersAndBothTorquesAgree) {
  const SlipResult s = slip_of(GetParam().values);
  EXPECT_EQ(s.status, SlipStatus::converged);
  EXPECT_NEAR(s.power.total() / s.power_loss_input_output, 1.0, 1e-10);
  EXPECT_NEAR(s.torque_screw / s.torque_nut, -1.0, 1e-12);
  EXPECT_LE(s.evaluations, 8);
}

/// The reference with 4 of its 28 threads at their loads: sufficient for the plain calculation.
Case few_threads() {
  Case c = test::sandu_reference();
  c.mechanism.contacts_per_roller = 4;
  c.load_cases[0].axial_force *= 4.0 / 28.0;
  return c;
}

Case with_carrier(Case c) {
  c.carrier.roller_torque = 0.0015;
  c.carrier.screw_torque = 0.03;
  c.carrier.nut_torque = 0.04;
  return c;
}

Case mirrored(Case c) {  // a left-handed screw that drives its load
  c = test::left_handed(c);
  c.operation->speed = -c.operation->speed;
  return c;
}

INSTANTIATE_TEST_SUITE_P(
    Reference, SlipVariants,
    ::testing::Values(Variant{"standard", few_threads()}, Variant{"inverted", test::inverted(few_threads())},
                      Variant{"reverse", test::reversed(few_threads())},
                      Variant{"reverse_inverted", test::reversed(test::inverted(few_threads()))},
                      Variant{"left_handed", mirrored(few_threads())},
                      Variant{"left_handed_inverted", mirrored(test::inverted(few_threads()))},
                      Variant{"coulomb", test::with_coulomb(few_threads(), 0.11)},
                      Variant{"coulomb_inverted", test::with_coulomb(test::inverted(few_threads()), 0.11)},
                      Variant{"carrier", with_carrier(few_threads())},
                      Variant{"carrier_reverse_inverted", with_carrier(test::reversed(test::inverted(few_threads())))}),
    [](const auto& variant) { return variant.param.name; });

TEST(Slip, RandomCasesMatchThePlainCalculation) {
  std::mt19937_64 random(11);
  int compared = 0, left_out = 0;
  for (int n = test::samples(40, 400); n > 0; --n) {
    const Case c = test::random_slip(random);
    Result result;
    try {
      result = analyze_slip(c);
    } catch (const CaseError&) {  // no contact point with that profile
      ++left_out;
      continue;
    }
    const SlipResult& s = *result.load_cases[0].slip;
    if (!s.converged()) {
      EXPECT_FALSE(plain::solve(test::plain_case(c, result)).bracketed);
      ++left_out;
      continue;
    }
    SCOPED_TRACE(n);
    expect_as_plain(c, result, 1e-9);
    EXPECT_NEAR(s.power.total() / s.power_loss_input_output, 1.0, 1e-8);
    EXPECT_NEAR(s.torque_screw / s.torque_nut, -1.0, 1e-9);
    ++compared;
  }
  EXPECT_GT(compared, 4 * left_out);
}

TEST(MixedFriction, MatchesThePlainCalculation) {
  SKIP_UNDER_SANITIZERS();
  std::mt19937_64 random(34);
  std::uniform_real_distribution<double> unit;
  int compared = 0;
  const int tries = test::sanitized() ? 8 : test::count(20, 400);
  for (int n = 0; n < tries; ++n) {
    SCOPED_TRACE(n);
    Case c = test::random_slip(random);
    const auto rough = [&] { return std::exp(std::log(10e-9) + unit(random) * std::log(200.0)); };
    c.roughness = PerPart<double>{rough(), rough(), rough()};
    c = test::with_mixed_friction(c, 0.2 * unit(random), 0.5 + 3.0 * unit(random));
    Result result;
    try {
      result = analyze_slip(c);
    } catch (const CaseError&) {  // no contact point with that profile
      continue;
    }
    if (!result.load_cases[0].slip->converged()) continue;
    expect_as_plain(c, result, 1e-9);
    ++compared;
  }
  EXPECT_GT(5 * compared, 3 * tries);
}

/// Smooth flanks never touch, rough ones always.
TEST(MixedFriction, IsJacodsOfAThickFilmAndCoulombsWithoutFilm) {
  const auto expect_same = [](const SlipResult& a, const SlipResult& b, double tolerance) {
    EXPECT_NEAR(a.slip_ratio, b.slip_ratio, tolerance);
    EXPECT_NEAR(a.power.total() / b.power.total(), 1.0, tolerance);
    EXPECT_NEAR(*a.efficiency, *b.efficiency, tolerance);
    for (const Interface i : kInterfaces)
      EXPECT_NEAR(a.threads[i].friction_coefficient[0] / b.threads[i].friction_coefficient[0], 1.0, tolerance);
  };
  Case c = test::sandu_reference();
  const SlipResult jacod = slip_of(c);
  c.roughness = PerPart<double>{1e-15, 1e-15, 1e-15};  // Lambda 3e8, share 1e-17
  const SlipResult smooth = slip_of(test::with_mixed_friction(c, 0.11, 2.0));
  expect_same(smooth, jacod, 1e-13);
  EXPECT_FALSE(smooth.efficiency_fit);
  c.roughness = PerPart<double>{1e4, 1e4, 1e4};  // Lambda 3e-11
  const SlipResult rough = slip_of(test::with_mixed_friction(c, 0.11, 2.0));
  expect_same(rough, slip_of(test::with_coulomb(c, 0.11)), 1e-9);
  EXPECT_NEAR(rough.threads.screw.boundary_share[0], 1.0, 1e-9);
}

/// Films grow with the speed: from the friction of touching flanks down, then up with the shear of
/// the film.
TEST(MixedFriction, FollowsStribeck) {
  Case c = test::with_mixed_friction(test::sandu_reference(), 0.13, 2.0);
  c.roughness = PerPart<double>{0.05e-6, 0.05e-6, 0.05e-6};
  const Result result = analyze_slip(c);
  const StribeckCurve curve = stribeck_curve(c, result, 0);
  ASSERT_EQ(curve.speed.size(), 41u);
  EXPECT_NEAR(curve.speed[30] / result.load_cases[0].slip->speed, 1.0, 1e-12);
  EXPECT_NEAR(curve.power[30] / result.load_cases[0].slip->power.total(), 1.0, 1e-9);
  const std::vector<double>& nut = curve.friction.nut;
  EXPECT_NEAR(nut.front(), 0.13, 0.02);
  const auto least = std::ranges::min_element(nut);
  EXPECT_LT(*least, 0.8 * nut.front());
  EXPECT_LT(*least, 0.99 * nut.back());
  EXPECT_TRUE(std::ranges::is_sorted(curve.film_ratio.screw));
  EXPECT_GT(curve.film_ratio.screw.back(), kFullFilm);
}

Case along_rolling(Case c) {
  c.lubricant->film.direction = contact::FilmDirection::rolling;
  return c;
}

/// Film, film over roughness, share of touching flanks and mixed friction agree.
TEST(CentralFilm, AlongTheRollingIsThatOfThePlainCalculation) {
  for (Case c : {few_threads(), test::inverted(few_threads())}) {
    c = along_rolling(test::with_mixed_friction(c, 0.11, 2.0));
    c.model.patch_points = 9;
    const Result result = analyze_slip(c);
    expect_as_plain(c, result, 1e-9);
    const InterfaceSlip& nut = result.load_cases[0].slip->threads.nut;
    EXPECT_NEAR(nut.film_ratio[0], nut.central_film[0] / std::hypot(0.4e-6, 0.2e-6), 1e-12 * nut.film_ratio[0]);
    c.lubricant->film = {};
    EXPECT_LT(nut.central_film[0], analyze_slip(c).load_cases[0].slip->threads.nut.central_film[0]);
  }
}

/// The nut rolls along the helix, 45 deg and more off the minor axis of its ellipse.
TEST(CentralFilm, WarnsWhereItIsThatOfAnotherDirection) {
  const auto warnings = [](const Case& c) { return sentences(analyze_slip(c).load_cases[0].warnings); };
  const auto note = ::testing::Contains(
      ::testing::AllOf(HasSubstr("lubricant.film: the roller-nut contacts roll"), HasSubstr("deg off the major axis")));
  const Case c = test::sandu_reference();
  EXPECT_THAT(warnings(c), note);
  EXPECT_THAT(warnings(c), ::testing::Not(::testing::Contains(HasSubstr("the roller-screw contacts roll"))));
  EXPECT_THAT(warnings(along_rolling(c)), ::testing::Not(note));
  EXPECT_THAT(warnings(test::with_coulomb(c, 0.1)), note);  // Films are shown there too.
}

/// A bare nut of some cm passes some tenths of a watt per kelvin to still air.
TEST(Slip, WarnsOfHeatThatNothingTakes) {
  const auto note = ::testing::Contains(HasSubstr("heat: missing"));
  Case c = test::sandu_reference();
  const Result result = analyze_slip(c);
  ASSERT_GT(result.load_cases[0].slip->power.total(), 100.0);
  const double needed = result.load_cases[0].slip->power.total() / 55.0;
  EXPECT_THAT(sentences(result.load_cases[0].warnings),
              ::testing::Contains(HasSubstr(fmt::format("a thermal conductance of {:.3g} W/K", needed))));
  c.operation->speed *= 1e-3;
  EXPECT_THAT(sentences(analyze_slip(c).load_cases[0].warnings), ::testing::Not(note));
}

/// A roller's mass orbits with the carrier against the frame, in which the screw of an inverted mechanism does not
/// turn.
TEST(Slip, CentrifugalForceIsThatOfTheOrbitAgainstTheFrame) {
  for (Case c : {few_threads(), test::inverted(few_threads())}) {
    c.materials->roller.density = 7810.0;
    const Result result = analyze_slip(c);
    const SlipResult& s = *result.load_cases[0].slip;
    const contact::MechanismGeometry& threads = result.contacts.threads;
    const double radius = threads.roller.pitch_radius;
    const double mass =
        7810.0 * std::numbers::pi * radius * radius * threads.roller.pitch * c.mechanism.contacts_per_roller;
    const bool nut_turns = c.mechanism.type == Mechanism::Type::inverted;
    const double orbit = (nut_turns ? 1.0 - s.slip_ratio : s.slip_ratio) * s.speed;
    EXPECT_NEAR(s.forces.centrifugal, mass * threads.centre_distance * orbit * orbit, 1e-9 * s.forces.centrifugal);
  }
}

TEST(MixedFriction, WarnsOfNoThinFilm) {
  Case c = test::with_mixed_friction(test::sandu_reference(), 0.11, 2.0);
  const Result result = analyze_slip(c);
  EXPECT_LT(result.load_cases[0].slip->threads.screw.film_ratio[0], 3.0);
  EXPECT_THAT(sentences(result.load_cases[0].warnings), ::testing::Not(::testing::Contains(HasSubstr("lubrication"))));
}

/// With Coulomb friction, power is mu times the pressure and speed that cause wear.
TEST(Wear, IsArchardsVolumeByCoulombsPower) {
  for (Case c : {few_threads(), test::inverted(few_threads())}) {
    c = test::with_coulomb(c, 0.08);
    EXPECT_TRUE(slip_of(c).threads.screw.wear.empty());
    c.wear = Wear{1e-17};
    const SlipResult s = slip_of(c);
    const double advance = c.mechanism.lead * s.speed / (2 * std::numbers::pi);
    for (const Interface i : kInterfaces)
      EXPECT_NEAR(s.threads[i].wear[0] / (1e-17 * s.threads[i].power[0] / 0.08 / advance), 1.0, 1e-12);
    c.operation->speed *= 3.0;  // the same wear per metre
    EXPECT_NEAR(slip_of(c).threads.nut.wear[0] / s.threads.nut.wear[0], 1.0, 1e-9);
  }
}

TEST(Slip, AHalfTurnAboutTheRadialAxisReversesEverything) {
  const SlipResult a = slip_of(test::sandu_reference());
  const SlipResult b = slip_of(test::reversed(test::sandu_reference()));
  EXPECT_NEAR(b.slip_ratio, a.slip_ratio, 1e-14);
  EXPECT_NEAR(b.power.total() / a.power.total(), 1.0, 1e-12);
  EXPECT_NEAR(b.torque_screw / a.torque_screw, -1.0, 1e-12);
  EXPECT_NEAR(b.threads.nut.spin_torque[0] / a.threads.nut.spin_torque[0], 1.0, 1e-12);
}

TEST(Slip, TheMirrorImageLosesAsMuch) {
  const SlipResult a = slip_of(test::sandu_reference());
  const SlipResult b = slip_of(mirrored(test::sandu_reference()));
  EXPECT_NEAR(b.slip_ratio, a.slip_ratio, 1e-12);
  EXPECT_NEAR(*b.efficiency, *a.efficiency, 1e-12);
  EXPECT_NEAR(b.torque_screw / a.torque_screw, -1.0, 1e-12);
}

/// The load drives, and the output is smaller.
TEST(Slip, ALoadThatDrivesTheScrewPaysForTheFriction) {
  const Case c = test::left_handed(test::sandu_reference());
  const SlipResult s = slip_of(c);
  EXPECT_EQ(s.driven_by, DrivenBy::load);
  EXPECT_EQ(slip_of(test::turned_back(c)).driven_by, DrivenBy::screw);
  ASSERT_EQ(s.status, SlipStatus::converged);
  EXPECT_LT(std::abs(s.torque_screw), 35e3 * 10e-3 / (2 * std::numbers::pi));
  EXPECT_NEAR(s.power.total() / s.power_loss_input_output, 1.0, 1e-10);
  const double shaft = -s.torque_screw * s.speed;
  EXPECT_NEAR(*s.efficiency, shaft / (shaft + s.power.total()), 1e-12);
  EXPECT_EQ(s.self_locking, false);
  EXPECT_NEAR(*s.holding_torque * s.speed, -shaft, 1e-12 * shaft);  // a brake
}

/// A plane through the axis mirrors hand and rotation, and keeps the force.
TEST(Slip, DrivenByItsLoadAScrewIsItsMirrorImage) {
  std::mt19937_64 random(21);
  int compared = 0;
  for (int n = 0; n < 20; ++n) {
    SCOPED_TRACE(n);
    Case driven = test::random_slip(random);
    const double drive = driven.load_cases[0].axial_force * driven.operation->speed;
    if (drive * driven.mechanism.lead > 0.0) driven = test::turned_back(driven);
    const Case mirror = test::turned_back(test::left_handed(driven));
    SlipResult a, b;
    try {
      a = slip_of(driven), b = slip_of(mirror);
    } catch (const CaseError&) {  // no contact point with that profile
      continue;
    }
    EXPECT_EQ(a.status, b.status);
    EXPECT_EQ(a.driven_by, DrivenBy::load);
    EXPECT_EQ(b.driven_by, DrivenBy::load);
    if (!a.converged()) continue;
    EXPECT_NEAR(a.slip_ratio, b.slip_ratio, 1e-11);
    EXPECT_EQ(a.self_locking, b.self_locking);
    EXPECT_NEAR(a.efficiency.value_or(0.0), b.efficiency.value_or(0.0), 1e-9);
    EXPECT_NEAR(a.torque_screw / b.torque_screw, -1.0, 1e-9);
    EXPECT_NEAR(*a.holding_torque / *b.holding_torque, 1.0, 1e-9);
    for (const Interface i : kInterfaces) EXPECT_NEAR(a.threads[i].power[0] / b.threads[i].power[0], 1.0, 1e-9);
    ++compared;
  }
  EXPECT_GT(compared, 12);
}

TEST(Slip, BothSensesStandInOneListOfCases) {
  Case c = test::sandu_reference();
  c.load_cases.push_back(c.load_cases[0]);
  c.load_cases[1].name = "back";
  c.load_cases[1].speed = -c.operation->speed;
  const Result result = analyze_slip(c);
  EXPECT_EQ(result.load_cases[0].slip->driven_by, DrivenBy::screw);
  EXPECT_EQ(result.load_cases[1].slip->driven_by, DrivenBy::load);
  EXPECT_FALSE(result.load_cases[0].slip->holding_torque);
  expect_as_plain(c, result, 1e-10);
}

/// A roller without teeth is in balance along its orbit and about its axis, so that power and torques close.
TEST(Slip, AGroovedRollerBalancesWithoutTeeth) {
  for (const auto& [c, name] : {std::pair{test::recirculating(), "screw"},
                                {test::turned_back(test::with_coulomb(test::recirculating(), 1e-3)), "load"},
                                {test::reversed(test::recirculating()), "other sense"},
                                {test::left_handed(test::with_coulomb(test::recirculating(), 0.1)), "left hand"}}) {
    const Result result = analyze_slip(c);
    const SlipResult& s = *result.load_cases[0].slip;
    ASSERT_TRUE(s.converged()) << name;
    EXPECT_NEAR(s.power_loss_input_output, s.power.total(), 1e-9 * s.power.total()) << name;
    EXPECT_NEAR(s.torque_screw, -s.torque_nut, 1e-9 * std::abs(s.torque_screw)) << name;
    EXPECT_NEAR(s.forces.gears_y, 0.0, 1e-9 * std::abs(c.load_cases[0].axial_force)) << name;
    EXPECT_NEAR(s.moments.contacts + s.moments.spin + s.moments.carrier, 0.0, 1e-9 * std::abs(s.moments.spin)) << name;
    EXPECT_NEAR(s.travel_per_turn, 2e-3, 1e-18) << name;
    EXPECT_NEAR(s.slip_ratio, s.ideal_slip_ratio, 0.05) << name;
  }
  const SlipResult free = *analyze_slip(test::with_coulomb(test::recirculating(), 0.0)).load_cases[0].slip;
  EXPECT_EQ(free.slip_ratio, free.ideal_slip_ratio);
  EXPECT_NEAR(*free.efficiency, 1.0, 1e-12);
}

TEST(Slip, AGroovedRollerIsFoundFromAnyStart) {
  for (const Case& c : {test::recirculating(), test::reversed(test::recirculating())}) {
    const Result loads = analyze(c);
    const SlipModel model = SlipModels(c, loads.contacts).of(loads.load_cases[0]);
    const SlipEquilibrium alone = find_slip_equilibrium(model);
    ASSERT_TRUE(alone.ok());
    const RollerSpin& at = alone.balance.spin;
    ASSERT_NE(at.spin, 0.0);
    for (const double spin : {0.0, 0.999 * at.spin, -at.spin, 5.0, -80.0})
      for (const double slope : {0.0, at.slope, -1e3})
        for (const double slip_ratio : {at.slip_ratio, at.slip_ratio + 1e-4}) {
          const SlipEquilibrium found = find_slip_equilibrium(model, RollerSpin{slip_ratio, spin, slope});
          ASSERT_TRUE(found.ok()) << spin << " " << slope;
          EXPECT_NEAR(found.balance.spin.slip_ratio, at.slip_ratio, 1e-13) << spin << " " << slope;
          EXPECT_NEAR(found.balance.spin.spin, at.spin, 1e-13) << spin << " " << slope;
        }
  }
}

TEST(Slip, WithoutFrictionTheIdealSlipRatioAndFullEfficiencyRemain) {
  const SlipResult s = slip_of(test::with_coulomb(test::sandu_reference(), 0.0));
  EXPECT_EQ(s.status, SlipStatus::converged);
  EXPECT_DOUBLE_EQ(s.slip_ratio, s.ideal_slip_ratio);
  EXPECT_NEAR(*s.efficiency, 1.0, 1e-13);
  EXPECT_EQ(s.power.total(), 0.0);
  EXPECT_NEAR(s.torque_screw, 35e3 * 10e-3 / (2 * std::numbers::pi), 1e-10);  // (3.18)
}

/// One point for each contact has no spin: nothing brakes the rollers, as in the models of which fig. 3.8 warns.
TEST(Slip, SinglePointContactsMissTheSpin) {
  Case c = test::sandu_reference();
  c.model.patch_points = 1;
  const SlipResult s = slip_of(c);
  EXPECT_EQ(s.status, SlipStatus::converged);
  EXPECT_NEAR(s.slip_ratio, s.ideal_slip_ratio, 1e-6);
  EXPECT_EQ(s.threads.nut.spin_torque[0], 0.0);
  EXPECT_LT(s.power.nut, 1e-9 * s.power.screw);
}

/// Fig. 3.8: 21 x 21 points are enough.
TEST(Slip, PowerConvergesWithThePatchPoints) {
  SKIP_UNDER_SANITIZERS();
  Case c = test::sandu_reference();
  const auto power = [&](int points) {
    c.model.patch_points = points;
    return slip_of(c).power.total();
  };
  const double fine = power(401);
  double before = 1.0;
  for (const int points : {7, 21, 63, 189}) {
    const double error = std::abs(power(points) / fine - 1.0);
    EXPECT_LT(error, before) << points;
    before = error;
  }
  EXPECT_LT(std::abs(power(21) / fine - 1.0), 0.005);
}

/// Weights are not normalised: a coarse grid carries more than the load, with a corresponding error of the power.
TEST(Slip, FewestPatchPointsMissLoadAndPowerByLessThanTwoPercent) {
  SKIP_UNDER_SANITIZERS();
  const auto excess = [](int points) {
    const contact::PatchGrid grid(points);
    return grid.cell_load() * grid.dome().sum() - 1.0;
  };
  EXPECT_NEAR(excess(1), 0.91, 0.001);
  EXPECT_GT(excess(kFewestPatchPoints - 1), 0.025);
  for (int points = kFewestPatchPoints; points <= 100; ++points) EXPECT_LT(std::abs(excess(points)), 0.016) << points;

  for (const Case& lubricated : {test::sandu_reference(), test::inverted(test::sandu_reference())})
    for (Case c : {lubricated, test::with_coulomb(lubricated, 0.1)}) {
      const auto power = [&](int points) {
        c.model.patch_points = points;
        return slip_of(c).power.total();
      };
      const double fine = power(201);
      EXPECT_GT(power(kFewestPatchPoints - 1) / fine, 1.025);
      for (int points = kFewestPatchPoints; points <= 21; ++points)
        EXPECT_NEAR(power(points) / fine, 1.0, 0.02) << points;
    }
}

/// Friction so strong that it would hold a contact open.
TEST(Slip, AContactCanJam) {
  const Result result = analyze_slip(test::with_coulomb(test::sandu_reference(), 20.0));
  const SlipResult& s = *result.load_cases[0].slip;
  EXPECT_EQ(s.status, SlipStatus::jammed);
  EXPECT_FALSE(s.relative_residue.has_value());
  EXPECT_THAT(sentences(result.load_cases[0].warnings), ::testing::Contains(HasSubstr("jams")));
}

TEST(Slip, TooSlowAMotionIsWarnedOf) {
  Case c = test::sandu_reference();
  c.operation->speed = 1e-10;
  EXPECT_THAT(sentences(analyze_slip(c).load_cases[0].warnings),
              ::testing::Contains(HasSubstr("nothing slides faster")));
  // Down to where friction has no direction, the mean coefficient follows its formula.
  c.operation->speed = 1e-7;
  expect_as_plain(c, analyze_slip(c), 1e-9);
}

TEST(Slip, ASelfLockingScrewHasNoEfficiency) {
  Case c = test::left_handed(test::with_coulomb(test::sandu_reference(), 0.5));
  c.mechanism.lead = -2e-3;
  const Result result = analyze_slip(c);
  const SlipResult& s = *result.load_cases[0].slip;
  ASSERT_EQ(s.status, SlipStatus::converged);
  EXPECT_FALSE(s.efficiency.has_value());
  EXPECT_EQ(s.self_locking, true);
  EXPECT_GT(*s.holding_torque, 0.0);  // the shaft drives although the load helps
  const double load_power = -35e3 * c.mechanism.lead / (2 * std::numbers::pi) * s.speed;
  EXPECT_NEAR(*s.holding_torque * s.speed + load_power, s.power.total(), 1e-9 * s.power.total());
  EXPECT_THAT(sentences(result.load_cases[0].warnings), ::testing::Contains(HasSubstr("self-locking")));
}

TEST(Slip, AnExcessiveCarrierTorqueLeavesNoEquilibrium) {
  Case c = test::sandu_reference();
  c.carrier.nut_torque = 1e4;
  const Result result = analyze_slip(c);
  EXPECT_EQ(result.load_cases[0].slip->status, SlipStatus::no_equilibrium);
  EXPECT_FALSE(result.load_cases[0].slip->converged());
  EXPECT_THAT(sentences(result.load_cases[0].warnings), ::testing::Contains(HasSubstr("no_equilibrium")));
}

/// A screw that drags the carrier along turns the rollers faster than they would roll.
TEST(Slip, ADrivenCarrierPassesTheIdealSlipRatio) {
  Case c = few_threads();
  c.carrier.screw_torque = 0.5;
  const Result result = analyze_slip(c);
  const SlipResult& s = *result.load_cases[0].slip;
  ASSERT_EQ(s.status, SlipStatus::converged);
  EXPECT_GT(s.slip_ratio, s.ideal_slip_ratio);
  EXPECT_GT(s.optimality, 1.0);
  EXPECT_NEAR(s.power.total() / s.power_loss_input_output, 1.0, 1e-10);
  EXPECT_THAT(sentences(result.load_cases[0].warnings), ::testing::Contains(HasSubstr("beyond the ideal")));
  expect_as_plain(c, result, 1e-10);
}

/// Slightly above the ideal slip ratio, as in experiment 11 of Sandu 2018, section 2.2.3.
TEST(Slip, AnImposedSlipRatioMayPassTheIdealOne) {
  for (const auto& [type, slip_ratio] :
       {std::pair{Mechanism::Type::standard, 0.3742}, {Mechanism::Type::inverted, 0.4155}}) {
    Case c = test::sandu_reference();
    if (type == Mechanism::Type::inverted) c = test::inverted(c);
    c.operation->slip_ratio = slip_ratio;
    const Result result = analyze_slip(c);
    const SlipResult& s = *result.load_cases[0].slip;
    EXPECT_EQ(s.status, SlipStatus::imposed);
    EXPECT_EQ(s.slip_ratio, slip_ratio);
    EXPECT_GT(s.optimality, 1.0);
    EXPECT_THAT(sentences(result.load_cases[0].warnings), ::testing::Contains(HasSubstr("beyond the ideal one")));
    expect_as_plain(c, result, 1e-10);
  }
}

/// The mechanism of a design with all its radii, as if measured.
Case measured(Case c) {
  c.mechanism = find_contacts(c.mechanism, c.materials).mechanism;
  c.mechanism.geometry = Mechanism::Geometry::simulation;
  return c;
}

/// Gears keep the ratio of their teeth: both powers agree for any diameters, and pitch cylinders slide by
/// their difference.
TEST(Slip, DiametersOffTheRatioOfTheGearsSlide) {
  for (const bool standard : {true, false}) {
    Case c = measured(standard ? few_threads() : test::inverted(few_threads()));
    const SlipResult matched = slip_of(c);
    EXPECT_EQ(matched.pitch_sliding_per_turn, 0.0);
    const double thicker = 5e-5 * *c.mechanism.pitch_diameter.roller;
    *c.mechanism.pitch_diameter.roller += thicker;
    const Result result = analyze_slip(c);
    const SlipResult& s = *result.load_cases[0].slip;
    ASSERT_EQ(s.status, SlipStatus::converged);
    EXPECT_NEAR(s.power.total() / s.power_loss_input_output, 1.0, 1e-10);
    EXPECT_EQ(s.migration_per_turn, 0.0);
    EXPECT_NEAR(s.travel_per_turn, c.mechanism.lead, 1e-17);
    // 5 times the roller's circumference against that of the geared part, per turn that rolls on it.
    const double turns = standard ? s.slip_ratio : 1.0 - s.slip_ratio;
    EXPECT_NEAR(s.pitch_sliding_per_turn, turns * std::numbers::pi * 5.0 * thicker, 1e-14);
    const auto warned = ::testing::Contains(HasSubstr("pitch cylinders of rollers"));
    // Within the digits of stated diameters.
    EXPECT_THAT(sentences(result.load_cases[0].warnings), ::testing::Not(warned));
    *c.mechanism.pitch_diameter.roller += 4.0 * thicker;
    EXPECT_THAT(sentences(analyze_slip(c).load_cases[0].warnings), warned);
    expect_as_plain(c, analyze_slip(c), 1e-10);
  }
}

/// A roller whose pitch is d too long runs ahead by n_S d per turn of the carrier against the geared part; a
/// nut whose pitch is d too long travels l + epsilon n_S d per turn.
TEST(Slip, UnequalPitchesMakeRollersMigrate) {
  for (const bool standard : {true, false})
    for (const double hand : {1.0, -1.0}) {
      Case c = measured(standard ? few_threads() : test::inverted(few_threads()));
      c.mechanism.lead *= hand;
      const double pitch = axial_pitch(c.mechanism), off = 0.3e-6;
      c.mechanism.pitch.roller = pitch + off;
      const Result result = analyze_slip(c);
      const SlipResult& s = *result.load_cases[0].slip;
      ASSERT_EQ(s.status, SlipStatus::converged);
      const double turns = standard ? s.slip_ratio : 1.0 - s.slip_ratio;
      EXPECT_NEAR(s.migration_per_turn, turns * 5.0 * off, 1e-13);
      EXPECT_NEAR(s.power.total() / s.power_loss_input_output, 1.0, 1e-10);
      EXPECT_THAT(sentences(result.load_cases[0].warnings), ::testing::Contains(HasSubstr("the rollers run ahead of")));
      c.mechanism.pitch.roller.reset();
      c.mechanism.pitch.nut = pitch + off;
      const SlipResult nut = slip_of(c);
      EXPECT_NEAR(nut.travel_per_turn, 10e-3 + nut.slip_ratio * 5.0 * off, 1e-15);
      EXPECT_NEAR(nut.migration_per_turn, standard ? -nut.slip_ratio * 5.0 * off : 0.0, 1e-13);
      EXPECT_NEAR(nut.power.total() / nut.power_loss_input_output, 1.0, 1e-10);
    }
}

TEST(Slip, ThreadsThatLeaveTheirGroovesAreAnError) {
  Case c = measured(few_threads());
  const double pitch = axial_pitch(c.mechanism);
  c.mechanism.pitch.roller = pitch * (1.0 + 0.51 / (c.mechanism.contacts_per_roller - 1));
  try {
    analyze_slip(c);
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_EQ(error.path(), "mechanism.pitch.roller");
    EXPECT_THAT(error.what(), HasSubstr("differ by half a pitch"));
  }
}

/// Each interface has its own friction: mu of the screw acts there, that of the nut there.
TEST(Slip, InterfacesHaveCoefficientsOfTheirOwn) {
  Case c = test::with_coulomb(few_threads(), 0.1);
  c.friction->coefficient = {0.12, 0.08};
  const Result result = analyze_slip(c);
  for (const Interface i : kInterfaces)
    for (const double mu : result.load_cases[0].slip->threads[i].friction_coefficient)
      EXPECT_NEAR(mu, c.friction->coefficient[i], 1e-14);
  expect_as_plain(c, result, 1e-10);
}

/// Without friction F l/(2 pi) is needed, the same in both senses; friction opens a range about it whose ends are the
/// torques of a slow motion in either sense.
TEST(Slip, AScrewAtRestIsHeldBetweenTheTorquesOfBothSenses) {
  for (const bool standard : {true, false})
    for (const double mu : {0.0, 0.02, 0.2}) {
      Case c = test::with_coulomb(standard ? few_threads() : test::inverted(few_threads()), mu);
      c.materials->roller.density = 7810.0;
      c.operation->speed = 0.0;
      const SlipResult at_rest = slip_of(c);
      ASSERT_EQ(at_rest.status, SlipStatus::held);
      EXPECT_EQ(at_rest.power.total(), 0.0);
      const Holding& h = *at_rest.holding;
      const double ideal = c.load_cases[0].axial_force * c.mechanism.lead / (2.0 * std::numbers::pi);
      if (mu == 0.0) {
        EXPECT_NEAR(h.against_load.holding_torque, ideal, 1e-9 * ideal);
        EXPECT_NEAR(h.with_load.holding_torque, ideal, 1e-9 * ideal);
        continue;
      }
      EXPECT_GT(h.against_load.holding_torque, ideal);
      EXPECT_LT(h.with_load.holding_torque, ideal);
      for (const double speed : {1e-2, -1e-2}) {  // A force in tension is moved by speeds > 0.
        c.operation->speed = speed;
        const SlipResult slow = slip_of(c);
        const Holding::Bound& bound = speed > 0.0 ? h.against_load : h.with_load;
        EXPECT_NEAR(slow.torque_screw, bound.torque_screw, 1e-8 * ideal);
        EXPECT_NEAR(slow.torque_nut, bound.torque_nut, 1e-8 * ideal);
        EXPECT_NEAR(slow.forces.carrier_x, bound.forces.carrier_x, 1e-6 * std::abs(slow.forces.carrier_x));
      }
    }
}

/// At rest there is no film: touching flanks have the coefficient without film.
TEST(Slip, AtRestMixedFrictionIsThatOfTouchingFlanks) {
  Case c = few_threads();
  c.operation->speed = 0.0;
  const SlipResult mixed = slip_of(test::with_mixed_friction(c, 0.11, 2.0));
  const SlipResult coulomb = slip_of(test::with_coulomb(c, 0.11));
  EXPECT_EQ(mixed.holding->against_load.torque_screw, coulomb.holding->against_load.torque_screw);
  EXPECT_EQ(mixed.holding->with_load.torque_screw, coulomb.holding->with_load.torque_screw);
}

TEST(Slip, MixedLubricationIsWarnedOf) {
  Case c = test::sandu_reference();
  c.roughness = PerPart<double>{0.3e-6, 0.4e-6, 0.3e-6};
  const Result result = analyze_slip(c);
  const SlipResult& s = *result.load_cases[0].slip;
  EXPECT_NEAR(s.threads.screw.film_ratio[0], s.threads.screw.central_film[0] / 0.5e-6, 1e-12);
  EXPECT_THAT(sentences(result.load_cases[0].warnings),
              ::testing::Contains(HasSubstr("boundary lubrication at the roller-screw")));
  c.roughness = PerPart<double>{0.03e-6, 0.04e-6, 0.03e-6};
  EXPECT_THAT(sentences(analyze_slip(c).load_cases[0].warnings),
              ::testing::Not(::testing::Contains(HasSubstr("lubrication"))));
}

/// A film depends on motion and static load, not on the law of friction.
TEST(Slip, CoulombFrictionHasTheFilmOfItsLubricant) {
  Case c = test::sandu_reference();
  c.operation->slip_ratio = 0.3730;
  c.roughness = PerPart<double>{0.3e-6, 0.4e-6, 0.3e-6};
  const SlipResult jacod = slip_of(c);
  c = test::with_coulomb(c, 0.1);
  const Result result = analyze_slip(c);
  const SlipResult& coulomb = *result.load_cases[0].slip;
  EXPECT_EQ(coulomb.viscosity, jacod.viscosity);
  for (const Interface i : kInterfaces) {
    ASSERT_EQ(coulomb.threads[i].central_film.size(), jacod.threads[i].central_film.size());
    EXPECT_EQ(coulomb.threads[i].film_thickness, jacod.threads[i].film_thickness);
    EXPECT_EQ(coulomb.threads[i].central_film, jacod.threads[i].central_film);
    EXPECT_EQ(coulomb.threads[i].film_ratio, jacod.threads[i].film_ratio);
  }
  const auto advice = ::testing::Contains(HasSubstr("take a friction coefficient of surfaces that touch"));
  EXPECT_THAT(sentences(result.load_cases[0].warnings), ::testing::Not(advice));  // The default, 0.1, is one.
  EXPECT_THAT(sentences(analyze_slip(test::with_coulomb(c, 0.02)).load_cases[0].warnings), advice);
  c.lubricant.reset();
  const SlipResult dry = slip_of(c);
  EXPECT_TRUE(dry.threads.screw.central_film.empty());
  EXPECT_TRUE(dry.threads.screw.film_ratio.empty());
  EXPECT_FALSE(dry.viscosity);
}

/// Published fits side by side on one example: Hamrock and Dowson (1977) with the mean speed and
/// k = 1.03 lambda^-0.64, and Sandu's short form of Moes and Venner's.
TEST(Slip, FullFitLiesBetweenHamrockDowsonAndSandu) {
  const Result result = analyze_slip(test::sandu_reference());
  const SlipResult& s = *result.load_cases[0].slip;
  const contact::Lubricant oil{0.1665, 30e-9, 12e6};
  const auto hamrock_dowson = [&](Interface i) {
    const InterfaceContact& contact = result.contacts.interfaces[i];
    const contact::PrincipalValues rho = contact.geometry.relative;
    const double modulus = 2.0 * contact.contact_modulus;
    // Speed from Sandu's film, as the result does not state it.
    const double load = result.load_cases[0].threads.value()[i].normal_load[0];
    const auto film = [&](double speed) {
      return contact::sandu_film(oil, {load, rho.second, contact.contact_modulus}, speed).thickness;
    };
    const double speed = std::pow(s.threads[i].film_thickness[0] / film(1.0), 48.0 / 37.0);
    const double u = oil.viscosity * 0.5 * speed * rho.second / modulus;
    const double g = oil.pressure_viscosity * modulus;
    const double w = load * rho.second * rho.second / modulus;
    const double k = 1.03 * std::pow(rho.second / rho.first, 0.64);
    return 2.69 * std::pow(u, 0.67) * std::pow(g, 0.53) * std::pow(w, -0.067) * (1.0 - 0.61 * std::exp(-0.73 * k)) /
           rho.second;
  };
  EXPECT_NEAR(hamrock_dowson(Interface::screw), 297e-9, 1e-9);
  EXPECT_NEAR(hamrock_dowson(Interface::nut), 330e-9, 1e-9);
  for (const Interface i : kInterfaces) {
    EXPECT_GT(s.threads[i].central_film[0], 1.2 * hamrock_dowson(i));
    EXPECT_LT(s.threads[i].central_film[0], s.threads[i].film_thickness[0] / 1.15);
    EXPECT_GT(s.threads[i].central_film[0], s.threads[i].film_thickness[0] / 1.18);
  }
}

/// A bearing on the roller heads enters the balance: both powers still agree.
TEST(Slip, AJournalBearingKeepsTheEnergyBalance) {
  Case c = test::sandu_reference();
  c.carrier.bearing = HeadBearing{{6e-3, 6e-3, 0.1e-3}};
  c.materials->roller.density = 7810.0;
  const SlipResult s = slip_of(c);
  ASSERT_EQ(s.status, SlipStatus::converged);
  EXPECT_GT(s.power.carrier_roller, 0.0);
  EXPECT_LT(s.power.carrier_roller, 0.02 * s.power.total());  // section 3.3: very small
  EXPECT_GT(s.forces.centrifugal, 0.0);
  EXPECT_NEAR(s.power.total() / s.power_loss_input_output, 1.0, 1e-10);
  EXPECT_GT(*s.bearing_eccentricity, 0.5);
  EXPECT_LT(*s.bearing_eccentricity, 1.0);
}

/// The inverted screw of Abevi with a flexible roller: unequal loads, thread by thread.
Case solved_case() {
  Case c = test::sandu_reference();
  Mechanism& m = c.mechanism;
  m = {};
  m.type = Mechanism::Type::inverted;
  m.lead = 5e-3;
  m.starts = {3, 1};
  constexpr double flank = std::numbers::pi / 4;
  m.flank_angle = {flank, flank, flank};
  m.pitch_diameter = {21e-3, 7e-3, 35e-3};
  m.centre_distance = 14e-3;
  m.profile.roller = {Profile::Shape::convex, 4.949747468e-3};
  m.rollers = 11;
  m.contacts_per_roller = 20;
  c.structure.emplace();
  c.structure->screw = {6e-3, 10e-3};
  c.structure->roller = {5e-3, 5e-3, {}};
  c.structure->nut = {
      90e-3, 46e-3, {{0.0, 10e-3, 62e-3}, {80e-3, 90e-3, 62e-3}}, {.tension = 10e-3, .compression = 80e-3}};
  c.load_cases.clear();
  LoadCase load;
  load.name = "tension";
  load.axial_force = 45e3;
  load.direction = Direction::tension;
  load.position = 29.1666667e-3;
  c.load_cases.push_back(load);
  return c;
}

TEST(SlipOnSolvedLoads, MatchesThePlainCalculationThreadByThread) {
  Case c = solved_case();
  c.model.loads = ModelOptions::Loads::at_rest;
  const Result result = analyze_slip(c);
  ASSERT_TRUE(result.load_cases[0].slip->converged());
  expect_as_plain(c, result, 1e-10);
}

TEST(SlipOnSolvedLoads, KeepsTheEnergyBalance) {
  for (const Direction direction : {Direction::tension, Direction::compression}) {
    Case c = solved_case();
    c.load_cases[0].direction = direction;
    if (direction == Direction::compression) c.operation->speed = -c.operation->speed;
    const SlipResult s = slip_of(c);
    EXPECT_NEAR(s.power.total() / s.power_loss_input_output, 1.0, 1e-10);
    EXPECT_NEAR(s.torque_screw / s.torque_nut, -1.0, 1e-12);
    double by_threads = 0.0;
    for (const Interface i : kInterfaces)
      by_threads += std::accumulate(s.threads[i].power.begin(), s.threads[i].power.end(), 0.0);
    EXPECT_NEAR(11 * by_threads / s.power.total(), 1.0, 1e-13);
  }
}

TEST(SlipOnSolvedLoads, SaysWhatUnequalLoadsChange) {
  const Case solved = solved_case();
  const SlipResult s = slip_of(solved);
  Case equal = solved;
  equal.load_cases[0].share = LoadCase::Share::equal;
  const SlipResult e = slip_of(equal);
  ASSERT_TRUE(s.equal_shares.has_value());
  EXPECT_FALSE(e.equal_shares.has_value());
  EXPECT_DOUBLE_EQ(s.equal_shares->slip_ratio, e.slip_ratio);
  EXPECT_DOUBLE_EQ(s.equal_shares->power_loss, e.power.total());
  EXPECT_DOUBLE_EQ(*s.equal_shares->efficiency, *e.efficiency);
  EXPECT_DOUBLE_EQ(s.equal_shares->thread_power.nut, e.threads.nut.power[0]);
  EXPECT_EQ(s.hottest.interface, Interface::nut);  // where an inverted screw slides
  EXPECT_GT(s.threads.nut.power[static_cast<std::size_t>(s.hottest.thread)], s.equal_shares->thread_power.nut);
}

Case full_case() {
  Case c = solved_case();
  c.model.mechanism = ModelOptions::Mechanism::full;
  c.carrier.roller_torque = 0.001;
  c.carrier.bearing.reset();
  return c;
}

TEST(SlipOfAllRollers, IsThatOfTheSectorWhereAllAreAlike) {
  Case sector = full_case();
  sector.carrier.roller_torque = 0.0;
  sector.carrier.bearing = HeadBearing{{5e-3, 5e-3, 0.1e-3}};
  sector.materials->roller.density = 7810.0;
  sector.wear = Wear{1e-17};
  sector.roughness = PerPart<double>{0.2e-6, 0.2e-6, 0.2e-6};
  Case full = sector;
  sector.model.mechanism = ModelOptions::Mechanism::sector;
  const SlipResult a = slip_of(full), b = slip_of(sector);
  ASSERT_EQ(a.status, SlipStatus::converged);
  EXPECT_NEAR(a.slip_ratio, b.slip_ratio, 1e-12);
  EXPECT_NEAR(a.power.total() / b.power.total(), 1.0, 1e-10);
  EXPECT_NEAR(a.power.carrier_roller / b.power.carrier_roller, 1.0, 1e-10);
  EXPECT_NEAR(a.power_loss_input_output / b.power_loss_input_output, 1.0, 1e-10);
  EXPECT_NEAR(*a.efficiency / *b.efficiency, 1.0, 1e-10);
  EXPECT_NEAR(a.torque_screw / b.torque_screw, 1.0, 1e-10);
  EXPECT_NEAR(a.forces.carrier_x / b.forces.carrier_x, 1.0, 1e-10);
  EXPECT_NEAR(a.moments.contacts / b.moments.contacts, 1.0, 1e-10);
  EXPECT_NEAR(*a.bearing_eccentricity / *b.bearing_eccentricity, 1.0, 1e-10);
  EXPECT_NEAR(a.equal_shares->power_loss / b.equal_shares->power_loss, 1.0, 1e-10);
  for (const Interface i : kInterfaces) {
    EXPECT_EQ(a.threads[i].threads_per_roller, 20);
    ASSERT_EQ(a.threads[i].power.size(), 220u);
    for (std::size_t k = 0; k < 220; ++k) {
      EXPECT_NEAR(a.threads[i].power[k] / b.threads[i].power[k % 20], 1.0, 1e-10);
      EXPECT_NEAR(a.threads[i].film_ratio[k] / b.threads[i].film_ratio[k % 20], 1.0, 1e-10);
      EXPECT_NEAR(a.threads[i].wear[k] / b.threads[i].wear[k % 20], 1.0, 1e-10);
    }
  }
}

TEST(SlipOfAllRollers, KeepsTheEnergyBalanceOfUnequalRollers) {
  Case c = full_case();
  c.deviations.roller_diameters = {4e-6, -3e-6, 2e-6, 0.0, -1e-6, 5e-6, 0.0, 0.0, 1e-6, -4e-6, 0.0};
  c.load_cases[0].spatial.side_force.value.y = 1e3;
  for (const bool missing : {false, true}) {
    if (missing) c.deviations.missing_rollers = {3};
    for (const double speed : {40.0, -40.0}) {
      c.operation->speed = speed;
      const SlipResult s = slip_of(c);
      ASSERT_EQ(s.status, SlipStatus::converged);
      EXPECT_NEAR(s.power.total() / s.power_loss_input_output, 1.0, 1e-9);
      EXPECT_NEAR(s.torque_screw / s.torque_nut, -1.0, 1e-9);
      double by_threads = 0.0;
      for (const Interface i : kInterfaces)
        by_threads += std::accumulate(s.threads[i].power.begin(), s.threads[i].power.end(), 0.0);
      EXPECT_NEAR(by_threads / (s.power.screw + s.power.nut), 1.0, 1e-12);
      const std::vector<double>& power = s.threads.nut.power;
      EXPECT_GT(power[0], 1.05 * power[20]);  // a thicker roller
      for (std::size_t k = 40; k < 60; ++k) EXPECT_EQ(power[k] == 0.0, missing);
    }
  }
}

/// Equal loads given thread by thread are Sandu's equal shares.
TEST(SlipOnSolvedLoads, EqualLoadsGiveSandu) {
  Case c = solved_case();
  c.load_cases[0].share = LoadCase::Share::equal;
  const Result equal = analyze_slip(c);
  expect_as_plain(c, equal, 1e-10);  // which sums over 20 threads of their own
}

TEST(SlipPictures, ShowTheRootAndTheResultsFields) {
  const Case c = test::sandu_reference();
  const Result result = analyze_slip(c);
  const SlipResult& s = *result.load_cases[0].slip;
  const SlipPictures p = slip_pictures(c, result, 0);
  const ResidueCurve& curve = p.residue;
  ASSERT_GT(curve.slip_ratio.size(), 50u);
  // Strictly monotonous with one change of sign (section 3.2.6).
  for (std::size_t k = 1; k < curve.moments.size(); ++k)
    EXPECT_GT(curve.moments[k].residue(), curve.moments[k - 1].residue());
  EXPECT_LT(curve.moments.front().residue(), 0.0);
  EXPECT_GT(curve.moments.back().residue(), 0.0);
  EXPECT_LT(p.residue_near_root.slip_ratio.front(), s.slip_ratio);
  EXPECT_GT(p.residue_near_root.slip_ratio.back(), s.ideal_slip_ratio);
  for (const Interface i : kInterfaces) {
    const PatchField& f = (*p.most_loaded_thread)[i];
    const double mean = std::accumulate(f.friction_coefficient.begin(), f.friction_coefficient.end(), 0.0) /
                        static_cast<double>(f.friction_coefficient.size());
    EXPECT_NEAR(mean, s.threads[i].friction_coefficient[0], 1e-12);
    EXPECT_EQ(f.along_major.size(), f.sliding_minor.size());
  }
}

/// Sandu's reference with an oil that is heated at the inlet.
Case with_inlet_heating(Case c) {
  c.lubricant->film.inlet_heating = Lubricant::Film::InletHeating{0.14, 0.04};
  return c;
}

TEST(Film, FullColdInletIsThatWithoutFactor) {
  Case c = test::with_mixed_friction(test::sandu_reference(), 0.11, 2.0);
  const SlipResult before = slip_of(c);
  c.lubricant->film.starvation = 1.0;
  const SlipResult after = slip_of(c);
  EXPECT_EQ(after.slip_ratio, before.slip_ratio);
  EXPECT_EQ(after.power.total(), before.power.total());
  EXPECT_EQ(after.threads.screw.film_factor, std::vector<double>(28, 1.0));
}

/// phi thins the film over roughness and in the law of friction, not the two films themselves.
TEST(Film, FactorThinsTheFilmOverRoughness) {
  Case c = test::with_mixed_friction(test::sandu_reference(), 0.11, 2.0);
  c.operation->slip_ratio = 0.3;
  const SlipResult full = slip_of(c);
  c.lubricant->film.starvation = 0.7;
  const SlipResult starved = slip_of(c), warm = slip_of(with_inlet_heating(c));
  for (const Interface i : kInterfaces) {
    const InterfaceSlip &f = full.threads[i], &s = starved.threads[i], &w = warm.threads[i];
    EXPECT_EQ(s.central_film, f.central_film);
    EXPECT_EQ(s.film_thickness, f.film_thickness);
    EXPECT_NEAR(s.film_ratio[0] / f.film_ratio[0], 0.7, 1e-14);
    EXPECT_LT(w.film_factor[0], 0.7);
    EXPECT_NEAR(w.film_ratio[0] / f.film_ratio[0], w.film_factor[0], 1e-14);
    EXPECT_NEAR(w.boundary_share[0], std::pow(1.0 + w.film_ratio[0], -2.0), 1e-14);
    EXPECT_GT(s.boundary_share[0], f.boundary_share[0]);
  }
}

/// Jacod's friction of a film that is thinner by phi: H_c -> phi H_c, that is K/phi.
TEST(Film, ThinnerFilmRubsMore) {
  Case c = test::sandu_reference();
  c.operation->slip_ratio = 0.3;
  const double full = slip_of(c).threads.screw.friction_coefficient[0];
  c.lubricant->film.starvation = 0.5;
  EXPECT_GT(slip_of(c).threads.screw.friction_coefficient[0], full);
}

/// Newton's method on the slope of the moment finds the root that the values alone have.
TEST(Film, InletHeatingLeavesABalance) {
  const Case c = with_inlet_heating(test::with_mixed_friction(test::sandu_reference(), 0.11, 2.0));
  const SlipResult s = slip_of(c);
  ASSERT_EQ(s.status, SlipStatus::converged);
  EXPECT_LT(s.evaluations, 12);
  EXPECT_NEAR(s.power_loss_input_output / s.power.total(), 1.0, 1e-8);
  EXPECT_NEAR(*s.relative_residue, 0.0, 1e-13);
}

TEST(Film, CoefficientOfTheOilIsThatOfItsLaw) {
  Case c = with_inlet_heating(test::sandu_reference());
  Lubricant& oil = *c.lubricant;
  oil.viscosity.reset();
  oil.walther = contact::walther_line(313.15, 100e-6, 373.15, 11.2e-6);
  oil.density = 870.0;
  oil.temperature = 333.15;
  oil.film.inlet_heating->temperature_coefficient.reset();
  EXPECT_EQ(in_operation(oil).temperature_coefficient, contact::temperature_coefficient(*oil.walther, 333.15));
  oil.film.inlet_heating->temperature_coefficient = 0.05;
  EXPECT_EQ(in_operation(oil).temperature_coefficient, 0.05);
}

TEST(Flash, NeedsThreePropertiesOfBothBodies) {
  Case c = test::sandu_reference();
  EXPECT_TRUE(slip_of(c).threads.screw.flash_temperature.empty());
  for (const Part p : {Part::roller, Part::screw}) {
    Material& m = (*c.materials)[p];
    m.density = 7810.0;
    m.conductivity = 45.0;
    m.specific_heat = 460.0;
  }
  const SlipResult s = slip_of(c);
  ASSERT_EQ(s.threads.screw.flash_temperature.size(), 28u);
  EXPECT_GT(s.threads.screw.flash_temperature[0], 0.0);
  EXPECT_TRUE(s.threads.nut.flash_temperature.empty());
}

TEST(Flash, WarnsAboveFiftyKelvin) {
  Case c = test::with_coulomb(test::sandu_reference(), 0.1);
  for (const Part p : kParts) {
    Material& m = (*c.materials)[p];
    m.density = 7810.0;
    m.conductivity = 45.0;
    m.specific_heat = 460.0;
  }
  const auto told = [](const Case& of) {
    return std::ranges::any_of(analyze_slip(of).load_cases[0].warnings,
                               [](const Warning& w) { return w.code == "screw_flash_temperature"; });
  };
  const double flash = slip_of(c).threads.screw.flash_temperature[0];
  EXPECT_EQ(told(c), flash > 50.0);
  c.operation->speed *= 400.0;
  EXPECT_TRUE(told(c));
  c.operation->speed *= 1e-5;
  EXPECT_FALSE(told(c));
}

}  // namespace
}  // namespace prs
