#include "prs/sector/sector_model.h"

#include <algorithm>

#include "prs/indices.h"
#include "prs/model/groove.h"
#include "prs/sector/refined_formulas.h"
#include "prs/threads/threads.h"

namespace prs {
namespace {

/// Effects of models of bodies that have none.
constexpr RefinedEffects kNoEffects{false, false, false, false, false, false, false};

const RefinedEffects& effects_of(const ModelOptions& options) {
  return options.bodies->effects ? options.refined : kNoEffects;
}

/// Inputs from which the numbers of a sector are made.
struct Given {
  const Mechanism& mechanism;
  const Structure& structure;
  const Materials& materials;
  const PerInterface<ContactLaw>& laws;
  RefinedEffects effects;

  double pitch_radius(Part p) const { return 0.5 * *mechanism.pitch_diameter[p]; }

  /// Depth of the roots below the pitch radius [m]; 0 if sections are taken at the pitch radius.
  double root_depth(Part p) const {
    if (!effects.core) return 0.0;
    if (mechanism.thread[p]) return mechanism.thread[p]->dedendum;
    const double psi = std::max(laws.screw.normal_angle, laws.nut.normal_angle);
    return default_groove(p == Part::nut, axial_pitch(mechanism), pitch_radius(p), psi, psi).dedendum;
  }
  /// Outer diameter of the section that bends and carries axial force in screw and roller [m].
  double root_diameter(Part p) const { return *mechanism.pitch_diameter[p] - 2.0 * root_depth(p); }
  /// Diameter of the screw before its first contact [m].
  double plain_screw_diameter() const {
    return carrier_part(mechanism.type) == Part::nut ? root_diameter(Part::screw) : *mechanism.pitch_diameter.screw;
  }
};

void set_screw(SectorModel& s, const Given& g) {
  const double root = g.root_diameter(Part::screw);
  const auto rigidity = [&](double diameter) {
    return g.materials.screw.youngs_modulus * ring_area(diameter, g.structure.screw.bore) / s.rollers;
  };
  s.plain_screw_rigidity = rigidity(g.plain_screw_diameter());
  s.screw_rigidity = rigidity(root);
  s.free_length = free_length(g.structure);
  if (g.effects.poisson)
    s.offset_compliance = poisson_offset(s.sense, 0.5 * root, 0.5 * g.structure.screw.bore, g.materials.screw,
                                         loaded_rollers(g.mechanism), g.laws.screw.normal_angle);
}

/// Sets the roller and its radial guides (Abevi's BC3 and its alternatives).
void set_roller(SectorModel& s, const Given& g, const ModelOptions& options) {
  const Structure::Roller& roller = g.structure.roller;
  const bool shear = options.roller_shear || g.effects.shear;
  s.thread = disc_rigidity(g.materials.roller, g.root_diameter(Part::roller), shear);
  s.end = disc_rigidity(g.materials.roller, roller.end_diameter, shear);
  s.end_length = roller.end_length;
  s.roller_radius = g.pitch_radius(Part::roller);
  s.guide_clearance = roller.guidance.clearance;
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
  if (options.bodies->effects &&
      roller_contacts(options, g.mechanism.starts.roller) == ModelOptions::RollerContacts::half_pitch_apart)
    s.contact_half_distance = 0.25 * s.pitch;
}

/// Inner radius of the section that carries axial force in a nut of some outer radius.
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

void set_contacts(SectorModel& s, const Given& g, const Deviations& deviations, Direction direction) {
  if (g.laws.screw.hertz_constant != 0.0) set_laws(s, {numbers_of(g.laws.screw), numbers_of(g.laws.nut)});
  if (!deviates(g.mechanism, deviations)) {
    for (const Interface i : kInterfaces)
      s.gaps[i].assign(static_cast<std::size_t>(g.mechanism.contacts_per_roller), 0.0);
    return;
  }
  s.gaps = initial_gaps(g.mechanism, deviations, g.materials, {g.laws.screw.normal_angle, g.laws.nut.normal_angle},
                        direction);
}

void set_nut_bore(NutBore& bore, const Given& g, const NutLine& line) {
  bore.pitch = g.pitch_radius(Part::nut);
  const double depth = g.root_depth(Part::nut);
  bore.root.clear();
  for (const double outer : line.outer_radius) bore.root.push_back(nut_root(g, depth, outer));
}

void set_bodies(SectorModel& s, const Given& g) {
  RefinedBodies& b = s.bodies;
  b.effects = g.effects;
  for (const Part p : kParts) b.numbers.material[p] = g.materials[p];
  b.numbers.screw_radius = g.pitch_radius(Part::screw);
  b.numbers.screw_bore = 0.5 * g.structure.screw.bore;
  b.numbers.nut_pitch_radius = g.pitch_radius(Part::nut);
  set_nut_line(b.line, s);
  set_nut_bore(b.bore, g, b.line);
  set_alike_segments(b.line, b.bore, b.same);
  b.has_ring = false;
  if (!b.has_shell()) return;
  const std::optional<ThrustRing> ring = thrust_ring(b.line, g.structure.nut, b.bore);
  b.has_ring = ring.has_value();
  b.numbers.ring_inner = ring ? ring->inner_radius : 0.0;
  b.numbers.ring_outer = ring ? ring->outer_radius : 0.0;
}

/// Sets `line` for contacts at contact(0), .. contact(count - 1).
template <class Contact>
void set_line(NutLine& line, const SectorModel& s, int count, Contact contact) {
  std::vector<double>& sections = line.sections;
  sections.clear();
  for (int k = 0; k < count; ++k) sections.push_back(contact(k));
  if (!std::ranges::is_sorted(sections)) std::ranges::sort(sections);
  const auto insert = [&](double x) { sections.insert(std::ranges::upper_bound(sections, x), x); };
  for (const double x : {0.0, s.nut_length, s.thrust}) insert(x);
  for (const SectorModel::Flange& flange : s.flanges) {
    insert(flange.from);
    insert(flange.to);
  }
  const double same = kSamePlace * s.nut_length;
  const auto end = std::unique(sections.begin(), sections.end(), [&](double a, double b) { return b - a < same; });
  sections.erase(end, sections.end());

  const auto node_at = [&](double x) {
    const auto next = std::lower_bound(sections.begin(), sections.end(), x - same);
    return static_cast<int>(next - sections.begin());
  };
  line.outer_radius.clear();
  line.axial_rigidity.clear();
  for (std::size_t i = 1; i < sections.size(); ++i) {
    const double middle = 0.5 * (sections[i - 1] + sections[i]);
    const auto flange =
        std::ranges::find_if(s.flanges, [&](const auto& f) { return f.from < middle && middle < f.to; });
    const bool plain = flange == s.flanges.end();
    line.outer_radius.push_back(plain ? s.nut_radius : flange->outer_radius);
    line.axial_rigidity.push_back(plain ? s.nut_rigidity : flange->axial_rigidity);
  }
  line.contacts.clear();
  for (int k = 0; k < count; ++k) line.contacts.push_back(node_at(contact(k)));
  line.thrust = node_at(s.thrust);
}

RoundBody operator+(const RoundBody& a, const RoundBody& b) {
  return {a.volume + b.volume, a.polar_moment + b.polar_moment};
}

}  // namespace

SectorModel sector_model(const Mechanism& m, const Structure& structure, const Materials& materials,
                         const ModelOptions& options, const PerInterface<ContactLaw>& laws, Direction direction,
                         double position, const Deviations& deviations) {
  SectorModel s;
  set_sector_model(s, m, structure, materials, options, laws, direction, position, deviations);
  work_out(s);
  return s;
}

void set_sector_model(SectorModel& s, const Mechanism& m, const Structure& structure, const Materials& materials,
                      const ModelOptions& options, const PerInterface<ContactLaw>& laws, Direction direction,
                      double position, const Deviations& deviations) {
  const Given g{m, structure, materials, laws, effects_of(options)};
  static_cast<SectorNumbers<double>&>(s) = {};
  s.flanges.clear();
  s.nut_shell.reset();
  for (const Interface i : kInterfaces) s.body_compliance[i].clear();
  s.rollers = loaded_rollers(m);
  s.sense = sense(direction);
  s.pitch = axial_pitch(m);
  set_screw(s, g);
  set_roller(s, g, options);
  set_nut(s, g, direction, position);
  set_contacts(s, g, deviations, direction);
  s.is_refined = options.bodies->effects;
  if (s.is_refined) set_bodies(s, g);
}

void work_out(SectorModel& s) {
  if (!s.is_refined) return;
  const RefinedBodies& b = s.bodies;
  if (b.has_shell())
    s.nut_shell = nut_shell(
        b.shape(), nut_numbers(s, b.numbers, b.line.sections.data(), b.line.outer_radius.data(), b.bore.root.data()));
  if (!b.effects.radial && !b.effects.concentration) return;
  for (const Interface i : kInterfaces) s.body_compliance[i].assign(s.gaps[i].size(), 0.0);
  add_body_compliance(b.shape(), static_cast<const SectorNumbers<double>&>(s), b.numbers, b.line.outer_radius.data(),
                      s.body_compliance.screw.data(), s.body_compliance.nut.data());
}

void set_nut_line(NutLine& line, const SectorModel& s) {
  set_line(line, s, s.contacts(), [&](int k) { return s.position + k * s.pitch; });
}

void set_laws(SectorModel& s, const PerInterface<ContactLawNumbers>& laws) {
  for (const Interface i : kInterfaces) {
    s.hertz_constant[i] = laws[i].hertz_constant;
    s.cosine[i] = laws[i].cosine;
    s.sine[i] = laws[i].sine;
    s.compliance[i] = laws[i].compliance;
  }
}

NutLine nut_line(const SectorModel& s) {
  NutLine line;
  set_nut_line(line, s);
  return line;
}

NutLine nut_line(const SectorModel& s, const std::vector<double>& contact_x) {
  NutLine line;
  set_line(line, s, static_cast<int>(contact_x.size()), [&](int k) { return item_at(contact_x, k); });
  return line;
}

BodyRadii body_radii(const Mechanism& m, const Structure& structure, const Materials& materials,
                     const ModelOptions& options, const PerInterface<ContactLaw>& laws, const NutLine& line) {
  const Given g{m, structure, materials, laws, effects_of(options)};
  BodyRadii radii{0.5 * g.plain_screw_diameter(), 0.5 * g.root_diameter(Part::screw), {}};
  set_nut_bore(radii.nut, g, line);
  return radii;
}

RoundBody tube(double outer, double inner, double length) {
  return {ring_area(outer, inner) * length,
          std::numbers::pi / 32.0 * (std::pow(outer, 4) - std::pow(inner, 4)) * length};
}

RoundBody nut_body(const Mechanism& m, const Structure::Nut& nut) {
  RoundBody body = tube(nut.outer_diameter, *m.pitch_diameter.nut, nut.length);
  for (const Structure::Flange& f : nut.flanges)
    body = body + tube(f.outer_diameter, nut.outer_diameter, f.to - f.from);
  return body;
}

RoundBody roller_body(const Mechanism& m, const Structure::Roller& roller) {
  return tube(*m.pitch_diameter.roller, 0.0, m.contacts_per_roller * axial_pitch(m)) +
         tube(roller.end_diameter, 0.0, 2.0 * roller.end_length);
}

RoundBody screw_body(const Mechanism& m, const Structure::Screw& screw, double length) {
  return tube(*m.pitch_diameter.screw, screw.bore, length);
}

double envelope_volume(const Structure::Nut& nut) {
  double diameter = nut.outer_diameter;
  for (const Structure::Flange& f : nut.flanges) diameter = std::max(diameter, f.outer_diameter);
  return disc_area(diameter) * nut.length;
}

}  // namespace prs
