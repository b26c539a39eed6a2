#pragma once

#include "fe/lanes.h"

namespace prs {

/// Roller between two contacts: axial stiffness, and the bending of fe::Beam with rotations times
/// the roller's radius r, l the length:
///
///     near = (4 + Phi) b/r^2,  far = (2 - Phi) b/r^2,  b = E I/(l (1 + Phi)),  slope = r/l.
template <class Real>
struct RollerBeam {
  Real axial, near, far, slope;

  /// Stiffness over freedoms U, V = U + 1, T = U + 2 of the first node; `add` as of fe::Chain.
  template <int U, class Add>
  [[gnu::always_inline]] void add_first(Add add) const {
    const Real shear = slope * (near + far);
    add(fe::Index<U>{}, fe::Index<U>{}, axial);
    add(fe::Index<U + 1>{}, fe::Index<U + 1>{}, 2.0 * slope * shear);
    add(fe::Index<U + 1>{}, fe::Index<U + 2>{}, shear);
    add(fe::Index<U + 2>{}, fe::Index<U + 2>{}, near);
  }

  template <int U, class Add>
  [[gnu::always_inline]] void add_second(Add add) const {
    const Real shear = slope * (near + far);
    add(fe::Index<U>{}, fe::Index<U>{}, axial);
    add(fe::Index<U + 1>{}, fe::Index<U + 1>{}, 2.0 * slope * shear);
    add(fe::Index<U + 1>{}, fe::Index<U + 2>{}, -shear);
    add(fe::Index<U + 2>{}, fe::Index<U + 2>{}, near);
  }

  /// From the first node's U to the second node's W.
  template <int U, int W, class Add>
  [[gnu::always_inline]] void add_coupling(Add add) const {
    const Real shear = slope * (near + far);
    add(fe::Index<U>{}, fe::Index<W>{}, -axial);
    add(fe::Index<U + 1>{}, fe::Index<W + 1>{}, -2.0 * slope * shear);
    add(fe::Index<U + 1>{}, fe::Index<W + 2>{}, shear);
    add(fe::Index<U + 2>{}, fe::Index<W + 1>{}, -shear);
    add(fe::Index<U + 2>{}, fe::Index<W + 2>{}, far);
  }

  /// End forces as fe::end_forces, rigid motion dropped before it meets the stiffness.
  template <int U, int W, class State>
  [[gnu::always_inline]] void add_forces(const State& first, const State& second, Real* first_force,
                                         Real* second_force) const {
    const auto difference = [&](int i, int j) __attribute__((always_inline)) {
      return (second.head[j] - first.head[i]) + (second.tail[j] - first.tail[i]);
    };
    const Real tension = axial * difference(U, W);
    const Real chord = slope * difference(U + 1, W + 1);
    const Real rotation_1 = (first.head[U + 2] - chord) + first.tail[U + 2];
    const Real rotation_2 = (second.head[W + 2] - chord) + second.tail[W + 2];
    const Real moment_1 = near * rotation_1 + far * rotation_2;
    const Real moment_2 = far * rotation_1 + near * rotation_2;
    const Real shear = slope * (moment_1 + moment_2);
    first_force[U] -= tension;
    first_force[U + 1] += shear;
    first_force[U + 2] += moment_1;
    second_force[W] += tension;
    second_force[W + 1] -= shear;
    second_force[W + 2] += moment_2;
  }
};

/// A uniform length of a roller; flexibilities so that rigid ones are zeros.
template <class Real>
struct RollerLength {
  Real length;
  Real bending;  ///< 1/(E I) [1/(N m^2)]
  Real shear;    ///< 1/(kappa G A) [1/N]; 0 without shear.
};

/// Stiffness over (v, r theta) that a roller's end has for its outermost contact: symmetric.
template <class Real>
struct RollerEnd {
  Real vv, vt, tt;  ///< [N/m]

  /// To freedoms V and V + 1 of a station; `add` as of fe::Chain.
  template <int V, class Add>
  [[gnu::always_inline]] void add(Add add) const {
    add(fe::Index<V>{}, fe::Index<V>{}, vv);
    add(fe::Index<V>{}, fe::Index<V + 1>{}, vt);
    add(fe::Index<V + 1>{}, fe::Index<V + 1>{}, tt);
  }

  template <int V, class State>
  [[gnu::always_inline]] void add_forces(const State& here, Real* force) const {
    const Real v = here.head[V] + here.tail[V], t = here.head[V + 1] + here.tail[V + 1];
    force[V] += vv * v + vt * t;
    force[V + 1] += vt * v + tt * t;
  }
};

/// The run-out from the outermost contact to the inner node of the end element, the end element and
/// the radial guides at both its nodes, condensed to the contact: with the cantilever's flexibility
///
///     f_ii = l_1^3/(3 B_1) + l_1/G_1,   f_io = f_ii + l_1^2 l_2/(2 B_1),
///     f_oo = f_io + l_1 l_2 (l_1/2 + l_2)/B_1 + l_2^3/(3 B_2) + l_2/G_2
///
/// the guides' forces R obey [1/g_o + f_oo, f_io; f_io, 1/g_i + f_ii] R = the rigid displacements
/// of their nodes. A guide of infinite stiffness holds, one of 0 is none. `side` is -1 at the end
/// that faces the loaded end of the screw, +1 at the other; r the radius that rotations are scaled
/// by.
template <class Real>
[[gnu::always_inline]] inline RollerEnd<Real> roller_end(const RollerLength<Real>& run_out,
                                                         const RollerLength<Real>& end,
                                                         const Real& outer_guide,
                                                         const Real& inner_guide, const Real& side,
                                                         const Real& radius) {
  const Real &l1 = run_out.length, &l2 = end.length;
  const Real ii = l1 * l1 * l1 * run_out.bending * (1.0 / 3.0) + l1 * run_out.shear;
  const Real io = ii + 0.5 * l1 * l1 * l2 * run_out.bending;
  const Real oo = io + l1 * l2 * (0.5 * l1 + l2) * run_out.bending +
                  l2 * l2 * l2 * end.bending * (1.0 / 3.0) + l2 * end.shear;
  const Real inner = 1.0 / (1.0 / inner_guide + ii);
  const Real share = io * inner;
  const Real outer = 1.0 / (1.0 / outer_guide + (oo - io * share));
  const Real to_inner = side * l1 / radius;
  const Real to_outer = side * (l1 + l2) / radius - share * to_inner;
  const Real moved = 1.0 - share;
  return {inner + outer * moved * moved, inner * to_inner + outer * moved * to_outer,
          inner * to_inner * to_inner + outer * to_outer * to_outer};
}

}  // namespace prs
