#pragma once

#include "fe/chain_station.h"

namespace fe {

/// What the tangent is solved for: the contacts' remainders and
template <class Real>
struct ChainResidual {
  Real load;         ///< against the loaded freedom, 0 of station 0 [N],
  bool corrections;  ///< and `ChainRecord::correction`.
};

/// Gaussian elimination with the tangent, station by station, its factors and the solution left in
/// the records.
template <class Real, class Station>
class ChainElimination {
 public:
  using Record = ChainRecord<Real, Station>;
  using Mask = Lanes<Real>;
  static constexpr int M = Station::kFreedoms;

  explicit ChainElimination(const ChainStations<Real, Station>& chain)
      : station_(chain.station), stations_(chain.count), records_(chain.records) {}

  /// Factors the tangent, with its linear part times 1 + shift, and does the forward half of the
  /// solve. Calls move(record) of each station first. True where a pivot is not positive. One code
  /// for all shifts: a chain without one has the same bits whatever its neighbours need.
  template <class Move>
  Mask factorize(const ChainResidual<Real>& residual, const Real& shift, const Move& move) const {
    Front front;
    unroll<2 * M>([&](auto i) __attribute__((always_inline)) {
      front.right[i] = Real(0.0);
      unroll<2 * M>([&](auto j) __attribute__((always_inline)) {
        front.a[i][j] = front.added[i][j] = Real(0.0);
      });
    });
    front.right[0] = -residual.load;
    const Real scale = 1.0 + shift;
    Real smallest(1e300);  // pivot; one that is no number makes those after it so
    const int last = stations_ - 1;
    for (int k = 0; k < last; ++k) {
      move(records_[k]);
      assemble<true>(k, residual.corrections, scale, front);
      eliminate<2 * M>(records_[k], front, smallest);
      pass_on(k, scale, front);
    }
    move(records_[last]);
    assemble<kFolded<Station>>(last, residual.corrections, scale, front);
    if constexpr (kFolded<Station>) meet(records_[last], front, smallest);
    eliminate<M>(records_[last], front, smallest);
    return !(-of_both<Station>(Real(-smallest)) > 0.0);
  }

  /// Backward half: the step at station k from that at the next one, which it replaces.
  [[gnu::always_inline]] void substitute_back(int k, Real* next) const {
    if (k == stations_ - 1)
      substitute_back<true>(records_[k], next);
    else
      substitute_back<false>(records_[k], next);
  }

 private:
  /// Upper triangle and right-hand side of a station and the next one. `added` collects what the
  /// stations bring, apart from what eliminations leave, which is late.
  struct Front {
    Real a[2 * M][2 * M];
    Real added[2 * M][2 * M];
    Real right[2 * M];
  };

  /// add(i, j, value) of a station into the front; `scale` is that of the diagonal.
  [[gnu::always_inline]] static auto adder(const Real& scale, Front& front) {
    return [&](auto i, auto j, const Real& value) __attribute__((always_inline)) {
      if constexpr (i == j)
        front.added[i][j] += scale * value;
      else
        front.added[i][j] += value;
    };
  }

  template <bool kWithInterval>
  [[gnu::always_inline]] void assemble(int k, bool corrections, const Real& scale,
                                       Front& front) const {
    const Record& record = records_[k];
    const auto add = adder(scale, front);
    station_.add_station(k, add);
    if constexpr (kWithInterval) station_.add_interval_start(k, add);
    unroll<2>([&](auto c) __attribute__((always_inline)) {
      const auto& contact = record.contact[c];
      add_tangent<c>(station_, front.added, contact.tangent);
      add_along<c>(station_, front.right, contact.remainder);
    });
    if (corrections)
      unroll<M>([&](auto i)
                    __attribute__((always_inline)) { front.right[i] += record.correction[i]; });

    unroll<M>([&](auto i) __attribute__((always_inline)) {
      unroll<M>([&](auto j) __attribute__((always_inline)) { front.a[i][j] += front.added[i][j]; });
      unroll<M>([&](auto j)
                    __attribute__((always_inline)) { front.a[i][M + j] = front.added[i][M + j]; });
    });
  }

  /// Eliminates a station from the first kReach freedoms of the front.
  template <int kReach>
  [[gnu::always_inline]] static void eliminate(Record& record, Front& front, Real& smallest) {
    static constexpr const ChainFill<Station>& fill = kChainFill<Station>;
    unroll<M>([&](auto p) __attribute__((always_inline)) {
      smallest = min(smallest, front.a[p][p]);
      const Real inverse = 1.0 / front.a[p][p];
      record.step[p] = front.right[p] * inverse;
      unroll<kReach>([&](auto j) __attribute__((always_inline)) {
        if constexpr (j > p && fill.meets[p][j]) {
          const Real multiplier = front.a[p][j] * inverse;
          record.multiplier[fill.place[p][j]] = multiplier;
          front.right[j] -= multiplier * front.right[p];
          unroll<kReach>([&](auto i) __attribute__((always_inline)) {
            if constexpr (i == j && j == p + 1)  // the next pivot, the sooner the better
              front.a[j][j] -= front.a[p][j] * front.a[p][j] * inverse;
            else if constexpr (i >= j && fill.meets[p][i])
              front.a[j][i] -= multiplier * front.a[p][i];
          });
        }
      });
    });
  }

  /// The next station's part of the front becomes the first.
  [[gnu::always_inline]] void pass_on(int k, const Real& scale, Front& front) const {
    unroll<M>([&](auto i) __attribute__((always_inline)) {
      front.right[i] = front.right[M + i];
      front.right[M + i] = Real(0.0);
      unroll<M>([&](auto j) __attribute__((always_inline)) {
        front.a[i][j] = front.a[M + i][M + j];
        front.a[M + i][M + j] = front.added[i][j] = front.added[i][M + j] = Real(0.0);
      });
    });
    station_.add_interval_end(k, adder(scale, front));
  }

  /// Joins both halves in the middle: each lane's last station gets what the elimination of the
  /// other lane's last station adds to it.
  [[gnu::always_inline]] static void meet(Record& record, Front& front, Real& smallest) {
    Front own;
    unroll<M>([&](auto i) __attribute__((always_inline)) {
      own.right[i] = front.right[i];
      unroll<M>([&](auto j) __attribute__((always_inline)) { own.a[i][j] = front.a[i][j]; });
    });
    eliminate<2 * M>(record, front, smallest);
    unroll<M>([&](auto i) __attribute__((always_inline)) {
      front.right[i] = own.right[i] + mirrored(front.right[M + i]);
      unroll<M>([&](auto j) __attribute__((always_inline)) {
        if constexpr (j >= i) front.a[i][j] = own.a[i][j] + mirrored(front.a[M + i][M + j]);
      });
    });
  }

  template <bool kLast>
  [[gnu::always_inline]] static void substitute_back(Record& record, Real* next) {
    static constexpr const ChainFill<Station>& fill = kChainFill<Station>;
    Real d[2 * M];
    if constexpr (!kLast)
      unroll<M>([&](auto i) __attribute__((always_inline)) { d[M + i] = next[i]; });
    unroll<M>([&](auto back) __attribute__((always_inline)) {
      constexpr int p = M - 1 - back;
      Real x = record.step[p];
      unroll<kLast ? M : 2 * M>([&](auto reverse) __attribute__((always_inline)) {
        constexpr int j = (kLast ? M : 2 * M) - 1 - reverse;
        if constexpr (j > p && fill.meets[p][j]) x -= record.multiplier[fill.place[p][j]] * d[j];
      });
      d[p] = record.step[p] = next[p] = x;
    });
  }

  const Station& station_;
  int stations_;
  Record* records_;
};

/// Walks along the chain for the forces of its linear elements. Calls move(record) of each station
/// before its state is read.
template <class Real, class Station, class Move>
class ChainForces {
 public:
  static constexpr int M = Station::kFreedoms;

  ChainForces(const ChainStations<Real, Station>& chain, const Move& move)
      : chain_(chain), move_(move) {
    set_zero(carried_);
    move_(chain_.records[0]);
  }

  /// Forces at the next station k.
  [[gnu::always_inline]] void at(int k, Real* force) {
    const auto& record = chain_.records[k];
    Real next[M];
    set_zero(next);
    unroll<M>([&](auto i) __attribute__((always_inline)) { force[i] = carried_[i]; });
    chain_.station.add_forces(k, record.state, force);
    if (k + 1 < chain_.count) {
      move_(chain_.records[k + 1]);
      chain_.station.add_forces(k, record.state, chain_.records[k + 1].state, force, next);
    }
    if constexpr (kFolded<Station>)
      if (k + 1 == chain_.count) {
        ChainState<Real, M> beyond;
        unroll<M>([&](auto i) __attribute__((always_inline)) {
          beyond.head[i] = mirrored(record.state.head[i]);
          beyond.tail[i] = mirrored(record.state.tail[i]);
        });
        chain_.station.add_forces(k, record.state, beyond, force, next);
      }
    unroll<M>([&](auto i) __attribute__((always_inline)) { carried_[i] = next[i]; });
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

/// Residual of the states under the load on freedom 0 of station 0. Where marked, what of the
/// residual is not the contacts' remainders becomes the correction; elsewhere, unless `active`,
/// corrections stay.
template <class Real, class Station, class Move>
WholeResidual<Real> whole_residual(const ChainStations<Real, Station>& chain, const Real& load,
                                   const Move& move, const Lanes<Real>& marked,
                                   const Lanes<Real>& active) {
  constexpr int M = Station::kFreedoms;
  Real worst(0.0), energy(0.0);
  ChainForces<Real, Station, Move> forces(chain, move);
  for (int k = 0; k < chain.count; ++k) {
    auto& record = chain.records[k];
    Real force[M], remainder[M];
    forces.at(k, force);
    unroll<M>([&](auto i) __attribute__((always_inline)) {
      energy += 0.5 * record.state.head[i] * force[i];
    });
    if (k == 0) {
      force[0] -= load;
      energy -= load * record.state.head[0];
    }
    set_zero(remainder);
    unroll<2>([&](auto i) __attribute__((always_inline)) {
      const auto& c = record.contact[i];
      add_along<i>(chain.station, force, Real(c.force - c.remainder));
      add_along<i>(chain.station, remainder, c.remainder);
    });
    unroll<M>([&](auto i) __attribute__((always_inline)) {
      const Lanes<Real> held = chain.station.held(k, i);
      const Real none(0.0);
      const Real unmarked = select(active, none, record.correction[i]);
      record.correction[i] = select(marked, select(held, none, force[i]), unmarked);
      worst = max(worst, select(held, Real(0.0), abs(force[i] + remainder[i])));
    });
  }
  energy = total<Station>(energy);
  worst = of_both<Station>(worst);
  // The largest of numbers some of which are none can be any; their sum is none.
  return {select(energy <= energy, worst, energy), energy};
}

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
