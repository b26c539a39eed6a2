#pragma once

#include "fe/chain_station.h"
#include "prs/sector/chain/chain_sector.h"
#include "simd/inlined.h"

namespace prs {

/// One tooth of a refined sector: screw u; nut u, v, r theta; roller u, v, r theta, at two nodes if the contacts of a
/// tooth lie apart.
template <class Real, ChainSector::Kind kKind>
struct ShellStation {
  static constexpr bool kApart = kKind != ChainSector::Kind::shell;
  enum : int { S, N, U = 4, kLast = kApart ? 7 : 4, kFreedoms = kLast + 3 };

  static constexpr bool couples(int i, int j) {
    if (i == S || j == S) return i == j;
    if (i < U || j < U) return i < U && j < U;
    return i >= kLast && j < U + 3 && (i == kLast) == (j == U);
  }

  /// Approach at screw and nut: coefficient 0 is s cos(psi), coefficient 1 sin(psi), coefficient 2 that of the nut's
  /// rotation.
  template <int C>
  static constexpr auto form() {
    constexpr int kSecond = kApart ? kLast : U;
    constexpr bool kScrewFirst = kKind == ChainSector::Kind::apart_screw_first;
    constexpr int kScrew = kScrewFirst ? U : kSecond, kNut = kScrewFirst ? kSecond : U;
    if constexpr (C == 0)
      return std::array<fe::ChainTerm, 4>{
          {{S, 0, false}, {kScrew, 0, true}, {kScrew + 1, 1, true}, {kScrew + 2, 0, true}}};
    else
      return std::array<fe::ChainTerm, 6>{{{N, 0, true},
                                           {N + 1, 1, true},
                                           {N + 2, 2, false},
                                           {kNut, 0, false},
                                           {kNut + 1, 1, false},
                                           {kNut + 2, 0, true}}};
  }

  int stations;
  Real part[2][3];  ///< Coefficients of the approach of screw and nut.
  Real screw;
  RollerChain<Real> roller;
  const NutSegment<Real>* segments;
  const int* segment_of;  ///< Segment of the interval to the next station.
  const NutSupport<Real>* supports;

  /// Sets the members that stations take from a sector's numbers.
  void set_parts(const SectorNumbers<Real>& numbers, const Real& nut_rotation_part) {
    screw = numbers.screw_rigidity / numbers.pitch;
    for (const Interface i : kInterfaces) {
      Real* const of = part[static_cast<int>(i)];
      of[0] = numbers.sense * numbers.cosine[i];
      of[1] = numbers.sine[i];
      of[2] = nut_rotation_part;
    }
  }

  PRS_INLINED const Real& coefficient(int contact, int kind) const { return part[contact][kind]; }

  template <int I>
  PRS_INLINED fe::Lanes<Real> held(int k, fe::Index<I>) const {
    constexpr int kDiagonal[3] = {0, 3, 5};
    if constexpr (I >= N && I < U) return supports[k].stiffness[kDiagonal[I - N]] > 1e300;
    if constexpr (I > U && I != kLast) return roller.bending_support > 1e300;
    return Real(0.0) > 1.0;
  }

  template <class Add>
  PRS_INLINED void add_station(int k, Add add) const {
    add_triangle<N>(supports[k].stiffness, add);
    const auto hold = [&](auto i) PRS_INLINED { add(i, i, roller.bending_support); };
    hold(fe::Index<U + 1>{});
    hold(fe::Index<U + 2>{});
    if constexpr (kApart) {
      hold(fe::Index<kLast + 1>{});
      hold(fe::Index<kLast + 2>{});
      roller.tooth.template add_end<U>(add, 1.0);
      roller.tooth.template add_coupling<U, kLast>(add);
      roller.tooth.template add_end<kLast>(add, -1.0);
    }
    if (k == 0) roller.ends[0].template add<U + 1>(add);
    if (k == stations - 1) roller.ends[1].template add<kLast + 1>(add);
  }

  template <class Add>
  PRS_INLINED void add_interval_start(int k, Add add) const {
    add(fe::Index<S>{}, fe::Index<S>{}, screw);
    add(fe::Index<S>{}, fe::Index<kFreedoms + S>{}, -screw);
    const NutSegment<Real>& segment = segments[segment_of[k]];
    add_triangle<N>(segment.first, add);
    fe::unroll<3>([&](auto i) PRS_INLINED {
      fe::unroll<3>([&](auto j) PRS_INLINED {
        add(fe::Index<N + i>{}, fe::Index<kFreedoms + N + j>{}, segment.coupling[3 * i + j]);
      });
    });
    roller.thread.template add_end<kLast>(add, 1.0);
    roller.thread.template add_coupling<kLast, kFreedoms + U>(add);
  }

  template <class Add>
  PRS_INLINED void add_interval_end(int k, Add add) const {
    add(fe::Index<S>{}, fe::Index<S>{}, screw);
    add_triangle<N>(segments[segment_of[k]].second, add);
    roller.thread.template add_end<U>(add, -1.0);
  }

  using State = fe::ChainState<Real, kFreedoms>;

  PRS_INLINED void add_forces(int k, const State& here, Real* force) const {
    const Real* stiffness = supports[k].stiffness;
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j, ++stiffness) {
        const Real finite = select(*stiffness > 1e300, Real(0.0), *stiffness);
        force[N + i] += finite * (here.head[N + j] + here.tail[N + j]);
        if (i != j) force[N + j] += finite * (here.head[N + i] + here.tail[N + i]);
      }
    if constexpr (kApart) roller.tooth.template add_forces<U, kLast>(here, here, force, force);
    if (k == 0) roller.ends[0].template add_forces<U + 1>(here, force);
    if (k == stations - 1) roller.ends[1].template add_forces<kLast + 1>(here, force);
  }

  PRS_INLINED void add_forces(int k, const State& here, const State& next, Real* force, Real* next_force) const {
    const Real tension = screw * next.difference(S, here);
    force[S] -= tension;
    next_force[S] += tension;
    roller.thread.template add_forces<kLast, U>(here, next, force, next_force);

    Real deformation[6], f[6];
    for (int i = 0; i < 3; ++i) {
      deformation[i] = next.difference(N + i, here);
      deformation[3 + i] = 0.5 * (here.head[N + i] + next.head[N + i]) + 0.5 * (here.tail[N + i] + next.tail[N + i]);
      f[i] = f[3 + i] = Real(0.0);
    }
    const Real* stiffness = segments[segment_of[k]].deformation;
    for (int i = 0; i < 6; ++i)
      for (int j = i; j < 6; ++j, ++stiffness) {
        f[i] += *stiffness * deformation[j];
        if (i != j) f[j] += *stiffness * deformation[i];
      }
    for (int i = 0; i < 3; ++i) {
      force[N + i] += 0.5 * f[3 + i] - f[i];
      next_force[N + i] += 0.5 * f[3 + i] + f[i];
    }
  }

 private:
  template <int First, class Add>
  PRS_INLINED static void add_triangle(const Real* stiffness, Add add) {
    add(fe::Index<First>{}, fe::Index<First>{}, stiffness[0]);
    add(fe::Index<First>{}, fe::Index<First + 1>{}, stiffness[1]);
    add(fe::Index<First>{}, fe::Index<First + 2>{}, stiffness[2]);
    add(fe::Index<First + 1>{}, fe::Index<First + 1>{}, stiffness[3]);
    add(fe::Index<First + 1>{}, fe::Index<First + 2>{}, stiffness[4]);
    add(fe::Index<First + 2>{}, fe::Index<First + 2>{}, stiffness[5]);
  }
};

}  // namespace prs
