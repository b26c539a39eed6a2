#pragma once

#include "fe/chain_station.h"
#include "simd/inlined.h"

namespace fe {

/// Right-hand side of a solve with the tangent, besides the contacts' remainders.
template <class Real>
struct ChainResidual {
  Real load;         ///< Load against the loaded freedom, freedom 0 of station 0 [N].
  bool corrections;  ///< Adds `ChainRecord::correction`.
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
  /// solve. Calls move(record) of each station first. Returns true where a pivot is not positive. The
  /// same code serves all shifts: a chain without a shift has the same bits whatever its neighbours
  /// need.
  template <class Move>
  Mask factorize(const ChainResidual<Real>& residual, const Real& shift, const Move& move) const {
    Front front;
    unroll<2 * M>([&](auto i) PRS_INLINED {
      front.right[i] = Real(0.0);
      unroll<2 * M>([&](auto j) PRS_INLINED { front.a[i][j] = front.added[i][j] = Real(0.0); });
    });
    front.right[0] = -residual.load;
    const Real scale = 1.0 + shift;
    Real smallest(1e300);  // Smallest pivot; one that is NaN makes all later ones NaN.
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
  PRS_INLINED void substitute_back(int k, Real* next) const {
    if (k == stations_ - 1)
      substitute_back<true>(records_[k], next);
    else
      substitute_back<false>(records_[k], next);
  }

 private:
  /// Upper triangle and right-hand side of a station and the next one. `added` collects the stations'
  /// own terms, apart from the terms of eliminations, which are computed later.
  struct Front {
    Real a[2 * M][2 * M];
    Real added[2 * M][2 * M];
    Real right[2 * M];
  };

  /// Function add(i, j, value) that adds a station's terms to the front, those of the diagonal times
  /// `scale`.
  PRS_INLINED static auto adder(const Real& scale, Front& front) {
    return [&](auto i, auto j, const Real& value) PRS_INLINED {
      if constexpr (i == j)
        front.added[i][j] += scale * value;
      else
        front.added[i][j] += value;
    };
  }

  template <bool kWithInterval>
  PRS_INLINED void assemble(int k, bool corrections, const Real& scale, Front& front) const {
    const Record& record = records_[k];
    const auto add = adder(scale, front);
    station_.add_station(k, add);
    if constexpr (kWithInterval) station_.add_interval_start(k, add);
    unroll<2>([&](auto c) PRS_INLINED {
      const auto& contact = record.contact[c];
      add_tangent<c>(station_, front.added, contact.tangent);
      add_along<c>(station_, front.right, contact.remainder);
    });
    if (corrections) unroll<M>([&](auto i) PRS_INLINED { front.right[i] += record.correction[i]; });

    unroll<M>([&](auto i) PRS_INLINED {
      unroll<M>([&](auto j) PRS_INLINED { front.a[i][j] += front.added[i][j]; });
      unroll<M>([&](auto j) PRS_INLINED { front.a[i][M + j] = front.added[i][M + j]; });
    });
  }

  /// Eliminates a station from the first kReach freedoms of the front.
  template <int kReach>
  PRS_INLINED static void eliminate(Record& record, Front& front, Real& smallest) {
    static constexpr const ChainFill<Station>& fill = kChainFill<Station>;
    unroll<M>([&](auto p) PRS_INLINED {
      smallest = min(smallest, front.a[p][p]);
      const Real inverse = 1.0 / front.a[p][p];
      record.step[p] = front.right[p] * inverse;
      unroll<kReach>([&](auto j) PRS_INLINED {
        if constexpr (j > p && fill.meets[p][j]) {
          const Real multiplier = front.a[p][j] * inverse;
          record.multiplier[fill.place[p][j]] = multiplier;
          front.right[j] -= multiplier * front.right[p];
          unroll<kReach>([&](auto i) PRS_INLINED {
            if constexpr (i == j && j == p + 1)  // The next pivot, on which the next elimination waits.
              front.a[j][j] -= front.a[p][j] * front.a[p][j] * inverse;
            else if constexpr (i >= j && fill.meets[p][i])
              front.a[j][i] -= multiplier * front.a[p][i];
          });
        }
      });
    });
  }

  /// Moves the next station's part of the front to the place of the first.
  PRS_INLINED void pass_on(int k, const Real& scale, Front& front) const {
    unroll<M>([&](auto i) PRS_INLINED {
      front.right[i] = front.right[M + i];
      front.right[M + i] = Real(0.0);
      unroll<M>([&](auto j) PRS_INLINED {
        front.a[i][j] = front.a[M + i][M + j];
        front.a[M + i][M + j] = front.added[i][j] = front.added[i][M + j] = Real(0.0);
      });
    });
    station_.add_interval_end(k, adder(scale, front));
  }

  /// Joins both halves in the middle: each lane's last station gets what the elimination of the
  /// other lane's last station adds to it.
  PRS_INLINED static void meet(Record& record, Front& front, Real& smallest) {
    Front own;
    unroll<M>([&](auto i) PRS_INLINED {
      own.right[i] = front.right[i];
      unroll<M>([&](auto j) PRS_INLINED { own.a[i][j] = front.a[i][j]; });
    });
    eliminate<2 * M>(record, front, smallest);
    unroll<M>([&](auto i) PRS_INLINED {
      front.right[i] = own.right[i] + Station::mirrored(front.right[M + i]);
      unroll<M>([&](auto j) PRS_INLINED {
        if constexpr (j >= i) front.a[i][j] = own.a[i][j] + Station::mirrored(front.a[M + i][M + j]);
      });
    });
  }

  template <bool kLast>
  PRS_INLINED static void substitute_back(Record& record, Real* next) {
    static constexpr const ChainFill<Station>& fill = kChainFill<Station>;
    Real d[2 * M];
    if constexpr (!kLast) unroll<M>([&](auto i) PRS_INLINED { d[M + i] = next[i]; });
    unroll<M>([&](auto back) PRS_INLINED {
      constexpr int p = M - 1 - back;
      Real x = record.step[p];
      unroll<kLast ? M : 2 * M>([&](auto reverse) PRS_INLINED {
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

}  // namespace fe
