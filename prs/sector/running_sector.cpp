#include "prs/sector/running_sector.h"

namespace prs {
namespace {

using fe::Dof;

void add_force(std::vector<fe::NodalLoad>& loads, const fe::RigidArm& at, double x, double y) {
  loads.push_back({at.node, Dof::u, x});
  loads.push_back({at.node, Dof::v, y});
  loads.push_back({at.node, Dof::theta, at.dx * y - at.dy * x});
}

/// Friction of thread k on the roller, and back on screw or nut.
void add_friction(std::vector<fe::NodalLoad>& loads, const Sector& s, const RollerPush& push,
                  Interface i, int k) {
  const fe::SpringElement& spring = s.model.springs[static_cast<std::size_t>(s.spring(i, k))];
  const double x = push.axial[i][static_cast<std::size_t>(k)];
  const double y = push.radial[i][static_cast<std::size_t>(k)];
  const double sense = i == Interface::screw ? -1.0 : 1.0;
  add_force(loads, spring.from, sense * x, sense * y);
  add_force(loads, spring.to, -sense * x, -sense * y);
}

void add_centrifugal(std::vector<fe::NodalLoad>& loads, const Sector& s, const RollerPush& push) {
  for (const fe::BeamElement& b : s.model.beams)
    for (const int node : {b.first, b.second})
      loads.push_back(
          {node, Dof::v, 0.5 * b.beam.length * (is_head(s, b) ? push.of_heads : push.of_thread)});
}

}  // namespace

std::vector<fe::NodalLoad> push_loads(const Sector& s, const RollerPush& push) {
  std::vector<fe::NodalLoad> loads;
  for (const Interface i : kInterfaces)
    for (int k = 0; k < s.contacts(); ++k) add_friction(loads, s, push, i, k);
  add_centrifugal(loads, s, push);
  return loads;
}

TurnedLoads::TurnedLoads(const SectorSolver& solver, double axial_force,
                         const RollerPush& per_normal_load)
    : equations_(solver.equations()), of_spring_(solver.equations().springs().size()) {
  const Sector& s = solver.sector();
  std::vector<fe::NodalLoad> loads;
  add_centrifugal(loads, s, per_normal_load);
  constant_ = axial_force / s.rollers * solver.unit_load() + equations_.load_vector(loads);
  for (const Interface i : kInterfaces)
    for (int k = 0; k < s.contacts(); ++k) {
      loads.clear();
      add_friction(loads, s, per_normal_load, i, k);
      for (const fe::NodalLoad& load : loads)
        if (const int equation = equations_.number(load.node, load.dof);
            equation >= 0 && load.value != 0.0)
          of_spring_[static_cast<std::size_t>(s.spring(i, k))].push_back({equation, load.value});
    }
}

void TurnedLoads::operator()(const fe::State& state, Eigen::VectorXd& load) const {
  load = constant_;
  for (std::size_t k = 0; k < of_spring_.size(); ++k) {
    if (of_spring_[k].empty()) continue;
    const double normal = equations_.response(state, static_cast<int>(k)).force;
    for (const OfNormalLoad& of : of_spring_[k]) load[of.equation] += normal * of.times;
  }
}

}  // namespace prs
