#pragma once

#include "prs/loads/analysis_options.h"
#include "prs/model/case.h"
#include "prs/sector/load_distribution.h"
#include "prs/threads/contacts.h"

namespace prs {

/// Equilibrium of one sector under the axial force on the whole mechanism [N], > 0.
using DistributionSolver = std::function<LoadDistribution(double axial_force)>;

/// Solves load after load in one direction, with the first contact at one position on the nut. The
/// influence model has a solver of its own. Throws CaseError where a body cannot be meshed.
DistributionSolver distribution_solver(const Conditions& c, const Contacts& contacts,
                                       const PerInterface<ContactLaw>& laws, Direction direction,
                                       double position, Solver solver);

}  // namespace prs
