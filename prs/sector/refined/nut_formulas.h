#pragma once

#include <span>

#include "fe/shell_formulas.h"
#include "prs/model/model_options.h"
#include "prs/model/part.h"

/// Formulas of the nut as a shell for a number or a batch of numbers: one nut per lane. See
/// nut_shell.h.
namespace prs {

/// Properties that nuts side by side share.
struct NutShape {
  std::span<const int> contacts;  ///< Nodes of the contacts, ascending.
  int thrust = 0;                 ///< Node of the thrust section.
  /// First segment equal to it, for each segment.
  std::span<const int> same;
  bool has_ring = false;  ///< Whether the thrust section leans on a ring.
  RefinedEffects effects;

  std::size_t nodes() const { return same.size() + 1; }
  bool held_radially() const { return !effects.hoop; }
};

/// A nut's numbers; sections of nodes and radii of segments as in NutLine and NutBore.
template <class Real>
struct NutNumbers {
  const Real* sections;
  const Real* outer_radius;
  const Real* root;
  Real pitch_radius, ring_inner, ring_outer;
  Real modulus, poisson;
  Real rollers;
  Real sense, cosine, sine;  ///< s, cos(psi), sin(psi).
};

/// Distance from the inner edge of a ring of width w to the centre of pressure, when a face of
/// half-space stiffness E* leans on it with the force P' per length and the tilt theta, which opens
/// its outer edge where > 0 [m]. A tilted flat punch (Johnson, Contact Mechanics, 1985, chapter 2;
/// p ~ sqrt((b - x)/x) while it touches over b < w):
///
///     P'/(pi E* theta) = b/4                     for theta > theta_1 = 4 P'/(pi E* w),
///     w/2 - pi E* theta w^2/(16 P')              for |theta| <= theta_1, touching all over,
///
/// and mirrored for theta < -theta_1.
template <class Real>
Real centre_of_pressure(const Real& force, const Real& tilt, const Real& width, const Real& plane_modulus) {
  using simd::abs, simd::select;
  constexpr double kPi = std::numbers::pi;
  const Real lean = kPi * plane_modulus * abs(tilt) * width / force;  // 4 if b = w
  const Real from_edge = select(lean > 4.0, width / lean, width * (0.5 - lean / 16.0));
  return select(tilt > 0.0, from_edge, width - from_edge);
}

/// Part of a nut from its end up to a node, with its loads, condensed to that node.
template <class Real>
struct NutEnd {
  Real vv{}, vt{}, tt{};  ///< Stiffness over (v, theta); u is free.
  Real u{}, v{}, t{};     ///< Loads on the node.

  /// Adds one shell, `step` 1 along the axis, -1 against it. The deformations of the shell are eliminated, not its far
  /// node: a stiff shell loses no digits.
  void pass(fe::ShellBlocks<Real> k, double step, bool held_radially) {
    k.uv *= step;
    k.tv *= step;
    k.dm *= step;
    // Matrix over (u, theta, v) of the deformation and (v, theta) of the node reached; then loads.
    Real a[5][5] = {{k.uu, k.ut, -0.5 * k.uv, k.uv, Real(0.0)},
                    {Real(0.0), k.tt + 0.25 * k.mm + tt, -0.5 * (k.tv + k.dm) + vt, k.tv - vt, -0.5 * k.mm - tt},
                    {Real(0.0), Real(0.0), 0.25 * k.vv + k.dd + vv, -0.5 * k.vv - vv, k.dm - vt},
                    {Real(0.0), Real(0.0), Real(0.0), k.vv + vv, vt},
                    {Real(0.0), Real(0.0), Real(0.0), Real(0.0), k.mm + tt}};
    Real f[5] = {-u, -t, -v, v, t};
    for (int p = 0; p < (held_radially ? 2 : 3); ++p) {
      const Real inverse = 1.0 / a[p][p];
      for (int i = p + 1; i < 5; ++i) {
        const Real share = a[p][i] * inverse;
        for (int j = i; j < 5; ++j) a[i][j] -= share * a[p][j];
        f[i] -= share * f[p];
      }
    }
    vv = a[3][3];
    vt = a[3][4];
    tt = a[4][4];
    v = f[3];
    t = f[4];
  }
  void add(const Real& axial, const Real& radial, const Real& moment) {
    u += axial;
    v += radial;
    t += moment;
  }
};

/// Rigidities of a segment's wall, u at the radius `reference`.
template <class Real>
fe::ShellRigidityOf<Real> wall_rigidity(const NutNumbers<Real>& n, std::size_t segment, const Real& reference,
                                        const RefinedEffects& effects) {
  const Real &root = n.root[segment], &outer = n.outer_radius[segment];
  const Real shear_modulus = n.modulus / (2.0 * (1.0 + n.poisson));
  const Real poisson = effects.poisson && effects.hoop ? n.poisson : Real(0.0);
  const auto tube = [&](const Real& r0) {
    return fe::tube_rigidity(root, outer, r0, n.modulus, poisson, shear_modulus);
  };
  fe::ShellRigidityOf<Real> wall = tube(reference);
  if (!effects.flange) {
    wall = tube(Real(reference + wall.eccentric / wall.axial));
    wall.eccentric = Real(0.0);
  }
  wall.hoop = fe::tube_hoop(n.pitch_radius, outer, n.modulus, poisson);
  wall.radially_rigid = !effects.hoop;
  return fe::scaled_rigidity(wall, Real(1.0 / n.rollers));
}

/// Rotation of the thrust section, u held there.
template <class Real>
struct ThrustTilt {
  Real by_loads;   ///< Rotation by unit normal loads on all contacts [rad/N].
  Real by_moment;  ///< [rad/(N m)]
};

/// Condenses node by node from both ends to the thrust section.
template <class Real>
ThrustTilt<Real> thrust_tilt(const NutShape& shape, const NutNumbers<Real>& n, const fe::ShellBlocks<Real>* shells,
                             const Real& contact_arm) {
  const Real axial = n.sense * n.cosine, moment = -axial * contact_arm;
  const auto last = static_cast<int>(shape.same.size());
  const auto sweep = [&](int from, int step) {
    NutEnd<Real> end;
    auto contact = step > 0 ? std::size_t{0} : shape.contacts.size() - 1;
    const auto load = [&](int node) {
      for (; contact < shape.contacts.size() && shape.contacts[contact] == node;
           contact += static_cast<std::size_t>(step))
        end.add(axial, n.sine, moment);
    };
    for (int node = from; node != shape.thrust; node += step) {
      load(node);
      const auto segment = static_cast<std::size_t>(step > 0 ? node : node - 1);
      end.pass(shells[shape.same[segment]], step, shape.held_radially());
    }
    if (step > 0) load(shape.thrust);
    return end;
  };
  const NutEnd<Real> before = sweep(0, 1), behind = sweep(last, -1);
  const Real vv = before.vv + behind.vv, vt = before.vt + behind.vt, tt = before.tt + behind.tt;
  const Real v = before.v + behind.v, t = before.t + behind.t;
  const Real share = shape.held_radially() ? Real(0.0) : vt / vv;
  const Real by_moment = 1.0 / (tt - share * vt);
  return {(t - share * v) * by_moment, by_moment};
}

/// Radius at which the housing pushes, between the edges of the ring: the further out it is, the more the face tilts,
/// which moves the centre of pressure in.
template <class Real>
Real thrust_radius(const NutShape& shape, const NutNumbers<Real>& n, const ThrustTilt<Real>& tilt) {
  using simd::select;
  constexpr double kTwoPi = 2.0 * std::numbers::pi;
  const Real plane_modulus = n.modulus / (1.0 - n.poisson * n.poisson);
  const Real axial_force = n.cosine * static_cast<double>(shape.contacts.size());
  const Real width = n.ring_outer - n.ring_inner;
  Real low = n.ring_inner, high = n.ring_outer;
  for (int i = 0; i < 60; ++i) {
    const Real middle = 0.5 * (low + high);
    const Real theta = n.sense * tilt.by_loads + tilt.by_moment * axial_force * (middle - n.ring_inner);
    const Real centre = n.ring_inner + centre_of_pressure(Real(n.rollers * axial_force / (kTwoPi * middle)), theta,
                                                          width, plane_modulus);
    const auto further = centre > middle;
    low = select(further, middle, low);
    high = select(further, high, middle);
  }
  return 0.5 * (low + high);
}

/// Computes `NutShell` for nuts that have one: `shells[k]` of every segment k that is the first of its kind. Returns
/// the distance from the radius of the nodes to the contacts.
template <class Real>
Real set_nut_shells(const NutShape& shape, const NutNumbers<Real>& n, fe::ShellBlocks<Real>* shells) {
  const auto before = static_cast<std::size_t>(shape.thrust > 1 ? shape.thrust - 1 : 0);
  const Real reference = shape.has_ring ? n.ring_inner : Real(0.5 * (n.root[before] + n.outer_radius[before]));
  const auto for_each_kind = [&](auto f) {
    for (std::size_t k = 0; k < shape.same.size(); ++k)
      if (shape.same[k] == static_cast<int>(k)) f(k);
  };
  for_each_kind([&](std::size_t k) {
    shells[k] =
        fe::shell_blocks(wall_rigidity(n, k, reference, shape.effects), Real(n.sections[k + 1] - n.sections[k]));
  });
  if (!shape.effects.flange) return Real(0.0);
  const Real arm = n.pitch_radius - reference;
  if (!shape.has_ring) return arm;
  const Real radius = thrust_radius(shape, n, thrust_tilt(shape, n, shells, arm));
  for_each_kind([&](std::size_t k) { shells[k] = fe::about(shells[k], Real(radius - reference)); });
  return n.pitch_radius - radius;
}

}  // namespace prs
