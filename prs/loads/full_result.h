#pragma once

#include "prs/loads/load_case_result.h"
#include "prs/mechanism/modes.h"

namespace prs {

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
