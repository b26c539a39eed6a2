#pragma once

#include "prs/heat/thermal_network.h"
#include "prs/slip/slip.h"

namespace prs {

/// A load case for a share of the time.
struct TimedLoad {
  LoadCase load;
  double share = 1.0;
};

/// Temperatures at which the mean heat of loads that take turns flows off: parts take minutes to
/// warm, so that each has one temperature under all of them,
///
///     Q(T) = sum_j w_j Q_j(T),   w_j the shares of time.
///
/// With solved shares from the steady state of equal ones. The case must have passed `check_case`
/// and the requirements of `slip`.
SteadyHeat steady_heat_of(const Conditions& c, const Contacts& contacts,
                          std::span<const TimedLoad> loads);

/// A warning that there is no steady state.
Warning no_steady_state(HeatStatus status, const std::string& reason);

/// What `analyze_slip` delivers. Where the case states `heat`, loads and slip of each load case are
/// those at its steady temperatures, and the cycle of its duty is found. The case must have passed
/// `check_case` and the requirements of `slip`. Throws CaseError as `analyze_slip`.
Result analyze_heat(const Conditions& c, Contacts contacts, AnalysisOptions options = {});
inline Result analyze_heat(const Case& c, AnalysisOptions options = {}) {
  return analyze_heat(c, checked_contacts(c, options.detail), options);
}

}  // namespace prs
