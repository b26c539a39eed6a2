#pragma once

#include <Eigen/Core>

namespace fe {

/// Straight bar that carries axial force only; freedoms (u_1, u_2) [m].
struct Bar {
  double axial_rigidity = 0.0;  ///< E A [N]
  double length = 0.0;          ///< L [m], > 0.

  /// E A / L [N/m], the factor of [[1, -1], [-1, 1]] (Abevi 2015, (A1)).
  double stiffness() const { return axial_rigidity / length; }
};

/// Straight plane beam along x with the freedoms (u, v, theta) at each end: axial and transverse
/// displacement [m], rotation [rad], theta = dv/dx in bending without shear.
struct Beam {
  double axial_rigidity = 0.0;    ///< E A [N]
  double bending_rigidity = 0.0;  ///< E I [N m^2]
  double shear_rigidity = 0.0;    ///< kappa G A [N]; 0 leaves shear out (Euler-Bernoulli).
  double length = 0.0;            ///< L [m], > 0.
};

template <class Real>
using BeamVector = Eigen::Matrix<Real, 6, 1>;
template <class Real>
using BeamMatrix = Eigen::Matrix<Real, 6, 6>;

/// Phi = 12 E I / (kappa G A L^2), the share of shear in the transverse flexibility of Timoshenko's
/// beam (Przemieniecki, Theory of Matrix Structural Analysis, 1968, section 5.6).
template <class Real = double>
Real shear_ratio(const Beam& b) {
  const Real l = b.length, shear = b.shear_rigidity;
  if (!(b.shear_rigidity > 0.0)) return Real(0.0);
  return 12.0 * b.bending_rigidity / (shear * l * l);
}

/// 6 x 6 stiffness over (u_1, v_1, theta_1, u_2, v_2, theta_2), in N/m, N and N m (Abevi 2015,
/// (A4), for Phi = 0).
template <class Real = double>
BeamMatrix<Real> stiffness_matrix(const Beam& beam) {
  const Real l = beam.length;
  const Real a = beam.axial_rigidity / l;
  const Real phi = shear_ratio<Real>(beam);
  const Real b = beam.bending_rigidity / (l * l * l * (1.0 + phi));
  const Real t = 12.0 * b, c = 6.0 * b * l;
  const Real near = (4.0 + phi) * b * l * l, far = (2.0 - phi) * b * l * l;
  const Real o(0.0);
  BeamMatrix<Real> k;
  // clang-format off
  k <<  a,  o,    o, -a,  o,    o,
        o,  t,    c,  o, -t,    c,
        o,  c, near,  o, -c,  far,
       -a,  o,    o,  a,  o,    o,
        o, -t,   -c,  o,  t,   -c,
        o,  c,  far,  o, -c, near;
  // clang-format on
  return k;
}

/// Deformation of a beam. Rigid translation does not appear.
template <class Real>
struct BeamMotion {
  Real elongation;       ///< u_2 - u_1 [m]
  Real deflection;       ///< v_2 - v_1 [m]
  Real first_rotation;   ///< theta_1 [rad]
  Real second_rotation;  ///< theta_2 [rad]
  Real first_rest{};     ///< Compensation: rounding error of theta_1 [rad].
  Real second_rest{};    ///< Compensation: rounding error of theta_2 [rad].
};

/// End forces on the beam, K q over (u_1, v_1, theta_1, u_2, v_2, theta_2), from elongation and the
/// end rotations against the chord. Rigid motions drop out before they meet the stiffness, so the
/// forces balance to rounding however large the motion is.
template <class Real = double>
BeamVector<Real> end_forces(const Beam& beam, const BeamMotion<Real>& motion) {
  const Real l = beam.length;
  const Real phi = shear_ratio<Real>(beam);
  const Real b = beam.bending_rigidity / (l * (1.0 + phi));
  const Real chord = motion.deflection / l;
  const Real first = (motion.first_rotation - chord) + motion.first_rest;
  const Real second = (motion.second_rotation - chord) + motion.second_rest;
  const Real tension = beam.axial_rigidity / l * motion.elongation;
  const Real m1 = b * ((4.0 + phi) * first + (2.0 - phi) * second);
  const Real m2 = b * ((2.0 - phi) * first + (4.0 + phi) * second);
  const Real shear = (m1 + m2) / l;
  return {-tension, shear, m1, tension, -shear, m2};
}

}  // namespace fe
