#pragma once

#include "prs/life/analyze_life.h"
#include "prs/preload/analyze_preload.h"

namespace prs {

// Preload and life at the temperatures that follow from the losses, where the case states `heat`.

/// What `analyze_preload` delivers, with a block `heat` at the steady temperatures of the load case
/// that `preload.load_case` names, by default the first one. The case must have passed `check_case`
/// and the requirements of `preload`.
PreloadResult analyze_warm_preload(const Conditions& c, Contacts contacts);
inline PreloadResult analyze_warm_preload(const Case& c) {
  return analyze_warm_preload(c, checked_contacts(c, Detail::complete));
}

/// What `analyze_life` delivers, with a block `heat`, solved shares and `life.temperatures: heat`
/// at one temperature of each part: that at which the mean heat of the spectrum flows off, or the
/// mean over the cycle of `heat.duty`. The case must have passed `check_case` and the requirements
/// of `life`.
LifeResult analyze_warm_life(const Conditions& c, Contacts contacts,
                             std::optional<LoadHistory> history = {});
inline LifeResult analyze_warm_life(const Case& c, std::optional<LoadHistory> history = {}) {
  return analyze_warm_life(c, checked_contacts(c, Detail::complete), std::move(history));
}

}  // namespace prs
