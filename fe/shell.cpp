#include "fe/shell.h"

#include <Eigen/Cholesky>
#include <cassert>

namespace fe {
using Eigen::Matrix2d;
using Eigen::Matrix4d;

ShellMatrix to_matrix(const ShellBlocks<double>& k) {
  ShellMatrix m;
  // clang-format off
  m << k.uu, 0.0,  k.ut, k.uv, 0.0,
       0.0,  k.dd, 0.0,  0.0,  k.dm,
       k.ut, 0.0,  k.tt, k.tv, 0.0,
       k.uv, 0.0,  k.tv, k.vv, 0.0,
       0.0,  k.dm, 0.0,  0.0,  k.mm;
  // clang-format on
  return m;
}

ShellBlocks<double> to_blocks(const ShellMatrix& m) {
  return {m(0, 0), m(0, 2), m(0, 3), m(2, 2), m(2, 3), m(3, 3), m(1, 1), m(1, 4), m(4, 4)};
}

namespace {

using std::numbers::pi;

constexpr double kLongestPiece = 0.125;  ///< Longest piece, over (B/H)^(1/4).

/// Hermite's cubics over (w_1, w_1', w_2, w_2'), 4 Gauss points.
Matrix4d hermite_piece(const OvalRigidity& r, double l) {
  static constexpr double kPoint[] = {0.339981043584856265, 0.861136311594052575};
  static constexpr double kWeight[] = {0.652145154862546143, 0.347854845137453857};
  Matrix4d k = Matrix4d::Zero();
  for (int i = 0; i < 4; ++i) {
    const double s = 0.5 * (1.0 + (i % 2 == 0 ? 1.0 : -1.0) * kPoint[i / 2]);
    const double weight = 0.5 * l * kWeight[i / 2];
    const Eigen::RowVector4d w(1.0 + s * s * (2.0 * s - 3.0), l * s * (1.0 - s) * (1.0 - s), s * s * (3.0 - 2.0 * s),
                               l * s * s * (s - 1.0));
    const Eigen::RowVector4d slope(6.0 * s * (s - 1.0) / l, (1.0 - s) * (1.0 - 3.0 * s), 6.0 * s * (1.0 - s) / l,
                                   s * (3.0 * s - 2.0));
    const Eigen::RowVector4d curvature((12.0 * s - 6.0) / (l * l), (6.0 * s - 4.0) / l, (6.0 - 12.0 * s) / (l * l),
                                       (6.0 * s - 2.0) / l);
    k += weight * (r.bending * curvature.transpose() * curvature + r.twist * slope.transpose() * slope +
                   r.hoop * w.transpose() * w - r.coupling * (w.transpose() * curvature + curvature.transpose() * w));
  }
  return k;
}

/// Stiffness of two equal lengths in a row, with the node between them eliminated.
Matrix4d hermite_doubled(const Matrix4d& k) {
  const Matrix2d k11 = k.topLeftCorner<2, 2>(), k12 = k.topRightCorner<2, 2>(), k22 = k.bottomRightCorner<2, 2>();
  Eigen::Matrix<double, 2, 4> coupling;
  coupling << k12.transpose(), k12;
  Matrix4d whole = Matrix4d::Zero();
  whole.topLeftCorner<2, 2>() = k11;
  whole.bottomRightCorner<2, 2>() = k22;
  return whole - coupling.transpose() * Matrix2d(k22 + k11).llt().solve(coupling);
}

}  // namespace

OvalRigidity oval_tube(int n, double inner, double root, double outer, double modulus, double poisson) {
  assert(n >= 2 && inner < outer && root < outer);
  const double radius = 0.5 * (inner + outer), h = outer - inner, order = n * n;
  const double plate = modulus * h * h * h / (12.0 * (1.0 - poisson * poisson));
  const double bent = plate * (order - 1.0) * (order - 1.0);
  OvalRigidity r;
  r.bending = pi * radius * (modulus * (outer - root) * radius * radius / (order * order) + plate);
  r.coupling = pi * poisson * plate * (order - 1.0) / radius;
  r.twist = 2.0 * pi * (1.0 - poisson) * bent / (order * radius);
  r.hoop = pi * bent / (radius * radius * radius);
  return r;
}

ShellMatrix stiffness_matrix(const OvalRigidity& wall, double length) {
  const double longest = kLongestPiece * std::pow(wall.bending / wall.hoop, 0.25);
  int halvings = 0;
  for (double l = length; l > longest && halvings < 30; l *= 0.5) ++halvings;
  Matrix4d k = hermite_piece(wall, std::ldexp(length, -halvings));
  for (int i = 0; i < halvings; ++i) k = hermite_doubled(k);
  // (w_1, w_1', w_2, w_2') from differences and means.
  Matrix4d t;
  t << -0.5 * Matrix2d::Identity(), Matrix2d::Identity(), 0.5 * Matrix2d::Identity(), Matrix2d::Identity();
  ShellMatrix shell = ShellMatrix::Zero();
  shell.bottomRightCorner<4, 4>() = t.transpose() * (0.5 * (k + k.transpose())) * t;
  return shell;
}

}  // namespace fe
