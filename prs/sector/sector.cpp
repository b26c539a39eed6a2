#include "prs/sector/sector.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "prs/sector/refined/refinement.h"
#include "prs/sector/section_properties.h"

namespace prs {
namespace {

using fe::Dof;

/// Bars from the loaded section through the contacts.
void add_screw(Sector& s, const Mechanism& m, double bore, double free_length, double free_diameter,
               double diameter, double modulus) {
  const auto rigidity = [&](double d) { return modulus * ring_area(d, bore) / m.rollers; };
  s.loaded_node = s.model.add_node();
  const bool at_first_contact = free_length == 0.0;
  int previous = s.loaded_node;
  for (int k = 0; k < m.contacts_per_roller; ++k) {
    if (k == 0 && at_first_contact) {
      s.screw_nodes.push_back(s.loaded_node);
      continue;
    }
    const int node = s.model.add_node();
    const fe::Bar bar = k == 0 ? fe::Bar{rigidity(free_diameter), free_length}
                               : fe::Bar{rigidity(diameter), axial_pitch(m)};
    s.model.bars.push_back({previous, node, bar});
    s.screw_nodes.push_back(node);
    previous = node;
  }
}

/// Nodes at the ends, the flange faces, the thrust section of the load's direction and the
/// contacts.
NutLine nut_line(const Mechanism& m, const Structure::Nut& nut, Direction direction,
                 double position) {
  const double thrust =
      direction == Direction::tension ? *nut.thrust.tension : *nut.thrust.compression;
  NutLine line;
  std::vector<double>& sections = line.sections;
  sections = {0.0, nut.length, thrust};
  for (const Structure::Flange& flange : nut.flanges) {
    sections.push_back(flange.from);
    sections.push_back(flange.to);
  }
  const auto contact = [&](int k) { return position + k * axial_pitch(m); };
  for (int k = 0; k < m.contacts_per_roller; ++k) sections.push_back(contact(k));
  std::sort(sections.begin(), sections.end());
  const double same = kSamePlace * nut.length;
  const auto end = std::unique(sections.begin(), sections.end(),
                               [&](double a, double b) { return b - a < same; });
  sections.erase(end, sections.end());

  const auto node_at = [&](double x) {
    const auto next = std::lower_bound(sections.begin(), sections.end(), x - same);
    return static_cast<int>(next - sections.begin());
  };
  for (std::size_t i = 1; i < sections.size(); ++i)
    line.outer_radius.push_back(0.5 * nut_diameter(nut, 0.5 * (sections[i - 1] + sections[i])));
  for (int k = 0; k < m.contacts_per_roller; ++k) line.contacts.push_back(node_at(contact(k)));
  line.thrust = node_at(thrust);
  return line;
}

/// Nodes of the nut, the thrust section held.
int add_nut_nodes(Sector& s, const NutLine& line) {
  const int first = s.model.nodes;
  s.model.nodes += static_cast<int>(line.sections.size());
  for (const int node : line.contacts) s.nut_nodes.push_back(first + node);
  s.model.fixed_supports.push_back({first + line.thrust, Dof::u});
  return first;
}

void add_nut_bars(Sector& s, const NutLine& line, const std::vector<double>& bore, double modulus) {
  int node = add_nut_nodes(s, line);
  for (std::size_t i = 0; i < line.outer_radius.size(); ++i, ++node) {
    const double area = ring_area(2.0 * line.outer_radius[i], 2.0 * bore[i]);
    const double rigidity = modulus * area / s.rollers;
    s.model.bars.push_back({node, node + 1, {rigidity, line.length(i)}});
  }
}

void add_nut_shell(Sector& s, const NutLine& line, const NutShell& shell, bool radially_rigid) {
  const int first = add_nut_nodes(s, line);
  int node = first;
  for (const fe::ShellMatrix& stiffness : shell.segments) {
    s.model.shells.push_back({node, node + 1, stiffness});
    ++node;
  }
  if (shell.straight_thrust_section)
    s.model.fixed_supports.push_back({first + line.thrust, Dof::theta});
  if (radially_rigid)
    for (int i = first; i <= node; ++i) s.model.fixed_supports.push_back({i, Dof::v});
}

/// Beams from end to end: end element, half a pitch of thread run-out, the pitches between the
/// teeth, run-out, end element. The contacts of a tooth stand at its middle, or `half_distance` to
/// both sides of it.
void add_roller(Sector& s, const Mechanism& m, const Structure::Roller& roller,
                double thread_diameter, double half_distance, const Material& material,
                bool shear) {
  const auto beam = [&](double diameter, double length) {
    const DiscRigidity r = disc_rigidity(material, diameter, shear);
    return fe::Beam{r.axial, r.bending, r.shear, length};
  };
  const double pitch = axial_pitch(m);
  const fe::Beam end = beam(roller.end_diameter, roller.end_length);
  const fe::Beam run_out = beam(thread_diameter, 0.5 * pitch - half_distance);
  const fe::Beam tooth = beam(thread_diameter, 2.0 * half_distance);
  const fe::Beam thread = beam(thread_diameter, pitch - 2.0 * half_distance);

  int last = s.model.add_node();
  const auto extend = [&](const fe::Beam& b) {
    const int next = s.model.add_node();
    s.model.beams.push_back({last, next, b});
    return last = next;
  };
  s.roller_end_nodes.push_back(last);
  s.roller_end_nodes.push_back(extend(end));
  for (int k = 0; k < m.contacts_per_roller; ++k) {
    s.roller_nodes.push_back(extend(k == 0 ? run_out : thread));
    if (half_distance > 0.0) s.roller_nodes.push_back(extend(tooth));
  }
  s.roller_end_nodes.push_back(extend(run_out));
  s.roller_end_nodes.push_back(extend(end));
}

/// What holds the roller radially (Abevi's BC3 and its alternatives).
void add_guidance(Sector& s, const Guidance& guidance, ModelOptions::Roller bending) {
  if (bending == ModelOptions::Roller::rigid_bending) {
    const auto hold = [&](int node) {
      s.model.fixed_supports.push_back({node, Dof::v});
      s.model.fixed_supports.push_back({node, Dof::theta});
    };
    for (const int node : s.roller_end_nodes) hold(node);
    for (const int node : s.roller_nodes) hold(node);
    return;
  }
  switch (guidance.kind) {
    case Guidance::Kind::both_end_nodes:
      for (const int node : s.roller_end_nodes) s.model.fixed_supports.push_back({node, Dof::v});
      break;
    case Guidance::Kind::outer_node:
      s.model.fixed_supports.push_back({s.roller_end_nodes.front(), Dof::v});
      s.model.fixed_supports.push_back({s.roller_end_nodes.back(), Dof::v});
      break;
    case Guidance::Kind::ring:
      for (const int node : s.roller_end_nodes)
        s.model.elastic_supports.push_back({node, Dof::v, guidance.ring_stiffness});
      break;
  }
}

/// Hertz springs between the rigid arms: N = k_0 <w - g - c N>^1.5 with
/// screw w = s cos(psi)(u_S - u_R - theta r_R) - sin(psi) v_R,
/// nut   w = s cos(psi)(u_R - theta r_R - u_N + theta_N y) + sin(psi) (v_R - v_N),
/// y the radius of the nut's contacts less that of its nodes. Where the contacts of a tooth do not
/// lie opposite each other, its flank at the screw faces against the load, the other one along it.
void add_contacts(Sector& s, double nut_arm, const PerInterface<std::vector<double>>& compliance) {
  const double sense = prs::sense(s.direction);
  const auto n = static_cast<std::size_t>(s.contacts());
  const bool apart = s.roller_nodes.size() > n;
  const auto roller_node = [&](Interface i, std::size_t k) {
    const bool second = (i == Interface::screw) == (sense < 0.0);
    return s.roller_nodes[apart ? 2 * k + (second ? 1 : 0) : k];
  };
  const auto spring = [&](fe::RigidArm from, fe::RigidArm to, Interface i, std::size_t k) {
    const ContactLaw& law = s.laws[i];
    s.model.springs.push_back(
        {from,
         to,
         sense * std::cos(law.normal_angle),
         std::sin(law.normal_angle),
         {law.hertz_constant, 1.5, s.gaps[i][k], law.compliance + compliance[i][k]}});
  };
  for (std::size_t k = 0; k < n; ++k)
    spring({s.screw_nodes[k]}, {roller_node(Interface::screw, k), 0.0, -s.roller_radius},
           Interface::screw, k);
  for (std::size_t k = 0; k < n; ++k)
    spring({roller_node(Interface::nut, k), 0.0, s.roller_radius}, {s.nut_nodes[k], 0.0, nut_arm},
           Interface::nut, k);
}

}  // namespace

Sector build_sector(const Mechanism& m, const Structure& structure, const Materials& materials,
                    const ModelOptions& options, const PerInterface<ContactLaw>& laws,
                    Direction direction, double position, const Deviations& deviations) {
  Sector s;
  s.laws = laws;
  s.direction = direction;
  s.rollers = m.rollers;
  s.roller_radius = 0.5 * *m.pitch_diameter.roller;
  s.gaps = initial_gaps(m, deviations, materials, {laws.screw.normal_angle, laws.nut.normal_angle},
                        direction);

  const NutLine line = nut_line(m, structure.nut, direction, position);
  const Refinement refined = refinement(m, structure, materials, options, laws, direction, line);
  s.offset_compliance = refined.offset_compliance;

  add_screw(s, m, structure.screw.bore, free_length(structure), refined.plain_screw_diameter,
            refined.screw_diameter, materials.screw.youngs_modulus);
  add_roller(s, m, structure.roller, refined.roller_diameter, refined.roller_half_distance,
             materials.roller, refined.roller_shear);
  if (refined.nut)
    add_nut_shell(s, line, *refined.nut, refined.nut_radially_rigid);
  else
    add_nut_bars(s, line, refined.nut_bore, materials.nut.youngs_modulus);
  add_guidance(s, structure.roller.guidance, options.roller);
  add_contacts(s, refined.nut ? refined.nut->contact_arm : 0.0, refined.compliance);
  return s;
}

}  // namespace prs
