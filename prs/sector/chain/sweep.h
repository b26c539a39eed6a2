#pragma once

#include "fe/chain.h"
#include "prs/sector/chain/deliver.h"
#include "prs/sector/chain/lane_access.h"
#include "prs/sector/sector_numbers.h"

namespace prs {

/// Loads F one after the other on one sector a lane. Displacements grow as F^(2/3) while Hertz's
/// contacts are softer than the bodies, by a factor that is smooth in s = F^(1/3): as far as the
/// loads ascend, a lane starts from
///
///     u(F) = sum over the last 3 loads of (s/s_j)^2 L_j(s) u_j,   L_j Lagrange's polynomials,
///
/// from two loads or one where the step to this load is more than twice the one before. The first
/// start is from rigid bodies that share the load equally, every thread closed. Folded chains
/// (fe::kFolded) remember nothing.
template <class Real, class Station, class Law>
class Sweep {
 public:
  using Record = fe::ChainRecord<Real, Station>;
  static constexpr int M = Station::kFreedoms;
  static constexpr int kAges = 3;
  /// Of a contact and lane in a kernel's workspace: record, nut, ground, two compliances, history.
  static constexpr std::size_t kWorkspaceNumbers = sizeof(Record) / sizeof(Real) + 4 + kAges * M;

  /// `history` has room for kAges M numbers a station, unless no state is to be remembered.
  Sweep(const SectorNumbers<Real>& sector, int contacts, const Station& station, const Law& law,
        Record* records, Real* history)
      : sector_(sector),
        contacts_(contacts),
        stations_(station.stations),
        free_compliance_(sector.free_length / sector.plain_screw_rigidity),
        station_(station),
        law_(law),
        records_(records),
        chain_(station, law, stations_, records) {
    for (int age = 0; age < kAges; ++age) ages_[age] = history + age * stations_ * M;
  }

  /// Solves under the axial forces on the mechanisms; gap(i, k) are the initial gaps. `remember`:
  /// more loads follow.
  template <class Gap>
  void solve(const Real& axial_force, const Gap& gap, bool remember,
             const fe::NewtonOptions& options, const LaneRange& range, const ThreadLoads& results) {
    const Real force = axial_force / sector_.rollers;
    const fe::Lanes<Real> extrapolated = known_ >= 1.0;
    if (any(!extrapolated)) start_from_rest(force, gap);
    if constexpr (!fe::kFolded<Station>)
      if (any(extrapolated)) extrapolate(force, gap, extrapolated);
    Real load = sector_.sense * force;
    if constexpr (fe::kFolded<Station>) load = first_lane(load);
    fe::ChainSummary<Real> summary = chain_.solve(load, force, options, !any(extrapolated));
    if constexpr (!fe::kFolded<Station>)
      if (remember) this->remember(force, summary.converged);
    summary.energy -= 0.5 * free_compliance_ * force * force;
    deliver<fe::kFolded<Station>>(summary, law_, contacts_, records_, range, results);
    const auto& loaded = records_[0].state;
    const Real compliance = free_compliance_ + sector_.offset_compliance;
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
      const Real &cosine = sector_.cosine[kInterfaces[i]],
                 &constant = sector_.hertz_constant[kInterfaces[i]];
      const Real root = cbrt(force / (static_cast<double>(contacts_) * cosine * constant));
      Real widest = gap(i, 0);
      for (int k = 1; k < stations_; ++k) widest = fe::largest(widest, Real(gap(i, k)));
      if constexpr (fe::kFolded<Station>) widest = fe::largest(widest, mirrored(widest));
      for (int k = 0; k < stations_; ++k)
        records_[k].contact[i].net_approach = root * root + (widest - gap(i, k));
      shift[i] = sector_.sense * (root * root + widest) / cosine;
    }
    for (int k = 0; k < stations_; ++k) {
      auto& state = records_[k].state;
      for (int i = 0; i < M; ++i) state.head[i] = state.tail[i] = Real(0.0);
      state.head[Station::S] = shift[0] + shift[1];
      for (int i = Station::U; i < M; i += 3) state.head[i] = shift[1];
    }
  }

  /// The state reached becomes the youngest of the history; one that failed empties it.
  void remember(const Real& force, const fe::Lanes<Real>& converged) {
    Real* const oldest = ages_[kAges - 1];
    for (int age = kAges - 1; age > 0; --age) {
      ages_[age] = ages_[age - 1];
      root_[age] = root_[age - 1];
    }
    root_[0] = cbrt(force);
    ages_[0] = oldest;
    known_ = select(converged, min(known_ + 1.0, Real(double{kAges})), Real(0.0));
    for (int k = 0; k < stations_; ++k) {
      const Record& record = records_[k];
      Real* kept = ages_[0] + k * M;
      for (int i = 0; i < M; ++i) *kept++ = select(converged, record.state.head[i], Real(0.0));
    }
    if (first_)  // numbers, whatever weight they get
      for (int i = 0; i < M * stations_; ++i) ages_[1][i] = ages_[2][i] = ages_[0][i];
    first_ = false;
  }

  /// Start of the lanes marked; where the load does not ascend it is the last solution.
  template <class Gap>
  void extrapolate(const Real& force, const Gap& gap, const fe::Lanes<Real>& marked) {
    const Real s = cbrt(force);
    const Real &s0 = root_[0], &s1 = root_[1], &s2 = root_[2];
    const fe::Lanes<Real> one = s > s0;
    const auto near = [](const Real& to, const Real& from, const Real& before) {
      return to - from <= 2.0 * (from - before);
    };
    const fe::Lanes<Real> two = one & (known_ >= 2.0) & near(s, s0, s1);
    const fe::Lanes<Real> three = two & (known_ >= 3.0) & near(s0, s1, s2) & (s1 > s2);
    const Real none(0.0), unit(1.0);
    const Real scale[kAges] = {s / s0, s / s1, s / s2};
    // (s - s_j) and 1/(s_i - s_j)
    const Real to0 = s - s0, to1 = s - s1, to2 = s - s2;
    const Real by01 = unit / (s0 - s1), by02 = unit / (s0 - s2), by12 = unit / (s1 - s2);
    const auto where = [&](const fe::Lanes<Real>& lanes, const Real& factor) {
      return select(lanes, factor, unit);
    };
    const Real weight[kAges] = {
        where(one, scale[0] * scale[0]) * where(two, to1 * by01) * where(three, to2 * by02),
        select(two, scale[1] * scale[1] * -to0 * by01 * where(three, to2 * by12), none),
        select(three, scale[2] * scale[2] * to0 * by02 * to1 * by12, none)};
    if (any(!marked))
      combine(weight, gap,
              [&](const Real& sum, const Real& other) { return select(marked, sum, other); });
    else
      combine(weight, gap, [](const Real& sum, const Real&) { return sum; });
  }

  /// Weighted sum of the states in the history, as far as `choose(sum, start there)` takes it.
  template <class Gap, class Choose>
  void combine(const Real* weight, const Gap& gap, Choose choose) {
    for (int k = 0; k < stations_; ++k) {
      const Real *a = ages_[0] + k * M, *b = ages_[1] + k * M, *c = ages_[2] + k * M;
      Record& record = records_[k];
      for (int i = 0; i < M; ++i) {
        record.state.head[i] =
            choose(weight[0] * a[i] + weight[1] * b[i] + weight[2] * c[i], record.state.head[i]);
        record.state.tail[i] = Real(0.0);
      }
      fe::unroll<2>([&](auto i) __attribute__((always_inline)) {
        Real& net_approach = record.contact[i].net_approach;
        net_approach = choose(fe::along<i>(station_, record.state.head) - gap(i, k), net_approach);
      });
    }
  }

  const SectorNumbers<Real>& sector_;
  int contacts_;
  int stations_;          ///< As many; half as many where the chain is folded.
  Real free_compliance_;  ///< Of the screw before the first contact [m/N].
  const Station& station_;
  const Law& law_;
  Record* records_;
  Real* ages_[kAges];  ///< Of the history, the youngest first.
  fe::Chain<Real, Station, Law> chain_;
  Real root_[kAges] = {Real(0.0), Real(0.0), Real(0.0)};  ///< s
  Real known_ = Real(0.0);  ///< Solutions in the history of the loads just before.
  bool first_ = true;       ///< Nothing is in the history yet.
};

}  // namespace prs
