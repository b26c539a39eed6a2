#pragma once

#include <Eigen/Core>

#include "fe/shell_formulas.h"

namespace fe {

/// Stiffness of a uniform length over its deformations: (u_2 - u_1, v_2 - v_1, theta_2 - theta_1, (v_1 + v_2)/2,
/// (theta_1 + theta_2)/2), in N/m, N and N m. Axial translation, the only rigid motion, does not appear.
using ShellMatrix = Eigen::Matrix<double, 5, 5>;

ShellMatrix to_matrix(const ShellBlocks<double>& blocks);
/// Blocks of a shell matrix whose halves mirror each other.
ShellBlocks<double> to_blocks(const ShellMatrix& matrix);

/// 6 x 6 stiffness over (u_1, v_1, theta_1, u_2, v_2, theta_2).
template <class Real = double>
Eigen::Matrix<Real, 6, 6> nodal_stiffness(const ShellMatrix& stiffness) {
  Eigen::Matrix<Real, 5, 6> deformation = Eigen::Matrix<Real, 5, 6>::Zero();
  for (int i = 0; i < 3; ++i) {
    deformation(i, i) = Real(-1.0);
    deformation(i, i + 3) = Real(1.0);
  }
  for (int i = 1; i < 3; ++i) deformation(i + 2, i) = deformation(i + 2, i + 3) = Real(0.5);
  return deformation.transpose() * stiffness.cast<Real>() * deformation;
}

/// End forces K q over (u_1, v_1, theta_1, u_2, v_2, theta_2) for the deformation of `ShellMatrix`.
template <class Real>
Eigen::Matrix<Real, 6, 1> end_forces(const ShellMatrix& stiffness, const Eigen::Matrix<Real, 5, 1>& deformation) {
  const Eigen::Matrix<Real, 5, 1> f = stiffness.cast<Real>() * deformation;
  const Real half(0.5);
  return {-f[0], half * f[3] - f[1], half * f[4] - f[2], f[0], half * f[3] + f[1], half * f[4] + f[2]};
}

/// Rigidities of a thin cylinder that becomes out of round as w(x) cos(n phi), n >= 2, without stretching around the
/// axis and without membrane shear. Per length the energy is half of
///
///     B w''^2 - 2 C w w'' + T w'^2 + H w^2.
struct OvalRigidity {
  double bending = 0.0;   ///< B [N m^2]
  double coupling = 0.0;  ///< C, Poisson's effect [N]
  double twist = 0.0;     ///< T [N]
  double hoop = 0.0;      ///< H [N/m^2]
};

/// A tube that stretches along its axis with the wall from `root` to `outer` and bends with that
/// from `inner` to `outer`, R its mean radius. With v_phi = -w and u_phi = -R v' the strain along
/// the axis is -R w''/n^2, the changes of curvature are -w'', (n^2 - 1) w/R^2 and
/// (n^2 - 1) w'/(n R), and
///
///     B = pi R (E h_u R^2/n^4 + D),   C = pi nu D (n^2 - 1)/R,
///     T = 2 pi (1 - nu) D (n^2 - 1)^2/(n^2 R),   H = pi D (n^2 - 1)^2/R^3,
///     D = E h^3/(12 (1 - nu^2)),
///
/// h_u and h the thickness of either wall (Love's shell, e.g. Soedel, Vibrations of Shells and
/// Plates, 2004, chapters 2 and 5). SI units.
OvalRigidity oval_tube(int n, double inner, double root, double outer, double modulus, double poisson);

/// Stiffness of a uniform length, with zeros for u; v is w and theta w'. Cubic polynomials on pieces of at most an
/// eighth of (B/H)^(1/4), the nodes between them eliminated.
ShellMatrix stiffness_matrix(const OvalRigidity& wall, double length);

}  // namespace fe
