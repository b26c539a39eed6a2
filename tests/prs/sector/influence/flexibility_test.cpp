#include "prs/sector/influence/teeth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "prs/sector/influence/influence_solver.h"
#include "support/coarse_bodies.h"
#include "support/count.h"
#include "support/half_space_spectrum.h"
#include "support/sanitized.h"
#include "support/sectors.h"

namespace prs {
namespace {

using std::numbers::pi;
using test::abevi;
using test::SectorCase;

/// Short screw with flank normals at 45 deg.
SectorCase short_screw_at_45_deg() {
  SectorCase c = test::short_screw();
  for (const Interface i : kInterfaces) c.laws[i].normal_angle = pi / 4.0;
  return c;
}

/// Abevi's screw with the teeth of the reference curves, whose grooves are wider than by default.
SectorCase with_wide_grooves() {
  SectorCase c = abevi();
  for (const Part p : kParts) c.mechanism.thread[p] = ThreadHeight{0.25e-3, 0.30e-3};
  return c;
}

BodyGeometry geometry(const SectorCase& c, double patch_scale = 1.0) {
  const PerInterface<HertzPatch> patches{{0.227e-3 * patch_scale, 0.178e-3 * patch_scale},
                                         {0.198e-3 * patch_scale, 0.242e-3 * patch_scale}};
  return body_geometry(c.mechanism, c.structure, c.materials, c.laws, patches, c.direction);
}

Eigen::MatrixXd reversed(const Eigen::MatrixXd& m) { return m.reverse(); }

TEST(BlockSolver, ShortWavesSeeAHalfSpace) {
  const BodyGeometry b = geometry(with_wide_grooves());
  FlexibilityOptions options;
  options.mesh.patch_cells = 8;
  options.mesh.growth = 1.3;
  for (const Part part : kParts) {
    const Groove& g = b.grooves[part];
    const HertzPatch& patch = b.patches[part == Part::nut ? Interface::nut : Interface::screw];
    const double far = part == Part::screw ? 3e-3 : part == Part::nut ? 23e-3 : 0.0;
    BlockSolver block({g,
                       far,
                       b.materials[part],
                       {{0.0, FlankSide::backward, patch, options.mesh.patch_cells}},
                       {},
                       0,
                       1,
                       1,
                       options});
    const auto ratio = [&](double wave) {
      const int n = static_cast<int>(wave * g.pitch_radius / patch.along_circumference);
      const double r = g.pitch_radius;
      return block.solve(n, 1).kernel[1](0, 0) / (2.0 / r * test::half_space_spectrum(patch, b.materials[part], n / r));
    };
    EXPECT_NEAR(ratio(1.0), 1.0, 0.007) << name(part);
    EXPECT_NEAR(ratio(2.0), 1.0, 0.006) << name(part);
  }
}

TEST(BlockSolver, HarmonicsDieOutWithinTheirReach) {
  SKIP_UNDER_SANITIZERS();
  const BodyGeometry b = geometry(with_wide_grooves());
  const FlexibilityOptions options;
  const LoadedFlank flank{0.0, FlankSide::backward, b.patches.nut, options.mesh.patch_cells};
  BlockSolver block({b.grooves.nut, 23e-3, b.materials.nut, {flank}, {}, 0, 1, 101, options});
  for (const int n : {11, 22, 44}) {
    const BlockResponse r = block.solve(n, block.reach(n));
    const double own = r.kernel[static_cast<std::size_t>(r.reach)](0, 0);
    EXPECT_LT(std::abs(r.kernel.front()(0, 0)), 3e-3 * own) << n;
    const auto centre = static_cast<std::size_t>(r.reach);
    EXPECT_NEAR(r.kernel[centre - 1](0, 0) / r.kernel[centre + 1](0, 0), 1.0, 5e-3) << n;
  }
}

TEST(Flexibility, FarThreadsOfTheScrewSeeABarBetweenCoreAndPitchSection) {
  const SectorCase c = abevi();
  const BodyGeometry b = geometry(c);
  const Flexibility f = screw_flexibility(b, c.direction, test::coarse_bodies());
  // Between the loaded section and the load, and far from both, displacements grow by the extension
  // of one pitch.
  const double per_pitch = f.matrix(4, 15) - f.matrix(3, 15);
  const auto of_bar = [&](double radius) {
    const double area = pi * (radius * radius - 9e-6);
    return b.rollers * 0.5 * b.pitch() / (c.materials.screw.youngs_modulus * area);
  };
  const double cosine = std::cos(c.laws.screw.normal_angle);
  EXPECT_GT(per_pitch, of_bar(b.grooves.screw.pitch_radius) * 2.0 * cosine * cosine);
  EXPECT_LT(per_pitch, of_bar(b.grooves.screw.radius(-b.grooves.screw.dedendum)) * 1.001);
}

TEST(Flexibility, IsSymmetricAndHasNoHertzLeft) {
  SKIP_UNDER_SANITIZERS();
  const SectorCase c = short_screw_at_45_deg();
  const BodyFlexibilities f = body_flexibilities(geometry(c), c.direction, c.position, {});
  for (const Flexibility* body : {&f.screw, &f.nut, &f.roller}) {
    EXPECT_LT((body->matrix - body->matrix.transpose()).norm(), 1e-15 * body->matrix.norm());
    // Without its half-space part a thread is no softer than its neighbours make it.
    EXPECT_LT(std::abs(body->matrix(2, 2) - body->matrix(2, 3)), 0.1 * body->half_space);
  }
}

TEST(Flexibility, MirroredScrewHasMirroredBodies) {
  SKIP_UNDER_SANITIZERS();
  SectorCase c = short_screw_at_45_deg();
  const BodyGeometry tension = geometry(c);
  const Flexibility nut = nut_flexibility(tension, c.direction, c.position, test::coarse_bodies());
  const Flexibility roller = roller_flexibility(tension, c.direction, test::coarse_bodies());
  c.direction = Direction::compression;
  const BodyGeometry compression = geometry(c);
  const Flexibility other_nut = nut_flexibility(compression, c.direction, c.position, test::coarse_bodies());
  const Flexibility other_roller = roller_flexibility(compression, c.direction, test::coarse_bodies());
  EXPECT_LT((reversed(nut.matrix) - other_nut.matrix).norm(), 1e-9 * nut.matrix.norm());
  // The roller is held axially at its right end in both: compare under loads in balance.
  const int n = 6;
  Eigen::MatrixXd balanced = Eigen::MatrixXd::Zero(2 * n, n);
  for (int k = 0; k < n; ++k) balanced(k, k) = balanced(n + (k + 2) % n, k) = 1.0;
  Eigen::MatrixXd mirrored = balanced;
  mirrored.topRows(n) = balanced.topRows(n).colwise().reverse().eval();
  mirrored.bottomRows(n) = balanced.bottomRows(n).colwise().reverse().eval();
  const Eigen::MatrixXd first = balanced.transpose() * roller.matrix * balanced;
  const Eigen::MatrixXd second = mirrored.transpose() * other_roller.matrix * mirrored;
  EXPECT_LT((first - second).norm(), 1e-9 * first.norm());
}

TEST(Flexibility, SizeOfThePatchDropsOut) {
  SKIP_UNDER_SANITIZERS();
  SectorCase c = short_screw_at_45_deg();
  c.mechanism.contacts_per_roller = 4;
  FlexibilityOptions options;
  options.mesh.patch_cells = 8;
  options.mesh.growth = 1.3;
  const Flexibility full = screw_flexibility(geometry(c), c.direction, options);
  const Flexibility small = screw_flexibility(geometry(c, 0.6), c.direction, options);
  EXPECT_GT(small.half_space, 1.6 * full.half_space);
  EXPECT_LT(std::abs(small.matrix(1, 1) - full.matrix(1, 1)), 2e-3 * full.half_space);
  EXPECT_LT(std::abs(small.matrix(1, 2) - full.matrix(1, 2)), 2e-3 * full.half_space);
}

/// Comparison with a mesh three times as fine, computed here: 0.5 % in stiffness, 0.1 % of the sector load.
TEST(Flexibility, DefaultsHaveWorkingAccuracy) {
  if (test::count(0, 1) == 0) GTEST_SKIP() << "only in the thorough run";
  const SectorCase c = abevi();  // CONFIG 2, tension
  const Sector sector = c.build();
  const double force = 45e3 / 11;
  const auto solved_with = [&](const FlexibilityOptions& options) {
    const BodyFlexibilities f = body_flexibilities(geometry(c), c.direction, c.position, options);
    return solve(contact_problem(f.joined(), c.laws, sector.gaps), force);
  };
  FlexibilityOptions fine;
  fine.mesh.patch_cells = 12;
  fine.mesh.growth = 1.25;
  fine.mesh.step_cell = 0.02;
  const ContactSolution working = solved_with({}), finest = solved_with(fine);
  ASSERT_TRUE(working.converged() && finest.converged());
  EXPECT_NEAR(working.screw_motion / finest.screw_motion, 1.0, 0.005);
  for (int k = 0; k < 40; ++k) {
    const double cosine = std::cos((k < 20 ? c.laws.screw : c.laws.nut).normal_angle);
    EXPECT_NEAR(working.normal_load[k] * cosine / force, finest.normal_load[k] * cosine / force, 0.001) << k;
  }
}

TEST(Flexibility, GuidanceRingOfGreatStiffnessHoldsLikeASupport) {
  SectorCase c = short_screw_at_45_deg();
  const Flexibility held = roller_flexibility(geometry(c), c.direction, test::coarse_bodies());
  c.structure.roller.guidance = {Guidance::Kind::ring, 1e13};
  const Flexibility ring = roller_flexibility(geometry(c), c.direction, test::coarse_bodies());
  c.structure.roller.guidance = {Guidance::Kind::outer_node, 0.0};
  const Flexibility outer = roller_flexibility(geometry(c), c.direction, test::coarse_bodies());
  // Sections stay round under a support, but not on a ring, which holds their mean.
  EXPECT_LT((ring.matrix - held.matrix).norm(), 0.05 * held.matrix.norm());
  EXPECT_GT((outer.matrix - held.matrix).norm(), 0.1 * held.matrix.norm());
}

TEST(Flexibility, ContactsAtTheEndsOfTheNutHaveTheirThread) {
  SectorCase c = short_screw_at_45_deg();
  c.structure.screw.free_length = 0.0;
  c.structure.nut.length = 5.0 * axial_pitch(c.mechanism);
  c.structure.nut.flanges.clear();
  c.structure.nut.thrust = {.tension = 4e-3, .compression = 4e-3};
  for (const Direction d : {Direction::tension, Direction::compression}) {
    c.direction = d;
    const BodyFlexibilities f = body_flexibilities(geometry(c), d, 0.0, test::coarse_bodies());
    EXPECT_GT(f.nut.matrix(0, 1), 0.0);
    EXPECT_GT(f.screw.matrix(4, 5), 0.0);
  }
  GroovedShape shape;
  shape.groove = geometry(c).grooves.screw;
  shape.end = 10e-3;
  EXPECT_THROW(mesh_grooved_body(shape, {{0.0, FlankSide::backward, {0.2e-3, 0.2e-3}, 4}}, {}), std::invalid_argument);
}

TEST(Flexibility, UnilateralThrustFaceIsSofter) {
  const SectorCase c = short_screw_at_45_deg();
  FlexibilityOptions bilateral = test::coarse_bodies();
  bilateral.unilateral_thrust = false;
  const double both = nut_flexibility(geometry(c), c.direction, c.position, bilateral).matrix.sum();
  const double pushes = nut_flexibility(geometry(c), c.direction, c.position, test::coarse_bodies()).matrix.sum();
  EXPECT_GT(pushes, both);
  EXPECT_LT(pushes, 1.1 * both);
}

}  // namespace
}  // namespace prs
