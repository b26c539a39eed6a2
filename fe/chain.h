#pragma once

#include "fe/chain_elimination.h"
#include "fe/chain_residual.h"
#include "fe/newton_types.h"
#include "fe/rounding.h"
#include "simd/inlined.h"

namespace fe {

/// Displacement of the loaded freedom by `unit_load` there, K x = f with the contacts' tangent K, in the lanes
/// `wanted`. NaN in the others, and where K is singular or its factors have too few digits. x replaces the states.
///
/// An approximate solution has K x = f - r, and x'f + x'r has an error of second order in that of x: x is refined until
/// x'r is small.
template <class Real, class Station>
Real chain_flexibility(const ChainStations<Real, Station>& chain, const Real& unit_load, const Lanes<Real>& wanted) {
  constexpr int M = Station::kFreedoms, kMostRefinements = 10;
  constexpr double kTolerance = 1e-11;
  const ChainElimination<Real, Station> elimination(chain);
  // Replaces steps by K^-1 times the right-hand side. Returns false if K is singular.
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
    unroll<M>([&](auto i) PRS_INLINED {
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
      unroll<M>([&](auto i) PRS_INLINED { chain.records[k].state.move_back(i, -chain.records[k].step[i], searching); });
  }
  return flexibility;
}

/// Sums over the contacts for a full step d: E the energy after it, N and t force and tangent before it, delta the
/// decrease of net approach by it.
template <class Real>
struct ChainStepSums {
  Real energy = Real(0.0);     ///< E after the step [J]
  Real work = Real(0.0);       ///< N delta
  Real stiffness = Real(0.0);  ///< t delta^2
  Real slope = Real(0.0);      ///< d'r, r the residual before the step
  Real left = Real(0.0);       ///< Largest difference of a force from its linearization after the step [N].
};

/// Backward half of the solve for the residual, and the sums over the contacts that are active after the full step.
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
    unroll<2>([&](auto i) PRS_INLINED {
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
    if (residual.corrections) unroll<M>([&](auto i) PRS_INLINED { s.slope += record.correction[i] * d[i]; });
  }
  s.slope -= residual.load * d[0];
  return {total<Station>(s.energy), total<Station>(s.work), total<Station>(s.stiffness), total<Station>(s.slope),
          of_both<Station>(s.left)};
}

/// Moves the marked contacts back by a share of the last step and returns their energies there.
template <class Real, class Station, class Law>
Real take_back(const ChainStations<Real, Station>& chain, const Law& law, const Real& share,
               const Lanes<Real>& marked) {
  Real energy(0.0);
  for (int k = 0; k < chain.count; ++k) {
    auto& record = chain.records[k];
    unroll<2>([&](auto i) PRS_INLINED {
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

/// Largest change of a contact's force by rounding of the displacements, relative to the largest force.
template <class Real, class Station>
Real approach_rounding(const ChainStations<Real, Station>& chain) {
  constexpr int M = Station::kFreedoms;
  Real largest_change(0.0), largest_force(0.0);
  for (int k = 0; k < chain.count; ++k) {
    const auto& record = chain.records[k];
    Real size(0.0);
    unroll<M>([&](auto i) PRS_INLINED { size = max(size, abs(record.state.head[i])); });
    unroll<2>([&](auto i) PRS_INLINED {
      largest_change = max(largest_change, record.contact[i].tangent * size);
      largest_force = max(largest_force, record.contact[i].force);
    });
  }
  return kForceRounding * of_both<Station>(largest_change) / of_both<Station>(largest_force);
}

/// Largest change of a contact's force by the last step, relative to the largest force.
template <class Real, class Station>
Real force_change(const ChainStations<Real, Station>& chain) {
  Real largest_change(0.0), largest_force(0.0);
  for (int k = 0; k < chain.count; ++k) {
    const auto& record = chain.records[k];
    unroll<2>([&](auto i) PRS_INLINED {
      const auto& c = record.contact[i];
      largest_change = max(largest_change, c.tangent * abs(along<i>(chain.station, record.step)));
      largest_force = max(largest_force, c.force);
    });
  }
  return of_both<Station>(largest_change) / of_both<Station>(largest_force);
}

/// Outcome of each of the chains side by side; as in NewtonSummary.
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
/// After a full Newton step the residual is only the difference of the contacts' forces from their linearization, so
/// that the linear elements are not needed between factorizations; the whole residual, from displacements that keep
/// their rounding, decides at the end, and where it is not small enough a step for it follows. Energies are computed in
/// the same way: along a step d,
///
///     E(a) - E(0) = sum of the contacts' - a (d'r - sum N delta) + a^2/2 (d'r - sum t delta^2),
///
/// with delta the decrease of a contact's net approach by d.
template <class Real, class Station, class Law>
class Chain {
 public:
  using Record = ChainRecord<Real, Station>;
  using Mask = Lanes<Real>;
  static constexpr int M = Station::kFreedoms;

  /// `records`, one per station, hold net approaches and states to start from.
  Chain(const Station& station, const Law& law, int stations, Record* records)
      : chain_{station, stations, records}, elimination_(chain_), law_(law) {}

  /// Solves from the net approaches and states in the records, which must be those of rigid bodies. Residuals are
  /// relative to `scale`.
  ChainSummary<Real> solve(const Real& load, const Real& scale, const NewtonOptions& options) {
    start(load, scale);
    const int limit = options.iteration_limit(contacts());
    for (int iteration = 0; iteration < limit && any(active_); ++iteration) {
      Real shift(0.0);
      if (!factorize(options, shift)) return summary_;
      ChainStepSums<Real> sums = full_step(elimination_, chain_, law_, residual_, active_);
      residual_ = {Real(0.0), false};
      search(options, sums);
      assess(options, sums, shift);
    }
    if (any(active_)) look_at_all(active_);
    return summary_;
  }

  /// Displacement of the loaded freedom per load at the current state, which is overwritten. NaN if the state is no
  /// equilibrium, or for a reason of chain_flexibility.
  Real flexibility() const {
    Real unit(1.0);
    if constexpr (kFolded<Station>) unit = select(abs(load_) > 0.0, unit, Real(0.0));
    return chain_flexibility(chain_, unit, summary_.converged);
  }

 private:
  /// Number of contacts, of both halves of a folded chain.
  int contacts() const { return (kFolded<Station> ? 4 : 2) * chain_.count; }

  void start(const Real& load, const Real& scale) {
    load_ = load;
    inverse_scale_ = 1.0 / scale;
    Real worst(0.0), contact_energy(0.0);
    for (int k = 0; k < chain_.count; ++k) {
      Record& record = chain_.records[k];
      Real residual[M];
      set_zero(residual);
      set_zero(record.correction);
      if (k == 0) residual[0] -= load;
      unroll<2>([&](auto i) PRS_INLINED {
        auto& c = record.contact[i];
        const ChainResponse<Real> r = law_.evaluate(i, k, c.net_approach);
        c.force = c.remainder = r.force;
        c.tangent = r.tangent;
        contact_energy += r.energy;
        add_along<i>(chain_.station, residual, r.force);
      });
      unroll<M>([&](auto i) PRS_INLINED { worst = max(worst, abs(residual[i])); });
    }
    contact_energy_ = total<Station>(contact_energy);
    summary_ = {};
    summary_.initial_relative_residual = summary_.relative_residual = of_both<Station>(worst) * inverse_scale_;
    summary_.energy = contact_energy_ + total<Station>(Real(-load * chain_.records[0].state.head[0]));
    active_ = scale >= scale;
    checked_ = !active_;
    residual_ = {load, false};
    move_pending_ = false;
  }

  /// Function that applies the last step, when its stations are read next.
  auto pending_move() const {
    return [this](Record& record) PRS_INLINED {
      if (move_pending_)
        unroll<M>([&](auto i) PRS_INLINED { record.state.move_back(i, length_ * record.step[i], moved_); });
    };
  }

  /// Shifts the tangent if it is singular; stops lanes for which no shift helps. Returns false if all do.
  bool factorize(const NewtonOptions& options, Real& shift) {
    Mask singular = elimination_.factorize(residual_, shift, pending_move()) & active_;
    move_pending_ = false;
    while (any(singular)) {
      const Mask give_up = singular & !(shift < options.last_shift);
      summary_.singular = summary_.singular | give_up;
      active_ = active_ & !give_up;
      singular = singular & !give_up;
      if (!any(active_)) return false;
      shift = select(singular, select(shift > 0.0, kShiftGrowth * shift, Real(options.first_shift)), shift);
      singular = elimination_.factorize(residual_, shift, pending_move()) & active_;
    }
    return true;
  }

  /// Halves the step if the energy does not fall.
  void search(const NewtonOptions& options, ChainStepSums<Real>& s) {
    length_ = Real(1.0);
    const auto gain = [&] {
      return (s.energy - contact_energy_) - length_ * (s.slope - s.work) +
             0.5 * length_ * length_ * (s.slope - s.stiffness);
    };
    const Real rounding = kEnergyRounding * (contact_energy_ + abs(s.work));
    const auto too_high = [&] {
      return active_ & !(gain() <= rounding - options.sufficient_decrease * length_ * s.slope);
    };
    Mask high = too_high();
    for (int halvings = 0; any(high); high = too_high(), ++halvings) {
      if (halvings == options.max_halvings) {
        summary_.search_failed = summary_.search_failed | high;
        break;
      }
      const Real shorter = select(high, 0.5 * length_, length_);
      s.energy = select(high, take_back(chain_, law_, Real(length_ - shorter), high), s.energy);
      length_ = shorter;
    }
    summary_.energy = select(active_, summary_.energy + gain(), summary_.energy);
    contact_energy_ = select(active_, s.energy, contact_energy_);
    summary_.iterations = select(active_, summary_.iterations + 1.0, summary_.iterations);
    moved_ = active_;
    move_pending_ = true;
    active_ = active_ & !summary_.search_failed;
  }

  /// Checks for equilibrium, by the whole residual if its own step would be the next.
  void assess(const NewtonOptions& options, const ChainStepSums<Real>& s, const Real& shift) {
    // |cos|, |sin| <= 1, and a freedom meets at most both contacts of its station.
    const Real relative = 2.0 * s.left * inverse_scale_;
    const Mask settled = options.settled(s.slope, summary_.energy);
    const Mask small = options.small(relative);
    const Mask candidate = active_ & settled & small;
    const Mask unusual = active_ & ((length_ < 1.0) | (shift > 0.0));
    const Real before = summary_.relative_residual;
    summary_.relative_residual = select(moved_, relative, before);
    const Mask check = candidate | unusual | summary_.search_failed;
    const Mask checked_before = checked_;
    checked_ = check;
    if (!any(check)) return;
    const Real whole = look_at_all(check);
    // Upper bound of the last step's change of a contact's force, relative to the largest force. A change dN of one
    // contact has t delta^2 = 5/3 (dN/N)^2 times the energy of that contact. The bound is too large by at most the root
    // of twice the number of contacts.
    const Real change = sqrt(1.2 * static_cast<double>(contacts()) * length_ * length_ * s.stiffness / contact_energy_);
    const Mask resolved = approach_rounding(chain_) <= options.force_tolerance;
    const Mask exact = options.exact(change, whole, before);
    const Mask small_in_all = options.small(whole);
    const Mask done = candidate & resolved & exact & small_in_all;
    // A whole residual that its own step does not reduce is due to rounding.
    const Mask stalled = candidate & checked_before & !done & options.stalled(whole, before);
    const Mask rounded =
        any(stalled) ? stalled & resolved & options.rounded(length_ * force_change(chain_), whole) : stalled;
    summary_.converged = summary_.converged | done | rounded;
    summary_.at_rounding = summary_.at_rounding | rounded;
    summary_.search_failed = summary_.search_failed | (stalled & !rounded);
    active_ = active_ & !done & !stalled;
  }

  /// Residual of all freedoms relative to the scale; in marked lanes it and the energy become those of the state.
  Real look_at_all(const Mask& marked) {
    const WholeResidual<Real> r = whole_residual(chain_, load_, pending_move(), marked, active_);
    move_pending_ = false;
    residual_.corrections = true;
    const Real whole = r.worst * inverse_scale_;
    summary_.energy = select(marked, r.linear_energy + contact_energy_, summary_.energy);
    summary_.relative_residual = select(marked, whole, summary_.relative_residual);
    return whole;
  }

  ChainStations<Real, Station> chain_;
  ChainElimination<Real, Station> elimination_;
  const Law& law_;

  ChainSummary<Real> summary_;
  Real load_, inverse_scale_, contact_energy_;
  ChainResidual<Real> residual_;  ///< Right-hand side of the next step.
  Mask active_,
      checked_;                ///< Lanes checked by the whole residual after the last step.
  Real length_;                ///< Fraction of the last step that was taken.
  Mask moved_;                 ///< Lanes that took the last step.
  bool move_pending_ = false;  ///< Whether the states do not contain the last step yet.
};

}  // namespace fe
