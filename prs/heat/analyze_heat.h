#pragma once

#include "prs/heat/duty_cycle.h"
#include "prs/life/analyze_life.h"
#include "prs/preload/preloaded_mechanism.h"

namespace prs {

/// A load case for a share of the time.
struct TimedLoad {
  LoadCase load;
  double share = 1.0;
};

/// Temperatures for the mean heat of alternating loads: parts take minutes to warm, so that each has one temperature
/// under all loads,
///
///     Q(T) = sum_j w_j Q_j(T),   w_j the shares of time.
///
/// With solved shares the search starts from the steady state of equal ones. The case must have passed `check_case` and
/// the requirements of `slip`.
SteadyHeat steady_heat_of(const Conditions& c, const Contacts& contacts, std::span<const TimedLoad> loads);

/// Adds the warnings of `found` that are new.
void add_new(std::vector<Warning> found, std::vector<Warning>& warnings);

/// A warning that there is no steady state.
Warning no_steady_state(HeatStatus status, const std::string& reason);

/// Result of `analyze_slip`. If the case states `heat`, loads and slip of each load case are those at its steady
/// temperatures, and the cycle of its duty is computed. The case must have passed `check_case` and the requirements of
/// `slip`. Throws CaseError as `analyze_slip`.
Result analyze_heat(const Conditions& c, Contacts contacts, AnalysisOptions options = {});
inline Result analyze_heat(const Case& c, AnalysisOptions options = {}) {
  return analyze_heat(c, checked_contacts(c, options.detail), options);
}

// Preload and life at the temperatures that follow from the losses, if the case states `heat`.

/// Result of `analyze_preload`, with a block `heat` at the steady temperatures of the load case that
/// `preload.load_case` names, by default the first one. The case must have passed `check_case` and the requirements of
/// `preload`.
PreloadResult analyze_warm_preload(const Conditions& c, Contacts contacts);
inline PreloadResult analyze_warm_preload(const Case& c) {
  return analyze_warm_preload(c, checked_contacts(c, Detail::complete));
}

/// Result of `analyze_life`, with a block `heat`, solved shares and `life.temperatures: heat` at one temperature of
/// each part: for the mean heat of the spectrum, or the mean over the cycle of `heat.duty`. The case must have passed
/// `check_case` and the requirements of `life`.
LifeResult analyze_warm_life(const Conditions& c, Contacts contacts, std::optional<LoadHistory> history = {});
inline LifeResult analyze_warm_life(const Case& c, std::optional<LoadHistory> history = {}) {
  return analyze_warm_life(c, checked_contacts(c, Detail::complete), std::move(history));
}

}  // namespace prs
