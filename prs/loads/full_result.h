#pragma once

#include "prs/loads/load_case_result.h"
#include "prs/mechanism/modes.h"

namespace prs {

/// Results of a load case of the full mechanism in addition to the loads of its threads.
struct FullLoads {
  int freedoms = 0;
  int rollers = 0;                   ///< Number of rollers, missing ones included.
  double carrier_angle = 0.0;        ///< [rad]
  std::vector<int> idle_rollers;     ///< Numbers from 1.
  std::vector<int> missing_rollers;  ///< Numbers from 1.
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

/// Result of a load case on all rollers. `push`: on each present roller, for bars and refined bodies; valid at this
/// carrier angle only, so that an orbit is left out.
LoadCaseResult full_result(const LoadCase& load_case, const Conditions& c, const Contacts& contacts,
                           const PerInterface<ContactLaw>& laws, FullSolver& solver, Detail detail,
                           const std::vector<RollerPush>& push = {});

/// Distribution of a load case over all rollers.
FullDistribution full_distribution(const LoadCase& load_case, const Conditions& c, const Contacts& contacts,
                                   const PerInterface<ContactLaw>& laws, FullSolver& solver, Detail detail,
                                   const std::vector<RollerPush>& push = {});

/// A turn of the carrier under a load case, with `solved` for each position.
Orbit full_orbit(const LoadCase& load_case, const Conditions& c, const Contacts& contacts,
                 const PerInterface<ContactLaw>& laws,
                 const std::function<FullDistribution(double carrier_angle)>& solved, const SpatialLoad::Orbit& wanted);

/// A turn of the carrier under a load case.
Orbit full_orbit(const LoadCase& load_case, const Conditions& c, const Contacts& contacts,
                 const PerInterface<ContactLaw>& laws, FullSolver& solver, const SpatialLoad::Orbit& wanted);

/// Whether a requested travel was completed.
bool travels(const LoadCaseResult& result);

Warning no_orbit(const Orbit::Failure& failure);
/// Reason why a position of the carrier has no equilibrium, with the position.
std::string text(const Orbit::Failure& failure);

}  // namespace prs
