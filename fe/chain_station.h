#pragma once

#include <array>

#include "fe/lanes.h"
#include "simd/inlined.h"

/// A chain of equal stations, each with two unilateral contacts, solved station by station. `Real` is a number or a
/// batch of numbers: several chains side by side, each with its own convergence.
///
/// A `Station` defines the linear part and the contacts:
///
/// - `kFreedoms`: M, freedoms of a station
/// - `couples(i, j)`: whether the interval to the next station couples freedom i with j there
/// - `form<contact>()`: terms of the contact's approach, a linear form of the freedoms
/// - `coefficient(contact, kind)`: coefficient of the terms of this kind in that form
/// - `held(k, Index<i>)`: whether freedom i of station k cannot move
/// - `add_station(k, add)`: stiffness of supports and elements within station k
/// - `add_interval_start(k, add)`: terms of the interval from k to k + 1 at k, and its coupling
/// - `add_interval_end(k, add)`: its terms at k + 1
/// - `add_forces(k, here, force)`: the forces of elements within a station, from their deformations
/// - `add_forces(k, here, next, force, next_force)`: the forces of the interval
///
/// with add(Index<i>, Index<j>, value) for i <= j, j >= M meaning freedom j - M of the next station. A held freedom has
/// a support of infinite stiffness: the inverse of its pivot is exactly 0, and so is all that its elimination adds.
///
/// A `Law` defines the contacts' force: evaluate(contact, k, net approach) -> ChainResponse.

namespace fe {

/// sign * coefficient(kind) times a freedom.
struct ChainTerm {
  int freedom = 0;
  int kind = 0;
  bool negative = false;
};

template <class Real>
struct ChainResponse {
  Real energy;   ///< [J]
  Real force;    ///< [N]
  Real tangent;  ///< [N/m]
};

/// Displacements of one station as unevaluated sums head + tail (see State).
template <class Real, int M>
struct ChainState {
  Real head[M];
  Real tail[M];

  /// Difference of a freedom here and at `from`.
  PRS_INLINED Real difference(int i, const ChainState& from) const {
    return (head[i] - from.head[i]) + (tail[i] - from.tail[i]);
  }

  /// Subtracts the step where `move`.
  template <class Mask>
  PRS_INLINED void move_back(int i, const Real& step, const Mask& move) {
    const Real change = tail[i] - step;
    const Real sum = head[i] + change;
    const Real rounded = sum - head[i];
    tail[i] = select(move, (head[i] - (sum - rounded)) + (change - rounded), tail[i]);
    head[i] = select(move, sum, head[i]);
  }
};

/// Freedoms coupled to each pivot of a station once the pivots before it are eliminated: M of the station itself, then
/// M of the next one.
template <class Station>
struct ChainFill {
  static constexpr int M = Station::kFreedoms;
  std::array<std::array<bool, 2 * M>, M> meets{};
  std::array<std::array<int, 2 * M>, M> place{};  ///< Index of the multiplier in storage.
  int multipliers = 0;

  constexpr ChainFill() {
    std::array<std::array<bool, 2 * M>, 2 * M> filled{};
    for (std::size_t i = 0; i < M; ++i)
      for (std::size_t j = i + 1; j < 2 * M; ++j)
        filled[i][j] = j < M || Station::couples(static_cast<int>(i), static_cast<int>(j) - M);
    for (std::size_t p = 0; p < M; ++p)
      for (std::size_t j = p + 1; j < 2 * M; ++j) {
        if (!filled[p][j]) continue;
        meets[p][j] = true;
        place[p][j] = multipliers++;
        for (std::size_t i = p + 1; i < j; ++i) filled[i][j] = filled[i][j] || filled[p][i];
      }
  }
};

template <class Station>
inline constexpr ChainFill<Station> kChainFill{};

/// State of a solve at a station.
template <class Real, class Station>
struct ChainRecord {
  static constexpr int M = Station::kFreedoms;
  struct Contact {
    Real net_approach;  ///< w - g [m]
    Real force;         ///< Force at this approach [N].
    Real tangent;       ///< [N/m]
    Real remainder;     ///< Part of the residual along the contact [N].
  };
  Real multiplier[static_cast<std::size_t>(kChainFill<Station>.multipliers)];
  Real step[M];
  ChainState<Real, M> state;
  Contact contact[2];
  Real correction[M];  ///< Other part of the residual, from the linear elements [N].
};

/// Station, law and records of the chain being solved.
template <class Real, class Station>
struct ChainStations {
  const Station& station;
  int count;
  ChainRecord<Real, Station>* records;
};

/// Adds a value to a sum, or subtracts it.
template <bool kNegative, class Real, class Value>
PRS_INLINED inline void add_signed(Real& sum, const Value& value) {
  if constexpr (kNegative)
    sum -= value;
  else
    sum += value;
}

/// Approach b'd of contact C with the form b.
template <int C, class Station, class Real>
PRS_INLINED inline Real along(const Station& station, const Real* d) {
  static constexpr auto form = Station::template form<C>();
  Real sum(0.0);
  unroll<static_cast<int>(form.size())>([&](auto i) PRS_INLINED {
    add_signed<form[i].negative>(sum, station.coefficient(C, form[i].kind) * d[form[i].freedom]);
  });
  return sum;
}

/// Adds b force to `right`.
template <int C, class Station, class Real>
PRS_INLINED inline void add_along(const Station& station, Real* right, const Real& force) {
  static constexpr auto form = Station::template form<C>();
  unroll<static_cast<int>(form.size())>([&](auto i) PRS_INLINED {
    add_signed<form[i].negative>(right[form[i].freedom], station.coefficient(C, form[i].kind) * force);
  });
}

/// Adds t b b' to the upper triangle of `a`.
template <int C, class Station, class Real, std::size_t N>
PRS_INLINED inline void add_tangent(const Station& station, Real (&a)[N][N], const Real& t) {
  static constexpr auto form = Station::template form<C>();
  unroll<static_cast<int>(form.size())>([&](auto i) PRS_INLINED {
    const Real row = t * station.coefficient(C, form[i].kind);
    unroll<static_cast<int>(form.size())>([&](auto j) PRS_INLINED {
      if constexpr (form[i].freedom <= form[j].freedom)
        add_signed<form[i].negative != form[j].negative>(a[form[i].freedom][form[j].freedom],
                                                         row * station.coefficient(C, form[j].kind));
    });
  });
}

/// Whether the two lanes are the halves of one chain of twice as many stations: lane 0 goes from the
/// first station to the middle, lane 1 from the last one back to the middle, its intervals given in
/// this direction. Loads are {load, 0}, and Station::mirrored(x) swaps the lanes. The halves are
/// eliminated at once and meet in the middle (twisted factorization: Parlett, Dhillon, Linear
/// Algebra Appl. 267, 1997): a single solve waits for half as many pivots one after the other.
template <class Station>
inline constexpr bool kFolded = requires {
  requires Station::kFolded;
};

/// Sum over the chain of the sums of its lanes.
template <class Station, class Real>
PRS_INLINED inline Real total(const Real& sum) {
  if constexpr (kFolded<Station>)
    return sum + Station::mirrored(sum);
  else
    return sum;
}

/// Maximum over the chain of the maxima of its lanes.
template <class Station, class Real>
PRS_INLINED inline Real of_both(const Real& worst) {
  if constexpr (kFolded<Station>)
    return max(worst, Station::mirrored(worst));
  else
    return worst;
}

}  // namespace fe
