#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "fe/newton_types.h"

/// A chain of equal stations, each with two unilateral contacts, solved station by station. `Real`
/// is a number or a batch of numbers: several chains side by side, each with its own convergence.
///
/// A `Station` tells the linear part and the contacts:
///
/// - `kFreedoms`: M, freedoms of a station
///
/// - `couples(i, j)`: whether the interval to the next station couples freedom i with j there
///
/// - `form<contact>()`: the approaches of the two contacts as linear forms of the freedoms
///
/// - `coefficient(contact, kind)`: of the forms
///
/// - `held(k, Index<i>)`: whether freedom i of station k cannot move
///
/// - `add_station(k, add)`: stiffness of supports and elements within station k
///
/// - `add_interval_start(k, add)`: what the interval from k to k + 1 adds to k and couples
///
/// - `add_interval_end(k, add)`: what it adds to k + 1
///
/// - `add_forces(k, here, force)`: the forces of elements within a station, by what deforms them
///
/// - `add_forces(k, here, next, force, next_force)`: those of the interval
///
/// with add(Index<i>, Index<j>, value) for i <= j, j >= M meaning freedom j - M of the next
/// station. A held freedom has a support of infinite stiffness: its inverse pivot is 0, and with it
/// all that it passes on, exactly.
///
/// A `Law` tells the contacts' force: evaluate(contact, k, closure) -> ChainResponse.
namespace fe {

template <int I>
using Index = std::integral_constant<int, I>;

/// f(Index<0>), f(Index<1>), .. f(Index<N - 1>), written out by the compiler.
template <int N, class F>
[[gnu::always_inline]] inline void unroll(F&& f) {
  [&]<int... I>(std::integer_sequence<int, I...>) __attribute__((always_inline)) {
    (f(Index<I>{}), ...);
  }
  (std::make_integer_sequence<int, N>{});
}

/// The operations that batches have, for single numbers.
[[gnu::always_inline]] inline double select(bool condition, double a, double b) {
  return condition ? a : b;
}
[[gnu::always_inline]] inline bool any(bool condition) { return condition; }
[[gnu::always_inline]] inline double sqrt(double x) { return __builtin_sqrt(x); }
[[gnu::always_inline]] inline double abs(double x) { return __builtin_fabs(x); }
[[gnu::always_inline]] inline double max(double a, double b) { return a > b ? a : b; }
[[gnu::always_inline]] inline double min(double a, double b) { return a < b ? a : b; }
[[gnu::always_inline]] inline double cbrt(double x) { return __builtin_cbrt(x); }

/// The larger of both; keeps a NaN in `a` or `b`.
template <class Real>
[[gnu::always_inline]] inline Real largest(const Real& a, const Real& b) {
  return select(b <= a, a, select(a <= b, b, a + b));
}

/// Yes or no for each of the chains side by side.
template <class Real>
using Lanes = decltype(Real() < Real());

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

  /// Of a freedom here less the same one at `from`.
  [[gnu::always_inline]] Real difference(int i, const ChainState& from) const {
    return (head[i] - from.head[i]) + (tail[i] - from.tail[i]);
  }

  /// this -= step where `move`.
  template <class Mask>
  [[gnu::always_inline]] void move_back(int i, const Real& step, const Mask& move) {
    const Real change = tail[i] - step;
    const Real sum = head[i] + change;
    const Real rounded = sum - head[i];
    tail[i] = select(move, (head[i] - (sum - rounded)) + (change - rounded), tail[i]);
    head[i] = select(move, sum, head[i]);
  }
};

/// Which freedoms each pivot of a station meets, its own station first, when those before it are
/// eliminated.
template <class Station>
struct ChainFill {
  static constexpr int M = Station::kFreedoms;
  std::array<std::array<bool, 2 * M>, M> meets{};
  std::array<std::array<int, 2 * M>, M> place{};  ///< Of the multiplier in storage.
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

/// All that a solve keeps of a station.
template <class Real, class Station>
struct ChainRecord {
  static constexpr int M = Station::kFreedoms;
  struct Contact {
    Real closure;    ///< w - g [m]
    Real force;      ///< At this closure [N].
    Real tangent;    ///< [N/m]
    Real remainder;  ///< Of the residual, along the contact [N].
  };
  Real multiplier[static_cast<std::size_t>(kChainFill<Station>.multipliers)];
  Real step[M];
  ChainState<Real, M> state;
  Contact contact[2];
  Real correction[M];  ///< Rest of the residual, of the linear elements [N].
};

/// Whether two lanes are the halves of one chain of twice as many stations, from its first station
/// on and from its last one back to the middle, every interval of the second half being told in the
/// sense of its walk. Loads are {load, 0}, and mirrored(x) swaps the lanes. The halves are
/// eliminated at once and meet in the middle (twisted factorization: Parlett, Dhillon, Linear
/// Algebra Appl. 267, 1997): a single solve waits for half as many pivots one after the other.
template <class Station>
inline constexpr bool kFolded = requires {
  requires Station::kFolded;
};

/// How each of the chains side by side ended; as in NewtonSummary.
template <class Real>
struct ChainSummary {
  Lanes<Real> converged = Real(0.0) < Real(0.0);
  Lanes<Real> singular = converged;
  Lanes<Real> search_failed = converged;
  Lanes<Real> at_rounding = converged;
  Real iterations = Real(0.0);
  Real initial_relative_residual = Real(0.0);
  Real relative_residual = Real(0.0);
  Real energy = Real(0.0);
};

/// Newton's method of NewtonSolver for chains. The load pushes freedom 0 of station 0.
///
/// A full Newton step leaves of the residual only what the contacts' forces differ from their
/// tangents, so that between factorizations the linear elements need not be looked at; the whole
/// residual, from displacements that keep their rounding, decides at the end, and where it is not
/// small enough its own step follows. Energies are followed in the same way: along a step d,
///
///     E(a) - E(0) = sum of the contacts' - a (d'r - sum N delta) + a^2/2 (d'r - sum t delta^2),
///
/// delta the change of a contact's closure.
template <class Real, class Station, class Law>
class Chain {
 public:
  using Record = ChainRecord<Real, Station>;
  using Mask = Lanes<Real>;
  static constexpr int M = Station::kFreedoms;

  /// `records`, one a station, hold closures and states to start from.
  Chain(const Station& station, const Law& law, int stations, Record* records)
      : station_(station), law_(law), stations_(stations), records_(records) {}

  /// From the states and closures in the records. `rigid`: the states are those of rigid bodies, as
  /// they always are of folded chains. Residuals are relative to `scale`.
  ChainSummary<Real> solve(const Real& load, const Real& scale, const NewtonOptions& options,
                           bool rigid) {
    start(load, scale, rigid);
    return iterate(options);
  }

  /// Displacement of the loaded freedom per load, at the state reached, which it replaces; NaN where
  /// the tangent is singular or its factors have too few digits.
  ///
  /// With x the solution so far, K x = f - r, it is x'f + x'r but for the square of the error of x:
  /// x is refined until the second part is small.
  Real flexibility() {
    pending_load_ = Real(-1.0);
    if constexpr (kFolded<Station>)
      pending_load_ = select(abs(load_) > 0.0, pending_load_, Real(0.0));
    load_pending_ = true;
    has_correction_ = move_pending_ = false;
    for (int k = 0; k < stations_; ++k)
      for (auto& c : records_[k].contact) c.remainder = Real(0.0);
    Mask searching = solve_for_right_hand_side() & summary_.converged;
    for (int k = 0; k < stations_; ++k)
      unroll<M>([&](auto i) __attribute__((always_inline)) {
        records_[k].state.head[i] = records_[k].step[i];
        records_[k].state.tail[i] = Real(0.0);
      });
    load_pending_ = false;
    has_correction_ = true;
    Real flexibility(__builtin_nan(""));
    for (int refinement = 0; any(searching); ++refinement) {
      const Real left = tangent_residual();
      const Real found = total(-pending_load_ * records_[0].state.head[0]);
      const Mask known = searching & (abs(left) <= kTangentTolerance * found);
      flexibility = select(known, found + left, flexibility);
      searching = searching & !known;
      if (!any(searching) || refinement == kMostRefinements) break;
      searching = searching & solve_for_right_hand_side();
      for (int k = 0; k < stations_; ++k)
        unroll<M>([&](auto i) __attribute__((always_inline)) {
          records_[k].state.move_back(i, -records_[k].step[i], searching);
        });
    }
    return flexibility;
  }

  /// Approach b'd of contact C, b its form.
  template <int C>
  [[gnu::always_inline]] Real along(const Real* d) const {
    static constexpr auto form = Station::template form<C>();
    Real sum(0.0);
    unroll<static_cast<int>(form.size())>([&](auto i) __attribute__((always_inline)) {
      if constexpr (form[i].negative)
        sum -= station_.coefficient(C, form[i].kind) * d[form[i].freedom];
      else
        sum += station_.coefficient(C, form[i].kind) * d[form[i].freedom];
    });
    return sum;
  }

 private:
  static constexpr double kTangentTolerance = 1e-11;
  static constexpr int kMostRefinements = 10;

  /// Steps become K^-1 of the right-hand side. False where K is singular.
  Mask solve_for_right_hand_side() {
    const Mask regular = !factorize<false>(Real(0.0));
    Real next[M];
    unroll<M>([&](auto i) __attribute__((always_inline)) { next[i] = Real(0.0); });
    for (int k = stations_ - 1; k >= 0; --k) substitute_back(k, next);
    return regular;
  }

  /// Forces of the linear elements at station k, those of the interval to it being `carried`, which
  /// become those of the interval to the next one.
  [[gnu::always_inline]] void linear_forces(int k, Real* force, Real* carried) {
    const Record& record = records_[k];
    Real next[M];
    unroll<M>([&](auto i) __attribute__((always_inline)) {
      force[i] = carried[i];
      next[i] = Real(0.0);
    });
    station_.add_forces(k, record.state, force);
    if (k + 1 < stations_) {
      if (move_pending_) move(records_[k + 1]);
      station_.add_forces(k, record.state, records_[k + 1].state, force, next);
    }
    if constexpr (kFolded<Station>)
      if (k + 1 == stations_) {
        ChainState<Real, M> beyond;
        unroll<M>([&](auto i) __attribute__((always_inline)) {
          beyond.head[i] = mirrored(record.state.head[i]);
          beyond.tail[i] = mirrored(record.state.tail[i]);
        });
        station_.add_forces(k, record.state, beyond, force, next);
      }
    unroll<M>([&](auto i) __attribute__((always_inline)) { carried[i] = next[i]; });
  }

  /// What rounding of the displacements can change in a contact's force, relative to the largest.
  Real approach_rounding() const {
    Real largest_change(0.0), largest_force(0.0);
    for (int k = 0; k < stations_; ++k) {
      const Record& record = records_[k];
      Real size(0.0);
      unroll<M>([&](auto i)
                    __attribute__((always_inline)) { size = max(size, abs(record.state.head[i])); });
      unroll<2>([&](auto i) __attribute__((always_inline)) {
        largest_change = max(largest_change, record.contact[i].tangent * size);
        largest_force = max(largest_force, record.contact[i].force);
      });
    }
    return 4.0 * 2.220446049250313e-16 * of_both(largest_change) / of_both(largest_force);
  }

  /// Corrections become f - K x, x being the state; x'(f - K x).
  Real tangent_residual() {
    Real work(0.0);
    Real carried[M];
    unroll<M>([&](auto i) __attribute__((always_inline)) { carried[i] = Real(0.0); });
    for (int k = 0; k < stations_; ++k) {
      Record& record = records_[k];
      Real force[M];
      linear_forces(k, force, carried);
      if (k == 0) force[0] += pending_load_;
      unroll<2>([&](auto i) __attribute__((always_inline)) {
        const Real approach = along<i>(record.state.head) + along<i>(record.state.tail);
        add_along<i>(force, record.contact[i].tangent * approach);
      });
      unroll<M>([&](auto i) __attribute__((always_inline)) {
        record.correction[i] = select(station_.held(k, i), Real(0.0), -force[i]);
        work += record.state.head[i] * record.correction[i];
      });
    }
    return total(work);
  }

  /// Sum over the chain of what each lane has summed.
  [[gnu::always_inline]] static Real total(const Real& sum) {
    if constexpr (kFolded<Station>)
      return sum + mirrored(sum);
    else
      return sum;
  }

  /// Largest over the chain of what is each lane's largest.
  [[gnu::always_inline]] static Real of_both(const Real& worst) {
    if constexpr (kFolded<Station>)
      return max(worst, mirrored(worst));
    else
      return worst;
  }

  void start(const Real& load, const Real& scale, bool rigid) {
    load_ = pending_load_ = load;
    inverse_scale_ = 1.0 / scale;
    contact_energy_ = Real(0.0);
    Real worst(0.0), linear_energy(0.0);
    Real carried[M];
    unroll<M>([&](auto i) __attribute__((always_inline)) { carried[i] = Real(0.0); });
    for (int k = 0; k < stations_; ++k) {
      Record& record = records_[k];
      Real residual[M];
      unroll<M>([&](auto i) __attribute__((always_inline)) {
        residual[i] = carried[i];
        carried[i] = Real(0.0);
      });
      if constexpr (!kFolded<Station>)
        if (!rigid) {
          station_.add_forces(k, record.state, residual);
          if (k + 1 < stations_)
            station_.add_forces(k, record.state, records_[k + 1].state, residual, carried);
        }
      unroll<M>([&](auto i) __attribute__((always_inline)) {
        residual[i] = select(station_.held(k, i), Real(0.0), residual[i]);
        record.correction[i] = residual[i];
        linear_energy += 0.5 * residual[i] * record.state.head[i];
      });
      if (k == 0) residual[0] -= load;
      unroll<2>([&](auto i) __attribute__((always_inline)) {
        auto& c = record.contact[i];
        const ChainResponse<Real> r = law_.evaluate(i, k, c.closure);
        c.force = c.remainder = r.force;
        c.tangent = r.tangent;
        contact_energy_ += r.energy;
        add_along<i>(residual, r.force);
      });
      unroll<M>([&](auto i)
                    __attribute__((always_inline)) { worst = max(worst, abs(residual[i])); });
    }
    contact_energy_ = total(contact_energy_);
    summary_ = {};
    summary_.initial_relative_residual = summary_.relative_residual =
        of_both(worst) * inverse_scale_;
    summary_.energy = contact_energy_ + total(linear_energy - load * records_[0].state.head[0]);
    active_ = scale >= scale;
    checked_ = !active_;
    load_pending_ = has_correction_ = true;
    move_pending_ = false;
  }

  /// In both halves of a folded chain.
  int contacts() const { return (kFolded<Station> ? 4 : 2) * stations_; }

  ChainSummary<Real> iterate(const NewtonOptions& options) {
    const int limit = options.iteration_limit(contacts());
    for (int iteration = 0; iteration < limit && any(active_); ++iteration) {
      Real shift(0.0);
      Mask singular = factorize<false>(shift) & active_;
      while (any(singular)) {
        const Mask give_up = singular & !(shift < options.last_shift);
        summary_.singular = summary_.singular | give_up;
        active_ = active_ & !give_up;
        singular = singular & !give_up;
        if (!any(active_)) return summary_;
        shift =
            select(singular, select(shift > 0.0, 100.0 * shift, Real(options.first_shift)), shift);
        singular = factorize<true>(shift) & active_;
      }
      take_step(options, shift);
    }
    if (any(active_))
      summary_.relative_residual =
          select(active_, whole_residual(active_), summary_.relative_residual);
    return summary_;
  }

  /// Factors the tangent, station by station, and does the forward half of the solve for the
  /// residual. True where a pivot is not positive.
  template <bool kShifted>
  Mask factorize(const Real& shift) {
    Front front;
    unroll<2 * M>([&](auto i) __attribute__((always_inline)) {
      front.right[i] = Real(0.0);
      unroll<2 * M>([&](auto j) __attribute__((always_inline)) {
        front.a[i][j] = front.added[i][j] = Real(0.0);
      });
    });
    if (load_pending_) front.right[0] = -pending_load_;
    Real smallest(1e300);  // pivot; one that is no number makes those after it so
    for (int k = 0; k + 1 < stations_; ++k) {
      assemble<kShifted, true>(k, shift, front);
      eliminate<2 * M>(records_[k], front, smallest);
      pass_on<kShifted>(k, shift, front);
    }
    assemble<kShifted, kFolded<Station>>(stations_ - 1, shift, front);
    if constexpr (kFolded<Station>) meet(records_[stations_ - 1], front, smallest);
    eliminate<M>(records_[stations_ - 1], front, smallest);
    move_pending_ = false;
    return !(-of_both(-smallest) > 0.0);
  }

  /// Upper triangle and right-hand side of a station and the next one. `added` collects what the
  /// stations bring, apart from what eliminations leave, which is late.
  struct Front {
    Real a[2 * M][2 * M];
    Real added[2 * M][2 * M];
    Real right[2 * M];
  };

  /// add(i, j, value) of a station into the front.
  template <bool kShifted>
  [[gnu::always_inline]] static auto adder(const Real& shift, Front& front) {
    return [&](auto i, auto j, const Real& value) __attribute__((always_inline)) {
      if constexpr (kShifted && i == j)
        front.added[i][j] += (1.0 + shift) * value;
      else
        front.added[i][j] += value;
    };
  }

  template <bool kShifted, bool kWithInterval>
  [[gnu::always_inline]] void assemble(int k, const Real& shift, Front& front) {
    Record& record = records_[k];
    const auto add = adder<kShifted>(shift, front);
    if (move_pending_) move(record);
    station_.add_station(k, add);
    if constexpr (kWithInterval) station_.add_interval_start(k, add);
    unroll<2>([&](auto c) __attribute__((always_inline)) {
      const auto& contact = record.contact[c];
      add_tangent<c>(front, contact.tangent);
      add_along<c>(front.right, contact.remainder);
    });
    if (has_correction_)
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
  template <bool kShifted>
  [[gnu::always_inline]] void pass_on(int k, const Real& shift, Front& front) {
    unroll<M>([&](auto i) __attribute__((always_inline)) {
      front.right[i] = front.right[M + i];
      front.right[M + i] = Real(0.0);
      unroll<M>([&](auto j) __attribute__((always_inline)) {
        front.a[i][j] = front.a[M + i][M + j];
        front.a[M + i][M + j] = front.added[i][j] = front.added[i][M + j] = Real(0.0);
      });
    });
    station_.add_interval_end(k, adder<kShifted>(shift, front));
  }

  /// Leaves in each lane the station beside the middle with what the other lane's elimination of
  /// its own has for it.
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

  /// a += t b b', b the form of contact C.
  template <int C>
  [[gnu::always_inline]] void add_tangent(Front& front, const Real& t) const {
    static constexpr auto form = Station::template form<C>();
    unroll<static_cast<int>(form.size())>([&](auto i) __attribute__((always_inline)) {
      const Real row = t * station_.coefficient(C, form[i].kind);
      unroll<static_cast<int>(form.size())>([&](auto j) __attribute__((always_inline)) {
        if constexpr (form[i].freedom <= form[j].freedom) {
          Real& a = front.added[form[i].freedom][form[j].freedom];
          if constexpr (form[i].negative != form[j].negative)
            a -= row * station_.coefficient(C, form[j].kind);
          else
            a += row * station_.coefficient(C, form[j].kind);
        }
      });
    });
  }

  /// right += b force.
  template <int C>
  [[gnu::always_inline]] void add_along(Real* right, const Real& force) const {
    static constexpr auto form = Station::template form<C>();
    unroll<static_cast<int>(form.size())>([&](auto i) __attribute__((always_inline)) {
      if constexpr (form[i].negative)
        right[form[i].freedom] -= station_.coefficient(C, form[i].kind) * force;
      else
        right[form[i].freedom] += station_.coefficient(C, form[i].kind) * force;
    });
  }

  /// The step at station k from that at the next one, which it replaces.
  [[gnu::always_inline]] void substitute_back(int k, Real* next) {
    if (k == stations_ - 1)
      substitute_back<true>(records_[k], next);
    else
      substitute_back<false>(records_[k], next);
  }

  template <bool kLast>
  [[gnu::always_inline]] void substitute_back(Record& record, Real* next) {
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

  /// Moves the state by the accepted step.
  [[gnu::always_inline]] void move(Record& record) const {
    unroll<M>([&](auto i) __attribute__((always_inline)) {
      record.state.move_back(i, length_ * record.step[i], moved_);
    });
  }

  /// Backward half of the solve, the contacts after the full step, and the halvings where that does
  /// not descend; then what is left of the residual.
  void take_step(const NewtonOptions& options, const Real& shift) {
    Real energy(0.0), work(0.0), stiffness(0.0), slope(0.0), left(0.0);
    Real d[M];
    unroll<M>([&](auto i) __attribute__((always_inline)) { d[i] = Real(0.0); });
    for (int k = stations_ - 1; k >= 0; --k) {
      Record& record = records_[k];
      substitute_back(k, d);
      unroll<2>([&](auto i) __attribute__((always_inline)) {
        auto& c = record.contact[i];
        const Real change = along<i>(d);
        const Real closure = c.closure - change;
        const ChainResponse<Real> r = law_.evaluate(i, k, closure);
        energy += r.energy;
        work += c.force * change;
        stiffness += c.tangent * change * change;
        slope += c.remainder * change;
        const Real remainder = (r.force - c.force) + c.tangent * change;
        left = max(left, abs(remainder));
        c.closure = select(active_, closure, c.closure);
        c.force = select(active_, r.force, c.force);
        c.tangent = select(active_, r.tangent, c.tangent);
        c.remainder = select(active_, remainder, c.remainder);
      });
      if (has_correction_)
        unroll<M>([&](auto i)
                      __attribute__((always_inline)) { slope += record.correction[i] * d[i]; });
    }
    if (load_pending_) slope -= pending_load_ * d[0];
    energy = total(energy);
    work = total(work);
    stiffness = total(stiffness);
    slope = total(slope);
    left = of_both(left);
    load_pending_ = has_correction_ = false;

    length_ = Real(1.0);
    const auto gain = [&] {
      return (energy - contact_energy_) - length_ * (slope - work) +
             0.5 * length_ * length_ * (slope - stiffness);
    };
    const Real rounding = 64.0 * 2.220446049250313e-16 * (contact_energy_ + abs(work));
    const auto too_high = [&] {
      return active_ & !(gain() <= rounding - options.sufficient_decrease * length_ * slope);
    };
    Mask high = too_high();
    for (int halvings = 0; any(high); high = too_high(), ++halvings) {
      if (halvings == options.max_halvings) {
        summary_.search_failed = summary_.search_failed | high;
        break;
      }
      const Real shorter = select(high, 0.5 * length_, length_);
      energy = select(high, contacts_at(shorter, high), energy);
      length_ = shorter;
    }
    summary_.energy = select(active_, summary_.energy + gain(), summary_.energy);
    contact_energy_ = select(active_, energy, contact_energy_);
    summary_.iterations = select(active_, summary_.iterations + 1.0, summary_.iterations);
    moved_ = active_;
    move_pending_ = true;
    active_ = active_ & !summary_.search_failed;

    // |cos|, |sin| <= 1, and a freedom meets at most both contacts of its station.
    const Real relative = 2.0 * left * inverse_scale_;
    const Mask settled = slope <= options.energy_tolerance * abs(summary_.energy);
    const Mask candidate = active_ & settled & (relative <= options.residual_tolerance);
    const Mask unusual = active_ & ((length_ < 1.0) | (shift > 0.0));
    const Real before = summary_.relative_residual;
    summary_.relative_residual = select(moved_, relative, before);
    const Mask check = candidate | unusual | summary_.search_failed;
    const Mask checked_before = checked_;
    checked_ = check;
    if (!any(check)) return;
    const Real whole = whole_residual(check);
    summary_.relative_residual = select(check, whole, summary_.relative_residual);
    // What the last step changed in a contact's force, relative to the largest: of one contact
    // alone the work of the change is 5/3 of its square times the energy.
    const Real change =
        sqrt(1.2 * static_cast<double>(contacts()) * length_ * length_ * stiffness /
             contact_energy_);
    const Mask told = approach_rounding() <= options.force_tolerance;
    const Mask exact = told & (change * whole <= options.force_tolerance * before);
    const Mask done = candidate & exact & (whole <= options.residual_tolerance);
    // A whole residual that its own step does not lessen is that of rounding.
    const Mask stalled = candidate & checked_before & !done & (whole > 0.1 * before);
    const Mask rounded = stalled & told & (whole <= options.rounding_tolerance) &
                         (change <= options.force_tolerance);
    summary_.converged = summary_.converged | done | rounded;
    summary_.at_rounding = summary_.at_rounding | rounded;
    summary_.search_failed = summary_.search_failed | (stalled & !rounded);
    active_ = active_ & !done & !stalled;
  }

  /// Takes the contacts marked back to the step length and sums their energies there.
  Real contacts_at(const Real& length, const Mask& marked) {
    Real energy(0.0);
    for (int k = 0; k < stations_; ++k) {
      Record& record = records_[k];
      unroll<2>([&](auto i) __attribute__((always_inline)) {
        auto& c = record.contact[i];
        const Real closure = c.closure + (length_ - length) * along<i>(record.step);
        const ChainResponse<Real> r = law_.evaluate(i, k, closure);
        energy += r.energy;
        c.closure = select(marked, closure, c.closure);
        c.force = select(marked, r.force, c.force);
        c.tangent = select(marked, r.tangent, c.tangent);
      });
    }
    return total(energy);
  }

  /// Residual of all freedoms at the state, relative to the load; where marked, what of it is not
  /// the remainders' becomes the correction, and the energy is that of the state.
  Real whole_residual(const Mask& marked) {
    Real worst(0.0), energy(0.0);
    Real carried[M];
    unroll<M>([&](auto i) __attribute__((always_inline)) { carried[i] = Real(0.0); });
    if (move_pending_) move(records_[0]);
    for (int k = 0; k < stations_; ++k) {
      Record& record = records_[k];
      Real force[M];
      linear_forces(k, force, carried);
      unroll<M>([&](auto i) __attribute__((always_inline)) {
        energy += 0.5 * record.state.head[i] * force[i];
      });
      if (k == 0) {
        force[0] -= load_;
        energy -= load_ * record.state.head[0];
      }
      unroll<2>([&](auto i) __attribute__((always_inline)) {
        add_along<i>(force, record.contact[i].force - record.contact[i].remainder);
      });
      Real remainder[M];
      unroll<M>([&](auto i) __attribute__((always_inline)) { remainder[i] = Real(0.0); });
      unroll<2>([&](auto i) __attribute__((always_inline)) {
        add_along<i>(remainder, record.contact[i].remainder);
      });
      unroll<M>([&](auto i) __attribute__((always_inline)) {
        const Mask held = station_.held(k, i);
        const Real none(0.0);
        const Real unmarked = select(active_, none, record.correction[i]);
        record.correction[i] = select(marked, select(held, none, force[i]), unmarked);
        worst = max(worst, select(held, Real(0.0), abs(force[i] + remainder[i])));
      });
    }
    move_pending_ = false;
    has_correction_ = true;
    energy = total(energy);
    worst = of_both(worst);
    summary_.energy = select(marked, energy + contact_energy_, summary_.energy);
    // The largest of numbers some of which are none can be any; their sum is none.
    return select(energy <= energy, worst, energy) * inverse_scale_;
  }

  const Station& station_;
  const Law& law_;
  int stations_;
  Record* records_;

  ChainSummary<Real> summary_;
  Real load_, pending_load_, inverse_scale_, contact_energy_;
  Real length_;                    ///< Of the last step.
  Mask active_, moved_, checked_;  ///< Checked: by the whole residual.
  bool load_pending_ = false;      ///< The residual lacks `pending_load_` still.
  bool has_correction_ = false;    ///< `Record::correction` is part of the residual.
  bool move_pending_ = false;      ///< States lack the last step.
};

}  // namespace fe
