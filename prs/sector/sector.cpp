#include "prs/sector/sector.h"

#include "prs/indices.h"

namespace prs {
namespace {

using fe::Dof;

/// Adds bars from the loaded section through the contacts.
void add_screw(Sector& s) {
  s.loaded_node = s.model.add_node();
  const auto extend = [&](int from, const fe::Bar& bar) {
    const int next = s.model.add_node();
    s.model.bars.push_back({from, next, bar});
    return next;
  };
  s.screw_nodes = {s.free_length == 0.0 ? s.loaded_node
                                        : extend(s.loaded_node, {s.plain_screw_rigidity, s.free_length})};
  for (int k = 1; k < s.contacts(); ++k)
    s.screw_nodes.push_back(extend(s.screw_nodes.back(), {s.screw_rigidity, s.pitch}));
}

/// Adds bars or shells along the nut, and holds the thrust section.
void add_nut(Sector& s) {
  const NutLine line = nut_line(s);
  const int first = s.model.nodes, last = first + static_cast<int>(line.outer_radius.size());
  s.model.nodes = last + 1;
  for (const int node : line.contacts) s.nut_nodes.push_back(first + node);
  const auto hold = [&](int node, Dof dof) { s.model.fixed_supports.push_back({node, dof}); };
  hold(first + line.thrust, Dof::u);
  for (int node = first; node < last; ++node) {
    const auto i = static_cast<std::size_t>(node - first);
    if (s.nut_shell)
      s.model.shells.push_back({node, node + 1, s.nut_shell->segments[i]});
    else
      s.model.bars.push_back({node, node + 1, {line.axial_rigidity[i], line.length(i)}});
  }
  if (!s.nut_shell) return;
  if (s.nut_shell->straight_thrust_section) hold(first + line.thrust, Dof::theta);
  if (s.nut_shell->radially_rigid)
    for (int node = first; node <= last; ++node) hold(node, Dof::v);
}

/// Adds beams from end to end: end element, half a pitch of thread run-out, the pitches between the teeth, run-out, end
/// element. The contacts of a tooth are at its middle, or at equal distances to both sides of it.
void add_roller(Sector& s) {
  const auto beam = [](const RollerSection<double>& section, double length) {
    return fe::Beam{section.axial, section.bending, section.shear, length};
  };
  const double half_distance = s.contact_half_distance;
  const fe::Beam end = beam(s.end, s.end_length);
  const fe::Beam run_out = beam(s.thread, 0.5 * s.pitch - half_distance);
  const fe::Beam tooth = beam(s.thread, 2.0 * half_distance);
  const fe::Beam thread = beam(s.thread, s.pitch - 2.0 * half_distance);

  int last = s.model.add_node();
  const auto extend = [&](const fe::Beam& b) {
    const int next = s.model.add_node();
    s.model.beams.push_back({last, next, b});
    return last = next;
  };
  s.roller_end_nodes.push_back(last);
  s.roller_end_nodes.push_back(extend(end));
  for (int k = 0; k < s.contacts(); ++k) {
    s.roller_nodes.push_back(extend(k == 0 ? run_out : thread));
    if (s.contacts_apart()) s.roller_nodes.push_back(extend(tooth));
  }
  s.roller_end_nodes.push_back(extend(run_out));
  s.roller_end_nodes.push_back(extend(end));
}

void add_guidance(Sector& s) {
  if (!s.bends()) {
    for (const auto* nodes : {&s.roller_end_nodes, &s.roller_nodes})
      for (const int node : *nodes)
        for (const Dof dof : {Dof::v, Dof::theta}) s.model.fixed_supports.push_back({node, dof});
    return;
  }
  const auto guide = [&](int node, double stiffness) {
    if (s.has_loose_guides())
      for (const double side : {1.0, -1.0})
        s.model.form_springs.push_back({{{node, Dof::v, side}}, s.ring_guide().stop()});
    else if (stiffness == kHeld)
      s.model.fixed_supports.push_back({node, Dof::v});
    else if (stiffness > 0.0)
      s.model.elastic_supports.push_back({node, Dof::v, stiffness});
  };
  guide(s.roller_end_nodes[0], s.outer_guide);
  guide(s.roller_end_nodes[1], s.inner_guide);
  guide(s.roller_end_nodes[2], s.inner_guide);
  guide(s.roller_end_nodes[3], s.outer_guide);
}

/// Adds Hertz springs between the rigid arms: N = k_0 <w - g - c N>^1.5 with
///   screw w = s cos(psi)(u_S - u_R - theta r_R) - sin(psi) v_R,
///   nut   w = s cos(psi)(u_R - theta r_R - u_N + theta_N y) + sin(psi) (v_R - v_N),
/// y the radius of the nut's contacts less that of its nodes. If the contacts of a tooth do not lie opposite each
/// other, its flank at the screw faces against the load, the other one along it.
void add_contacts(Sector& s) {
  const auto roller_node = [&](Interface i, std::size_t k) {
    const bool second = (i == Interface::screw) == (s.sense < 0.0);
    return s.roller_nodes[s.contacts_apart() ? 2 * k + (second ? 1 : 0) : k];
  };
  const double nut_arm = s.nut_shell ? s.nut_shell->contact_arm : 0.0;
  for (const Interface i : kInterfaces)
    for (const auto k : indices(s.screw_nodes)) {
      const bool at_screw = i == Interface::screw;
      const fe::RigidArm roller{roller_node(i, k), 0.0, at_screw ? -s.roller_radius : s.roller_radius};
      s.model.springs.push_back({at_screw ? fe::RigidArm{s.screw_nodes[k]} : roller,
                                 at_screw ? roller : fe::RigidArm{s.nut_nodes[k], 0.0, nut_arm},
                                 s.sense * s.cosine[i],
                                 s.sine[i],
                                 {s.hertz_constant[i], s.gaps[i][k], s.contact_compliance(i, k)}});
    }
}

}  // namespace

Sector build_sector(const SectorModel& model) {
  Sector s{model, {}, 0, {}, {}, {}, {}};
  add_screw(s);
  add_roller(s);
  add_nut(s);
  add_guidance(s);
  add_contacts(s);
  return s;
}

SectorSolver::SectorSolver(Sector sector)
    : sector_(std::move(sector)),
      equations_(sector_.model),
      solver_(equations_),
      unit_load_(equations_.load_vector({{sector_.loaded_node, Dof::u, sector_.sense}})),
      rate_(equations_.size()) {}

Eigen::VectorXd SectorSolver::equal_shares(double axial_force) const {
  const double thread_load = axial_force / (sector_.rollers * sector_.contacts());
  // Axial shift of the pushing body against the pushed one.
  const auto shift = [&](Interface i) {
    const double cosine = sector_.cosine[i];
    const double approach = std::pow(thread_load / (cosine * sector_.hertz_constant[i]), 2.0 / 3.0);
    const double widest = *std::max_element(sector_.gaps[i].begin(), sector_.gaps[i].end());
    return sector_.sense * (approach + widest) / cosine;
  };
  const double roller = shift(Interface::nut);
  const double screw = roller + shift(Interface::screw);

  Eigen::VectorXd q = Eigen::VectorXd::Zero(equations_.size());
  const auto set = [&](const std::vector<int>& nodes, double u) {
    for (const int node : nodes) q[equations_.number(node, Dof::u)] = u;
  };
  set({sector_.loaded_node}, screw);
  set(sector_.screw_nodes, screw);
  set(sector_.roller_nodes, roller);
  set(sector_.roller_end_nodes, roller);
  return q;
}

fe::NewtonOptions SectorSolver::newton_options(double axial_force) const {
  fe::NewtonOptions options;
  options.force_scale = axial_force / sector_.rollers;
  options.length_scale = sector_.roller_radius;
  return options;
}

void add_offset_energy(fe::NewtonSummary& summary, double compliance, double force) {
  const double energy = -0.5 * compliance * force * force;
  summary.energy += energy;
  for (fe::NewtonIteration& iteration : summary.history) iteration.energy += energy;
}

LoadDistribution SectorSolver::solve(double axial_force) {
  const double sector_force = axial_force / sector_.rollers;
  state_ = equal_shares(axial_force);
  fe::NewtonSummary summary = solver_.solve(sector_force * unit_load_, newton_options(axial_force), state_);
  add_offset_energy(summary, sector_.offset_compliance, sector_force);
  LoadDistribution result = at(state_, axial_force);
  result.solve = std::move(summary);
  return result;
}

fe::NewtonSummary SectorSolver::go_on(double axial_force, const std::vector<fe::NodalLoad>& further, bool is_trial) {
  constexpr int kMostOfTrial = 30;
  const double sector_force = axial_force / sector_.rollers;
  fe::NewtonOptions options = newton_options(axial_force);
  std::function<bool()> held;
  if (is_trial) {
    options.max_iterations = kMostOfTrial;
    held = [] { return false; };
  }
  fe::NewtonSummary summary =
      solver_.solve(sector_force * unit_load_ + equations_.load_vector(further), options, state_, held);
  add_offset_energy(summary, sector_.offset_compliance, sector_force);
  return summary;
}

LoadDistribution SectorSolver::at(const fe::State& state, double axial_force) {
  LoadDistribution result;
  for (const Interface i : kInterfaces)
    for (int k = 0; k < sector_.contacts(); ++k) {
      const int spring = sector_.spring(i, k);
      result.normal_load[i].push_back(equations_.response(state, spring).force);
      result.approach[i].push_back(equations_.law_approach(state, spring));
    }
  result.axial_displacement = unit_load_.dot(state.head) + unit_load_.dot(state.tail) +
                              sector_.offset_compliance * axial_force / sector_.rollers;
  if (solver_.solve_tangent(state, unit_load_, rate_)) {
    const double flexibility = unit_load_.dot(rate_) + sector_.offset_compliance;
    if (flexibility > 0.0) result.tangent_stiffness = sector_.rollers / flexibility;
  }
  if (sector_.has_loose_guides()) result.guides = {guide_loads(sector_, equations_, state)};
  return result;
}

bool SectorSolver::state_rate(const Eigen::VectorXd& residual_rate, Eigen::VectorXd& rate) {
  return solver_.solve_tangent(state_, -residual_rate, rate);
}

}  // namespace prs
