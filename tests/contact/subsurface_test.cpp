#include "contact/hertz.h"

#include <gtest/gtest.h>

#include <cmath>

namespace contact {
namespace {

TEST(Subsurface, CircularContactIsTheClosedForm) {
  // Johnson 1985, (3.45): sigma_r/p_0 = -(1 + nu)(1 - (z/a) atan(a/z)) + 1/(2 (1 + z^2/a^2)),
  // sigma_z/p_0 = -1/(1 + z^2/a^2).
  const double nu = 0.3;
  for (const double z : {0.01, 0.2, 0.48, 1.0, 3.0}) {
    const AxisStress s = stress_on_axis(1.0, 1.0, z, nu);
    const double radial = -(1 + nu) * (1 - z * std::atan(1 / z)) + 0.5 / (1 + z * z);
    EXPECT_NEAR(s.along_major, radial, 1e-13);
    EXPECT_NEAR(s.along_minor, radial, 1e-13);
    EXPECT_NEAR(s.along_normal, -1 / (1 + z * z), 1e-15);
  }
}

TEST(Subsurface, LineContactIsTheClosedForm) {
  // Johnson 1985, (4.46): along the normal of a line contact.
  const double nu = 0.3, long_axis = 1e7;
  for (const double z : {0.1, 0.5, 0.786, 2.0}) {
    const AxisStress s = stress_on_axis(long_axis, 1.0, z, nu);
    const double root = std::sqrt(1 + z * z);
    const double across = -((1 + 2 * z * z) / root - 2 * z);
    EXPECT_NEAR(s.along_minor, across, 1e-6);
    EXPECT_NEAR(s.along_normal, -1 / root, 1e-12);
    EXPECT_NEAR(s.along_major, nu * (across - 1 / root), 1e-6);  // plane strain
  }
}

TEST(Subsurface, SurfaceStressesAreHertzs) {
  // Johnson 1985, (3.67): sigma_x = -p_0 (2 nu + (1 - 2 nu) b/(a + b)) at the centre.
  const double a = 3.0, b = 1.2, nu = 0.27;
  const AxisStress s = stress_on_axis(a, b, 0.0, nu);
  EXPECT_NEAR(s.along_major, -(2 * nu + (1 - 2 * nu) * b / (a + b)), 1e-15);
  EXPECT_NEAR(s.along_minor, -(2 * nu + (1 - 2 * nu) * a / (a + b)), 1e-15);
  EXPECT_NEAR(s.along_normal, -1.0, 1e-15);
}

TEST(Subsurface, LargestShearIsThatOfTheHandbook) {
  // Johnson 1985, table 4.1 (nu = 0.3): b/a, z/b, tau/p_0; the depths there are read off to 0.006.
  struct Row {
    double k, depth, shear;
  };
  for (const Row& row : {Row{1e-6, 0.785, 0.300}, Row{0.2, 0.745, 0.322}, Row{0.4, 0.665, 0.325},
                         Row{0.6, 0.590, 0.323}, Row{0.8, 0.530, 0.317}, Row{1.0, 0.480, 0.310}}) {
    const SubsurfaceShear s = largest_subsurface_shear(row.k, 0.3);
    EXPECT_NEAR(s.depth_over_semi_minor, row.depth, 7e-3) << row.k;
    EXPECT_NEAR(s.shear_over_pressure, row.shear, 1.1e-3) << row.k;
  }
}

TEST(Subsurface, NoOtherDepthHasALargerShear) {
  for (const double nu : {0.0, 0.2, 0.3, 0.5}) {
    for (const double k : {1e-4, 0.1, 0.5, 0.9, 1.0}) {
      const SubsurfaceShear best = largest_subsurface_shear(k, nu);
      for (double z = 0.0; z < 3.0; z += 0.003) {
        EXPECT_LE(stress_on_axis(1 / k, 1.0, z, nu).largest_shear(), best.shear_over_pressure + 1e-12);
      }
    }
  }
}

TEST(Subsurface, VonMisesIsThatOfTheHandbook) {
  // Johnson 1985, sections 3.4 and 4.2: yield at p_0 = 1.61 Y below a circle, 1.79 Y below a line by von Mises.
  const SubsurfaceVonMises circle = largest_subsurface_von_mises(1.0, 0.3),
                           line = largest_subsurface_von_mises(1e-6, 0.3);
  EXPECT_NEAR(circle.stress_over_pressure, 1 / 1.61, 3e-3);
  EXPECT_NEAR(circle.depth_over_semi_minor, 0.48, 6e-3);
  EXPECT_NEAR(line.stress_over_pressure, 1 / 1.79, 2e-3);
  EXPECT_NEAR(line.depth_over_semi_minor, 0.70, 6e-3);
  // Two equal stresses on a circle's axis: the difference from the third, twice the shear.
  EXPECT_NEAR(circle.stress_over_pressure, 2 * largest_subsurface_shear(1.0, 0.3).shear_over_pressure, 1e-12);
}

TEST(Subsurface, NoOtherDepthHasALargerVonMisesStress) {
  for (const double nu : {0.0, 0.2, 0.3, 0.5})
    for (const double k : {1e-4, 0.1, 0.5, 0.9, 1.0}) {
      const SubsurfaceVonMises best = largest_subsurface_von_mises(k, nu);
      for (double z = 0.0; z < 3.0; z += 0.003)
        EXPECT_LE(stress_on_axis(1 / k, 1.0, z, nu).von_mises(), best.stress_over_pressure + 1e-12);
    }
}

}  // namespace
}  // namespace contact
