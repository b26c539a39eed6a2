#pragma once

#include <array>

#include "fe/lanes.h"

/// A chain of equal stations, each with two unilateral contacts, solved station by station. `Real` is a number or a
/// batch of numbers: several chains side by side, each with its own convergence.
///
/// A `Station` defines the linear part and the contacts:
///
/// - `kFreedoms`: M, freedoms of a station
/// - `couples(i, j)`: whether the interval to the next station couples freedom i with j there
/// - `form<contact>()`: the approaches of the two contacts as linear forms of the freedoms
/// - `coefficient(contact, kind)`: of the forms
/// - `held(k, Index<i>)`: whether freedom i of station k cannot move
/// - `add_station(k, add)`: stiffness of supports and elements within station k
/// - `add_interval_start(k, add)`: terms of the interval from k to k + 1 at k, and its coupling
/// - `add_interval_end(k, add)`: its terms at k + 1
/// - `add_forces(k, here, force)`: the forces of elements within a station, from their deformations
/// - `add_forces(k, here, next, force, next_force)`: the forces of the interval
///
/// with add(Index<i>, Index<j>, value) for i <= j, j >= M meaning freedom j - M of the next station. A held freedom has
/// a support of infinite stiffness: its inverse pivot is 0, and with it all that it passes on, exactly.
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
  [[gnu::always_inline]] Real difference(int i, const ChainState& from) const {
    return (head[i] - from.head[i]) + (tail[i] - from.tail[i]);
  }

  /// Subtracts the step where `move`.
  template <class Mask>
  [[gnu::always_inline]] void move_back(int i, const Real& step, const Mask& move) {
    const Real change = tail[i] - step;
    const Real sum = head[i] + change;
    const Real rounded = sum - head[i];
    tail[i] = select(move, (head[i] - (sum - rounded)) + (change - rounded), tail[i]);
    head[i] = select(move, sum, head[i]);
  }
};

/// Freedoms coupled to each pivot of a station, its own station first, after the pivots before it are eliminated.
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

/// Approach b'd of contact C with the form b.
template <int C, class Station, class Real>
[[gnu::always_inline]] inline Real along(const Station& station, const Real* d) {
  static constexpr auto form = Station::template form<C>();
  Real sum(0.0);
  unroll<static_cast<int>(form.size())>([&](auto i) __attribute__((always_inline)) {
    if constexpr (form[i].negative)
      sum -= station.coefficient(C, form[i].kind) * d[form[i].freedom];
    else
      sum += station.coefficient(C, form[i].kind) * d[form[i].freedom];
  });
  return sum;
}

/// Adds b force to `right`.
template <int C, class Station, class Real>
[[gnu::always_inline]] inline void add_along(const Station& station, Real* right, const Real& force) {
  static constexpr auto form = Station::template form<C>();
  unroll<static_cast<int>(form.size())>([&](auto i) __attribute__((always_inline)) {
    if constexpr (form[i].negative)
      right[form[i].freedom] -= station.coefficient(C, form[i].kind) * force;
    else
      right[form[i].freedom] += station.coefficient(C, form[i].kind) * force;
  });
}

/// Adds t b b' to the upper triangle of `a`.
template <int C, class Station, class Real, std::size_t N>
[[gnu::always_inline]] inline void add_tangent(const Station& station, Real (&a)[N][N], const Real& t) {
  static constexpr auto form = Station::template form<C>();
  unroll<static_cast<int>(form.size())>([&](auto i) __attribute__((always_inline)) {
    const Real row = t * station.coefficient(C, form[i].kind);
    unroll<static_cast<int>(form.size())>([&](auto j) __attribute__((always_inline)) {
      if constexpr (form[i].freedom <= form[j].freedom) {
        Real& entry = a[form[i].freedom][form[j].freedom];
        if constexpr (form[i].negative != form[j].negative)
          entry -= row * station.coefficient(C, form[j].kind);
        else
          entry += row * station.coefficient(C, form[j].kind);
      }
    });
  });
}

/// Whether two lanes are the halves of one chain of twice as many stations, from its first station on and from its last
/// one back to the middle; every interval of the second half is described in the direction of its walk. Loads are
/// {load, 0}, and mirrored(x) swaps the lanes. The halves are eliminated at once and meet in the middle (twisted
/// factorization: Parlett, Dhillon, Linear Algebra Appl. 267, 1997): a single solve has half as many dependent pivots.
template <class Station>
inline constexpr bool kFolded = requires {
  requires Station::kFolded;
};

/// Sum over the chain of the sums of its lanes.
template <class Station, class Real>
[[gnu::always_inline]] inline Real total(const Real& sum) {
  if constexpr (kFolded<Station>)
    return sum + mirrored(sum);
  else
    return sum;
}

/// Maximum over the chain of the maxima of its lanes.
template <class Station, class Real>
[[gnu::always_inline]] inline Real of_both(const Real& worst) {
  if constexpr (kFolded<Station>)
    return max(worst, mirrored(worst));
  else
    return worst;
}

/// N = k_0 <w - g>^1.5, the PowerLawSpring of chains: contact 0 and 1 of every station.
template <class Real>
struct ChainHertz {
  Real stiffness[2];  ///< k_0 [N/m^1.5]

  [[gnu::always_inline]] ChainResponse<Real> evaluate(int i, int, const Real& net_approach) const {
    const Real d = select(net_approach <= 0.0, Real(0.0), net_approach);
    const Real root = stiffness[i] * sqrt(d);
    const Real force = root * d;
    return {0.4 * force * d, force, 1.5 * root};
  }

  /// Deflection of the power law alone [m].
  Real law_approach(int, int, const Real& net_approach) const {
    return select(net_approach <= 0.0, Real(0.0), net_approach);
  }
};

/// Power law with a linear compliance in series, N = k_0 <w - g - c N>^1.5, of either sign and along its tangent once c
/// < 0 takes back half of what the power law adds (see PowerLawSpring).
template <class Real>
struct ChainHertzInSeries {
  Real stiffness[2];
  const Real* compliance[2];  ///< c of each station [m/N].

  ChainResponse<Real> evaluate(int i, int k, const Real& net_approach) const {
    const Real& k0 = stiffness[i];
    const Real& c = compliance[i][k];
    const Real a = c * k0;
    // With x = sqrt(d), d the approach of the power law: x^2 (1 + a x) = total, up to largest x.
    const Real largest_x = select(a < 0.0, -1.0 / (3.0 * a), Real(1e100));
    const Real largest_total = largest_x * largest_x * (1.0 + a * largest_x);
    const Lanes<Real> open = net_approach <= 0.0;
    const Real closed = select(open, Real(1.0), net_approach);
    const Lanes<Real> linear = (a < 0.0) & (closed > largest_total);
    const Real total = select(linear, largest_total, closed);
    Real x = sqrt(total);
    Lanes<Real> searching = x > 0.0;
    for (int iteration = 0; iteration < 100 && any(searching); ++iteration) {
      const Real step = (x * x * (1.0 + a * x) - total) / (x * (2.0 + 3.0 * a * x));
      x = select(searching, x - step, x);
      searching = searching & (abs(step) > 1e-9 * x);  // the square of this change is below rounding
    }
    x = select(linear, largest_x, x);
    const Real force = k0 * x * x * x;
    const Real power_law_tangent = 1.5 * k0 * x;
    const Real tangent = power_law_tangent / (1.0 + c * power_law_tangent);
    const Real beyond = select(linear, closed - largest_total, Real(0.0));
    const Real energy = force * (0.4 * x * x + 0.5 * c * force) + beyond * (force + 0.5 * tangent * beyond);
    const Real none(0.0);
    return {select(open, none, energy), select(open, none, force + tangent * beyond), select(open, none, tangent)};
  }

  Real law_approach(int i, int k, const Real& net_approach) const {
    const Real root = cbrt(evaluate(i, k, net_approach).force / stiffness[i]);
    return root * root;
  }
};

}  // namespace fe
