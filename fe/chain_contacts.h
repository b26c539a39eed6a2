#pragma once

#include "fe/chain_elimination.h"

namespace fe {

/// Sums over the contacts at a full step d: energy E, force N, tangent t, change of net approach
/// delta.
template <class Real>
struct ChainStepSums {
  Real energy = Real(0.0);     ///< E after the step [J]
  Real work = Real(0.0);       ///< N delta
  Real stiffness = Real(0.0);  ///< t delta^2
  Real slope = Real(0.0);      ///< d'r, r the residual before the step
  Real left = Real(0.0);  ///< Largest difference of a force from its tangent after the step [N].
};

/// Backward half of the solve for the residual; the contacts that are active after the full step.
template <class Real, class Station, class Law>
ChainStepSums<Real> full_step(const ChainElimination<Real, Station>& elimination,
                              const ChainStations<Real, Station>& chain, const Law& law,
                              const ChainResidual<Real>& residual, const Lanes<Real>& active) {
  constexpr int M = Station::kFreedoms;
  ChainStepSums<Real> s;
  Real d[M];
  set_zero(d);
  for (int k = chain.count - 1; k >= 0; --k) {
    auto& record = chain.records[k];
    elimination.substitute_back(k, d);
    unroll<2>([&](auto i) __attribute__((always_inline)) {
      auto& c = record.contact[i];
      const Real change = along<i>(chain.station, d);
      const Real net_approach = c.net_approach - change;
      const ChainResponse<Real> r = law.evaluate(i, k, net_approach);
      s.energy += r.energy;
      s.work += c.force * change;
      s.stiffness += c.tangent * change * change;
      s.slope += c.remainder * change;
      const Real remainder = (r.force - c.force) + c.tangent * change;
      s.left = max(s.left, abs(remainder));
      c.net_approach = select(active, net_approach, c.net_approach);
      c.force = select(active, r.force, c.force);
      c.tangent = select(active, r.tangent, c.tangent);
      c.remainder = select(active, remainder, c.remainder);
    });
    if (residual.corrections)
      unroll<M>([&](auto i)
                    __attribute__((always_inline)) { s.slope += record.correction[i] * d[i]; });
  }
  s.slope -= residual.load * d[0];
  return {total<Station>(s.energy), total<Station>(s.work), total<Station>(s.stiffness),
          total<Station>(s.slope), of_both<Station>(s.left)};
}

/// Takes the contacts marked back by a share of the last step; their energies there.
template <class Real, class Station, class Law>
Real take_back(const ChainStations<Real, Station>& chain, const Law& law, const Real& share,
               const Lanes<Real>& marked) {
  Real energy(0.0);
  for (int k = 0; k < chain.count; ++k) {
    auto& record = chain.records[k];
    unroll<2>([&](auto i) __attribute__((always_inline)) {
      auto& c = record.contact[i];
      const Real net_approach = c.net_approach + share * along<i>(chain.station, record.step);
      const ChainResponse<Real> r = law.evaluate(i, k, net_approach);
      energy += r.energy;
      c.net_approach = select(marked, net_approach, c.net_approach);
      c.force = select(marked, r.force, c.force);
      c.tangent = select(marked, r.tangent, c.tangent);
    });
  }
  return total<Station>(energy);
}

/// What rounding of the displacements can change in a contact's force, relative to the largest.
template <class Real, class Station>
Real approach_rounding(const ChainStations<Real, Station>& chain) {
  constexpr int M = Station::kFreedoms;
  Real largest_change(0.0), largest_force(0.0);
  for (int k = 0; k < chain.count; ++k) {
    const auto& record = chain.records[k];
    Real size(0.0);
    unroll<M>([&](auto i)
                  __attribute__((always_inline)) { size = max(size, abs(record.state.head[i])); });
    unroll<2>([&](auto i) __attribute__((always_inline)) {
      largest_change = max(largest_change, record.contact[i].tangent * size);
      largest_force = max(largest_force, record.contact[i].force);
    });
  }
  return 4.0 * 2.220446049250313e-16 * of_both<Station>(largest_change) /
         of_both<Station>(largest_force);
}

/// Largest change of a contact's force by the last step, relative to the largest force.
template <class Real, class Station>
Real force_change(const ChainStations<Real, Station>& chain) {
  Real largest_change(0.0), largest_force(0.0);
  for (int k = 0; k < chain.count; ++k) {
    const auto& record = chain.records[k];
    unroll<2>([&](auto i) __attribute__((always_inline)) {
      const auto& c = record.contact[i];
      largest_change = max(largest_change, c.tangent * abs(along<i>(chain.station, record.step)));
      largest_force = max(largest_force, c.force);
    });
  }
  return of_both<Station>(largest_change) / of_both<Station>(largest_force);
}

}  // namespace fe
