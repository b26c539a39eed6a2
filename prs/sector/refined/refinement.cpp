#include "prs/sector/refined/refinement.h"

#include <algorithm>
#include <cmath>

#include "prs/model/groove.h"
#include "prs/sector/refined/local_compliance.h"

namespace prs {
namespace {

double pitch_radius(const Mechanism& m, Part p) { return 0.5 * *m.pitch_diameter[p]; }

double root_depth(const Mechanism& m, Part p, double normal_angle) {
  if (m.thread[p]) return m.thread[p]->dedendum;
  return default_groove(p == Part::nut, axial_pitch(m), pitch_radius(m, p), normal_angle,
                        normal_angle)
      .dedendum;
}

/// Where the nut's roots lie between the nodes.
std::vector<double> nut_roots(const Mechanism& m, double depth, const NutLine& line) {
  const double radius = pitch_radius(m, Part::nut), least = kLeastWall * axial_pitch(m);
  std::vector<double> roots;
  for (const double outer : line.outer_radius) {
    const double wall = outer - radius;
    roots.push_back(radius + std::min(depth, std::max(wall - least, 0.5 * wall)));
  }
  return roots;
}

double outer_radius_at(const NutLine& line, int node) {
  const auto k = static_cast<std::size_t>(node);
  const double before = line.outer_radius[std::max<std::size_t>(k, 1) - 1];
  return std::min(before, line.outer_radius[std::min(k, line.outer_radius.size() - 1)]);
}

/// The screw's surface and the nut's wall under radial loads.
void add_radial(Refinement& r, const Mechanism& m, const Structure& structure,
                const Materials& materials, const PerInterface<ContactLaw>& laws,
                const NutLine& line) {
  const double pitch = axial_pitch(m);
  const double screw = pitch_radius(m, Part::screw), bore = 0.5 * structure.screw.bore;
  const double whole =
      cylinder_compliance(screw, bore, materials.screw, m.rollers, pitch, laws.screw.normal_angle);
  const std::vector<double> shares =
      band_shares(m.contacts_per_roller, pitch, screw, bore, materials.screw.poisson_ratio);
  for (std::size_t k = 0; k < shares.size(); ++k) {
    r.compliance.screw[k] += shares[k] * whole;
    r.compliance.nut[k] +=
        wall_compliance(pitch_radius(m, Part::nut), outer_radius_at(line, line.contacts[k]),
                        materials.nut, m.rollers, pitch, laws.nut.normal_angle);
  }
}

/// Both bodies of an interface by the rows in which the contacts stand.
void add_concentration(Refinement& r, const Mechanism& m, const Materials& materials,
                       const PerInterface<ContactLaw>& laws) {
  for (const Interface i : kInterfaces) {
    const Part body = body_of(i);
    const auto of = [&](Part p, const LineReach& reach) {
      return concentration_compliance(reach, materials[p], axial_pitch(m), laws[i].normal_angle);
    };
    const double both = of(body, rows_around(pitch_radius(m, body), m.rollers)) +
                        of(Part::roller, opposite_rows(pitch_radius(m, Part::roller)));
    for (double& compliance : r.compliance[i]) compliance += both;
  }
}

}  // namespace

Refinement refinement(const Mechanism& m, const Structure& structure, const Materials& materials,
                      const ModelOptions& options, const PerInterface<ContactLaw>& laws,
                      Direction direction, const NutLine& line) {
  Refinement r;
  r.plain_screw_diameter = r.screw_diameter = *m.pitch_diameter.screw;
  r.roller_diameter = *m.pitch_diameter.roller;
  r.nut_bore.assign(line.outer_radius.size(), pitch_radius(m, Part::nut));
  r.roller_shear = options.roller_shear;
  for (const Interface i : kInterfaces)
    r.compliance[i].assign(static_cast<std::size_t>(m.contacts_per_roller), 0.0);
  if (options.bodies != ModelOptions::Bodies::refined) return r;

  const RefinedEffects& effects = options.refined;
  const double bore = 0.5 * structure.screw.bore;
  if (effects.core) {
    const double psi = std::max(laws.screw.normal_angle, laws.nut.normal_angle);
    r.screw_diameter -= 2.0 * root_depth(m, Part::screw, psi);
    r.roller_diameter -= 2.0 * root_depth(m, Part::roller, psi);
    r.nut_bore = nut_roots(m, root_depth(m, Part::nut, psi), line);
    if (m.type == Mechanism::Type::standard) r.plain_screw_diameter = r.screw_diameter;
  }
  r.roller_shear |= effects.shear;
  if (roller_contacts(options, m.starts.roller) == ModelOptions::RollerContacts::half_pitch_apart)
    r.roller_half_distance = 0.25 * axial_pitch(m);
  const NutBore nut{r.nut_bore, pitch_radius(m, Part::nut)};
  if (effects.hoop || effects.flange)
    r.nut = nut_shell(line, thrust_ring(line, structure.nut, nut), nut,
                      {sense(direction), laws.nut.normal_angle}, materials.nut, m.rollers, effects);
  r.nut_radially_rigid = !effects.hoop;
  if (effects.radial) add_radial(r, m, structure, materials, laws, line);
  if (effects.concentration) add_concentration(r, m, materials, laws);
  if (effects.poisson)
    r.offset_compliance = poisson_offset(sense(direction), 0.5 * r.screw_diameter, bore,
                                         materials.screw, m.rollers, laws.screw.normal_angle);
  return r;
}

}  // namespace prs
