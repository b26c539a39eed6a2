#pragma once

#include "prs/loads/result.h"
#include "prs/sector/sector.h"
#include "simd/instruction_set.h"

namespace prs {

/// Result of a load case whose load distribution is solved: loads, ellipses and pressures of each thread, displacement
/// and stiffness; only the status if it did not converge.
LoadCaseResult solved_result(const LoadCase& load_case, const Contacts& contacts, const PerInterface<ContactLaw>& laws,
                             LoadDistribution distribution);

/// Numbers of the threads to compute besides loads and approaches.
struct LoadDetail {
  bool axial_load = true;
  bool load_rate = true;
  bool ellipses = true;  ///< Whether to compute semi-axes, pressures and derived values.
  bool tangent_stiffness = true;
};

/// Fills the result of a load case, which keeps its memory and exchanges it with the distribution's. Parts not in
/// `detail` are left empty.
void set_solved_result(LoadCaseResult& result, const Contacts& contacts, const PerInterface<ContactLawNumbers>& laws,
                       LoadDistribution& distribution, simd::InstructionSet set, const LoadDetail& detail = {});

/// Result with equal thread loads by assumption; approaches follow if the Hertz constants are known.
LoadCaseResult equal_share_result(const LoadCase& load_case, const Contacts& contacts,
                                  const PerInterface<double>& normal_angle,
                                  const PerInterface<std::optional<double>>& hertz_constant);

/// Fills the result of a load case with equal thread loads, which keeps its memory. Parts not in `detail` are left
/// empty.
void set_equal_share_result(LoadCaseResult& result, const Contacts& contacts, const PerInterface<double>& normal_angle,
                            const PerInterface<std::optional<double>>& hertz_constant, simd::InstructionSet set,
                            const LoadDetail& detail = {});

/// Result with equal thread loads and the laws of a load distribution.
LoadCaseResult equal_share_result(const LoadCase& load_case, const Contacts& contacts,
                                  const PerInterface<ContactLaw>& laws);

/// Result with equal thread loads and the laws from the geometry; the contacts must exist.
LoadCaseResult equal_share_result(const LoadCase& load_case, const Contacts& contacts);
void set_equal_share_result(LoadCaseResult& result, const Contacts& contacts, simd::InstructionSet set,
                            const LoadDetail& detail = {});

/// Adds warnings: open threads, high pressures, ellipses beyond the flanks.
void add_warnings(LoadCaseResult& result, const Contacts& contacts);

/// Warning on a peak pressure [Pa] of an interface above its limit.
std::optional<Warning> static_pressure_warning(std::string path, Interface i, double peak_pressure,
                                               const Contacts& contacts);

/// Contact pressure [Pa] above which a screw that turns under load gets a warning. Flanks of
/// bearing steel that run above about 2.5 GPa have a short life, whatever their static safety.
inline constexpr double kRunningPressureLimit = 2.5e9;

/// Warning if the largest peak pressure [Pa] of an interface is above `kRunningPressureLimit`; none above the static
/// limit, which has its own warning, or if no limit is known. Given by `slip`, `life` and, with a speed, `measures`:
/// `solve` does not know whether the screw turns under the load.
std::optional<Warning> running_pressure_warning(std::string path, Interface i, double peak_pressure,
                                                const Contacts& contacts);

}  // namespace prs
