#pragma once

#include <optional>
#include <string>

#include "prs/threads/contact_laws.h"
#include "prs/sector/load_distribution.h"
#include "prs/loads/result.h"

namespace prs {

/// The answer to a load case whose load distribution is solved: loads, ellipses and pressures of
/// each thread, displacement and stiffness; the status alone where it did not converge.
LoadCaseResult solved_result(const LoadCase& load_case, const Contacts& contacts,
                             const PerInterface<ContactLaw>& laws, LoadDistribution distribution);

/// Threads with equal loads by assumption; approaches follow where the Hertz constants are known.
LoadCaseResult equal_share_result(const LoadCase& load_case, const Contacts& contacts,
                                  const PerInterface<double>& normal_angle,
                                  const PerInterface<std::optional<double>>& hertz_constant);

/// The same with the laws of a load distribution.
LoadCaseResult equal_share_result(const LoadCase& load_case, const Contacts& contacts,
                                  const PerInterface<ContactLaw>& laws);

/// The same with what the geometry gives; the contacts must exist.
LoadCaseResult equal_share_result(const LoadCase& load_case, const Contacts& contacts);

/// Adds what is unusual about an answer: open threads, pressures, ellipses beyond the flanks.
void add_warnings(LoadCaseResult& result, const Contacts& contacts);

/// Contact pressure from which a note stands beside a screw that runs under it: flanks of bearing
/// steel that turn under more than some 2.5 GPa live short, however static safety stands.
inline constexpr double kRunningPressureLimit = 2.5e9;

/// A note where the largest peak pressure [Pa] of an interface is above `kRunningPressureLimit`;
/// none above `kStaticPressureLimit`, of which its own warning speaks. `slip`, `life` and, with a
/// speed, `measures` have it: `solve` does not know whether the screw turns under the load.
std::optional<std::string> running_pressure_note(Interface i, double peak_pressure);

}  // namespace prs
