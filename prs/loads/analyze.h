#pragma once

#include "prs/model/case.h"
#include "prs/model/detail.h"
#include "prs/loads/result.h"

namespace prs {

/// Contact pressure beyond which the static capacity of through-hardened steel is exceeded: a
/// permanent deformation of 1e-4 of the element's diameter at 4.0 GPa (ISO 76:2006, roller
/// bearings).
inline constexpr double kStaticPressureLimit = 4.0e9;

/// The whole chain: mechanism geometry -> contacts -> Hertz constants -> sector model -> Newton
/// equilibrium of each load case -> loads and pressures per thread, stiffness. With Detail::numbers
/// by the chain kernel, in place of CHOLMOD. Reads nothing, prints nothing. The case must have
/// passed `check_case` and the requirements of `solve`. A load case that does not converge is a
/// result with its status. Throws CaseError where the geometry gives no contact and the case does
/// not override it.
Result analyze(const Case& c, Detail detail = Detail::complete);

/// The first half of the chain: contact points, curvatures and, where materials are given, Hertz
/// contacts, with the ellipses and pressures of the load cases that have `share: equal`. The other
/// load cases are left out. Throws CaseError where an interface has no contact.
Result analyze_contacts(const Case& c, Detail detail = Detail::complete);

/// Contacts whose mechanism fits the structure, also where the mechanism had to be designed. Throws
/// CaseError where it does not.
Contacts checked_contacts(const Case& c, Detail detail);

}  // namespace prs
