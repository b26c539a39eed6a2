#pragma once

#include <span>
#include <vector>

#include "fe/lanes.h"
#include "prs/sector/sector_numbers.h"
#include "simd/inlined.h"

namespace prs {

using fe::abs, fe::any, fe::max, fe::min, fe::select;  // for single numbers, besides those for batches

/// Number of values in a batch.
template <class Real>
inline constexpr std::size_t kLanes = sizeof(Real) / sizeof(double);

/// Batch of values[0], values[1], ..
template <class Real>
PRS_INLINED inline Real from_lanes(const double* values) {
  Real x;
  std::memcpy(&x, values, sizeof x);
  return x;
}

template <class Real>
PRS_INLINED inline void to_lanes(const Real& x, double* values) {
  std::memcpy(values, &x, sizeof x);
}

template <class Real>
PRS_INLINED inline double lane(const Real& x, std::size_t l) {
  double value;
  std::memcpy(&value, reinterpret_cast<const char*>(&x) + l * sizeof value, sizeof value);
  return value;
}

/// A batch of solves, one per lane, from `first` on out of `size` solves whose numbers are in arrays. Lanes beyond the
/// end repeat the last solve and deliver nothing.
struct LaneRange {
  std::size_t first = 0;
  std::size_t size = 0;

  /// Number `offset` of each solve, `stride` numbers per solve; zeros from an empty array.
  template <class Real>
  PRS_INLINED Real load(std::span<const double> values, std::size_t stride = 1, std::size_t offset = 0) const {
    if (values.empty()) return Real(0.0);
    if (stride == 1 && first + kLanes<Real> <= size) return from_lanes<Real>(values.data() + first + offset);
    double lanes[kLanes<Real>];
    for (std::size_t l = 0; l < kLanes<Real>; ++l)
      lanes[l] = values[(first + l < size ? first + l : size - 1) * stride + offset];
    return from_lanes<Real>(lanes);
  }
  template <class Real, class T>
  PRS_INLINED void store(const Real& x, std::vector<T>& values, std::size_t stride = 1, std::size_t offset = 0) const {
    double lanes[kLanes<Real>];
    to_lanes(x, lanes);
    for (std::size_t l = 0; l < kLanes<Real> && first + l < size; ++l)
      values[(first + l) * stride + offset] = static_cast<T>(lanes[l]);
  }
};

/// Roller between two contacts: axial stiffness, and the bending of fe::Beam with rotations times
/// the roller's radius r, l the length:
///
///     near = (4 + Phi) b/r^2,  far = (2 - Phi) b/r^2,  b = E I/(l (1 + Phi)),  slope = r/l.
template <class Real>
struct RollerBeam {
  Real axial, near, far, slope;

  /// Stiffness over freedoms U, V = U + 1, T = U + 2 of the first node, `side` 1, or of the second one, -1; `add` as in
  /// fe/chain_station.h.
  template <int U, class Add>
  PRS_INLINED void add_end(Add add, double side) const {
    const Real shear = slope * (near + far);
    add(fe::Index<U>{}, fe::Index<U>{}, axial);
    add(fe::Index<U + 1>{}, fe::Index<U + 1>{}, 2.0 * slope * shear);
    add(fe::Index<U + 1>{}, fe::Index<U + 2>{}, side * shear);
    add(fe::Index<U + 2>{}, fe::Index<U + 2>{}, near);
  }

  /// Coupling of the first node's freedoms from U on with the second node's from W on.
  template <int U, int W, class Add>
  PRS_INLINED void add_coupling(Add add) const {
    const Real shear = slope * (near + far);
    add(fe::Index<U>{}, fe::Index<W>{}, -axial);
    add(fe::Index<U + 1>{}, fe::Index<W + 1>{}, -2.0 * slope * shear);
    add(fe::Index<U + 1>{}, fe::Index<W + 2>{}, shear);
    add(fe::Index<U + 2>{}, fe::Index<W + 1>{}, -shear);
    add(fe::Index<U + 2>{}, fe::Index<W + 2>{}, far);
  }

  /// End forces like fe::end_forces: rigid motion is removed before the stiffness is applied.
  template <int U, int W, class State>
  PRS_INLINED void add_forces(const State& first, const State& second, Real* first_force, Real* second_force) const {
    const auto difference = [&](int i, int j) PRS_INLINED {
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

/// A uniform length of a roller; given by flexibilities, so that rigid ones are zeros.
template <class Real>
struct RollerLength {
  Real length;
  Real bending;  ///< 1/(E I) [1/(N m^2)]
  Real shear;    ///< 1/(kappa G A) [1/N]; 0 without shear.
};

/// Stiffness over (v, r theta) of a roller's end at its outermost contact: symmetric.
template <class Real>
struct RollerEnd {
  Real vv, vt, tt;  ///< [N/m]

  /// Adds it to freedoms V and V + 1 of a station; `add` as in fe/chain_station.h.
  template <int V, class Add>
  PRS_INLINED void add(Add add) const {
    add(fe::Index<V>{}, fe::Index<V>{}, vv);
    add(fe::Index<V>{}, fe::Index<V + 1>{}, vt);
    add(fe::Index<V + 1>{}, fe::Index<V + 1>{}, tt);
  }

  template <int V, class State>
  PRS_INLINED void add_forces(const State& here, Real* force) const {
    const Real v = here.head[V] + here.tail[V], t = here.head[V + 1] + here.tail[V + 1];
    force[V] += vv * v + vt * t;
    force[V + 1] += vt * v + tt * t;
  }
};

/// The run-out from the outermost contact to the inner node of the end element, the end element and the radial guides
/// at both its nodes, condensed to the contact: with the cantilever's flexibility
///
///     f_ii = l_1^3/(3 B_1) + l_1/G_1,   f_io = f_ii + l_1^2 l_2/(2 B_1),
///     f_oo = f_io + l_1 l_2 (l_1/2 + l_2)/B_1 + l_2^3/(3 B_2) + l_2/G_2
///
/// the guides' forces R obey [1/g_o + f_oo, f_io; f_io, 1/g_i + f_ii] R = the rigid displacements of their nodes. A
/// guide of infinite stiffness holds, one of stiffness 0 is absent. `side` is -1 at the end that faces the loaded end
/// of the screw, +1 at the other; r the radius that rotations are scaled by.
template <class Real>
PRS_INLINED inline RollerEnd<Real> roller_end(const RollerLength<Real>& run_out, const RollerLength<Real>& end,
                                              const Real& outer_guide, const Real& inner_guide, const Real& side,
                                              const Real& radius) {
  const Real &l1 = run_out.length, &l2 = end.length;
  const Real ii = l1 * l1 * l1 * run_out.bending * (1.0 / 3.0) + l1 * run_out.shear;
  const Real io = ii + 0.5 * l1 * l1 * l2 * run_out.bending;
  const Real oo =
      io + l1 * l2 * (0.5 * l1 + l2) * run_out.bending + l2 * l2 * l2 * end.bending * (1.0 / 3.0) + l2 * end.shear;
  const Real inner = 1.0 / (1.0 / inner_guide + ii);
  const Real share = io * inner;
  const Real outer = 1.0 / (1.0 / outer_guide + (oo - io * share));
  const Real to_inner = side * l1 / radius;
  const Real to_outer = side * (l1 + l2) / radius - share * to_inner;
  const Real moved = 1.0 - share;
  return {inner + outer * moved * moved, inner * to_inner + outer * moved * to_outer,
          inner * to_inner * to_inner + outer * to_outer * to_outer};
}

/// A roller between and beyond its contacts.
template <class Real>
struct RollerChain {
  RollerBeam<Real> thread;  ///< Beam to the next tooth.
  RollerBeam<Real> tooth;   ///< Beam between the two contacts of a tooth, if they lie apart.
  RollerEnd<Real> ends[2];
  Real bending_support;  ///< Infinite if v = theta = 0 everywhere, else 0.
};

template <class Real>
PRS_INLINED inline RollerBeam<Real> roller_beam(const RollerSection<Real>& section, const Real& length,
                                                const Real& radius) {
  const Real shear = section.shear * length * length;
  const Real phi = select(shear <= 0.0, Real(0.0), 12.0 * section.bending / shear);
  const Real b = section.bending / (length * (1.0 + phi) * radius * radius);
  return {section.axial / length, (4.0 + phi) * b, (2.0 - phi) * b, radius / length};
}

template <class Real>
PRS_INLINED inline RollerLength<Real> roller_length(const RollerSection<Real>& section, const Real& length) {
  return {length, 1.0 / section.bending, select(section.shear <= 0.0, Real(0.0), 1.0 / section.shear)};
}

template <class Real>
PRS_INLINED inline RollerChain<Real> roller_chain(const SectorNumbers<Real>& n) {
  const Real half = n.contact_half_distance;
  const RollerEnd<Real> first =
      roller_end(roller_length(n.thread, Real(0.5 * n.pitch - half)), roller_length(n.end, n.end_length), n.outer_guide,
                 n.inner_guide, Real(-1.0), n.roller_radius);
  return {roller_beam(n.thread, Real(n.pitch - 2.0 * half), n.roller_radius),
          {Real(0.0), Real(0.0), Real(0.0), Real(0.0)},
          {first, {first.vv, -first.vt, first.tt}},
          select(n.rigid_bending > 0.0, Real(__builtin_inf()), Real(0.0))};
}

/// Stiffness between two contacts of a nut, whose freedoms are u, v and r theta, r the radius that rotations are scaled
/// by.
template <class Real>
struct NutSegment {
  /// Stiffness over the first and the second node: upper triangles row by row, and the full coupling [N/m].
  Real first[6] = {};
  Real coupling[9] = {};
  Real second[6] = {};
  /// Stiffness over the deformations (q_2 - q_1, (q_1 + q_2)/2), upper triangle row by row.
  Real deformation[21] = {};
};

/// Supports of a contact's node besides the segments to its neighbours: ends of the nut and held freedoms.
template <class Real>
struct NutSupport {
  Real stiffness[6] = {};  ///< Upper triangle row by row; infinite: held [N/m].
};

/// A sector as a chain of stations, everything between the contacts condensed. SI units.
struct ChainSector {
  enum class Kind {
    bars,               ///< Screw u; nut u; roller u, v, theta.
    shell,              ///< Nut u, v, theta.
    apart_nut_first,    ///< Shell with a roller node for each contact; along x that of the nut comes first.
    apart_screw_first,  ///< The other order.
  };

  Kind kind = Kind::bars;
  int contacts = 0;
  SectorNumbers<double> numbers;
  RollerChain<double> roller{};
  double nut_rotation_part = 0.0;                ///< Coefficient of the nut's r theta in its approach.
  PerInterface<std::vector<double>> compliance;  ///< Compliance in series; bars: empty for zeros.
  PerInterface<std::vector<double>> gaps;

  std::vector<double> nut;     ///< Bars: stiffness to the next contact [N/m].
  std::vector<double> ground;  ///< Bars: stiffness to the thrust section; infinite: held [N/m].

  std::vector<NutSegment<double>> segments;  ///< Shell: segments between contacts, each kind once.
  std::vector<int> segment_of;               ///< Shell: segment to the next contact.
  std::vector<NutSupport<double>> supports;  ///< Shell: support of each contact.
};

}  // namespace prs
