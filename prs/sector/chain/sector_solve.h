#pragma once

#include "fe/chain.h"
#include "prs/sector/chain/chain_sector.h"
#include "prs/sector/chain/thread_loads.h"

namespace prs {

template <class Real>
Real status_of(const fe::ChainSummary<Real>& s) {
  const auto code = [](fe::NewtonStatus status) { return Real(static_cast<double>(status)); };
  using enum fe::NewtonStatus;
  return select(s.converged, code(converged),
                select(s.singular, code(not_positive_definite),
                       select(s.search_failed, code(line_search_failed), code(iteration_limit))));
}

/// Copies thread by thread, one lane after the other: records are read in order.
template <class Real, class Record>
void deliver_normal_loads(int contacts, const Record* records, const LaneRange& range, ThreadLoads& results) {
  auto& [screw, nut] = results.normal_load;
  for (std::size_t l = 0; l < kLanes<Real> && range.first + l < range.size; ++l) {
    double* const at_screw = screw.data() + (range.first + l) * results.stride;
    double* const at_nut = nut.data() + (range.first + l) * results.stride;
    for (int k = 0; k < contacts; ++k) {
      at_screw[k] = lane(records[k].contact[0].force, l);
      at_nut[k] = lane(records[k].contact[1].force, l);
    }
  }
}

/// Copies the last solve from the records to the results. kFolded: one solve, whose second lane holds the second half
/// of the threads, the last one first.
template <bool kFolded, class Real, class Law, class Record>
void deliver(const fe::ChainSummary<Real>& summary, const Law& law, int contacts, const Record* records,
             const LaneRange& range, ThreadLoads& results) {
  if constexpr (!kFolded) deliver_normal_loads<Real>(contacts, records, range, results);
  for (const Interface i : kInterfaces) {
    const auto c = static_cast<int>(i);
    for (int k = 0; k < contacts; ++k) {
      const bool second = kFolded && 2 * k >= contacts;
      const int station = second ? contacts - 1 - k : k;
      const auto& contact = records[station].contact[c];
      const Real approach = law.law_approach(c, station, contact.net_approach);
      const auto thread = static_cast<std::size_t>(k);
      if constexpr (kFolded) {
        results.normal_load[i][thread] = lane(contact.force, second ? 1 : 0);
        results.approach[i][thread] = lane(approach, second ? 1 : 0);
      } else {
        range.store(approach, results.approach[i], results.stride, thread);
      }
    }
  }
  range.store(status_of(summary), results.status);
  range.store(summary.iterations, results.iterations);
  range.store(summary.initial_relative_residual, results.initial_relative_residual);
  range.store(summary.relative_residual, results.relative_residual);
  range.store(summary.energy, results.energy);
}

/// Number of values per contact and lane in a kernel's workspace: record, nut, ground, two compliances.
template <class Station>
inline constexpr std::size_t kStationNumbers = sizeof(fe::ChainRecord<double, Station>) / sizeof(double) + 4;

/// Start: rigid bodies that share the load equally, every thread closed. gap(i, k): initial gaps.
template <class Real, class Station, class Gap>
void start_from_rest(const SectorNumbers<Real>& sector, int contacts, int stations,
                     fe::ChainRecord<Real, Station>* records, const Real& force, const Gap& gap) {
  Real shift[2];
  for (int i = 0; i < 2; ++i) {
    const Real &cosine = sector.cosine[kInterfaces[i]], &constant = sector.hertz_constant[kInterfaces[i]];
    const Real root = cbrt(force / (static_cast<double>(contacts) * cosine * constant));
    Real widest = gap(i, 0);
    for (int k = 1; k < stations; ++k) widest = fe::largest(widest, Real(gap(i, k)));
    if constexpr (fe::kFolded<Station>) widest = fe::largest(widest, Station::mirrored(widest));
    for (int k = 0; k < stations; ++k) records[k].contact[i].net_approach = root * root + (widest - gap(i, k));
    shift[i] = sector.sense * (root * root + widest) / cosine;
  }
  for (int k = 0; k < stations; ++k) {
    auto& state = records[k].state;
    for (int i = 0; i < Station::kFreedoms; ++i) state.head[i] = state.tail[i] = Real(0.0);
    state.head[Station::S] = shift[0] + shift[1];
    for (int i = Station::U; i < Station::kFreedoms; i += 3) state.head[i] = shift[1];
  }
}

/// Equilibrium of one sector per lane under the axial force on its mechanism.
template <class Real, class Station, class Law, class Gap>
void solve_sectors(const SectorNumbers<Real>& sector, int contacts, const Station& station, const Law& law,
                   fe::ChainRecord<Real, Station>* records, const Real& axial_force, const Gap& gap,
                   const fe::NewtonOptions& options, const LaneRange& range, ThreadLoads& results) {
  const Real force = axial_force / sector.rollers;
  start_from_rest(sector, contacts, station.stations, records, force, gap);
  fe::Chain<Real, Station, Law> chain(station, law, station.stations, records);
  Real load = sector.sense * force;
  if constexpr (fe::kFolded<Station>) load = Station::first_lane(load);
  fe::ChainSummary<Real> summary = chain.solve(load, force, options);
  const Real compliance = sector.free_length / sector.plain_screw_rigidity + sector.offset_compliance;
  summary.energy -= 0.5 * compliance * force * force;
  deliver<fe::kFolded<Station>>(summary, law, contacts, records, range, results);
  const auto& loaded = records[0].state;
  range.store(sector.sense * (loaded.head[0] + loaded.tail[0]) + compliance * force, results.axial_displacement);
  if (!results.tangent_stiffness.empty())
    range.store(sector.rollers / (chain.flexibility() + compliance), results.tangent_stiffness);
}

}  // namespace prs
