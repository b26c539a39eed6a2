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
                          ThreadLoads& results) {
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

/// What the last solve left in the records, into the results. kFolded: one solve, whose second lane
/// holds the second half of the threads, the last one first.
template <bool kFolded, class Real, class Law, class Record>
void deliver(const fe::ChainSummary<Real>& summary, const Law& law, int contacts,
             const Record* records, const LaneRange& range, ThreadLoads& results) {
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

}  // namespace prs
