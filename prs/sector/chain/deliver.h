#pragma once

#include "fe/chain.h"
#include "prs/sector/chain/lane_access.h"
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

/// Thread by thread of one lane after the other: records are read in order.
template <class Real, class Record>
void deliver_normal_loads(int contacts, const Record* records, const LaneRange& range,
                          const ThreadLoads& results) {
  const auto& [screw, nut] = results.normal_load;
  for (std::size_t l = 0; l < kLanes<Real> && range.place(l) < range.size; ++l) {
    const std::size_t first = range.place(l) * results.stride;
    double* const at_screw = screw.empty() ? nullptr : screw.data() + first;
    double* const at_nut = nut.empty() ? nullptr : nut.data() + first;
    if (at_screw && at_nut)
      for (int k = 0; k < contacts; ++k) {
        at_screw[k] = lane(records[k].contact[0].force, l);
        at_nut[k] = lane(records[k].contact[1].force, l);
      }
    else if (double* const only = at_screw ? at_screw : at_nut)
      for (int k = 0; k < contacts; ++k)
        only[k] = lane(records[k].contact[at_screw ? 0 : 1].force, l);
  }
}

/// What the last solve left in the records, into the results. kFolded: one solve, whose second lane
/// holds the second half of the threads, the last one first.
template <bool kFolded, class Real, class Law, class Record>
void deliver(const fe::ChainSummary<Real>& summary, const Law& law, int contacts,
             const Record* records, const LaneRange& range, const ThreadLoads& results) {
  if constexpr (!kFolded) deliver_normal_loads<Real>(contacts, records, range, results);
  for (const Interface i : kInterfaces) {
    const auto c = static_cast<int>(i);
    if constexpr (kFolded) {
      for (int k = 0; k < contacts; ++k) {
        const bool second = 2 * k >= contacts;
        const int station = second ? contacts - 1 - k : k;
        const std::size_t l = second ? 1 : 0;
        const auto& contact = records[station].contact[c];
        const auto thread = static_cast<std::size_t>(k);
        if (!results.normal_load[i].empty())
          results.normal_load[i][thread] = lane(contact.force, l);
        if (!results.approach[i].empty())
          results.approach[i][thread] = lane(law.law_approach(c, station, contact.net_approach), l);
      }
      continue;
    }
    if (!results.approach[i].empty())
      for (int k = 0; k < contacts; ++k)
        range.store(law.law_approach(c, k, records[k].contact[c].net_approach), results.approach[i],
                    results.stride, static_cast<std::size_t>(k));
  }
  if (!results.status.empty()) {
    double status[kLanes<Real>];
    to_lanes(status_of(summary), status);
    for (std::size_t l = 0; l < kLanes<Real> && range.place(l) < range.size; ++l)
      results.status[range.place(l)] = static_cast<fe::NewtonStatus>(static_cast<int>(status[l]));
  }
  range.store(summary.iterations, results.iterations);
  range.store(summary.initial_relative_residual, results.initial_relative_residual);
  range.store(summary.relative_residual, results.relative_residual);
  range.store(summary.energy, results.energy);
}

}  // namespace prs
