#include "prs/sector/sector_model.h"

#include <algorithm>
#include <cmath>

#include "prs/model/groove.h"
#include "prs/sector/refined/local_compliance.h"
#include "prs/sector/section_properties.h"

namespace prs {
namespace {

/// Bars are refined bodies without any effect.
constexpr RefinedEffects kBars{false, false, false, false, false, false, false};

const RefinedEffects& effects_of(const ModelOptions& options) {
  return options.bodies == ModelOptions::Bodies::refined ? options.refined : kBars;
}

/// What the numbers of a sector are made from.
struct Given {
  const Mechanism& mechanism;
  const Structure& structure;
  const Materials& materials;
  const PerInterface<ContactLaw>& laws;
  RefinedEffects effects;

  double pitch_radius(Part p) const { return 0.5 * *mechanism.pitch_diameter[p]; }

  /// Depth of the roots below the pitch radius [m]; 0 where sections are taken at the pitch radius.
  double root_depth(Part p) const {
    if (!effects.core) return 0.0;
    if (mechanism.thread[p]) return mechanism.thread[p]->dedendum;
    const double psi = std::max(laws.screw.normal_angle, laws.nut.normal_angle);
    return default_groove(p == Part::nut, axial_pitch(mechanism), pitch_radius(p), psi, psi)
        .dedendum;
  }
  /// Outer diameter of what bends and carries axial force in screw and roller [m].
  double root_diameter(Part p) const { return *mechanism.pitch_diameter[p] - 2.0 * root_depth(p); }
  /// Of the screw before its first contact [m].
  double plain_screw_diameter() const {
    const bool threaded = mechanism.type == Mechanism::Type::standard;
    return threaded ? root_diameter(Part::screw) : *mechanism.pitch_diameter.screw;
  }
};

void set_screw(SectorModel& s, const Given& g) {
  const double root = g.root_diameter(Part::screw);
  const auto rigidity = [&](double diameter) {
    return g.materials.screw.youngs_modulus * ring_area(diameter, g.structure.screw.bore) /
           s.rollers;
  };
  s.plain_screw_rigidity = rigidity(g.plain_screw_diameter());
  s.screw_rigidity = rigidity(root);
  s.free_length = free_length(g.structure);
  if (g.effects.poisson)
    s.offset_compliance =
        poisson_offset(s.sense, 0.5 * root, 0.5 * g.structure.screw.bore, g.materials.screw,
                       g.mechanism.rollers, g.laws.screw.normal_angle);
}

/// The roller and what holds it radially (Abevi's BC3 and its alternatives).
void set_roller(SectorModel& s, const Given& g, const ModelOptions& options) {
  const Structure::Roller& roller = g.structure.roller;
  const bool shear = options.roller_shear || g.effects.shear;
  s.thread = disc_rigidity(g.materials.roller, g.root_diameter(Part::roller), shear);
  s.end = disc_rigidity(g.materials.roller, roller.end_diameter, shear);
  s.end_length = roller.end_length;
  s.roller_radius = g.pitch_radius(Part::roller);
  switch (roller.guidance.kind) {
    case Guidance::Kind::both_end_nodes:
      s.outer_guide = s.inner_guide = kHeld;
      break;
    case Guidance::Kind::outer_node:
      s.outer_guide = kHeld;
      break;
    case Guidance::Kind::ring:
      s.outer_guide = s.inner_guide = roller.guidance.ring_stiffness;
      break;
  }
  s.rigid_bending = options.roller == ModelOptions::Roller::rigid_bending ? 1.0 : 0.0;
  if (options.bodies == ModelOptions::Bodies::refined &&
      roller_contacts(options, g.mechanism.starts.roller) ==
          ModelOptions::RollerContacts::half_pitch_apart)
    s.contact_half_distance = 0.25 * s.pitch;
}

/// Inner radius of what carries axial force in a nut of some outer radius.
double nut_root(const Given& g, double depth, double outer_radius) {
  const double radius = g.pitch_radius(Part::nut), wall = outer_radius - radius;
  const double least = kLeastWall * axial_pitch(g.mechanism);
  return radius + std::min(depth, std::max(wall - least, 0.5 * wall));
}

void set_nut(SectorModel& s, const Given& g, Direction direction, double position) {
  const Structure::Nut& nut = g.structure.nut;
  const double depth = g.root_depth(Part::nut);
  const auto rigidity = [&](double outer_radius) {
    const double area = ring_area(2.0 * outer_radius, 2.0 * nut_root(g, depth, outer_radius));
    return g.materials.nut.youngs_modulus * area / s.rollers;
  };
  s.nut_radius = 0.5 * nut.outer_diameter;
  s.nut_rigidity = rigidity(s.nut_radius);
  s.nut_length = nut.length;
  s.thrust = direction == Direction::tension ? *nut.thrust.tension : *nut.thrust.compression;
  s.position = position;
  for (const Structure::Flange& f : nut.flanges) {
    const double radius = 0.5 * f.outer_diameter;
    s.flanges.push_back({f.from, f.to, radius, rigidity(radius)});
  }
}

void set_contacts(SectorModel& s, const Given& g, const Deviations& deviations,
                  Direction direction) {
  set_laws(s, g.laws);
  if (!deviates(g.mechanism, deviations)) {
    for (const Interface i : kInterfaces)
      s.gaps[i].assign(static_cast<std::size_t>(g.mechanism.contacts_per_roller), 0.0);
    return;
  }
  s.gaps = initial_gaps(g.mechanism, deviations, g.materials,
                        {g.laws.screw.normal_angle, g.laws.nut.normal_angle}, direction);
}

NutBore nut_bore(const Given& g, const NutLine& line) {
  NutBore bore{{}, g.pitch_radius(Part::nut)};
  const double depth = g.root_depth(Part::nut);
  for (const double outer : line.outer_radius) bore.root.push_back(nut_root(g, depth, outer));
  return bore;
}

void set_shell(SectorModel& s, const Given& g, const NutLine& line) {
  const NutBore bore = nut_bore(g, line);
  s.nut_shell = nut_shell(line, thrust_ring(line, g.structure.nut, bore), bore,
                          {s.sense, g.laws.nut.normal_angle}, g.materials.nut, g.mechanism.rollers,
                          g.effects);
}

double outer_radius_at(const NutLine& line, int node) {
  const auto k = static_cast<std::size_t>(node);
  const double before = line.outer_radius[std::max<std::size_t>(k, 1) - 1];
  return std::min(before, line.outer_radius[std::min(k, line.outer_radius.size() - 1)]);
}

/// The screw's surface and the nut's wall under radial loads.
void add_radial(SectorModel& s, const Given& g, const NutLine& line) {
  const double screw = g.pitch_radius(Part::screw), bore = 0.5 * g.structure.screw.bore;
  const double whole = cylinder_compliance(screw, bore, g.materials.screw, g.mechanism.rollers,
                                           s.pitch, g.laws.screw.normal_angle);
  const std::vector<double> shares =
      band_shares(s.contacts(), s.pitch, screw, bore, g.materials.screw.poisson_ratio);
  for (std::size_t k = 0; k < shares.size(); ++k) {
    s.body_compliance.screw[k] += shares[k] * whole;
    s.body_compliance.nut[k] +=
        wall_compliance(g.pitch_radius(Part::nut), outer_radius_at(line, line.contacts[k]),
                        g.materials.nut, g.mechanism.rollers, s.pitch, g.laws.nut.normal_angle);
  }
}

/// Both bodies of an interface by the rows in which the contacts stand.
void add_concentration(SectorModel& s, const Given& g) {
  for (const Interface i : kInterfaces) {
    const Part body = body_of(i);
    const auto of = [&](Part p, const LineReach& reach) {
      return concentration_compliance(reach, g.materials[p], s.pitch, g.laws[i].normal_angle);
    };
    const double both = of(body, rows_around(g.pitch_radius(body), g.mechanism.rollers)) +
                        of(Part::roller, opposite_rows(g.pitch_radius(Part::roller)));
    for (double& compliance : s.body_compliance[i]) compliance += both;
  }
}

}  // namespace

SectorModel sector_model(const Mechanism& m, const Structure& structure, const Materials& materials,
                         const ModelOptions& options, const PerInterface<ContactLaw>& laws,
                         Direction direction, double position, const Deviations& deviations) {
  SectorModel s;
  set_sector_model(s, m, structure, materials, options, laws, direction, position, deviations);
  return s;
}

void set_sector_model(SectorModel& s, const Mechanism& m, const Structure& structure,
                      const Materials& materials, const ModelOptions& options,
                      const PerInterface<ContactLaw>& laws, Direction direction, double position,
                      const Deviations& deviations) {
  const bool refined = options.bodies == ModelOptions::Bodies::refined;
  const Given g{m, structure, materials, laws, effects_of(options)};
  const RefinedEffects& effects = g.effects;
  static_cast<SectorNumbers<double>&>(s) = {};
  s.flanges.clear();
  s.nut_shell.reset();
  for (const Interface i : kInterfaces) s.body_compliance[i].clear();
  s.rollers = m.rollers;
  s.sense = sense(direction);
  s.pitch = axial_pitch(m);
  set_screw(s, g);
  set_roller(s, g, options);
  set_nut(s, g, direction, position);
  set_contacts(s, g, deviations, direction);
  if (!refined) return;

  const NutLine line = nut_line(s);
  if (effects.hoop || effects.flange) set_shell(s, g, line);
  if (effects.radial || effects.concentration)
    for (const Interface i : kInterfaces) s.body_compliance[i].assign(s.gaps[i].size(), 0.0);
  if (effects.radial) add_radial(s, g, line);
  if (effects.concentration) add_concentration(s, g);
}

void set_laws(SectorModel& s, const PerInterface<ContactLaw>& laws) {
  for (const Interface i : kInterfaces) {
    const auto& [constant, psi, compliance] = laws[i];
    const double cosine = std::cos(psi), sine = std::sin(psi);
    s.hertz_constant[i] = constant;
    s.cosine[i] = cosine;
    s.sine[i] = sine;
    s.compliance[i] = compliance;
  }
}

NutLine nut_line(const SectorModel& s) {
  std::vector<double> contacts;
  for (int k = 0; k < s.contacts(); ++k) contacts.push_back(s.position + k * s.pitch);
  return nut_line(s, contacts);
}

NutLine nut_line(const SectorModel& s, const std::vector<double>& contact_x) {
  NutLine line;
  std::vector<double>& sections = line.sections;
  sections = {0.0, s.nut_length, s.thrust};
  for (const SectorModel::Flange& flange : s.flanges) {
    sections.push_back(flange.from);
    sections.push_back(flange.to);
  }
  sections.insert(sections.end(), contact_x.begin(), contact_x.end());
  std::sort(sections.begin(), sections.end());
  const double same = kSamePlace * s.nut_length;
  const auto end = std::unique(sections.begin(), sections.end(),
                               [&](double a, double b) { return b - a < same; });
  sections.erase(end, sections.end());

  const auto node_at = [&](double x) {
    const auto next = std::lower_bound(sections.begin(), sections.end(), x - same);
    return static_cast<int>(next - sections.begin());
  };
  for (std::size_t i = 1; i < sections.size(); ++i) {
    const double middle = 0.5 * (sections[i - 1] + sections[i]);
    const auto flange = std::ranges::find_if(
        s.flanges, [&](const auto& f) { return f.from < middle && middle < f.to; });
    const bool plain = flange == s.flanges.end();
    line.outer_radius.push_back(plain ? s.nut_radius : flange->outer_radius);
    line.axial_rigidity.push_back(plain ? s.nut_rigidity : flange->axial_rigidity);
  }
  for (const double x : contact_x) line.contacts.push_back(node_at(x));
  line.thrust = node_at(s.thrust);
  return line;
}

BodyRadii body_radii(const Mechanism& m, const Structure& structure, const Materials& materials,
                     const ModelOptions& options, const PerInterface<ContactLaw>& laws,
                     const NutLine& line) {
  const Given g{m, structure, materials, laws, effects_of(options)};
  return {0.5 * g.plain_screw_diameter(), 0.5 * g.root_diameter(Part::screw), nut_bore(g, line)};
}

}  // namespace prs
