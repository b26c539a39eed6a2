#pragma once

#include <Eigen/Core>

namespace fe {

/// Straight plane beam along x with the freedoms (u, v, theta) at each end: axial and transverse
/// displacement [m], rotation [rad], theta = dv/dx in bending without shear.
struct Beam {
  double axial_rigidity = 0.0;    ///< E A [N]
  double bending_rigidity = 0.0;  ///< E I [N m^2]
  double shear_rigidity = 0.0;    ///< kappa G A [N]; 0 leaves shear out (Euler-Bernoulli).
  double length = 0.0;            ///< L [m], > 0.
};

using BeamVector = Eigen::Matrix<double, 6, 1>;
using BeamMatrix = Eigen::Matrix<double, 6, 6>;

/// Phi = 12 E I / (kappa G A L^2), the share of shear in the transverse flexibility of Timoshenko's
/// beam (Przemieniecki, Theory of Matrix Structural Analysis, 1968, section 5.6).
inline double shear_ratio(const Beam& b) {
  return b.shear_rigidity > 0.0
             ? 12.0 * b.bending_rigidity / (b.shear_rigidity * b.length * b.length)
             : 0.0;
}

/// 6 x 6 stiffness over (u_1, v_1, theta_1, u_2, v_2, theta_2), in N/m, N and N m (Abevi 2015,
/// (A4), for Phi = 0).
inline BeamMatrix stiffness_matrix(const Beam& beam) {
  const double l = beam.length;
  const double a = beam.axial_rigidity / l;
  const double phi = shear_ratio(beam);
  const double b = beam.bending_rigidity / (l * l * l * (1.0 + phi));
  const double t = 12.0 * b, c = 6.0 * b * l;
  const double near = (4.0 + phi) * b * l * l, far = (2.0 - phi) * b * l * l;
  BeamMatrix k;
  // clang-format off
  k <<  a,  0,    0, -a,  0,    0,
        0,  t,    c,  0, -t,    c,
        0,  c, near,  0, -c,  far,
       -a,  0,    0,  a,  0,    0,
        0, -t,   -c,  0,  t,   -c,
        0,  c,  far,  0, -c, near;
  // clang-format on
  return k;
}

/// What deforms a beam, and what it only carries along: rigid translation does not appear.
struct BeamMotion {
  double elongation = 0.0;       ///< u_2 - u_1 [m]
  double deflection = 0.0;       ///< v_2 - v_1 [m]
  double first_rotation = 0.0;   ///< theta_1 [rad]
  double second_rotation = 0.0;  ///< theta_2 [rad]
  double first_rest = 0.0;       ///< What rounding took from theta_1 and
  double second_rest = 0.0;      ///< theta_2 [rad].
};

/// End forces on the beam, K q over (u_1, v_1, theta_1, u_2, v_2, theta_2), from elongation and the
/// end rotations against the chord. Rigid motions drop out before they meet the stiffness, so the
/// forces balance to rounding however large the motion is.
inline BeamVector end_forces(const Beam& beam, const BeamMotion& motion) {
  const double l = beam.length;
  const double phi = shear_ratio(beam);
  const double b = beam.bending_rigidity / (l * (1.0 + phi));
  const double chord = motion.deflection / l;
  const double first = (motion.first_rotation - chord) + motion.first_rest;
  const double second = (motion.second_rotation - chord) + motion.second_rest;
  const double tension = beam.axial_rigidity / l * motion.elongation;
  const double m1 = b * ((4.0 + phi) * first + (2.0 - phi) * second);
  const double m2 = b * ((2.0 - phi) * first + (4.0 + phi) * second);
  const double shear = (m1 + m2) / l;
  return {-tension, shear, m1, tension, -shear, m2};
}

}  // namespace fe
