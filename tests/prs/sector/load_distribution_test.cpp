#include "prs/sector/sector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/count.h"
#include "support/dense_sector.h"
#include "support/sectors.h"
#include "support/sum.h"

namespace prs {
namespace {

using test::abevi;
using test::SectorCase;
using test::sum;

LoadDistribution solve(const SectorCase& c, double force) {
  SectorSolver solver(c.build());
  LoadDistribution r = solver.solve(force);
  EXPECT_TRUE(r.solve.converged()) << fe::name(r.solve.status) << r.solve.relative_residual;
  return r;
}

/// Axial loads of an interface over force/rollers.
std::vector<double> rates(const SectorCase& c, const LoadDistribution& r, Interface i, double force) {
  std::vector<double> rates;
  for (const double n : r.normal_load[i])
    rates.push_back(n * std::cos(c.laws[i].normal_angle) * c.mechanism.rollers / force);
  return rates;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECT_EQ(a.size(), b.size());
  double d = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) d = std::max(d, std::abs(a[i] - b[i]));
  return d;
}

std::vector<double> reversed(std::vector<double> v) {
  std::reverse(v.begin(), v.end());
  return v;
}

/// CONFIG 1 to 3, tension and compression, flexible and rigid in bending.
std::vector<SectorCase> paper_cases() {
  std::vector<SectorCase> cases;
  for (const double position : {54.3333333e-3, 29.1666667e-3, 4e-3})
    for (const Direction direction : {Direction::tension, Direction::compression})
      for (const auto roller : {ModelOptions::Roller::flexible, ModelOptions::Roller::rigid_bending}) {
        SectorCase c = abevi();
        c.position = position;
        c.direction = direction;
        c.options.roller = roller;
        cases.push_back(c);
      }
  return cases;
}

TEST(LoadDistribution, ThreeToFiveNewtonIterationsFromEqualSharesAt45kN) {
  for (const SectorCase& c : paper_cases()) {
    const LoadDistribution r = solve(c, 45e3);
    EXPECT_GE(r.solve.iterations(), 3);
    EXPECT_LE(r.solve.iterations(), 5);
    EXPECT_LE(r.solve.relative_residual, 1e-10);
  }
}

TEST(LoadDistribution, ThreadLoadsSumToAppliedLoad) {
  for (const SectorCase& c : paper_cases()) {
    const LoadDistribution r = solve(c, 45e3);
    for (const Interface i : kInterfaces) EXPECT_NEAR(sum(rates(c, r, i, 45e3)), 1.0, 1e-10);
  }
}

TEST(LoadDistribution, RandomSectorsAllConverge) {
  std::mt19937_64 random(20260101);
  const int count = test::samples(1000, 20000);
  for (int k = 0; k < count; ++k) {
    const SectorCase c = test::random_sector(random);
    const double force = test::random_force(c, random);
    SectorSolver solver(c.build());
    const LoadDistribution r = solver.solve(force);
    ASSERT_TRUE(r.solve.converged()) << k << ' ' << fe::name(r.solve.status) << ' ' << r.solve.relative_residual;
    ASSERT_LE(r.solve.relative_residual, 1e-10) << k;
    for (const Interface i : kInterfaces) ASSERT_NEAR(sum(rates(c, r, i, force)), 1.0, 1e-10) << k;
    ASSERT_GT(r.tangent_stiffness.value(), 0.0) << k;
    ASSERT_GT(r.axial_displacement, 0.0) << k;
  }
}

TEST(LoadDistribution, SparseAgreesWithIndependentDenseModel) {
  std::mt19937_64 random(5);
  for (int k = 0; k < test::samples(40, 400); ++k) {
    const SectorCase c = test::random_sector(random);
    const double force = test::random_force(c, random);
    const LoadDistribution r = solve(c, force);
    const test::DenseSector::Solution d = test::DenseSector(c).solve(force / c.mechanism.rollers);
    ASSERT_TRUE(d.converged) << k;
    std::vector<double> loads = r.normal_load.screw;
    loads.insert(loads.end(), r.normal_load.nut.begin(), r.normal_load.nut.end());
    const double sector_force = force / c.mechanism.rollers;
    EXPECT_LT(largest_difference(loads, {d.normal_load.begin(), d.normal_load.end()}), 1e-10 * sector_force) << k;
    EXPECT_NEAR(static_cast<double>(r.axial_displacement / d.displacement), 1.0, 1e-10) << k;
    EXPECT_NEAR(static_cast<double>(*r.tangent_stiffness / c.mechanism.rollers / d.tangent_stiffness), 1.0, 1e-8) << k;
  }
}

TEST(LoadDistribution, RollerIsInForceAndMomentBalance) {
  SectorCase c = abevi();
  c.structure.roller.guidance = {Guidance::Kind::ring, 2e7};
  for (const Direction direction : {Direction::tension, Direction::compression}) {
    c.direction = direction;
    SectorSolver solver(c.build());
    const LoadDistribution r = solver.solve(45e3);
    // Displacements of the ends are not part of the result: solve again for the state.
    const fe::Equations& equations = solver.equations();
    fe::NewtonSolver newton(equations);
    fe::State q = solver.equal_shares(45e3);
    ASSERT_TRUE(newton.solve(45e3 / 11 * solver.unit_load(), solver.newton_options(45e3), q).converged());
    const double p = 5e-3 / 3, radius = 3.5e-3, end = 5e-3;
    double axial = 0.0, radial = 0.0, moment = 0.0;
    const double s = sense(direction);
    for (std::size_t k = 0; k < 20; ++k) {
      const double x = static_cast<double>(k) * p;
      const double ns = r.normal_load.screw[k], nn = r.normal_load.nut[k];
      const double as = s * ns * std::cos(c.laws.screw.normal_angle);
      const double an = -s * nn * std::cos(c.laws.nut.normal_angle);
      const double rs = ns * std::sin(c.laws.screw.normal_angle);
      const double rn = -nn * std::sin(c.laws.nut.normal_angle);
      axial += as + an;
      radial += rs + rn;
      moment += x * (rs + rn) + radius * as - radius * an;
    }
    const double x[4] = {-p / 2 - end, -p / 2, 19.5 * p, 19.5 * p + end};
    for (std::size_t k = 0; k < 4; ++k) {
      const double v = equations.displacement(q, solver.sector().roller_end_nodes[k], fe::Dof::v);
      radial += -2e7 * v;
      moment += -2e7 * v * x[k];
    }
    const double force = 45e3 / 11;
    EXPECT_NEAR(axial / force, 0.0, 1e-10);
    EXPECT_NEAR(radial / force, 0.0, 1e-10);
    EXPECT_NEAR(moment / (force * 0.02), 0.0, 1e-10);
  }
}

/// Grooves change contacts, not bodies: with the same contact constants a sector of a recirculating screw is that of a
/// standard one with as many rollers as carry.
TEST(LoadDistribution, GroovedRollersShareAsThreadedOnes) {
  SectorCase standard = abevi(), grooved = abevi();
  standard.mechanism.type = Mechanism::Type::standard;
  grooved.mechanism.type = Mechanism::Type::recirculating;
  grooved.mechanism.starts.roller = 0;
  grooved.mechanism.rollers += 1;
  const double force = 45e3;
  const LoadDistribution a = solve(standard, force), b = solve(grooved, force);
  for (const Interface i : kInterfaces) {
    EXPECT_LT(largest_difference(rates(standard, a, i, force), rates(standard, b, i, force)), 1e-14);
    EXPECT_NEAR(sum(rates(standard, b, i, force)), 1.0, 1e-10);
  }
  EXPECT_DOUBLE_EQ(a.axial_displacement, b.axial_displacement);
}

TEST(LoadDistribution, RigidBodiesShareEqually) {
  SectorCase c = abevi();
  for (const Part p : kParts) c.materials[p].youngs_modulus = 209e15;
  c.options.roller = ModelOptions::Roller::rigid_bending;
  const LoadDistribution r = solve(c, 45e3);
  double displacement = 0.0;
  for (const Interface i : kInterfaces) {
    for (const double rate : rates(c, r, i, 45e3)) EXPECT_NEAR(rate, 0.05, 1e-6);
    const double cosine = std::cos(c.laws[i].normal_angle);
    displacement += std::pow(45e3 / 220 / cosine / c.laws[i].hertz_constant, 2.0 / 3.0) / cosine;
  }
  EXPECT_NEAR(r.axial_displacement / displacement, 1.0, 1e-5);
}

/// With one elastic body, the two thread loads obey delta_1 - delta_2 = cos(psi) F_2 p / (E A).
TEST(LoadDistribution, TwoThreadsFollowClosedForm) {
  SectorCase c = abevi();
  c.mechanism.contacts_per_roller = 2;
  c.materials.roller.youngs_modulus = c.materials.nut.youngs_modulus = 209e18;
  c.options.roller = ModelOptions::Roller::rigid_bending;
  const double force = 20e3, sector_force = force / 11;
  const double cosine = std::cos(c.laws.screw.normal_angle);
  const double area = std::numbers::pi / 4 * (21e-3 * 21e-3 - 6e-3 * 6e-3) / 11;
  const double compliance = 5e-3 / 3 / (209e9 * area);
  const auto approach = [&](double axial) { return std::pow(axial / cosine / c.laws.screw.hertz_constant, 2.0 / 3.0); };
  double low = 0.0, high = sector_force;  // second thread's load, by bisection
  for (int i = 0; i < 200; ++i) {
    const double f2 = 0.5 * (low + high);
    (approach(sector_force - f2) - approach(f2) > cosine * f2 * compliance ? low : high) = f2;
  }
  const std::vector<double> rate = rates(c, solve(c, force), Interface::screw, force);
  EXPECT_NEAR(rate[1] * sector_force / low, 1.0, 1e-8);
  EXPECT_NEAR(rate[0] + rate[1], 1.0, 1e-12);
}

/// Screw and nut with the same section, modulus and contact law, one flangeless nut over the
/// threads alone.
SectorCase equal_bodies() {
  SectorCase c = abevi();
  const double p = axial_pitch(c.mechanism);
  c.position = 0.0;
  c.structure.screw.free_length = 0.0;
  c.structure.nut = {19 * p, 0.0, {}, {.tension = 0.0, .compression = 19 * p}};
  const double screw_area = 21e-3 * 21e-3 - 6e-3 * 6e-3;
  c.structure.nut.outer_diameter = std::sqrt(35e-3 * 35e-3 + screw_area);
  c.laws.nut = c.laws.screw;
  return c;
}

TEST(LoadDistribution, EqualBodiesWithOppositeThrustAreSymmetricByHalfTurn) {
  for (const auto kind : {Guidance::Kind::both_end_nodes, Guidance::Kind::outer_node}) {
    SectorCase c = equal_bodies();
    c.structure.roller.guidance.kind = kind;
    c.direction = Direction::compression;
    const LoadDistribution r = solve(c, 45e3);
    EXPECT_LT(largest_difference(rates(c, r, Interface::screw, 45e3), reversed(rates(c, r, Interface::nut, 45e3))),
              1e-11);
  }
}

TEST(LoadDistribution, EqualBodiesMirrorTensionIntoCompression) {
  SectorCase c = equal_bodies();
  c.structure.nut.thrust = {.tension = 0.0, .compression = 0.0};
  c.direction = Direction::tension;
  const LoadDistribution tension = solve(c, 45e3);
  c.direction = Direction::compression;
  const LoadDistribution compression = solve(c, 45e3);
  EXPECT_LT(largest_difference(rates(c, tension, Interface::screw, 45e3), rates(c, compression, Interface::nut, 45e3)),
            1e-11);
  EXPECT_LT(largest_difference(rates(c, tension, Interface::nut, 45e3), rates(c, compression, Interface::screw, 45e3)),
            1e-11);
}

TEST(LoadDistribution, ScalingModuliConstantsAndLoadTogetherChangesNoDisplacement) {
  const SectorCase c = abevi();
  const LoadDistribution r = solve(c, 45e3);
  SectorCase scaled = c;
  for (const Part p : kParts) scaled.materials[p].youngs_modulus *= 3.7;
  for (const Interface i : kInterfaces) scaled.laws[i].hertz_constant *= 3.7;
  const LoadDistribution s = solve(scaled, 3.7 * 45e3);
  EXPECT_NEAR(s.axial_displacement / r.axial_displacement, 1.0, 1e-12);
  EXPECT_NEAR(*s.tangent_stiffness / *r.tangent_stiffness, 3.7, 1e-10);
  for (const Interface i : kInterfaces)
    EXPECT_LT(largest_difference(rates(c, r, i, 45e3), rates(scaled, s, i, 3.7 * 45e3)), 1e-12);
}

TEST(LoadDistribution, GeometricallySimilarScrewsShareAlike) {
  const double t = 2.3;
  const SectorCase c = abevi();
  SectorCase scaled = c;
  scaled.mechanism.lead *= t;
  for (const Part p : kParts) *scaled.mechanism.pitch_diameter[p] *= t;
  scaled.structure.screw = {t * 6e-3, t * 10e-3};
  scaled.structure.roller = {t * 5e-3, t * 5e-3, {}};
  scaled.structure.nut.length *= t;
  scaled.structure.nut.outer_diameter *= t;
  for (auto& f : scaled.structure.nut.flanges) f = {t * f.from, t * f.to, t * f.outer_diameter};
  scaled.structure.nut.thrust = {.tension = t * 10e-3, .compression = t * 80e-3};
  scaled.position *= t;
  for (const Interface i : kInterfaces) scaled.laws[i].hertz_constant *= std::sqrt(t);
  const LoadDistribution r = solve(c, 45e3), s = solve(scaled, t * t * 45e3);
  EXPECT_NEAR(s.axial_displacement / r.axial_displacement, t, 1e-11);
  for (const Interface i : kInterfaces)
    EXPECT_LT(largest_difference(rates(c, r, i, 45e3), rates(scaled, s, i, t * t * 45e3)), 1e-11);
}

TEST(LoadDistribution, VanishingLoadTendsToEqualSharesWithItsCubeRoot) {
  for (const SectorCase& c : paper_cases()) {
    const auto deviation = [&](double force) {
      const std::vector<double> r = rates(c, solve(c, force), Interface::screw, force);
      return *std::max_element(r.begin(), r.end()) - 0.05;
    };
    // The deviation is an expansion in F^(1/3): only its leading term remains as F falls.
    EXPECT_NEAR(std::log10(deviation(1e-3) / deviation(1e-6)), 1.0, 0.02);
    EXPECT_NEAR(std::log10(deviation(1e-6) / deviation(1e-9)), 1.0, 0.002);
  }
}

TEST(LoadDistribution, MovingBetweenTheFlangesChangesOnlyTheNutsElongation) {
  SectorCase c = abevi();
  const double area = std::numbers::pi / 4 * (46e-3 * 46e-3 - 35e-3 * 35e-3);
  for (const Direction direction : {Direction::tension, Direction::compression}) {
    c.direction = direction;
    c.position = 20e-3;
    const LoadDistribution here = solve(c, 45e3);
    c.position = 37e-3;
    const LoadDistribution there = solve(c, 45e3);
    for (const Interface i : kInterfaces)
      EXPECT_LT(largest_difference(rates(c, here, i, 45e3), rates(c, there, i, 45e3)), 1e-11);
    const double elongation = -sense(direction) * 45e3 * 17e-3 / (209e9 * area);
    EXPECT_NEAR((there.axial_displacement - here.axial_displacement) / elongation, 1.0, 1e-9);
  }
}

TEST(LoadDistribution, FreeLengthAddsItsElongationAlone) {
  SectorCase c = abevi();
  const LoadDistribution with = solve(c, 45e3);
  c.structure.screw.free_length = 0.0;
  const LoadDistribution without = solve(c, 45e3);
  const double area = std::numbers::pi / 4 * (21e-3 * 21e-3 - 6e-3 * 6e-3);
  EXPECT_NEAR((with.axial_displacement - without.axial_displacement) / (45e3 * 10e-3 / (209e9 * area)), 1.0, 1e-10);
  EXPECT_LT(largest_difference(with.normal_load.screw, without.normal_load.screw), 1e-9);
}

/// Without a free length no bar of the screw is left.
TEST(LoadDistribution, OneThreadMovesAsItsContactsAndTheFreeLengthDo) {
  SectorCase c = abevi();
  c.mechanism.contacts_per_roller = 1;
  const LoadDistribution with = solve(c, 4e3);
  c.structure.screw.free_length = 0.0;
  const LoadDistribution without = solve(c, 4e3);
  for (const Interface i : kInterfaces) EXPECT_NEAR(rates(c, without, i, 4e3)[0], 1.0, 1e-12);
  const double area = std::numbers::pi / 4 * (21e-3 * 21e-3 - 6e-3 * 6e-3);
  EXPECT_NEAR((with.axial_displacement - without.axial_displacement) / (4e3 * 10e-3 / (209e9 * area)), 1.0, 1e-10);
}

TEST(LoadDistribution, StiffRingsActAsBothEndNodesHeld) {
  SectorCase c = abevi();
  const LoadDistribution held = solve(c, 45e3);
  c.structure.roller.guidance = {Guidance::Kind::ring, 1e15};
  const LoadDistribution ring = solve(c, 45e3);
  EXPECT_LT(largest_difference(held.normal_load.nut, ring.normal_load.nut), 1e-4);
}

TEST(LoadDistribution, TangentStiffnessIsSlopeOfLoadOverDisplacement) {
  for (const SectorCase& c : paper_cases()) {
    const double h = 45.0;
    const double slope = 2.0 * h / (solve(c, 45e3 + h).axial_displacement - solve(c, 45e3 - h).axial_displacement);
    EXPECT_NEAR(*solve(c, 45e3).tangent_stiffness / slope, 1.0, 1e-6);
  }
}

TEST(LoadDistribution, TailOfNewtonIsQuadratic) {
  for (const SectorCase& c : paper_cases()) {
    SectorSolver solver(c.build());
    fe::NewtonOptions options = solver.newton_options(45e3);
    options.reuse_factorization_below = 0.0;
    fe::NewtonSolver newton(solver.equations());
    fe::State q = solver.equal_shares(45e3);
    const fe::NewtonSummary s = newton.solve(45e3 / 11 * solver.unit_load(), options, q);
    ASSERT_GE(s.history.size(), 3u);
    const double first = s.history[0].relative_residual, second = s.history[1].relative_residual,
                 third = s.history[2].relative_residual;
    EXPECT_LT(second, first * first);
    EXPECT_LT(third, 10.0 * second * second + 1e-13);
  }
}

TEST(LoadDistribution, NutNodesThatCoincideAreOne) {
  SectorCase c = abevi();
  c.position = 10e-3;  // the first contact stands on flange face and thrust section
  const Sector s = c.build();
  int fixed = -1;
  for (const fe::FixedSupport& f : s.model.fixed_supports)
    if (f.dof == fe::Dof::u) fixed = f.node;
  EXPECT_EQ(s.nut_nodes.front(), fixed);
  // Ends, four flange faces less the two at the ends and the shared one, twenty contacts.
  EXPECT_EQ(s.nut_nodes.back() - s.nut_nodes.front(), 19);
  solve(c, 45e3);
}

TEST(LoadDistribution, PitchErrorOpensThreadsAtLowLoad) {
  SectorCase c = abevi();
  c.mechanism.pitch.roller = axial_pitch(c.mechanism) + 1e-6;
  const LoadDistribution low = solve(c, 100.0), high = solve(c, 45e3);
  const auto open = [](const LoadDistribution& r) {
    return std::count(r.normal_load.screw.begin(), r.normal_load.screw.end(), 0.0);
  };
  EXPECT_GT(open(low), 5);
  EXPECT_LT(open(high), open(low));
  EXPECT_NEAR(sum(rates(c, low, Interface::screw, 100.0)), 1.0, 1e-10);
}

TEST(LoadDistribution, ResidualThatDoublesKeepHighFallsInWiderNumbers) {
  SectorCase c = abevi();
  c.structure.nut.outer_diameter = 35e-3 * (1.0 + 1e-15);  // a wall of a few atoms' rounding
  c.structure.nut.flanges.clear();
  SectorSolver solver(c.build());
  const LoadDistribution r = solver.solve(45e3);
  ASSERT_TRUE(r.solve.converged()) << fe::name(r.solve.status);
  EXPECT_LE(r.solve.relative_residual, 1e-12);
  for (const Interface i : kInterfaces) EXPECT_NEAR(sum(rates(c, r, i, 45e3)), 1.0, 1e-10);
}

/// Pitch error keeps other threads open, so that one carries all.
TEST(LoadDistribution, OneThreadCarriesAllBehindLargePitchError) {
  SectorCase c = abevi();
  c.mechanism.pitch.screw = axial_pitch(c.mechanism) + 1e-4;
  c.direction = Direction::tension;
  const std::vector<double> r = rates(c, solve(c, 500.0), Interface::screw, 500.0);
  EXPECT_EQ(std::count(r.begin(), r.end(), 0.0), 19);
  EXPECT_NEAR(*std::max_element(r.begin(), r.end()), 1.0, 1e-11);
}

}  // namespace
}  // namespace prs
