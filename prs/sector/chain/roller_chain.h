#pragma once

#include "prs/sector/chain/lane_access.h"
#include "prs/sector/chain/roller_beam.h"
#include "prs/sector/sector_numbers.h"

namespace prs {

/// A roller between and beyond its contacts.
template <class Real>
struct RollerChain {
  RollerBeam<Real> thread;  ///< To the next tooth.
  RollerBeam<Real> tooth;   ///< Between the two contacts of a tooth, where they lie apart.
  RollerEnd<Real> ends[2];
  Real bending_support;  ///< Infinite where v = theta = 0 everywhere, else 0.
};

template <class Real>
[[gnu::always_inline]] inline RollerBeam<Real> roller_beam(const RollerSection<Real>& section,
                                                           const Real& length, const Real& radius) {
  const Real shear = section.shear * length * length;
  const Real phi = select(shear <= 0.0, Real(0.0), 12.0 * section.bending / shear);
  const Real b = section.bending / (length * (1.0 + phi) * radius * radius);
  return {section.axial / length, (4.0 + phi) * b, (2.0 - phi) * b, radius / length};
}

template <class Real>
[[gnu::always_inline]] inline RollerLength<Real> roller_length(const RollerSection<Real>& section,
                                                               const Real& length) {
  return {length, 1.0 / section.bending,
          select(section.shear <= 0.0, Real(0.0), 1.0 / section.shear)};
}

template <class Real>
[[gnu::always_inline]] inline RollerChain<Real> roller_chain(const SectorNumbers<Real>& n) {
  const Real half = n.contact_half_distance;
  const RollerEnd<Real> first = roller_end(roller_length(n.thread, Real(0.5 * n.pitch - half)),
                                           roller_length(n.end, n.end_length), n.outer_guide,
                                           n.inner_guide, Real(-1.0), n.roller_radius);
  return {roller_beam(n.thread, Real(n.pitch - 2.0 * half), n.roller_radius),
          {Real(0.0), Real(0.0), Real(0.0), Real(0.0)},
          {first, {first.vv, -first.vt, first.tt}},
          select(n.rigid_bending > 0.0, Real(__builtin_inf()), Real(0.0))};
}

}  // namespace prs
