#include "prs/mechanism/full_model.h"

#include <algorithm>

#include "prs/threads/threads.h"

namespace prs {
namespace {

/// Turns of the helix of screw and nut up to the azimuth of a roller.
double helix_turns(const Mechanism& m, double azimuth) {
  const double sign = m.lead > 0.0 ? 1.0 : -1.0;
  return sign * m.starts.screw * azimuth / (2.0 * std::numbers::pi);
}

/// The start that a roller meets at its thread i.
std::size_t start_at(const Mechanism& m, double azimuth, int i) {
  const int shifted = i - static_cast<int>(std::floor(helix_turns(m, azimuth) + 0.5));
  const int starts = m.starts.screw;
  return static_cast<std::size_t>(((shifted % starts) + starts) % starts);
}

/// What the gaps of one roller are made of, before the smallest is taken off.
PerInterface<std::vector<double>> gaps_of(const Mechanism& m, const Deviations& all,
                                          const Materials& materials,
                                          const PerInterface<ContactLaw>& laws, Direction direction,
                                          std::size_t roller, double azimuth) {
  Deviations d = all;
  if (!all.roller_diameters.empty()) d.roller_diameter = all.roller_diameters[roller];
  if (!all.pitch_error.roller.lists.empty())
    d.pitch_error.roller.list = all.pitch_error.roller.lists[roller];
  const ThreadOffsets of_roller = thread_offsets(m, d, materials, Part::roller);
  PerInterface<std::vector<double>> gaps;
  for (const Interface i : kInterfaces) {
    ThreadOffsets body = thread_offsets(m, d, materials, body_of(i));
    const std::vector<double>& index_error = all.index_error[i];
    for (std::size_t k = 0; k < body.axial.size(); ++k) {
      if (!index_error.empty())
        body.axial[k] += index_error[start_at(m, azimuth, static_cast<int>(k))];
      body.radial[k] += along(all.thread_eccentricity[i], azimuth);
    }
    gaps[i] = gaps_between(body, of_roller, i, laws[i].normal_angle, direction);
  }
  return gaps;
}

void take_off_smallest(std::vector<FullModel::Roller>& rollers) {
  for (const Interface i : kInterfaces) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const FullModel::Roller& r : rollers)
      smallest = std::min(smallest, *std::ranges::min_element(r.gaps[i]));
    for (FullModel::Roller& r : rollers)
      for (double& gap : r.gaps[i]) gap -= smallest;
  }
}

/// Axial places of the contacts of all rollers, those of missing ones left out.
std::vector<double> all_contacts(const FullModel& f) {
  std::vector<double> x;
  for (const FullModel::Roller& r : f.present)
    x.insert(x.end(), r.contact_x.begin(), r.contact_x.end());
  return x;
}

double delta_of(const std::vector<double>& list, std::size_t roller) {
  return list.empty() ? 0.0 : list[roller];
}

void set_rollers(FullModel& f, const Mechanism& m, const Materials& materials,
                 const ModelOptions& options, const PerInterface<ContactLaw>& laws,
                 Direction direction, const Deviations& d) {
  for (int j = 0; j < f.rollers; ++j) {
    if (std::ranges::find(d.missing_rollers, j + 1) != d.missing_rollers.end()) continue;
    const auto number = static_cast<std::size_t>(j);
    FullModel::Roller r;
    r.number = j;
    r.azimuth = f.load.carrier_angle + 2.0 * std::numbers::pi * j / f.rollers;
    double phase = 0.0;
    if (options.contact_phase == ModelOptions::ContactPhase::helical) {
      const double turns = helix_turns(m, r.azimuth);
      phase = f.sector.pitch * (turns - std::floor(turns + 0.5));
    }
    for (int k = 0; k < m.contacts_per_roller; ++k)
      r.contact_x.push_back(f.sector.position + k * f.sector.pitch + phase);
    r.gaps = gaps_of(m, d, materials, laws, direction, number, r.azimuth);
    r.ring_offset = {delta_of(d.roller_position.near, number),
                     delta_of(d.roller_position.far, number)};
    f.present.push_back(std::move(r));
  }
  take_off_smallest(f.present);
}

}  // namespace

FullModel full_model(const Mechanism& m, const Structure& structure, const Materials& materials,
                     const ModelOptions& options, const PerInterface<ContactLaw>& laws,
                     const LoadCase& load_case, const Deviations& deviations) {
  FullModel f;
  ModelOptions sector_options = options;
  sector_options.roller_shear = options.roller_shear || options.shear;
  f.sector = sector_model(m, structure, materials, sector_options, laws, *load_case.direction,
                          *load_case.position);
  f.centre_distance = *m.centre_distance;
  f.rollers = m.rollers;
  f.load = load_case.spatial;
  f.axial_force = load_case.axial_force;

  const double first = f.sector.position, last = first + (f.threads() - 1) * f.sector.pitch;
  f.loaded_section = first - f.sector.free_length;
  f.thrust = f.sector.thrust;
  const double reach = 0.5 * f.sector.pitch + f.sector.end_length;
  f.roller_ends = {first - reach, last + reach};
  set_rollers(f, m, materials, options, laws, *load_case.direction, deviations);

  const auto section = [&](Part part, double outer_radius, double inner_radius) {
    return ring_rigidity(materials[part], 2.0 * outer_radius, 2.0 * inner_radius, options.shear);
  };
  const bool has_wall = f.sector.nut_shell.has_value();
  const NutLine line = has_wall ? nut_line(f.sector, all_contacts(f)) : nut_line(f.sector);
  const BodyRadii radii = body_radii(m, structure, materials, options, laws, line);
  const auto screw = [&](double from, double to, double radius) {
    f.screw.push_back({from, to, section(Part::screw, radius, 0.5 * structure.screw.bore)});
  };
  if (f.loaded_section < first) screw(f.loaded_section, first, radii.plain_screw);
  screw(first, last + structure.screw.far_length, radii.screw);
  for (std::size_t i = 0; i < line.outer_radius.size(); ++i)
    f.nut.push_back({line.sections[i], line.sections[i + 1],
                     section(Part::nut, line.outer_radius[i], radii.nut.root[i])});
  if (has_wall) {
    const NutLoad equal_loads{f.sense(), laws.nut.normal_angle};
    f.nut_wall = {line,
                  nut_shell(line, thrust_ring(line, structure.nut, radii.nut), radii.nut,
                            equal_loads, materials.nut, 1, options.refined),
                  options.refined.hoop ? nut_harmonics(line, radii.nut, materials.nut, f.rollers)
                                       : std::vector<NutHarmonic>{}};
  }

  const Rings& rings = structure.roller.rings;
  f.carrier = rings.carrier.value_or(m.type == Mechanism::Type::standard ? Rings::Carrier::nut
                                                                         : Rings::Carrier::screw);
  f.ring_stiffness = rings.stiffness;
  f.housing = structure.nut.housing;
  f.bearings = structure.screw.bearings;
  return f;
}

std::vector<NutHarmonic> nut_harmonics(const NutLine& line, const NutBore& bore,
                                       const Material& material, int rollers, int highest) {
  std::vector<NutHarmonic> harmonics;
  for (int n = 2; n <= highest; ++n) {
    if (n % rollers == 0) continue;
    NutHarmonic harmonic{n, {}};
    for (std::size_t i = 0; i < line.outer_radius.size(); ++i) {
      const auto same = [&](std::size_t k) {
        return line.outer_radius[k] == line.outer_radius[i] && bore.root[k] == bore.root[i] &&
               std::abs(line.length(k) - line.length(i)) <= 1e-12 * line.length(i);
      };
      std::size_t k = 0;
      while (k < i && !same(k)) ++k;
      harmonic.segments.push_back(
          k < i ? harmonic.segments[k]
                : fe::stiffness_matrix(
                      fe::oval_tube(n, bore.pitch, bore.root[i], line.outer_radius[i],
                                    material.youngs_modulus, material.poisson_ratio),
                      line.length(i)));
    }
    harmonics.push_back(std::move(harmonic));
  }
  return harmonics;
}

}  // namespace prs
