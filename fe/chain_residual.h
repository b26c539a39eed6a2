#pragma once

#include "fe/chain_station.h"
#include "simd/inlined.h"

namespace fe {

/// Walks along the chain for the forces of its linear elements. Calls move(record) of each station
/// before its state is read.
template <class Real, class Station, class Move>
class ChainForces {
 public:
  static constexpr int M = Station::kFreedoms;

  ChainForces(const ChainStations<Real, Station>& chain, const Move& move) : chain_(chain), move_(move) {
    set_zero(carried_);
    move_(chain_.records[0]);
  }

  /// Forces at the next station k.
  PRS_INLINED void at(int k, Real* force) {
    const auto& record = chain_.records[k];
    Real next[M];
    set_zero(next);
    unroll<M>([&](auto i) PRS_INLINED { force[i] = carried_[i]; });
    chain_.station.add_forces(k, record.state, force);
    if (k + 1 < chain_.count) {
      move_(chain_.records[k + 1]);
      chain_.station.add_forces(k, record.state, chain_.records[k + 1].state, force, next);
    }
    if constexpr (kFolded<Station>)
      if (k + 1 == chain_.count) {
        ChainState<Real, M> beyond;
        unroll<M>([&](auto i) PRS_INLINED {
          beyond.head[i] = Station::mirrored(record.state.head[i]);
          beyond.tail[i] = Station::mirrored(record.state.tail[i]);
        });
        chain_.station.add_forces(k, record.state, beyond, force, next);
      }
    unroll<M>([&](auto i) PRS_INLINED { carried_[i] = next[i]; });
  }

 private:
  const ChainStations<Real, Station>& chain_;
  const Move& move_;
  Real carried_[M];  ///< Forces of the interval to the next station.
};

template <class Real>
struct WholeResidual {
  Real worst;          ///< Largest of all freedoms [N].
  Real linear_energy;  ///< Energy of the linear elements and the load [J].
};

/// Residual of the states under the load on freedom 0 of station 0. In marked lanes the correction
/// becomes the residual less the contacts' remainders; in others it becomes 0 where `active`, and
/// stays where not.
template <class Real, class Station, class Move>
WholeResidual<Real> whole_residual(const ChainStations<Real, Station>& chain, const Real& load, const Move& move,
                                   const Lanes<Real>& marked, const Lanes<Real>& active) {
  constexpr int M = Station::kFreedoms;
  Real worst(0.0), energy(0.0);
  ChainForces<Real, Station, Move> forces(chain, move);
  for (int k = 0; k < chain.count; ++k) {
    auto& record = chain.records[k];
    Real force[M], remainder[M];
    forces.at(k, force);
    unroll<M>([&](auto i) PRS_INLINED { energy += 0.5 * record.state.head[i] * force[i]; });
    if (k == 0) {
      force[0] -= load;
      energy -= load * record.state.head[0];
    }
    set_zero(remainder);
    unroll<2>([&](auto i) PRS_INLINED {
      const auto& c = record.contact[i];
      add_along<i>(chain.station, force, Real(c.force - c.remainder));
      add_along<i>(chain.station, remainder, c.remainder);
    });
    unroll<M>([&](auto i) PRS_INLINED {
      const Lanes<Real> held = chain.station.held(k, i);
      const Real none(0.0);
      const Real unmarked = select(active, none, record.correction[i]);
      record.correction[i] = select(marked, select(held, none, force[i]), unmarked);
      worst = max(worst, select(held, Real(0.0), abs(force[i] + remainder[i])));
    });
  }
  energy = total<Station>(energy);
  worst = of_both<Station>(worst);
  // The maximum of numbers of which some are NaN can be any of them; their sum is NaN.
  return {select(energy <= energy, worst, energy), energy};
}

/// Sets the corrections to f - K x, x being the states and f `load` on the loaded freedom. Returns
/// x'(f - K x).
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
    unroll<2>([&](auto i) PRS_INLINED {
      const Real approach = along<i>(chain.station, record.state.head) + along<i>(chain.station, record.state.tail);
      add_along<i>(chain.station, force, Real(record.contact[i].tangent * approach));
    });
    unroll<M>([&](auto i) PRS_INLINED {
      record.correction[i] = select(chain.station.held(k, i), Real(0.0), -force[i]);
      work += record.state.head[i] * record.correction[i];
    });
  }
  return total<Station>(work);
}

}  // namespace fe
