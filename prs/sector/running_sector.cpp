#include "prs/sector/running_sector.h"

namespace prs {
namespace {

using fe::Dof;

void add_force(std::vector<fe::NodalLoad>& loads, const fe::RigidArm& at, double x, double y) {
  loads.push_back({at.node, Dof::u, x});
  loads.push_back({at.node, Dof::v, y});
  loads.push_back({at.node, Dof::theta, at.dx * y - at.dy * x});
}

}  // namespace

std::vector<fe::NodalLoad> push_loads(const Sector& s, const RollerPush& push) {
  std::vector<fe::NodalLoad> loads;
  for (const Interface i : kInterfaces)
    for (int k = 0; k < s.contacts(); ++k) {
      const fe::SpringElement& spring = s.model.springs[static_cast<std::size_t>(s.spring(i, k))];
      const double x = push.axial[i][static_cast<std::size_t>(k)];
      const double y = push.radial[i][static_cast<std::size_t>(k)];
      const double sense = i == Interface::screw ? -1.0 : 1.0;
      add_force(loads, spring.from, sense * x, sense * y);
      add_force(loads, spring.to, -sense * x, -sense * y);
    }
  for (const fe::BeamElement& b : s.model.beams)
    for (const int node : {b.first, b.second})
      loads.push_back(
          {node, Dof::v, 0.5 * b.beam.length * (is_head(s, b) ? push.of_heads : push.of_thread)});
  return loads;
}

}  // namespace prs
