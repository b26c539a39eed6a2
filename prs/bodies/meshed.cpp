#include "prs/bodies/meshed.h"

#include "prs/bodies/all_rollers.h"
#include "prs/sector/influence/influence_solver.h"

namespace prs {
namespace {

InfluenceSolver solver_of(const LoadedSector& of, bool friction) {
  return influence_solver(of.conditions, of.contacts, of.laws, of.direction, of.position, shared_matrix_cache(),
                          friction);
}

class RunningMeshes : public RunningSector {
 public:
  explicit RunningMeshes(const LoadedSector& of)
      : solver_(solver_of(of, true)), sense_(sense(of.direction)), pitch_(axial_pitch(of.contacts.mechanism)) {}

  LoadDistribution at_rest(double axial_force) override { return last_ = solver_.solve(force_ = axial_force); }
  fe::NewtonStatus go_on(const RollerPush&) override { return fe::NewtonStatus::no_equilibrium; }
  bool follow(const RollerPush& per_normal_load) override {
    LoadDistribution now = solver_.solve(force_, per_normal_load, sense_, pitch_);
    if (!now.solve.converged()) return false;
    last_ = std::move(now);
    return true;
  }

  PerInterface<std::vector<double>> normal_load() const override { return last_.normal_load; }
  GuideLoads guides() const override { return last_.guides.front(); }
  LoadDistribution loads(const RollerPush&) override { return std::move(last_); }

 private:
  InfluenceSolver solver_;
  double sense_, pitch_, force_ = 0.0;
  LoadDistribution last_;
};

}  // namespace

const BodySolver kMeshed{
    .at_rest = [](const LoadedSector& of, Solver) -> DistributionSolver {
      return [solver = solver_of(of, false)](double axial_force) { return solver.solve(axial_force); };
    },
    .running = [](const LoadedSector& of) -> std::unique_ptr<RunningSector> {
      return std::make_unique<RunningMeshes>(of);
    },
    .all_rollers = rollers_on_meshes,
    .is_at_hand =
        [](const LoadedSector& of) {
          return influence_is_kept(of.conditions, of.contacts, of.laws, of.direction, of.position);
        },
};

}  // namespace prs
