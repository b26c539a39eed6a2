#include "prs/sector/running_sector.h"

namespace prs {
namespace {

using fe::Dof;

void add_force(std::vector<fe::NodalLoad>& loads, const fe::RigidArm& at, double x, double y) {
  loads.push_back({at.node, Dof::u, x});
  loads.push_back({at.node, Dof::v, y});
  loads.push_back({at.node, Dof::theta, at.dx * y - at.dy * x});
}

/// Half of the centrifugal force of a length of the roller.
double half_weight(const Sector& s, const fe::BeamElement& b, const RollerPush& push) {
  const bool head =
      b.first == s.roller_end_nodes.front() || b.second == s.roller_end_nodes.back();
  return 0.5 * b.beam.length * (head ? push.of_heads : push.of_thread);
}

/// Forces across the axis at both ends of a length of the roller.
std::array<double, 2> shear(const fe::Equations& equations, const fe::State& q,
                            const fe::BeamElement& b) {
  const auto number = [&](int node, Dof dof) { return equations.number(node, dof); };
  const int t1 = number(b.first, Dof::theta), t2 = number(b.second, Dof::theta);
  const fe::BeamVector<double> f = fe::end_forces<double>(
      b.beam, {0.0, q.difference(number(b.first, Dof::v), number(b.second, Dof::v)), q[t1], q[t2],
               q.compensation(t1), q.compensation(t2)});
  return {f[1], f[4]};
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
      loads.push_back({node, Dof::v, half_weight(s, b, push)});
  return loads;
}

std::optional<std::array<double, 2>> guide_forces(const Sector& s, const fe::Equations& equations,
                                                  const fe::State& state, const RollerPush& push) {
  if (!s.bends()) return std::nullopt;
  // Between its guided nodes and its threads a roller has one length of run-out at each end.
  const auto& beams = s.model.beams;
  const fe::BeamElement &near = beams[1], &far = beams[beams.size() - 2];
  return std::array{
      shear(equations, state, near)[0] - 2.0 * half_weight(s, beams.front(), push) -
          half_weight(s, near, push),
      shear(equations, state, far)[1] - 2.0 * half_weight(s, beams.back(), push) -
          half_weight(s, far, push)};
}

}  // namespace prs
