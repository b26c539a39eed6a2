#pragma once

#include "fe/chain_elimination.h"
#include "fe/chain_forces.h"

namespace fe {

/// Corrections become f - K x, x being the states and f `load` on the loaded freedom; x'(f - K x).
template <class Real, class Station>
Real tangent_residual(const ChainStations<Real, Station>& chain, const Real& load) {
  constexpr int M = Station::kFreedoms;
  const auto stay = [](const auto&) {};
  ChainForces<Real, Station, decltype(stay)> forces(chain, stay);
  Real work(0.0);
  for (int k = 0; k < chain.count; ++k) {
    auto& record = chain.records[k];
    Real force[M];
    forces.at(k, force);
    if (k == 0) force[0] -= load;
    unroll<2>([&](auto i) __attribute__((always_inline)) {
      const Real approach =
          along<i>(chain.station, record.state.head) + along<i>(chain.station, record.state.tail);
      add_along<i>(chain.station, force, Real(record.contact[i].tangent * approach));
    });
    unroll<M>([&](auto i) __attribute__((always_inline)) {
      record.correction[i] = select(chain.station.held(k, i), Real(0.0), -force[i]);
      work += record.state.head[i] * record.correction[i];
    });
  }
  return total<Station>(work);
}

/// Displacement of the loaded freedom by `unit_load` there with the tangent K of the contacts, in
/// place of the states, where `wanted`; NaN elsewhere, and where K is singular or its factors have
/// too few digits.
///
/// With x the solution so far, K x = f - r, it is x'f + x'r but for the square of the error of x:
/// x is refined until the second part is small.
template <class Real, class Station>
Real chain_flexibility(const ChainStations<Real, Station>& chain, const Real& unit_load,
                       const Lanes<Real>& wanted) {
  constexpr int M = Station::kFreedoms, kMostRefinements = 10;
  constexpr double kTolerance = 1e-11;
  const ChainElimination<Real, Station> elimination(chain);
  // Steps become K^-1 of the right-hand side. False where K is singular.
  const auto solve = [&](const ChainResidual<Real>& right) {
    const Lanes<Real> regular = !elimination.factorize(right, Real(0.0), [](const auto&) {});
    Real next[M];
    set_zero(next);
    for (int k = chain.count - 1; k >= 0; --k) elimination.substitute_back(k, next);
    return regular;
  };

  for (int k = 0; k < chain.count; ++k)
    for (auto& c : chain.records[k].contact) c.remainder = Real(0.0);
  Lanes<Real> searching = solve({-unit_load, false}) & wanted;
  for (int k = 0; k < chain.count; ++k)
    unroll<M>([&](auto i) __attribute__((always_inline)) {
      chain.records[k].state.head[i] = chain.records[k].step[i];
      chain.records[k].state.tail[i] = Real(0.0);
    });
  Real flexibility(__builtin_nan(""));
  for (int refinement = 0; any(searching); ++refinement) {
    const Real left = tangent_residual(chain, unit_load);
    const Real found = total<Station>(Real(unit_load * chain.records[0].state.head[0]));
    const Lanes<Real> known = searching & (abs(left) <= kTolerance * found);
    flexibility = select(known, found + left, flexibility);
    searching = searching & !known;
    if (!any(searching) || refinement == kMostRefinements) break;
    searching = searching & solve({Real(0.0), true});
    for (int k = 0; k < chain.count; ++k)
      unroll<M>([&](auto i) __attribute__((always_inline)) {
        chain.records[k].state.move_back(i, -chain.records[k].step[i], searching);
      });
  }
  return flexibility;
}

}  // namespace fe
