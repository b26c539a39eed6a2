#include "prs/loads/distribution_solver.h"

#include "prs/sector/chain/fallback_solver.h"
#include "prs/sector/influence/influence_solver.h"

namespace prs {
namespace {

template <class SolverOfSector>
DistributionSolver shared(std::shared_ptr<SolverOfSector> solver) {
  return [solver = std::move(solver)](double axial_force) { return solver->solve(axial_force); };
}

}  // namespace

DistributionSolver distribution_solver(const Conditions& c, const Contacts& contacts,
                                       const PerInterface<ContactLaw>& laws, Direction direction,
                                       double position, Solver solver) {
  if (c.model.bodies == ModelOptions::Bodies::influence)
    return shared(std::make_shared<InfluenceSolver>(
        influence_solver(c, contacts, laws, direction, position)));
  SectorModel model = sector_model(contacts.mechanism, *c.structure, *c.materials, c.model, laws,
                                   direction, position, c.deviations);
  if (solver == Solver::chain) return shared(std::make_shared<FallbackSolver>(std::move(model)));
  return shared(std::make_shared<SectorSolver>(build_sector(model)));
}

}  // namespace prs
