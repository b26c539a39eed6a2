#pragma once

#include "prs/loads/result.h"
#include "prs/sector/sector.h"
#include "simd/instruction_set.h"

namespace prs {

/// The answer to a load case whose load distribution is solved: loads, ellipses and pressures of
/// each thread, displacement and stiffness; the status alone where it did not converge.
LoadCaseResult solved_result(const LoadCase& load_case, const Contacts& contacts, const PerInterface<ContactLaw>& laws,
                             LoadDistribution distribution);

/// Which numbers of the threads are wanted besides loads and approaches.
struct LoadDetail {
  bool axial_load = true;
  bool load_rate = true;
  bool ellipses = true;  ///< Semi-axes, pressures and what follows from them.
  bool tangent_stiffness = true;
};

/// The same into the result of that load case, which keeps its memory and exchanges it with the
/// distribution's. What is not wanted is left empty.
void set_solved_result(LoadCaseResult& result, const Contacts& contacts, const PerInterface<ContactLawNumbers>& laws,
                       LoadDistribution& distribution, simd::InstructionSet set, const LoadDetail& detail = {});

/// Threads with equal loads by assumption; approaches follow where the Hertz constants are known.
LoadCaseResult equal_share_result(const LoadCase& load_case, const Contacts& contacts,
                                  const PerInterface<double>& normal_angle,
                                  const PerInterface<std::optional<double>>& hertz_constant);

/// The same into the result of that load case, which keeps its memory. What is not wanted is left
/// empty.
void set_equal_share_result(LoadCaseResult& result, const Contacts& contacts, const PerInterface<double>& normal_angle,
                            const PerInterface<std::optional<double>>& hertz_constant, simd::InstructionSet set,
                            const LoadDetail& detail = {});

/// Equal loads with the laws of a load distribution.
LoadCaseResult equal_share_result(const LoadCase& load_case, const Contacts& contacts,
                                  const PerInterface<ContactLaw>& laws);

/// Result of equal shares with the laws that the geometry gives; the contacts must exist.
LoadCaseResult equal_share_result(const LoadCase& load_case, const Contacts& contacts);
void set_equal_share_result(LoadCaseResult& result, const Contacts& contacts, simd::InstructionSet set,
                            const LoadDetail& detail = {});

/// Adds warnings: open threads, high pressures, ellipses beyond the flanks.
void add_warnings(LoadCaseResult& result, const Contacts& contacts);

/// The warning on a peak pressure [Pa] of an interface above its limit.
std::optional<Warning> static_pressure_warning(std::string path, Interface i, double peak_pressure,
                                               const Contacts& contacts);

/// Contact pressure [Pa] above which a screw that turns under load gets a warning. Flanks of
/// bearing steel that run above about 2.5 GPa have a short life, whatever their static safety.
inline constexpr double kRunningPressureLimit = 2.5e9;

/// A warning where the largest peak pressure [Pa] of an interface is above `kRunningPressureLimit`;
/// none above its limit, which has a warning of its own, or where no limit is known. `slip`, `life` and, with a
/// speed, `measures` give it: `solve` does not know whether the screw turns under the load.
std::optional<Warning> running_pressure_warning(std::string path, Interface i, double peak_pressure,
                                                const Contacts& contacts);

}  // namespace prs
