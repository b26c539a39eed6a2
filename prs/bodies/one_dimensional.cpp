#include "prs/bodies/one_dimensional.h"

#include "prs/bodies/all_rollers.h"
#include "prs/sector/chain/chain_solver.h"
#include "prs/sector/roller_guides.h"

namespace prs {
namespace {

template <class SolverOfSector>
DistributionSolver shared(std::shared_ptr<SolverOfSector> solver) {
  return [solver = std::move(solver)](double axial_force) { return solver->solve(axial_force); };
}

class RunningBeams : public RunningSector {
 public:
  explicit RunningBeams(const LoadedSector& of) : solver_(build_sector(of.model())) {}

  LoadDistribution at_rest(double axial_force) override { return solver_.solve(force_ = axial_force); }
  fe::NewtonStatus go_on(const RollerPush& push) override { return under(push, true).status; }
  bool follow(const RollerPush& per_normal_load) override {
    return solver_.follow(force_, turned_loads(solver_, force_, per_normal_load));
  }

  PerInterface<std::vector<double>> normal_load() const override {
    PerInterface<std::vector<double>> loads;
    for (const Interface i : kInterfaces)
      for (int k = 0; k < sector().contacts(); ++k)
        loads[i].push_back(solver_.equations().response(solver_.state(), sector().spring(i, k)).force);
    return loads;
  }
  GuideLoads guides() const override { return guide_loads(sector(), solver_.equations(), solver_.state()); }
  LoadDistribution loads(const RollerPush& push) override {
    fe::NewtonSummary summary = under(push, false);
    LoadDistribution found = solver_.at(solver_.state(), force_);
    found.solve = std::move(summary);
    return found;
  }

 private:
  const Sector& sector() const { return solver_.sector(); }
  fe::NewtonSummary under(const RollerPush& push, bool is_trial) {
    return solver_.go_on(force_, push_loads(sector(), push), is_trial);
  }

  SectorSolver solver_;
  double force_ = 0.0;
};

}  // namespace

const BodySolver kOneDimensional{
    .at_rest =
        [](const LoadedSector& of, Solver solver) {
          if (solver == Solver::chain) return shared(std::make_shared<FallbackSolver>(of.model()));
          return shared(std::make_shared<SectorSolver>(build_sector(of.model())));
        },
    .running = [](const LoadedSector& of) -> std::unique_ptr<RunningSector> {
      return std::make_unique<RunningBeams>(of);
    },
    .all_rollers = rollers_on_beams,
};

}  // namespace prs
