#include "prs/sector/influence/influence_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "prs/model/problems.h"
#include "support/coarse_bodies.h"
#include "support/sanitized.h"
#include "support/sectors.h"

namespace prs {
namespace {

using test::abevi;
using test::SectorCase;
using test::short_screw;

BodyFlexibilities bodies(const SectorCase& c, MatrixCache& cache) {
  PerInterface<HertzPatch> patches;
  for (const Interface i : kInterfaces)
    patches[i] = nominal_patch({}, c.laws[i], c.materials[body_of(i)], c.materials.roller);
  return body_flexibilities(
      body_geometry(c.mechanism, c.structure, c.materials, c.laws, patches, c.direction, c.options), c.direction,
      c.position, test::coarse_bodies(), cache);
}

BodyFlexibilities bodies(const SectorCase& c) {
  static MatrixCache cache;
  return bodies(c, cache);
}

PerInterface<std::vector<double>> gaps(const SectorCase& c) { return c.build().gaps; }

InfluenceSolver solver(const SectorCase& c) { return {bodies(c), c.mechanism.rollers, c.laws, gaps(c)}; }

TEST(NominalPatch, HasItsPressure) {
  const Material steel = abevi().materials.screw;
  const double e_star = steel.youngs_modulus / (2.0 * (1.0 - 0.09));
  const double radius = 4e-3;
  const ContactLaw law{4.0 / 3.0 * e_star * std::sqrt(radius), 0.8};
  const HertzPatch patch = nominal_patch({}, law, steel, steel);
  // Hertz: a = pi p_0 R/(2 E*).
  EXPECT_NEAR(patch.along_profile, std::numbers::pi * 0.02 * radius / 2.0, 1e-18);
  EXPECT_EQ(patch.along_profile, patch.along_circumference);
}

TEST(InfluenceSolver, LoadsBalanceAtEveryLoad) {
  SKIP_UNDER_SANITIZERS();
  for (const Direction direction : {Direction::tension, Direction::compression}) {
    SectorCase c = short_screw();
    c.direction = direction;
    const InfluenceSolver s = solver(c);
    for (const double force : {10.0, 1e3, 20e3}) {
      const LoadDistribution d = s.solve(force);
      ASSERT_TRUE(d.solve.converged());
      ASSERT_GE(d.solve.iterations(), 1);
      EXPECT_LE(d.solve.history.back().relative_residual, 1e-12);
      EXPECT_TRUE(std::isnan(d.solve.history.back().energy));
      for (const Interface i : kInterfaces) {
        const double sum =
            std::accumulate(d.normal_load[i].begin(), d.normal_load[i].end(), 0.0) * std::cos(c.laws[i].normal_angle);
        EXPECT_NEAR(sum / (force / 11.0), 1.0, 1e-11);
        for (std::size_t k = 0; k < 6; ++k)
          EXPECT_NEAR(c.laws[i].hertz_constant * std::pow(d.approach[i][k], 1.5), d.normal_load[i][k], 1e-9 * force);
      }
    }
  }
}

TEST(InfluenceSolver, IsSofterThanBars) {
  SKIP_UNDER_SANITIZERS();
  const SectorCase c = short_screw();
  const double bars = SectorSolver(c.build()).solve(12e3).axial_displacement;
  const double displacement = solver(c).solve(12e3).axial_displacement;
  EXPECT_GT(displacement, 1.05 * bars);
  EXPECT_LT(displacement, 1.6 * bars);
}

TEST(InfluenceSolver, TangentIsTheSlopeOfTheDisplacement) {
  SKIP_UNDER_SANITIZERS();
  const InfluenceSolver s = solver(short_screw());
  const double force = 12e3, step = 1.0;
  const double slope =
      2.0 * step / (s.solve(force + step).axial_displacement - s.solve(force - step).axial_displacement);
  EXPECT_NEAR(*s.solve(force).tangent_stiffness / slope, 1.0, 1e-7);
}

TEST(InfluenceSolver, MirroredScrewGivesMirroredLoads) {
  SKIP_UNDER_SANITIZERS();
  SectorCase c = short_screw();
  const double psi = c.laws.screw.normal_angle;
  c.laws.nut.normal_angle = psi;
  c.mechanism.contacts_per_roller = 6;
  // The screw's bars and bodies are not symmetric; nut and roller are: the screw is removed.
  const auto without_screw = [&](Direction d) {
    c.direction = d;
    BodyFlexibilities b = bodies(c);
    b.screw.matrix.setZero();
    return InfluenceSolver(b, 11, c.laws, gaps(c)).solve(12e3);
  };
  const LoadDistribution t = without_screw(Direction::tension);
  const LoadDistribution p = without_screw(Direction::compression);
  for (const Interface i : kInterfaces)
    for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(t.normal_load[i][k], p.normal_load[i][5 - k], 1e-8 * 12e3);
  EXPECT_NEAR(t.axial_displacement / p.axial_displacement, 1.0, 1e-9);
}

TEST(InfluenceSolver, OneThreadLeftIsAChainOfCompliances) {
  SKIP_UNDER_SANITIZERS();
  SectorCase c = short_screw();
  const BodyFlexibilities b = bodies(c);
  const int k = 3;
  PerInterface<std::vector<double>> open;
  for (const Interface i : kInterfaces) {
    open[i].assign(6, 1e-3);
    open[i][k] = 0.0;
  }
  c.laws.screw.compliance = 3e-10;
  const double force = 2e3;
  const LoadDistribution d = InfluenceSolver(b, 11, c.laws, open).solve(force);
  ASSERT_TRUE(d.solve.converged());
  // w = cos(psi) times the motion across each interface; the shoulder is that of equal loads here.
  const Eigen::MatrixXd joined = b.joined();
  PerInterface<double> load, approach;
  for (const Interface i : kInterfaces) {
    load[i] = force / 11.0 / std::cos(c.laws[i].normal_angle);
    approach[i] = std::pow(load[i] / c.laws[i].hertz_constant, 2.0 / 3.0);
    EXPECT_NEAR(d.normal_load[i][k] / load[i], 1.0, 1e-10);
  }
  Eigen::VectorXd n = Eigen::VectorXd::Zero(12);
  n[k] = load.screw;
  n[6 + k] = load.nut;
  const Eigen::VectorXd elastic = joined * n;
  const double expected = (approach.screw + 3e-10 * load.screw + elastic[k]) / std::cos(c.laws.screw.normal_angle) +
                          (approach.nut + elastic[6 + k]) / std::cos(c.laws.nut.normal_angle);
  EXPECT_NEAR(d.axial_displacement / expected, 1.0, 2e-3);
  // Held in both senses only the chain is left.
  BodyFlexibilities held = b;
  held.nut.face.reset();
  EXPECT_NEAR(InfluenceSolver(held, 11, c.laws, open).solve(force).axial_displacement / expected, 1.0, 1e-11);
}

TEST(InfluenceSolver, ShoulderFurtherOutIsSofter) {
  SKIP_UNDER_SANITIZERS();
  SectorCase c = short_screw();
  double before = 0.0;
  for (const double inner : {46e-3, 50e-3, 56e-3}) {
    c.structure.nut.shoulder = {inner, 62e-3};
    const double now = solver(c).solve(12e3).axial_displacement;
    EXPECT_GT(now, before);
    before = now;
  }
  c.structure.nut.shoulder = {46e-3, 62e-3};
  const double stated = solver(c).solve(12e3).axial_displacement;
  c.structure.nut.shoulder.reset();
  EXPECT_NEAR(solver(c).solve(12e3).axial_displacement / stated, 1.0, 1e-12);
}

TEST(InfluenceSolver, BodiesAreWorkedOutOnce) {
  MatrixCache cache;
  SectorCase c = short_screw();
  bodies(c, cache);
  const int once = cache.computed();
  EXPECT_EQ(once, 7);  // screw, nut, roller twice, and three sets of teeth
  bodies(c, cache);
  EXPECT_EQ(cache.computed(), once);
  for (const Part p : kParts) c.materials[p].density = 7800.0;  // neither weight nor inertia matters
  bodies(c, cache);
  EXPECT_EQ(cache.computed(), once);
  c.structure.roller.guidance.kind = Guidance::Kind::outer_node;
  bodies(c, cache);
  EXPECT_EQ(cache.computed(), once + 1);  // the bent roller
  c.position += 1e-3;
  bodies(c, cache);
  EXPECT_EQ(cache.computed(), once + 2);  // the nut
  c.structure.nut.outer_diameter += 1e-3;
  bodies(c, cache);
  EXPECT_EQ(cache.computed(), once + 4);  // the nut and its teeth
  c.materials.roller.youngs_modulus *= 0.5;
  bodies(c, cache);
  EXPECT_EQ(cache.computed(), once + 11);  // all, since the contact ellipses change
}

TEST(InfluenceSolver, BodiesThatCannotBeMeshedAreAnInputError) {
  SectorCase s = short_screw();
  Conditions c;
  c.structure = s.structure;
  c.materials = s.materials;
  c.structure->nut.outer_diameter = 35.8e-3;
  c.structure->nut.flanges.clear();
  Contacts contacts;
  contacts.mechanism = s.mechanism;
  MatrixCache cache;
  EXPECT_THROW(influence_solver(c, contacts, s.laws, s.direction, s.position, cache), CaseError);
}

}  // namespace
}  // namespace prs
