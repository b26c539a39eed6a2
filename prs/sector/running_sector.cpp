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

fe::FollowingLoad turned_loads(const SectorSolver& solver, double axial_force,
                               const RollerPush& per_normal_load) {
  const Sector& s = solver.sector();
  const fe::Equations& equations = solver.equations();
  std::vector<fe::NodalLoad> centrifugal;
  add_centrifugal(centrifugal, s, per_normal_load);
  std::vector<std::vector<fe::NodalLoad>> loads(equations.springs().size());
  for (const Interface i : kInterfaces)
    for (int k = 0; k < s.contacts(); ++k)
      add_friction(loads[static_cast<std::size_t>(s.spring(i, k))], s, per_normal_load, i, k);
  return {equations,
          axial_force / s.rollers * solver.unit_load() + equations.load_vector(centrifugal), loads};
}

}  // namespace prs
