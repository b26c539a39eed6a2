#include "fe/shell.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

namespace fe {
namespace {

using std::numbers::pi;
using NodalMatrix = Eigen::Matrix<double, 6, 6>;

constexpr int kDegree = 7;
constexpr int kInner = kDegree - 1;        ///< Inner functions of one displacement.
constexpr int kOuter = 5;                  ///< Outer freedoms, the rows of ShellMatrix.
constexpr int kAll = kOuter + 3 * kInner;  ///< Inner ones of u, then v, then theta.

/// Strains (u', -theta', v, v' - theta) as rows, freedoms as columns.
using ShellStrains = Eigen::Matrix<double, 4, kAll>;

Eigen::Matrix4d strain_rigidity(const ShellRigidity& s) {
  Eigen::Matrix4d d;
  // clang-format off
  d << s.axial,      s.eccentric,    s.axial_hoop,   0.0,
       s.eccentric,  s.bending,      s.bending_hoop, 0.0,
       s.axial_hoop, s.bending_hoop, s.hoop,         0.0,
       0.0,          0.0,            0.0,            s.shear;
  // clang-format on
  return d;
}

/// Coefficient of the Legendre polynomial P_i(xi), -1 <= xi <= 1 along the length, in the strains.
/// A displacement is mean P_0 + difference/2 P_1 + sum_k a_k (P_k - P_(k-2))/sqrt(2 (2 k - 1)),
/// k = 2 .. kDegree, the derivatives of which are sqrt((2 k - 1)/2) P_(k-1).
ShellStrains legendre_strains(int i, double length) {
  const double rate = 2.0 / length;
  ShellStrains b = ShellStrains::Zero();
  const auto value = [&](int strain, int column, double factor) { b(strain, column) += factor; };
  if (i == 0) {
    value(0, 0, 0.5 * rate);
    value(1, 2, -0.5 * rate);
    value(2, 3, 1.0);
    value(3, 1, 0.5 * rate);
    value(3, 4, -1.0);
  }
  if (i == 1) {
    value(2, 1, 0.5);
    value(3, 2, -0.5);
  }
  for (int k = 2; k <= kDegree; ++k) {
    const int u = kOuter + k - 2, v = u + kInner, theta = v + kInner;
    if (i == k - 1) {
      const double slope = rate * std::sqrt(0.5 * (2 * k - 1));
      value(0, u, slope);
      value(1, theta, -slope);
      value(3, v, slope);
    }
    if (i == k || i == k - 2) {
      const double factor = (i == k ? 1.0 : -1.0) / std::sqrt(2.0 * (2 * k - 1));
      value(2, v, factor);
      value(3, theta, -factor);
    }
  }
  return b;
}

ShellMatrix piece(const ShellRigidity& shell, double length) {
  const Eigen::Matrix4d d = strain_rigidity(shell);
  Eigen::Matrix<double, kAll, kAll> k = Eigen::Matrix<double, kAll, kAll>::Zero();
  for (int i = 0; i <= kDegree; ++i) {
    const ShellStrains b = legendre_strains(i, length);
    std::array<int, kAll> there;  // freedoms that strain so at all: few
    std::size_t count = 0;
    for (int column = 0; column < kAll; ++column)
      if (!b.col(column).isZero(0.0)) there[count++] = column;
    const double weight = length / (2 * i + 1);
    for (std::size_t m = 0; m < count; ++m) {
      const Eigen::Vector4d stress = weight * d * b.col(there[m]);
      for (std::size_t n = 0; n < count; ++n) k(there[n], there[m]) += b.col(there[n]).dot(stress);
    }
  }
  if (shell.radially_rigid) {
    const int v = kOuter + kInner;
    k.middleRows<kInner>(v).setZero();
    k.middleCols<kInner>(v).setZero();
    k.block<kInner, kInner>(v, v).setIdentity();
  }
  for (int p = kAll - 1; p >= kOuter; --p) {
    const auto coupling = k.col(p).head(p);
    k.topLeftCorner(p, p).noalias() -= (coupling / k(p, p)) * coupling.transpose();
  }
  return k.topLeftCorner<kOuter, kOuter>();
}

/// (u_1, v_1, theta_1, u_2, v_2, theta_2) from the deformation, without axial translation.
Eigen::Matrix<double, 6, kOuter> displacements() {
  Eigen::Matrix<double, 6, kOuter> t = Eigen::Matrix<double, 6, kOuter>::Zero();
  for (int i = 0; i < 3; ++i) {
    t(i, i) = -0.5;
    t(i + 3, i) = 0.5;
  }
  for (int i = 1; i < 3; ++i) t(i, i + 2) = t(i + 3, i + 2) = 1.0;
  return t;
}

/// Two equal lengths in a row, the node between them eliminated.
ShellMatrix doubled(const ShellMatrix& half, bool radially_rigid) {
  const NodalMatrix k = nodal_stiffness(half);
  const auto k11 = k.topLeftCorner<3, 3>(), k12 = k.topRightCorner<3, 3>(),
             k22 = k.bottomRightCorner<3, 3>();
  Eigen::Matrix3d middle = k22 + k11;
  Eigen::Matrix<double, 3, 6> coupling;  // of the middle node to both ends
  coupling << k12.transpose(), k12;
  if (radially_rigid) {
    middle.row(1).setZero();
    middle.col(1).setZero();
    middle(1, 1) = 1.0;
    coupling.row(1).setZero();
  }
  NodalMatrix whole = NodalMatrix::Zero();
  whole.topLeftCorner<3, 3>() = k11;
  whole.bottomRightCorner<3, 3>() = k22;
  whole -= coupling.transpose() * middle.llt().solve(coupling);
  const auto t = displacements();
  return t.transpose() * whole * t;
}

}  // namespace

ShellRigidity scaled(ShellRigidity r, double share) {
  for (double* const rigidity :
       {&r.axial, &r.eccentric, &r.bending, &r.hoop, &r.axial_hoop, &r.bending_hoop, &r.shear})
    *rigidity *= share;
  return r;
}

ShellRigidity tube_rigidity(double inner, double outer, double reference, double modulus,
                            double poisson, double shear_modulus) {
  assert(0.0 < inner && inner < outer);
  const double plane = modulus / (1.0 - poisson * poisson);
  // Moments of the wall about its middle, then about the reference.
  const double h = outer - inner, middle = 0.5 * (inner + outer), z = middle - reference;
  const double area = 2.0 * pi * middle * h;
  const double about_middle = 2.0 * pi * h * h * h / 12.0;  // int z r dr, and int z^2 dr
  ShellRigidity s;
  s.axial = plane * area;
  s.eccentric = plane * (about_middle + area * z);
  s.bending = plane * (middle * about_middle + 2.0 * z * about_middle + area * z * z);
  s.hoop = plane * 2.0 * pi * std::log(outer / inner);
  s.axial_hoop = poisson * plane * 2.0 * pi * h;
  s.bending_hoop = poisson * plane * 2.0 * pi * h * z;
  s.shear = 5.0 / 6.0 * shear_modulus * area;
  return s;
}

ShellMatrix stiffness_matrix(const ShellRigidity& shell, double length) {
  const double bending = shell.bending - shell.eccentric * shell.eccentric / shell.axial;
  const double wave_number = std::sqrt(
      std::max({shell.shear / bending, std::sqrt(shell.hoop / bending), shell.hoop / shell.shear}));
  int halvings = 0;
  for (double l = length; l * wave_number > 1.0 && halvings < 30; l *= 0.5) ++halvings;
  ShellMatrix k = piece(shell, std::ldexp(length, -halvings));
  for (int i = 0; i < halvings; ++i) k = doubled(k, shell.radially_rigid);
  return 0.5 * (k + k.transpose());
}

ShellMatrix about(const ShellMatrix& stiffness, double shift) {
  ShellMatrix t = ShellMatrix::Identity();
  t(0, 2) = shift;  // u at r_0 is u at r_0 + shift and theta times the shift
  return t.transpose() * stiffness * t;
}

}  // namespace fe
