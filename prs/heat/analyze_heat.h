#pragma once

#include "prs/slip/slip.h"

namespace prs {

/// What `analyze_slip` delivers. Where the case states `heat`, loads and slip of each load case are
/// those at its steady temperatures, and the cycle of its duty is found. The case must have passed
/// `check_case` and the requirements of `slip`. Throws CaseError as `analyze_slip`.
Result analyze_heat(const Conditions& c, Contacts contacts, AnalysisOptions options = {});
inline Result analyze_heat(const Case& c, AnalysisOptions options = {}) {
  return analyze_heat(c, checked_contacts(c, options.detail), options);
}

}  // namespace prs
