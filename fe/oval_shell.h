#pragma once

#include "fe/shell.h"

namespace fe {

/// Rigidities of a thin cylinder that goes out of round as w(x) cos(n phi), n >= 2, without
/// stretching around the axis and without membrane shear. Per length the energy is half of
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
OvalRigidity oval_tube(int n, double inner, double root, double outer, double modulus,
                       double poisson);

/// Stiffness of a uniform length, u left without any; v is w and theta w'. Cubic polynomials on
/// pieces of at most an eighth of (B/H)^(1/4), the nodes between them eliminated.
ShellMatrix stiffness_matrix(const OvalRigidity& wall, double length);

}  // namespace fe
