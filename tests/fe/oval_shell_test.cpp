#include "fe/shell.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <complex>
#include <numbers>

namespace fe {
namespace {

using std::numbers::pi;

/// A thin ring pulled apart by two opposite forces P grows by (pi/4 - 2/pi) P R^3/(E I) along them
/// (Timoshenko, Strength of Materials, part 2, 1956, article 15).
TEST(OvalShell, ARingUnderOppositeForcesGrowsAsTimoshenkoSays) {
  const double modulus = 209e9, radius = 20e-3, h = 1e-3, length = 2e-3, force = 100.0;
  double growth = 0.0;
  for (int n = 2; n <= 200; n += 2) {
    const OvalRigidity wall = oval_tube(n, radius - 0.5 * h, radius - 0.5 * h, radius + 0.5 * h, modulus, 0.0);
    growth += 2.0 * 2.0 * force / (wall.hoop * length);
  }
  const double bending = modulus * h * h * h * length / 12.0;
  const double exact = (pi / 4.0 - 2.0 / pi) * force * radius * radius * radius / bending;
  EXPECT_NEAR(growth, exact, 1e-6 * exact);
}

/// Stiffness over (w, w') of both ends.
Eigen::Matrix4d nodal_of(const ShellMatrix& k) {
  Eigen::Matrix4d t;
  t << -Eigen::Matrix2d::Identity(), Eigen::Matrix2d::Identity(), 0.5 * Eigen::Matrix2d::Identity(),
      0.5 * Eigen::Matrix2d::Identity();
  return t.transpose() * k.bottomRightCorner<4, 4>() * t;
}

/// Stiffness of the near end over (w, w') of a tube without an end.
Eigen::Matrix2d end_stiffness(const OvalRigidity& wall) {
  // B w'''' - (T + 2 C) w'' + H w = 0, w = sum a_i exp(-r_i x), and the work on the end.
  const double sum = 0.5 * (wall.twist + 2.0 * wall.coupling) / wall.bending;
  const std::complex<double> root = std::sqrt(std::complex<double>(sum * sum - wall.hoop / wall.bending));
  const std::complex<double> r[2] = {std::sqrt(sum + root), std::sqrt(sum - root)};
  Eigen::Matrix2cd shape, force;
  for (int i = 0; i < 2; ++i) {
    shape.col(i) << 1.0, -r[i];
    force.col(i) << -wall.bending * r[i] * r[i] * r[i] + (wall.twist + wall.coupling) * r[i],
        -wall.bending * r[i] * r[i] + wall.coupling;
  }
  return (force * shape.inverse()).real();
}

TEST(OvalShell, ALongTubeDiesOutAsTheEquationSays) {
  for (const int n : {2, 3, 4, 5}) {
    const OvalRigidity wall = oval_tube(n, 17.5e-3, 17.8e-3, 23e-3, 209e9, 0.3);
    const double reach = std::pow(wall.bending / wall.hoop, 0.25);
    const ShellMatrix k = stiffness_matrix(wall, 20.0 * reach);
    const Eigen::Matrix4d nodal = nodal_of(k);
    const Eigen::Matrix2d near = nodal.topLeftCorner<2, 2>(), exact = end_stiffness(wall);
    EXPECT_LT((near - exact).norm(), 1e-6 * exact.norm()) << n;
    EXPECT_LT((nodal.topRightCorner<2, 2>().norm()), 1e-4 * near.norm());
  }
}

/// (R^6 12 (1 - nu^2)/(n^4 h^2 (n^2 - 1)^2))^(1/4) of a thin wall.
TEST(OvalShell, TheReachOfAThinWallIsVlasovs) {
  const double radius = 20e-3, h = 1e-5, nu = 0.3;
  for (const double n : {2.0, 3.0}) {
    const OvalRigidity wall =
        oval_tube(static_cast<int>(n), radius - 0.5 * h, radius - 0.5 * h, radius + 0.5 * h, 209e9, nu);
    const double vlasov =
        std::pow(12.0 * (1.0 - nu * nu) * std::pow(radius, 6) / std::pow(n * n * h * (n * n - 1.0), 2), 0.25);
    EXPECT_NEAR(std::pow(wall.bending / wall.hoop, 0.25), vlasov, 1e-5 * vlasov);
  }
}

TEST(OvalShell, PiecesOfALengthMakeTheLength) {
  const OvalRigidity wall = oval_tube(3, 17.5e-3, 17.8e-3, 23e-3, 209e9, 0.3);
  const auto nodal = [&](double length) { return nodal_of(stiffness_matrix(wall, length)); };
  const Eigen::Matrix4d a = nodal(2e-3), b = nodal(4e-3);
  Eigen::Matrix<double, 6, 6> both = Eigen::Matrix<double, 6, 6>::Zero();
  both.topLeftCorner<4, 4>() += a;
  both.bottomRightCorner<4, 4>() += b;
  const Eigen::Matrix2d middle = both.block<2, 2>(2, 2);
  Eigen::Matrix<double, 2, 4> coupling;
  coupling << both.block<2, 2>(2, 0), both.block<2, 2>(2, 4);
  Eigen::Matrix4d ends;
  ends << both.block<2, 2>(0, 0), both.block<2, 2>(0, 4), both.block<2, 2>(4, 0), both.block<2, 2>(4, 4);
  ends -= coupling.transpose() * middle.inverse() * coupling;
  const Eigen::Matrix4d wanted = nodal(6e-3);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) EXPECT_NEAR(ends(i, j), wanted(i, j), 1e-5 * std::sqrt(wanted(i, i) * wanted(j, j)));
}

}  // namespace
}  // namespace fe
