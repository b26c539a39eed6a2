#pragma once

#include <array>

#include "fe/chain.h"
#include "prs/sector/chain/lane_access.h"
#include "prs/sector/chain/roller_beam.h"

namespace prs {

/// One tooth of a sector of bars: screw u, nut u, roller u, v, r theta.
template <class Real>
struct BarStation {
  static constexpr int kFreedoms = 5;
  enum : int { S, N, U, V, T };
  static constexpr bool couples(int i, int j) { return i == j || (i >= V && j >= V); }

  /// w of screw and nut: s cos(psi) is coefficient 0, sin(psi) coefficient 1.
  template <int C>
  static constexpr std::array<fe::ChainTerm, 4> form() {
    if (C == 0) return {{{S, 0, false}, {U, 0, true}, {V, 1, true}, {T, 0, true}}};
    return {{{N, 0, true}, {U, 0, false}, {V, 1, false}, {T, 0, true}}};
  }

  int stations;
  Real axial_part[2];   ///< s cos(psi) of screw and nut.
  Real radial_part[2];  ///< sin(psi)
  Real screw;           ///< E A/p [N/m]
  RollerBeam<Real> roller;
  RollerEnd<Real> ends[2];
  Real bending_support;  ///< Infinite where v = theta = 0 everywhere, else 0.
  const Real* nut;       ///< To the next contact; 0 across the thrust section [N/m].
  const Real* ground;    ///< From a contact to the thrust section, if nothing lies between.

  [[gnu::always_inline]] const Real& coefficient(int contact, int kind) const {
    return kind == 0 ? axial_part[contact] : radial_part[contact];
  }

  template <int I>
  [[gnu::always_inline]] fe::Lanes<Real> held(int k, fe::Index<I>) const {
    if constexpr (I == N) return ground[k] > 1e300;
    if constexpr (I == V || I == T) return bending_support > 1e300;
    return Real(0.0) > 1.0;
  }

  template <class Add>
  [[gnu::always_inline]] void add_station(int k, Add add) const {
    add(fe::Index<N>{}, fe::Index<N>{}, ground[k]);
    add(fe::Index<V>{}, fe::Index<V>{}, bending_support);
    add(fe::Index<T>{}, fe::Index<T>{}, bending_support);
    if (k == 0) ends[0].template add<V>(add);
    if (k == stations - 1) ends[1].template add<V>(add);
  }

  template <class Add>
  [[gnu::always_inline]] void add_interval_start(int k, Add add) const {
    add(fe::Index<S>{}, fe::Index<S>{}, screw);
    add(fe::Index<S>{}, fe::Index<kFreedoms + S>{}, -screw);
    add(fe::Index<N>{}, fe::Index<N>{}, nut[k]);
    add(fe::Index<N>{}, fe::Index<kFreedoms + N>{}, -nut[k]);
    roller.template add_first<U>(add);
    roller.template add_coupling<U, kFreedoms + U>(add);
  }

  template <class Add>
  [[gnu::always_inline]] void add_interval_end(int k, Add add) const {
    add(fe::Index<S>{}, fe::Index<S>{}, screw);
    add(fe::Index<N>{}, fe::Index<N>{}, nut[k]);
    roller.template add_second<U>(add);
  }

  using State = fe::ChainState<Real, kFreedoms>;

  [[gnu::always_inline]] void add_forces(int k, const State& here, Real* force) const {
    force[N] += select(held(k, fe::Index<N>{}), Real(0.0), ground[k] * here.head[N]);
    if (k == 0) ends[0].template add_forces<V>(here, force);
    if (k == stations - 1) ends[1].template add_forces<V>(here, force);
  }

  [[gnu::always_inline]] void add_forces(int k, const State& here, const State& next, Real* force,
                                         Real* next_force) const {
    const Real screw_tension = screw * next.difference(S, here);
    force[S] -= screw_tension;
    next_force[S] += screw_tension;
    const Real nut_tension = nut[k] * next.difference(N, here);
    force[N] -= nut_tension;
    next_force[N] += nut_tension;
    roller.template add_forces<U, U>(here, next, force, next_force);
  }
};

}  // namespace prs
