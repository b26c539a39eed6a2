#pragma once

#include "prs/loads/result.h"
#include "prs/mechanism/modes.h"
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

/// The warning on a peak pressure [Pa] of an interface above `kStaticPressureLimit`.
Warning static_pressure_warning(std::string path, Interface i, double peak_pressure);

/// Contact pressure [Pa] above which a screw that turns under load gets a warning. Flanks of
/// bearing steel that run above about 2.5 GPa have a short life, whatever their static safety.
inline constexpr double kRunningPressureLimit = 2.5e9;

/// A warning where the largest peak pressure [Pa] of an interface is above `kRunningPressureLimit`;
/// none above `kStaticPressureLimit`, which has a warning of its own. `slip`, `life` and, with a
/// speed, `measures` give it: `solve` does not know whether the screw turns under the load.
std::optional<Warning> running_pressure_warning(std::string path, Interface i, double peak_pressure);

/// What a load case of the full mechanism has in addition to the loads of its threads.
struct FullLoads {
  int freedoms = 0;
  int rollers = 0;                   ///< Missing ones included.
  double carrier_angle = 0.0;        ///< [rad]
  std::vector<int> idle_rollers;     ///< From 1.
  std::vector<int> missing_rollers;  ///< From 1.
  ScrewEnd screw_end;
  SupportForce nut;
  std::array<RingForce, 2> rings;
  std::vector<SupportForce> bearings;
  SymmetricLoads symmetric;
  double symmetric_stiffness = 0.0;  ///< Force over displacement [N/m].
  std::optional<Orbit> orbit;
  std::optional<TravelResult> travel;
  std::optional<ModesResult> modes;
};

/// The answer to a load case on all rollers. `push`: on each roller present, of bars and refined
/// bodies; at this carrier angle only, so that an orbit is left out.
LoadCaseResult full_result(const LoadCase& load_case, const Conditions& c, const Contacts& contacts,
                           const PerInterface<ContactLaw>& laws, FullSolver& solver, Detail detail,
                           const std::vector<RollerPush>& push = {});

/// How a load case spreads over all rollers.
FullDistribution full_distribution(const LoadCase& load_case, const Conditions& c, const Contacts& contacts,
                                   const PerInterface<ContactLaw>& laws, FullSolver& solver, Detail detail,
                                   const std::vector<RollerPush>& push = {});

/// A turn of the carrier under a load case, each position answered by `solved`.
Orbit full_orbit(const LoadCase& load_case, const Conditions& c, const Contacts& contacts,
                 const PerInterface<ContactLaw>& laws,
                 const std::function<FullDistribution(double carrier_angle)>& solved, const SpatialLoad::Orbit& wanted);

/// A turn of the carrier under a load case.
Orbit full_orbit(const LoadCase& load_case, const Conditions& c, const Contacts& contacts,
                 const PerInterface<ContactLaw>& laws, FullSolver& solver, const SpatialLoad::Orbit& wanted);

/// Whether a travel that was asked for came to its end.
bool travels(const LoadCaseResult& result);

Warning no_orbit(const Orbit::Failure& failure);
/// Why a position of the carrier has no equilibrium, and which.
std::string text(const Orbit::Failure& failure);

}  // namespace prs
