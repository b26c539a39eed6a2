#include "prs/sector/sector.h"

namespace prs {
namespace {

using fe::Dof;

/// Bars from the loaded section through the contacts.
void add_screw(Sector& s) {
  s.loaded_node = s.model.add_node();
  const auto extend = [&](int from, const fe::Bar& bar) {
    const int next = s.model.add_node();
    s.model.bars.push_back({from, next, bar});
    return next;
  };
  s.screw_nodes = {s.free_length == 0.0
                       ? s.loaded_node
                       : extend(s.loaded_node, {s.plain_screw_rigidity, s.free_length})};
  for (int k = 1; k < s.contacts(); ++k)
    s.screw_nodes.push_back(extend(s.screw_nodes.back(), {s.screw_rigidity, s.pitch}));
}

/// Bars or shells along the nut, the thrust section held.
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

/// Beams from end to end: end element, half a pitch of thread run-out, the pitches between the
/// teeth, run-out, end element. The contacts of a tooth stand at its middle, or at equal distances
/// to both sides of it.
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
    if (stiffness == kHeld)
      s.model.fixed_supports.push_back({node, Dof::v});
    else if (stiffness > 0.0)
      s.model.elastic_supports.push_back({node, Dof::v, stiffness});
  };
  guide(s.roller_end_nodes[0], s.outer_guide);
  guide(s.roller_end_nodes[1], s.inner_guide);
  guide(s.roller_end_nodes[2], s.inner_guide);
  guide(s.roller_end_nodes[3], s.outer_guide);
}

/// Hertz springs between the rigid arms: N = k_0 <w - g - c N>^1.5 with
/// screw w = s cos(psi)(u_S - u_R - theta r_R) - sin(psi) v_R,
/// nut   w = s cos(psi)(u_R - theta r_R - u_N + theta_N y) + sin(psi) (v_R - v_N),
/// y the radius of the nut's contacts less that of its nodes. Where the contacts of a tooth do not
/// lie opposite each other, its flank at the screw faces against the load, the other one along it.
void add_contacts(Sector& s) {
  const auto roller_node = [&](Interface i, std::size_t k) {
    const bool second = (i == Interface::screw) == (s.sense < 0.0);
    return s.roller_nodes[s.contacts_apart() ? 2 * k + (second ? 1 : 0) : k];
  };
  const double nut_arm = s.nut_shell ? s.nut_shell->contact_arm : 0.0;
  for (const Interface i : kInterfaces)
    for (std::size_t k = 0; k < s.screw_nodes.size(); ++k) {
      const bool at_screw = i == Interface::screw;
      const fe::RigidArm roller{roller_node(i, k), 0.0,
                                at_screw ? -s.roller_radius : s.roller_radius};
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

}  // namespace prs
