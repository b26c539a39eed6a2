#include "prs/sector.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace prs {
namespace {

using fe::Dof;
using std::numbers::pi;

double disc_area(double diameter) { return pi / 4.0 * diameter * diameter; }

double ring_area(double outer, double inner) { return disc_area(outer) - disc_area(inner); }

double disc_second_moment(double diameter) { return pi / 64.0 * std::pow(diameter, 4); }

/// Cowper's shear coefficient of a solid disc, 6 (1 + nu)/(7 + 6 nu) (J. Appl. Mech. 33, 1966).
double disc_shear_coefficient(double poisson) {
  return 6.0 * (1.0 + poisson) / (7.0 + 6.0 * poisson);
}

/// Bars from the loaded section through the contacts.
void add_screw(Sector& s, const Mechanism& m, const Structure::Screw& screw, double modulus) {
  const double rigidity = modulus * ring_area(*m.pitch_diameter.screw, screw.bore) / m.rollers;
  s.loaded_node = s.model.add_node();
  const bool at_first_contact = screw.free_length == 0.0;
  int previous = s.loaded_node;
  for (int k = 0; k < m.contacts_per_roller; ++k) {
    if (k == 0 && at_first_contact) {
      s.screw_nodes.push_back(s.loaded_node);
      continue;
    }
    const int node = s.model.add_node();
    const double length = k == 0 ? screw.free_length : axial_pitch(m);
    s.model.bars.push_back({previous, node, {rigidity, length}});
    s.screw_nodes.push_back(node);
    previous = node;
  }
}

double nut_outer_diameter(const Structure::Nut& nut, double x) {
  for (const Structure::Flange& flange : nut.flanges)
    if (flange.from < x && x < flange.to) return flange.outer_diameter;
  return nut.outer_diameter;
}

/// Bars over the whole nut, the thrust section of the load's direction held.
void add_nut(Sector& s, const Mechanism& m, const Structure::Nut& nut, double modulus,
             double position) {
  const double thrust =
      s.direction == Direction::tension ? *nut.thrust.tension : *nut.thrust.compression;
  std::vector<double> sections{0.0, nut.length, thrust};
  for (const Structure::Flange& flange : nut.flanges) {
    sections.push_back(flange.from);
    sections.push_back(flange.to);
  }
  const auto contact = [&](int k) { return position + k * axial_pitch(m); };
  for (int k = 0; k < m.contacts_per_roller; ++k) sections.push_back(contact(k));
  std::sort(sections.begin(), sections.end());
  const double same = 1e-9 * nut.length;
  const auto end = std::unique(sections.begin(), sections.end(),
                               [&](double a, double b) { return b - a < same; });
  sections.erase(end, sections.end());

  const int first = s.model.nodes;
  s.model.nodes += static_cast<int>(sections.size());
  const auto node_at = [&](double x) {
    const auto next = std::lower_bound(sections.begin(), sections.end(), x - same);
    return first + static_cast<int>(next - sections.begin());
  };
  for (std::size_t i = 1; i < sections.size(); ++i) {
    const double outer = nut_outer_diameter(nut, 0.5 * (sections[i - 1] + sections[i]));
    const double rigidity = modulus * ring_area(outer, *m.pitch_diameter.nut) / m.rollers;
    const int node = first + static_cast<int>(i);
    s.model.bars.push_back({node - 1, node, {rigidity, sections[i] - sections[i - 1]}});
  }
  for (int k = 0; k < m.contacts_per_roller; ++k) s.nut_nodes.push_back(node_at(contact(k)));
  s.model.fixed_supports.push_back({node_at(thrust), Dof::u});
}

/// Beams from end to end: end element, half a pitch of thread run-out, the pitches between the
/// contacts, run-out, end element.
void add_roller(Sector& s, const Mechanism& m, const Structure::Roller& roller,
                const Material& material, bool shear) {
  const auto beam = [&](double diameter, double length) {
    const double shear_modulus = material.youngs_modulus / (2.0 * (1.0 + material.poisson_ratio));
    return fe::Beam{
        material.youngs_modulus * disc_area(diameter),
        material.youngs_modulus * disc_second_moment(diameter),
        shear ? disc_shear_coefficient(material.poisson_ratio) * shear_modulus * disc_area(diameter)
              : 0.0,
        length};
  };
  const double pitch = axial_pitch(m);
  const double thread_diameter = *m.pitch_diameter.roller;
  const fe::Beam end = beam(roller.end_diameter, roller.end_length);
  const fe::Beam run_out = beam(thread_diameter, 0.5 * pitch);
  const fe::Beam thread = beam(thread_diameter, pitch);

  int last = s.model.add_node();
  const auto extend = [&](const fe::Beam& b) {
    const int next = s.model.add_node();
    s.model.beams.push_back({last, next, b});
    return last = next;
  };
  s.roller_end_nodes.push_back(last);
  s.roller_end_nodes.push_back(extend(end));
  s.roller_nodes.push_back(extend(run_out));
  for (int k = 1; k < m.contacts_per_roller; ++k) s.roller_nodes.push_back(extend(thread));
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

/// Hertz springs between the rigid arms: N = k_0 <w - g>^1.5 with
/// screw w = s cos(psi)(u_S - u_R - theta r_R) - sin(psi) v_R,
/// nut   w = s cos(psi)(u_R - theta r_R - u_N) + sin(psi) v_R.
void add_contacts(Sector& s) {
  const double sense = prs::sense(s.direction);
  const auto spring = [&](fe::RigidArm from, fe::RigidArm to, Interface i, std::size_t k) {
    const ContactLaw& law = s.laws[i];
    s.model.springs.push_back({from,
                               to,
                               sense * std::cos(law.normal_angle),
                               std::sin(law.normal_angle),
                               {law.hertz_constant, 1.5, s.gaps[i][k], 0.0}});
  };
  const auto n = static_cast<std::size_t>(s.contacts());
  for (std::size_t k = 0; k < n; ++k)
    spring({s.screw_nodes[k]}, {s.roller_nodes[k], 0.0, -s.roller_radius}, Interface::screw, k);
  for (std::size_t k = 0; k < n; ++k)
    spring({s.roller_nodes[k], 0.0, s.roller_radius}, {s.nut_nodes[k]}, Interface::nut, k);
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

  add_screw(s, m, structure.screw, materials.screw.youngs_modulus);
  add_roller(s, m, structure.roller, materials.roller, options.roller_shear);
  add_nut(s, m, structure.nut, materials.nut.youngs_modulus, position);
  add_guidance(s, structure.roller.guidance, options.roller);
  add_contacts(s);
  return s;
}

}  // namespace prs
