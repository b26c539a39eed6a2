#pragma once

#include "fe/chain.h"
#include "prs/chain/deliver.h"
#include "prs/chain/lane_access.h"

namespace prs {

/// What a sweep knows of its sectors, one a lane, beside their stations. SI units.
template <class Real>
struct SweptSector {
  int contacts;
  Real rollers;
  Real sense;                         ///< s
  Real cosine[2], hertz_constant[2];  ///< Of psi, and k_0, of screw and nut.
  Real free_compliance;               ///< Of the screw before the first contact [m/N].
  Real offset_compliance;             ///< As in `Sector` [m/N].
};

/// Loads one after the other on one sector a lane. With two solutions of ascending loads behind it
/// a lane starts from the line, with three from the quadratic, through them: both balance the
/// linear elements with the same combination of the contacts' forces. Else it starts from rigid
/// bodies that share the load equally, every thread closed.
template <class Real, class Station, class Law>
class Sweep {
 public:
  using Record = fe::ChainRecord<Real, Station>;
  static constexpr int M = Station::kFreedoms;
  static constexpr int kKept = M + 4;  ///< Displacements, closures and forces of a station.
  static constexpr int kAges = 3;

  /// `history` has room for kAges kKept numbers a station, unless no state is to be remembered.
  Sweep(const SweptSector<Real>& sector, const Station& station, const Law& law, Record* records,
        Real* history)
      : sector_(sector),
        law_(law),
        records_(records),
        chain_(station, law, sector.contacts, records) {
    for (int age = 0; age < kAges; ++age) ages_[age] = history + age * sector.contacts * kKept;
  }

  /// Solves under the axial forces on the mechanisms; gap(i, k) are the initial gaps. `remember`:
  /// more loads follow.
  template <class Gap>
  void solve(const Real& axial_force, const Gap& gap, bool remember,
             const fe::NewtonOptions& options, const LaneRange& range, const ThreadLoads& results) {
    const Real force = axial_force / sector_.rollers;
    const fe::Lanes<Real> extrapolated = known_ >= 2.0;
    if (any(!extrapolated)) start_from_rest(force, gap);
    Real balanced(0.0);
    if (any(extrapolated)) balanced = sector_.sense * extrapolate(force, extrapolated);
    fe::ChainSummary<Real> summary =
        chain_.solve(sector_.sense * force, force, balanced, options);
    if (remember) this->remember(force, summary.converged);
    summary.energy -= 0.5 * sector_.free_compliance * force * force;
    deliver(summary, law_, sector_.contacts, records_, range, results);
    const auto& loaded = records_[0].state;
    const Real compliance = sector_.free_compliance + sector_.offset_compliance;
    range.store(sector_.sense * (loaded.head[0] + loaded.tail[0]) + compliance * force,
                results.axial_displacement);
    if (!results.tangent_stiffness.empty())
      range.store(sector_.rollers / (chain_.flexibility() + compliance), results.tangent_stiffness);
  }

 private:
  template <class Gap>
  void start_from_rest(const Real& force, const Gap& gap) {
    Real shift[2];
    for (int i = 0; i < 2; ++i) {
      const Real root = cbrt(force / (static_cast<double>(sector_.contacts) * sector_.cosine[i] *
                                      sector_.hertz_constant[i]));
      Real widest = gap(i, 0);
      for (int k = 1; k < sector_.contacts; ++k) widest = fe::largest(widest, Real(gap(i, k)));
      for (int k = 0; k < sector_.contacts; ++k) {
        records_[k].contact[i].closure = root * root + (widest - gap(i, k));
        records_[k].contact[i].remainder = Real(0.0);
      }
      shift[i] = sector_.sense * (root * root + widest) / sector_.cosine[i];
    }
    for (int k = 0; k < sector_.contacts; ++k) {
      auto& state = records_[k].state;
      for (int i = 0; i < M; ++i) state.head[i] = state.tail[i] = Real(0.0);
      state.head[Station::S] = shift[0] + shift[1];
      for (int i = Station::U; i < M; i += 3) state.head[i] = shift[1];
    }
  }

  /// The state reached becomes the youngest of the history; one that failed empties it.
  void remember(const Real& force, const fe::Lanes<Real>& converged) {
    known_ = select(converged, min(known_ + 1.0, Real(double{kAges})), Real(0.0));
    Real* const oldest = ages_[kAges - 1];
    for (int age = kAges - 1; age > 0; --age) {
      force_[age] = force_[age - 1];
      ages_[age] = ages_[age - 1];
    }
    force_[0] = force;
    ages_[0] = oldest;
    for (int k = 0; k < sector_.contacts; ++k) {
      Real* kept = ages_[0] + k * kKept;
      for (int i = 0; i < M; ++i) *kept++ = records_[k].state.head[i];
      for (const auto& c : records_[k].contact) {
        *kept++ = c.closure;
        *kept++ = c.force;
      }
    }
  }

  /// Start of the lanes marked; where loads do not ascend it is the last solution. Returns the
  /// force on the sector that its linear elements balance.
  Real extrapolate(const Real& force, const fe::Lanes<Real>& marked) {
    const Real &f0 = force_[0], &f1 = force_[1], &f2 = force_[2];
    const fe::Lanes<Real> line = (force > f0) & (f0 > f1);
    const fe::Lanes<Real> quadratic = line & (known_ >= double{kAges}) & (f1 > f2);
    const Real slope = (force - f0) / (f0 - f1);
    const Real none(0.0);
    const Real weight[kAges] = {
        select(quadratic, (force - f1) * (force - f2) / ((f0 - f1) * (f0 - f2)),
               select(line, 1.0 + slope, Real(1.0))),
        select(quadratic, (force - f0) * (force - f2) / ((f1 - f0) * (f1 - f2)),
               select(line, -slope, none)),
        select(quadratic, (force - f0) * (force - f1) / ((f2 - f0) * (f2 - f1)), none)};
    const bool three = any(quadratic);
    const auto combine = [&](const Real& youngest, const Real& middle, const Real& oldest)
                             __attribute__((always_inline)) {
      const Real two = weight[0] * youngest + weight[1] * middle;
      return three ? select(quadratic, two + weight[2] * oldest, two) : two;
    };
    for (int k = 0; k < sector_.contacts; ++k) {
      const Real *a = ages_[0] + k * kKept, *b = ages_[1] + k * kKept, *c = ages_[2] + k * kKept;
      Record& record = records_[k];
      const auto next = [&](Real& start) __attribute__((always_inline)) {
        start = select(marked, combine(*a++, *b++, *c++), start);
      };
      for (int i = 0; i < M; ++i) {
        next(record.state.head[i]);
        record.state.tail[i] = none;
      }
      for (auto& contact : record.contact) {
        next(contact.closure);
        next(contact.remainder);
      }
    }
    return select(marked, combine(f0, f1, f2), none);
  }

  const SweptSector<Real>& sector_;
  const Law& law_;
  Record* records_;
  Real* ages_[kAges];  ///< Of the history, the youngest first.
  fe::Chain<Real, Station, Law> chain_;
  Real force_[kAges] = {Real(0.0), Real(0.0), Real(0.0)};
  Real known_ = Real(0.0);  ///< Solutions in the history of the loads just before.
};

}  // namespace prs
