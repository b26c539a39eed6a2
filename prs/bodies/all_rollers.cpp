#include "prs/bodies/all_rollers.h"

#include "prs/mechanism/full_influence.h"

namespace prs {
namespace {

class RollersOnBeams : public RollersOnBodies {
 public:
  explicit RollersOnBeams(FullSolver& solver) : solver_(solver) {}

  FullDistribution solve(const FullModel& model, Detail detail) override { return solver_.solve(model, detail); }
  TravelModel travel(std::function<FullModel(double)> at, std::function<double(double)> turn) override {
    return {std::move(at), std::move(turn), [] {
              return [solver = std::make_shared<FullSolver>(FullStart::onwards)](const FullModel& f) {
                return solver->solve(f, Detail::complete);
              };
            }};
  }
  SymmetricLoads symmetric(const FullModel& model) override { return symmetric_loads(model); }

 private:
  FullSolver& solver_;
};

class RollersOnMeshes : public RollersOnBodies {
 public:
  RollersOnMeshes(const LoadedMechanism& of, const FullModel& model)
      : of_(of), bodies_(full_bodies(of.conditions, of.contacts, of.laws, model)) {}

  FullDistribution solve(const FullModel& model, Detail detail) override { return prs::solve(model, bodies_, detail); }
  TravelModel travel(std::function<FullModel(double)> at, std::function<double(double)>) override {
    return {std::move(at), {}, [this] { return [this](const FullModel& f) { return solve(f, Detail::complete); }; }};
  }
  SymmetricLoads symmetric(const FullModel& model) override {
    Conditions nominal = of_.conditions;
    nominal.deviations = {};
    const Direction direction = model.sense() < 0.0 ? Direction::tension : Direction::compression;
    return symmetric_loads(
        model,
        influence_solver(nominal, of_.contacts, of_.laws, direction, model.sector.position).solve(model.axial_force));
  }
  bool shoulder_lifts() const override { return bodies_.face.has_value(); }

 private:
  LoadedMechanism of_;
  FullBodies bodies_;
};

}  // namespace

std::unique_ptr<RollersOnBodies> rollers_on_beams(const LoadedMechanism&, const MakeModel&, FullSolver& solver) {
  return std::make_unique<RollersOnBeams>(solver);
}
std::unique_ptr<RollersOnBodies> rollers_on_meshes(const LoadedMechanism& of, const MakeModel& model, FullSolver&) {
  return std::make_unique<RollersOnMeshes>(of, model());
}

}  // namespace prs
