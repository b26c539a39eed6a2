#pragma once

#include "fe/chain_station.h"
#include "prs/model/structure.h"
#include "prs/sector/chain/chain_sector.h"
#include "simd/inlined.h"

namespace prs {

/// One tooth of a sector of bars: screw u, nut u, roller u, v, r theta.
template <class Real>
struct BarStation {
  static constexpr int kFreedoms = 5;
  enum : int { S, N, U, V, T };
  static constexpr bool couples(int i, int j) { return i == j || (i >= V && j >= V); }

  /// Approach at screw and nut: coefficient 0 is s cos(psi), coefficient 1 sin(psi).
  template <int C>
  static constexpr std::array<fe::ChainTerm, 4> form() {
    if (C == 0) return {{{S, 0, false}, {U, 0, true}, {V, 1, true}, {T, 0, true}}};
    return {{{N, 0, true}, {U, 0, false}, {V, 1, false}, {T, 0, true}}};
  }

  int stations;
  Real axial_part[2];   ///< s cos(psi) of screw and nut.
  Real radial_part[2];  ///< sin(psi)
  Real screw;           ///< E A/p [N/m]
  RollerChain<Real> roller;
  const Real* nut;     ///< Stiffness to the next contact; 0 across the thrust section [N/m].
  const Real* ground;  ///< Stiffness from a contact to the thrust section, if no other contact lies between.

  PRS_INLINED const Real& coefficient(int contact, int kind) const {
    return kind == 0 ? axial_part[contact] : radial_part[contact];
  }

  template <int I>
  PRS_INLINED fe::Lanes<Real> held(int k, fe::Index<I>) const {
    if constexpr (I == N) return ground[k] > 1e300;
    if constexpr (I == V || I == T) return roller.bending_support > 1e300;
    return Real(0.0) > 1.0;
  }

  template <class Add>
  PRS_INLINED void add_station(int k, Add add) const {
    add(fe::Index<N>{}, fe::Index<N>{}, ground[k]);
    add(fe::Index<V>{}, fe::Index<V>{}, roller.bending_support);
    add(fe::Index<T>{}, fe::Index<T>{}, roller.bending_support);
    if (k == 0) roller.ends[0].template add<V>(add);
    if (k == stations - 1) roller.ends[1].template add<V>(add);
  }

  template <class Add>
  PRS_INLINED void add_interval_start(int k, Add add) const {
    add(fe::Index<S>{}, fe::Index<S>{}, screw);
    add(fe::Index<S>{}, fe::Index<kFreedoms + S>{}, -screw);
    add(fe::Index<N>{}, fe::Index<N>{}, nut[k]);
    add(fe::Index<N>{}, fe::Index<kFreedoms + N>{}, -nut[k]);
    roller.thread.template add_end<U>(add, 1.0);
    roller.thread.template add_coupling<U, kFreedoms + U>(add);
  }

  template <class Add>
  PRS_INLINED void add_interval_end(int k, Add add) const {
    add(fe::Index<S>{}, fe::Index<S>{}, screw);
    add(fe::Index<N>{}, fe::Index<N>{}, nut[k]);
    roller.thread.template add_end<U>(add, -1.0);
  }

  using State = fe::ChainState<Real, kFreedoms>;

  PRS_INLINED void add_forces(int k, const State& here, Real* force) const {
    force[N] += select(held(k, fe::Index<N>{}), Real(0.0), ground[k] * here.head[N]);
    if (k == 0) roller.ends[0].template add_forces<V>(here, force);
    if (k == stations - 1) roller.ends[1].template add_forces<V>(here, force);
  }

  PRS_INLINED void add_forces(int k, const State& here, const State& next, Real* force, Real* next_force) const {
    const Real screw_tension = screw * next.difference(S, here);
    force[S] -= screw_tension;
    next_force[S] += screw_tension;
    const Real nut_tension = nut[k] * next.difference(N, here);
    force[N] -= nut_tension;
    next_force[N] += nut_tension;
    roller.thread.template add_forces<U, U>(here, next, force, next_force);
  }
};

/// Stiffness of a nut of bars between the contacts and to the thrust section, from its compliance
/// int dx/(E A). flange(i) has `from`, `to` and `axial_rigidity`.
template <class Real, class ReadFlange>
class NutOfBars {
 public:
  NutOfBars(const SectorNumbers<Real>& numbers, std::size_t flanges, const ReadFlange& flange)
      : numbers_(numbers), plain_(1.0 / numbers.nut_rigidity), flanges_(flanges), flange_(flange) {
    for (std::size_t i = 0; i < kKept && i < flanges; ++i) kept_[i] = read(i);
  }

  void set(int contacts, Real* nut, Real* ground) const {
    const Real same = kSamePlace * numbers_.nut_length;
    const Real& thrust = numbers_.thrust;
    const Real none = thrust - thrust;  // NaN if the thrust section is
    const auto support = [&](const fe::Lanes<Real>& where, const Real& from, const Real& to) {
      return any(where) ? select(where, 1.0 / compliance(from, to), none) : none;
    };
    Real x = numbers_.position;
    ground[0] = support(thrust <= x - same, thrust, x);
    for (int k = 0; k < contacts; ++k) {
      ground[k] = select(abs(x - thrust) < same, Real(__builtin_inf()), ground[k]);
      if (k + 1 == contacts) {
        ground[k] += support(thrust >= x + same, x, thrust);
        break;
      }
      const Real next = numbers_.position + (k + 1) * numbers_.pitch;
      const fe::Lanes<Real> inside = (thrust >= x + same) & (thrust <= next - same);
      ground[k] += support(inside, x, thrust);
      ground[k + 1] = support(inside, thrust, next);
      nut[k] = select(inside, none, 1.0 / compliance(x, next));
      x = next;
    }
  }

 private:
  static constexpr std::size_t kKept = 4;  ///< Number of flanges that are read only once.
  /// Ends of a flange, and its 1/(E A) less that of the plain nut.
  struct Flange {
    Real from, to, less;
  };

  Flange read(std::size_t i) const {
    const auto f = flange_(i);
    return {f.from, f.to, 1.0 / f.axial_rigidity - plain_};
  }

  /// Compliance between two sections [m/N].
  Real compliance(const Real& from, const Real& to) const {
    Real sum = (to - from) * plain_;
    for (std::size_t i = 0; i < flanges_; ++i) {
      const Flange f = i < kKept ? kept_[i] : read(i);
      const Real covered = min(f.to, to) - max(f.from, from);
      sum += select(covered <= 0.0, Real(0.0), covered * f.less);
    }
    return sum;
  }

  const SectorNumbers<Real>& numbers_;
  Real plain_;
  std::size_t flanges_;
  const ReadFlange& flange_;
  Flange kept_[kKept];
};

}  // namespace prs
