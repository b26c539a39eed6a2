#pragma once

#include "prs/loads/analysis_options.h"
#include "prs/loads/result.h"
#include "prs/sector/sector.h"

namespace prs {

/// Contacts whose mechanism fits the structure, even if the mechanism had to be designed. They are found once in a run:
/// every analysis takes them with the conditions of the case. Throws CaseError if the mechanism does not fit.
Contacts checked_contacts(const Case& c, Detail detail);

/// The mechanism of those contacts, see `resolved`. The case is restored afterwards; throws CaseError if the mechanism
/// does not fit.
Mechanism checked_mechanism(Case& c);

/// The whole chain on known contacts: Hertz constants -> sector model -> Newton equilibrium of each load case -> loads
/// and pressures per thread, stiffness. Reads and prints nothing. The case must have passed `check_case` and the
/// requirements of `solve`. A load case that does not converge is a result with its status. Throws CaseError if the
/// geometry gives no contact and the case does not override it. Load cases for which `left_out` is true are not solved.
Result analyze(const Conditions& c, Contacts contacts, AnalysisOptions options = {},
               const std::function<bool(const LoadCase&)>& left_out = {});
inline Result analyze(const Case& c, AnalysisOptions options = {}) {
  return analyze(c, checked_contacts(c, options.detail), options);
}

/// The first half of the chain: contact points, curvatures and, if materials are given, Hertz contacts, with the
/// ellipses and pressures of the load cases that have `share: equal`. The other load cases are left out. Throws
/// CaseError if an interface has no contact.
Result analyze_contacts(const Conditions& c, Contacts contacts, Detail detail = Detail::complete);
inline Result analyze_contacts(const Case& c, Detail detail = Detail::complete) {
  return analyze_contacts(c, checked_contacts(c, detail), detail);
}

}  // namespace prs
