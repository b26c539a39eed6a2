#pragma once

#include "prs/sector/chain/deliver.h"
#include "prs/sector/sector_numbers.h"

namespace prs {

/// Of a contact and lane in a kernel's workspace: record, nut, ground, two compliances.
template <class Station>
inline constexpr std::size_t kStationNumbers = sizeof(fe::ChainRecord<double, Station>) /
                                                   sizeof(double) +
                                               4;

/// Rigid bodies that share the load equally, every thread closed. gap(i, k) are the initial gaps.
template <class Real, class Station, class Gap>
void start_from_rest(const SectorNumbers<Real>& sector, int contacts, int stations,
                     fe::ChainRecord<Real, Station>* records, const Real& force, const Gap& gap) {
  Real shift[2];
  for (int i = 0; i < 2; ++i) {
    const Real &cosine = sector.cosine[kInterfaces[i]],
               &constant = sector.hertz_constant[kInterfaces[i]];
    const Real root = cbrt(force / (static_cast<double>(contacts) * cosine * constant));
    Real widest = gap(i, 0);
    for (int k = 1; k < stations; ++k) widest = fe::largest(widest, Real(gap(i, k)));
    if constexpr (fe::kFolded<Station>) widest = fe::largest(widest, mirrored(widest));
    for (int k = 0; k < stations; ++k)
      records[k].contact[i].net_approach = root * root + (widest - gap(i, k));
    shift[i] = sector.sense * (root * root + widest) / cosine;
  }
  for (int k = 0; k < stations; ++k) {
    auto& state = records[k].state;
    for (int i = 0; i < Station::kFreedoms; ++i) state.head[i] = state.tail[i] = Real(0.0);
    state.head[Station::S] = shift[0] + shift[1];
    for (int i = Station::U; i < Station::kFreedoms; i += 3) state.head[i] = shift[1];
  }
}

/// Equilibrium of one sector a lane under the axial force on its mechanism.
template <class Real, class Station, class Law, class Gap>
void solve_sectors(const SectorNumbers<Real>& sector, int contacts, const Station& station,
                   const Law& law, fe::ChainRecord<Real, Station>* records, const Real& axial_force,
                   const Gap& gap, const fe::NewtonOptions& options, const LaneRange& range,
                   ThreadLoads& results) {
  const Real force = axial_force / sector.rollers;
  start_from_rest(sector, contacts, station.stations, records, force, gap);
  fe::Chain<Real, Station, Law> chain(station, law, station.stations, records);
  Real load = sector.sense * force;
  if constexpr (fe::kFolded<Station>) load = first_lane(load);
  fe::ChainSummary<Real> summary = chain.solve(load, force, options);
  const Real compliance =
      sector.free_length / sector.plain_screw_rigidity + sector.offset_compliance;
  summary.energy -= 0.5 * compliance * force * force;
  deliver<fe::kFolded<Station>>(summary, law, contacts, records, range, results);
  const auto& loaded = records[0].state;
  range.store(sector.sense * (loaded.head[0] + loaded.tail[0]) + compliance * force,
              results.axial_displacement);
  if (!results.tangent_stiffness.empty())
    range.store(sector.rollers / (chain.flexibility() + compliance), results.tangent_stiffness);
}

}  // namespace prs
