#include "prs/threads/threads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <numbers>
#include <vector>

#include "prs/sector/sector.h"
#include "tests/support/sectors.h"

namespace prs {
namespace {

PerInterface<std::vector<double>> gaps_of(const test::SectorCase& c) {
  return initial_gaps(c.mechanism, c.deviations, c.materials, {c.laws.screw.normal_angle, c.laws.nut.normal_angle},
                      c.direction);
}

PitchError list(std::vector<double> values) { return {0.0, {}, std::move(values)}; }

TEST(Deviations, NominalPartsHaveNoGaps) {
  const auto gaps = gaps_of(test::abevi());
  for (const Interface i : kInterfaces)
    for (const double gap : gaps[i]) EXPECT_EQ(gap, 0.0);
}

TEST(Deviations, PitchesThatRoundingTellsApartHaveNoGaps) {
  test::SectorCase c = test::abevi();
  const double pitch = axial_pitch(c.mechanism), measured = 1.6e-3;
  for (const PerPart<double>& p :
       {PerPart<double>{pitch, std::nextafter(pitch, 1.0), std::nextafter(pitch, 0.0)},
        PerPart<double>{measured, std::nextafter(measured, 1.0), std::nextafter(measured, 0.0)}}) {
    c.mechanism.pitch = {p.screw, p.roller, p.nut};
    const auto gaps = gaps_of(c);
    for (const Interface i : kInterfaces)
      for (const double gap : gaps[i]) EXPECT_EQ(gap, 0.0);
  }
}

/// In tension (s = -1) the screw's faces that lie further away from its loaded end lead.
TEST(Deviations, AxialErrorsOpenByTheCosine) {
  test::SectorCase c = test::abevi();
  c.deviations.pitch_error.screw.linear = 3e-6;
  const double cosine = std::cos(c.laws.screw.normal_angle);
  auto gaps = gaps_of(c);
  EXPECT_EQ(gaps.screw.front(), 0.0);
  EXPECT_NEAR(gaps.screw.back(), 3e-6 * cosine, 1e-18);
  EXPECT_EQ(gaps.nut.back(), 0.0);
  c.direction = Direction::compression;
  gaps = gaps_of(c);
  EXPECT_NEAR(gaps.screw.front(), 3e-6 * cosine, 1e-18);
  EXPECT_EQ(gaps.screw.back(), 0.0);
}

/// An error of the roller moves both interfaces, one towards contact and one away from it.
TEST(Deviations, RollerErrorsActOnBothInterfaces) {
  test::SectorCase c = test::abevi();
  std::vector<double> error(20, 0.0);
  error[7] = 2e-6;
  c.deviations.pitch_error.roller = list(error);
  const auto gaps = gaps_of(c);
  const double at_screw = 2e-6 * std::cos(c.laws.screw.normal_angle);
  for (std::size_t k = 0; k < 20; ++k) {
    EXPECT_NEAR(gaps.screw[k], k == 7 ? 0.0 : at_screw, 1e-18);
    EXPECT_NEAR(gaps.nut[k], k == 7 ? 2e-6 * std::cos(c.laws.nut.normal_angle) : 0.0, 1e-18);
  }
}

TEST(Deviations, CrowningAndReliefOpenTheEndsByTheSine) {
  test::SectorCase c = test::abevi();
  c.deviations.crowning = 10e-6;
  auto gaps = gaps_of(c);
  const double sine = std::sin(c.laws.nut.normal_angle);
  EXPECT_NEAR(gaps.nut[0] - gaps.nut[9], 10e-6 * sine * (1.0 - std::pow(0.5 / 9.5, 2)), 1e-17);
  EXPECT_NEAR(gaps.nut[0], gaps.nut[19], 1e-20);
  EXPECT_EQ(gaps.nut[9], 0.0);

  c.deviations.crowning = 0.0;
  c.deviations.end_relief = EndRelief{4e-6, 4};
  gaps = gaps_of(c);
  EXPECT_NEAR(gaps.nut[0], 4e-6 * sine, 1e-18);
  EXPECT_NEAR(gaps.nut[1], 3e-6 * sine, 1e-18);
  EXPECT_EQ(gaps.nut[4], 0.0);
  EXPECT_NEAR(gaps.nut[18], 3e-6 * sine, 1e-18);
}

TEST(Deviations, APeriodicErrorRepeats) {
  test::SectorCase c = test::abevi();
  c.deviations.pitch_error.nut.periodic = PitchWave{1e-6, 4.0, 0.0};
  const auto gaps = gaps_of(c);
  for (std::size_t k = 0; k + 4 < 20; ++k) EXPECT_NEAR(gaps.nut[k], gaps.nut[k + 4], 1e-19);
  EXPECT_NEAR(std::abs(gaps.nut[1] - gaps.nut[3]), 2e-6 * std::cos(c.laws.nut.normal_angle), 1e-18);
}

/// A warm part is a part with a longer pitch; uniform oversize is a rigid motion.
TEST(Deviations, ATemperatureIsAPitchMismatch) {
  test::SectorCase warm = test::abevi(), longer = test::abevi();
  for (const Part part : kParts) warm.materials[part].thermal_expansion = 11.5e-6;
  warm.deviations.temperature = PerPart<double>{333.15, 293.15, 293.15};
  const double pitch = axial_pitch(longer.mechanism);
  longer.mechanism.pitch.screw = pitch * (1.0 + 11.5e-6 * 40.0);
  for (std::size_t k = 0; k < 20; ++k)
    EXPECT_NEAR(gaps_of(warm).screw[k], gaps_of(longer).screw[k], 1e-17);  // rounding of 20 pitches

  test::SectorCase oversize = test::abevi();
  oversize.deviations.roller_diameter = 5e-6;
  for (const double gap : gaps_of(oversize).screw) EXPECT_EQ(gap, 0.0);
}

/// Bodies so stiff that only the contacts deform, roller straight.
test::SectorCase rigid() {
  test::SectorCase c = test::abevi();
  c.options.roller = ModelOptions::Roller::rigid_bending;
  for (const Part part : kParts) c.materials[part].youngs_modulus = 1e18;
  return c;
}

TEST(Deviations, RigidBodiesShareTheLoadAmongTheThreadsThatTouch) {
  test::SectorCase c = rigid();
  std::vector<double> error(20, 0.0);
  error[5] = -1e-3;  // in tension the roller's thread 6 hangs back at the screw, leads at the nut
  c.deviations.pitch_error.nut = list(error);
  const double force = 45e3;
  const LoadDistribution d = SectorSolver(c.build()).solve(force);
  ASSERT_TRUE(d.solve.converged());
  const double cosine = std::cos(c.laws.nut.normal_angle);
  int open = 0;
  for (const double n : d.normal_load.nut)
    if (n == 0.0)
      ++open;
    else
      EXPECT_NEAR(n * cosine, force / 11 / (d.normal_load.nut[5] == 0.0 ? 19 : 1), 1e-3);
  EXPECT_TRUE(open == 1 || open == 19);
  for (const double n : d.normal_load.screw)
    EXPECT_NEAR(n * std::cos(c.laws.screw.normal_angle), force / 11 / 20, 1e-3);
}

/// Only thread 1 touches at both interfaces: bar, two Hertz contacts, bar, in series.
TEST(Deviations, AllThreadsButOneRelievedHaveTheClosedForm) {
  test::SectorCase c = test::abevi();
  c.options.roller = ModelOptions::Roller::rigid_bending;
  // In tension a screw thread further out lags; a nut thread further in gives way.
  std::vector<double> further(20, 1e-4), nearer(20, -1e-4);
  further[0] = nearer[0] = 0.0;
  c.deviations.pitch_error.screw = list(further);
  c.deviations.pitch_error.nut = list(nearer);
  const double force = 45e3, f = force / 11;
  const LoadDistribution d = SectorSolver(c.build()).solve(force);
  ASSERT_TRUE(d.solve.converged());
  EXPECT_NEAR(d.normal_load.screw[0] * std::cos(c.laws.screw.normal_angle) / f, 1.0, 1e-12);
  EXPECT_NEAR(d.normal_load.nut[0] * std::cos(c.laws.nut.normal_angle) / f, 1.0, 1e-12);

  const double e = 209e9;
  const auto ring = [](double outer, double inner) { return std::numbers::pi / 4 * (outer * outer - inner * inner); };
  const double screw = f * 10e-3 / (e * ring(21e-3, 6e-3) / 11);
  const double nut = f * (29.1666667e-3 - 10e-3) / (e * ring(46e-3, 35e-3) / 11);
  double contacts = 0.0;
  for (const Interface i : kInterfaces) {
    const double cosine = std::cos(c.laws[i].normal_angle);
    contacts += std::pow(f / cosine / c.laws[i].hertz_constant, 2.0 / 3.0) / cosine;
  }
  EXPECT_NEAR(d.axial_displacement / (screw + nut + contacts), 1.0, 1e-9);
}

}  // namespace
}  // namespace prs
