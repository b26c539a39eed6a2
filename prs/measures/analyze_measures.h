#pragma once

#include "prs/loads/analyze.h"
#include "prs/measures/measures.h"

namespace prs {

/// Everything that `analyze_measures` computes.
struct MeasuresResult {
  Result analysis;  ///< Contacts and thread loads that the measures are taken from.
  Measures measures;
  /// One per load case; absent where it did not converge.
  std::vector<std::optional<LoadMeasures>> load_measures;
  /// Whether the case has all for `slip` and `life`, which compute what is estimated here.
  bool slips = false, lives = false;
};

/// The measures of what is known of a case: contacts, and load cases that are solved.
MeasuresResult measured(const Conditions& c, Result analysis, Detail detail);

/// The chain of `analyze`, then the design measures of the mechanism and of each load case. Reads
/// nothing, prints nothing. The case must have passed `check_case` and the requirements of
/// `measures`. Throws CaseError where the geometry gives no contact.
MeasuresResult analyze_measures(const Conditions& c, Contacts found, AnalysisOptions options = {});
inline MeasuresResult analyze_measures(const Case& c, AnalysisOptions options = {}) {
  return analyze_measures(c, checked_contacts(c, options.detail), options);
}

}  // namespace prs
