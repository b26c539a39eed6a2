#include "contact/patch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <numbers>
#include <utility>
#include <vector>

#include "simd/dispatch.h"
#include "tests/support/allocations.h"

namespace contact {
namespace {

using std::numbers::pi;

HertzContact ellipse(double a, double b, double load) {
  HertzContact e;
  e.normal_load = load;
  e.semi_major = a;
  e.semi_minor = b;
  e.peak_pressure = 1.5 * load / (pi * a * b);
  return e;
}

const HertzContact kEllipse = ellipse(0.25e-3, 0.15e-3, 200.0);
const Lubricant kPatchGrease{0.1665, 30e-9, 12e6};
const FilmContact kFilmContact{200.0, 350.0, 115.385e9};

TEST(PatchGrid, HoldsTheCellCentresInsideTheEllipse) {
  const PatchGrid one(1);
  ASSERT_EQ(one.inside(), 1);
  EXPECT_EQ(one.along_major()[0], 0.0);
  EXPECT_EQ(one.dome()[0], 1.0);

  const PatchGrid grid(21);
  EXPECT_EQ(grid.inside(), 349);  // lattice points of a circle of radius 10.5
  EXPECT_NEAR(grid.along_major().sum(), 0.0, 1e-12);
  EXPECT_NEAR((grid.along_major() * grid.along_minor()).sum(), 0.0, 1e-12);
  EXPECT_GT(grid.dome().minCoeff(), 0.0);
}

TEST(PatchGrid, DomeTendsToTheWholeLoad) {
  double before = 1.0;
  for (const int n : {21, 63, 189, 567}) {
    const PatchGrid grid(n);
    const double error = std::abs(grid.cell_load() * grid.dome().sum() - 1.0);
    EXPECT_LT(error, 0.6 * std::pow(n, -1.5)) << n;
    EXPECT_LT(error, before);
    before = error;
  }
}

TEST(Patch, UniformCoulombSlidingTransmitsTheCoefficient) {
  const PatchGrid grid(21);
  const Patch patch(grid, kEllipse, friction_law(Coulomb{0.11}));
  const double whole = grid.cell_load() * grid.dome().sum();
  const PatchFriction f = patch.friction({0.03, -0.04, 0.0, 1.0});
  EXPECT_NEAR(f.traction_major, 0.6 * 0.11 * whole, 1e-15);
  EXPECT_NEAR(f.traction_minor, -0.8 * 0.11 * whole, 1e-15);
  EXPECT_NEAR(f.spin_arm, 0.0, 1e-18);
  EXPECT_NEAR(f.power_per_load, 0.11 * 0.05 * whole, 1e-16);
  EXPECT_NEAR(f.mean_friction / 0.11, 1.0, 1e-14);  // A sum over the points, in the order of the batches.
  EXPECT_DOUBLE_EQ(f.max_sliding_speed, 0.05);
}

TEST(Patch, CoulombSpinOfACircleHasTheClosedForm) {
  // C/N = mu (3/(2 pi a^2)) int r sqrt(1 - (r/a)^2) dA = (3 pi/16) mu a.
  const double a = 0.2e-3;
  double before = 1.0;
  for (const int n : {21, 84, 336}) {
    const PatchGrid grid(n);
    const PatchFriction f =
        Patch(grid, ellipse(a, a, 200.0), friction_law(Coulomb{0.1})).friction({0.0, 0.0, 25.0, 1.0});
    const double error = std::abs(f.spin_arm / (3.0 * pi / 16.0 * 0.1 * a) - 1.0);
    EXPECT_LT(error, 2.0 * std::pow(n, -1.5)) << n;
    EXPECT_LT(error, before);
    before = error;
    EXPECT_NEAR(f.power_per_load, 25.0 * f.spin_arm, 1e-15);  // all power is spin
    EXPECT_NEAR(f.traction_major, 0.0, 1e-15);
  }
}

TEST(Patch, TheCentreOfPureSpinHasNoDirection) {
  // Rounding noise in the centre's velocity must not cause a traction.
  const PatchGrid grid(21);
  for (const bool coulomb : {false, true}) {
    const Patch patch = coulomb ? Patch(grid, kEllipse, friction_law(Coulomb{0.1}))
                                : Patch(grid, kEllipse, friction_law(Jacod<double>{}, kPatchGrease, kFilmContact));
    const PatchFriction f = patch.friction({3e-15, -2e-15, 40.0, 0.8});
    EXPECT_LT(std::hypot(f.traction_major, f.traction_minor), 1e-13) << coulomb;
    EXPECT_GT(f.spin_arm, 0.0);
  }
}

/// Batches of points give what the law gives point by point.
TEST(Patch, SumsWhatItsFieldsShow) {
  const PatchGrid grid(21);
  for (const FrictionLaw& law : {friction_law(Jacod<double>{}, kPatchGrease, kFilmContact), friction_law(Coulomb{0.1}),
                                 friction_law(Mixed{0.12, 1.5}, kPatchGrease, kFilmContact, 0.4e-6)}) {
    SCOPED_TRACE(facts_of(law.kind).name);
    const Patch patch(grid, kEllipse, law);
    const PatchMotion motion{0.05, 0.07, 40.0, 0.5};
    const Eigen::ArrayXd v_1 = patch.sliding_major(motion), v_2 = patch.sliding_minor(motion);
    const Eigen::ArrayXd speed = (v_1.square() + v_2.square()).sqrt();
    const Eigen::ArrayXd mu = patch.friction_coefficient(motion);
    const Eigen::ArrayXd load = grid.cell_load() * grid.dome();  // load of each point, over N
    const PatchFriction f = patch.friction(motion);
    const auto expect = [](double value, double expected) { EXPECT_NEAR(value / expected, 1.0, 1e-13); };
    expect(f.traction_major, (mu * load * v_1 / speed).sum());
    expect(f.traction_minor, (mu * load * v_2 / speed).sum());
    expect(f.spin_arm,
           (mu * load *
            (v_2 * kEllipse.semi_major * grid.along_major() - v_1 * kEllipse.semi_minor * grid.along_minor()) / speed)
               .sum());
    expect(f.power_per_load, (mu * load * speed).sum());
    expect(f.mean_friction, mu.mean());
    expect(f.max_sliding_speed, speed.maxCoeff());
  }
}

TEST(Patch, PowerIsThatOfItsWrench) {
  const PatchGrid grid(21);
  const PatchMotion motion{0.05, -0.02, 60.0, 0.5};
  for (const Patch& patch : {Patch(grid, kEllipse, friction_law(Coulomb{0.1})),
                             Patch(grid, kEllipse, friction_law(Jacod<double>{}, kPatchGrease, kFilmContact))}) {
    const PatchFriction f = patch.friction(motion);
    EXPECT_NEAR(
        (f.traction_major * motion.sliding_major + f.traction_minor * motion.sliding_minor + f.spin_arm * motion.spin) /
            f.power_per_load,
        1.0, 1e-13);
  }
}

TEST(Patch, SlowSlidingIsNewtonian) {
  // asinh(x) = x for small x: friction in proportion to the sliding speed, at equal rolling.
  const PatchGrid grid(11);
  const Lubricant thin{1e-3, 5e-9, 12e6};
  const Patch patch(grid, ellipse(0.25e-3, 0.15e-3, 1.0), friction_law(Jacod<double>{}, thin, kFilmContact));
  const double slow = patch.friction({1e-9, 0.0, 0.0, 0.5}).traction_major;
  EXPECT_GT(slow, 0.0);
  EXPECT_NEAR(patch.friction({2e-9, 0.0, 0.0, 0.5}).traction_major / slow, 2.0, 1e-12);
}

TEST(Patch, EveryInstructionSetGivesTheSameSums) {
  const PatchGrid grid(21);
  std::vector<double> pressure(grid.points().size, 0.0);
  for (Eigen::Index i = 0; i < grid.inside(); ++i) pressure[static_cast<std::size_t>(i)] = 2.4e9 * grid.dome()[i];
  std::vector<double> ratio(pressure.size());
  ViscosityKernel{}(simd::Baseline{}, 0.1665, pressure.data(), pressure.size(), ratio.data());
  for (std::size_t i = 0; i < ratio.size(); ++i)
    EXPECT_NEAR(ratio[i] / roelands_viscosity_ratio(0.1665, pressure[i]), 1.0, 1e-13);

  const SlidingField sliding{0.05, 0.07, 0.01, 0.006};
  const RollingContactOf<double> contact{2.4e9, 330.0, 1.3, 12e6 / 2.4e9, 0.01};
  for (const FrictionLaw& law :
       {friction_law(Coulomb{0.1}), friction_law(Jacod<double>{}), friction_law(Mixed{0.12, 2.0})}) {
    SCOPED_TRACE(facts_of(law.kind).name);
    const PatchSums best =
        simd::run_kernel(simd::InstructionSet::best, PatchKernel{}, grid.points(), sliding, law, contact, ratio.data());
    const PatchSums plain = PatchKernel{}(simd::Baseline{}, grid.points(), sliding, law, contact, ratio.data());
    EXPECT_NEAR(best.traction_major / plain.traction_major, 1.0, 1e-14);
    EXPECT_NEAR(best.traction_minor / plain.traction_minor, 1.0, 1e-14);
    EXPECT_NEAR(best.moment_major / plain.moment_major, 1.0, 1e-13);
    EXPECT_NEAR(best.moment_minor / plain.moment_minor, 1.0, 1e-13);
    EXPECT_NEAR(best.power / plain.power, 1.0, 1e-14);
    EXPECT_NEAR(best.friction / plain.friction, 1.0, 1e-14);
    EXPECT_DOUBLE_EQ(best.max_speed, plain.max_speed);
  }
}

TEST(Patch, FrictionAllocatesNothing) {
  const PatchGrid grid(21);
  const Patch patch(grid, kEllipse, friction_law(Jacod<double>{}, kPatchGrease, kFilmContact));
  const auto before = ::test::allocations();
  (void)patch.friction({0.05, 0.07, 40.0, 0.5});
  EXPECT_EQ(::test::allocations(), before);
}

}  // namespace
}  // namespace contact
