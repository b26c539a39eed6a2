#include "prs/mechanism/full_model.h"

#include <algorithm>

#include "prs/indices.h"
#include "prs/threads/threads.h"

namespace prs {
namespace {

/// Turns of the helix of screw and nut up to the azimuth of a roller, and the nearest whole number of them, chosen
/// independently of rounding.
double helix_turns(const Mechanism& m, double azimuth) {
  const double sign = m.lead > 0.0 ? 1.0 : -1.0;
  return sign * m.starts.screw * azimuth / (2.0 * std::numbers::pi);
}
double whole_turns(double turns) { return std::floor(turns + 0.5 + 1e-9); }

/// Index of the start that a roller meets at its thread i.
std::size_t start_at(const Mechanism& m, double azimuth, int i) {
  const int shifted = i - static_cast<int>(whole_turns(helix_turns(m, azimuth)));
  const int starts = m.starts.screw;
  return static_cast<std::size_t>(((shifted % starts) + starts) % starts);
}

double measured_at(const MeasuredLead& m, double xi) {
  const auto above = std::upper_bound(m.at.begin() + 1, m.at.end() - 1, xi);
  const auto k = static_cast<std::size_t>(above - m.at.begin());
  const double share = (xi - m.at[k - 1]) / (m.at[k] - m.at[k - 1]);
  return m.deviation[k - 1] + share * (m.deviation[k] - m.deviation[k - 1]);
}

/// A shift of a thread, outwards at a roller and along x [m].
struct Shift {
  double radial = 0.0, axial = 0.0;
};

/// Shift of the thread of screw or nut at xi and the azimuth alpha on the part; `arm` is the radius at
/// which it moves as it tilts.
Shift shift_of(const TurningThread& t, double alpha, double xi, double middle, double arm) {
  const double tilt = t.wobble.amount * std::cos(alpha - t.wobble.angle);
  Shift s{t.eccentricity.amount * std::cos(alpha - t.eccentricity.angle) + tilt * (xi - t.wobble_at.value_or(middle)),
          t.per_300_mm * xi / 0.3 - arm * tilt};
  for (const LeadHarmonic& h : t.harmonics) s.axial += h.amplitude * std::sin(h.order * alpha + h.phase);
  for (const LeadWave& w : t.waves) s.axial += w.amplitude * std::sin(2.0 * std::numbers::pi * xi / w.length + w.phase);
  if (t.measured) s.axial += measured_at(*t.measured, xi);
  return s;
}

/// Shift of the thread of roller j, turned by `spin`, `from_middle` along it, at the screw or the nut.
Shift shift_of(const TurningRollers& t, std::size_t j, Interface i, double spin, double from_middle,
               double roller_radius) {
  const auto turned = [&](const TurningRollers::Error& e) { return e.amount.of(j) * std::cos(spin + e.angle.of(j)); };
  const bool screw = i == Interface::screw;
  const double tilt = turned(t.wobble);
  Shift s{turned(t.eccentricity) + tilt * from_middle, (screw ? 1.0 : -1.0) * roller_radius * tilt};
  const double side = (screw ? std::numbers::pi : 0.0) - spin;
  for (const TurningRollers::Harmonic& h : t.harmonics)
    s.axial += h.amplitude.of(j) * std::sin(h.order * side + h.phase.of(j));
  return s;
}

/// Data common to all rollers.
struct ThreadsOfAll {
  const Mechanism& m;
  const Deviations& d;
  const Materials& materials;
  const PerInterface<ContactLaw>& laws;
  Direction direction;
  Turn turn;
  double position;
  PerInterface<ThreadOffsets> body;
  ThreadOffsets roller;

  bool unlike() const { return !d.roller_diameters.empty() || !d.pitch_error.roller.lists.empty(); }
};

/// Contributions to the gaps of one roller, before the smallest is subtracted.
PerInterface<std::vector<double>> gaps_of(const ThreadsOfAll& all, std::size_t j, double azimuth,
                                          const std::vector<double>& contact_x) {
  const Mechanism& m = all.m;
  ThreadOffsets roller = all.roller;
  if (all.unlike()) {
    Deviations own = all.d;
    if (!all.d.roller_diameters.empty()) own.roller_diameter = all.d.roller_diameters[j];
    if (!all.d.pitch_error.roller.lists.empty()) own.pitch_error.roller.list = all.d.pitch_error.roller.lists[j];
    roller = thread_offsets(m, own, all.materials, Part::roller);
  }
  const Turning& turning = all.d.turning;
  const bool turns = turning != Turning{};
  const bool on_nut = carrier_part(m.type) == Part::nut;
  const double on_part = azimuth - all.turn.geared(m.type);
  const double spin = (on_nut ? -1.0 : 1.0) * m.starts.screw / m.starts.roller * on_part;
  const double radius = 0.5 * *m.pitch_diameter.roller;
  const double half = 0.5 * (m.contacts_per_roller - 1) * axial_pitch(m);
  PerInterface<std::vector<double>> gaps;
  for (const Interface i : kInterfaces) {
    const double ahead = i == Interface::screw ? 1.0 : -1.0;
    ThreadOffsets body = all.body[i], of_roller = roller;
    const std::vector<double>& index_error = all.d.index_error[i];
    const double part = i == Interface::screw ? all.turn.screw : all.turn.nut;
    const double travelled = (on_nut ? 0.0 : all.turn.travel) - (i == Interface::screw ? all.turn.travel : 0.0);
    for (const auto k : indices(body.axial)) {
      if (!index_error.empty()) body.axial[k] += index_error[start_at(m, on_part, static_cast<int>(k))];
      body.radial[k] += along(all.d.thread_eccentricity[i], azimuth);
      if (!turns) continue;
      const double x = contact_x[k] - all.position;
      const Shift b =
          shift_of(turning.thread[i], azimuth - part, x + travelled, half, *m.centre_distance - ahead * radius);
      const Shift r = shift_of(turning.rollers, j, i, spin, x - half, radius);
      body.axial[k] += b.axial;
      body.radial[k] += b.radial;
      of_roller.axial[k] += r.axial;
      of_roller.radial[k] -= ahead * r.radial;
    }
    gaps[i] = gaps_between(body, of_roller, i, all.laws[i].normal_angle, all.direction);
  }
  return gaps;
}

void take_off_smallest(FullModel& f) {
  for (const Interface i : kInterfaces) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const FullModel::Roller& r : f.present) smallest = std::min(smallest, *std::ranges::min_element(r.gaps[i]));
    for (FullModel::Roller& r : f.present)
      for (double& gap : r.gaps[i]) gap -= smallest;
    f.smallest_gap[i] = smallest;
  }
}

/// Axial places of the contacts of all rollers except missing ones.
std::vector<double> all_contacts(const FullModel& f) {
  std::vector<double> x;
  for (const FullModel::Roller& r : f.present) append(x, r.contact_x);
  return x;
}

double delta_of(const std::vector<double>& list, std::size_t roller) { return list.empty() ? 0.0 : list[roller]; }

void set_rollers(FullModel& f, const ModelOptions& options, const ThreadsOfAll& all) {
  const Mechanism& m = all.m;
  for (int j = 0; j < f.rollers; ++j) {
    const std::vector<int>& missing = all.d.missing_rollers;
    if (contains(missing, j + 1)) continue;
    const auto number = static_cast<std::size_t>(j);
    FullModel::Roller r;
    r.number = j;
    r.azimuth = f.load.carrier_angle + 2.0 * std::numbers::pi * j / f.rollers + all.turn.carrier;
    double phase = 0.0;
    if (options.contact_phase == ModelOptions::ContactPhase::helical) {
      const double turns = helix_turns(m, r.azimuth - all.turn.geared(m.type));
      phase = f.sector.pitch * (turns - whole_turns(turns));
    }
    for (int k = 0; k < m.contacts_per_roller; ++k)
      r.contact_x.push_back(f.sector.position + k * f.sector.pitch + phase);
    r.gaps = gaps_of(all, number, r.azimuth, r.contact_x);
    r.ring_offset = {delta_of(all.d.roller_position.near, number), delta_of(all.d.roller_position.far, number)};
    f.present.push_back(std::move(r));
  }
  take_off_smallest(f);
}

Lateral turned_back(const Lateral& l, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * l.y + s * l.z, c * l.z - s * l.y};
}

}  // namespace

Turn turn_of(const Mechanism& m, const Travel& t, double theta) {
  const bool screw = t.part == Travel::Part::screw;
  const double nut = screw ? 0.0 : -theta;
  return {screw ? theta : 0.0, nut, nut + slip_ratio(m, t) * theta, m.lead * theta / (2.0 * std::numbers::pi)};
}

Turn turn_of(const Mechanism& m, const LoadCase& load_case) {
  return load_case.travel ? turn_of(m, *load_case.travel, load_case.travel->from) : Turn{};
}

void turn_axes(FullModel& f, double angle) {
  const auto turn = [angle](Lateral& l) { l = turned_back(l, angle); };
  for (FullModel::Roller& r : f.present) r.azimuth -= angle;
  for (Lateral* l :
       {&f.load.eccentricity, &f.load.side_force.value, &f.load.moment.value, &f.load.nut_tilt, &f.load.nut_offset})
    turn(*l);
  for (Bearing& b : f.bearings) {
    turn(b.offset);
    turn(b.angle);
  }
}

FullModel full_model(const Mechanism& m, const Structure& structure, const Materials& materials,
                     const ModelOptions& options, const PerInterface<ContactLaw>& laws, const LoadCase& load_case,
                     const Deviations& deviations, const Turn& turn) {
  FullModel f;
  ModelOptions sector_options = options;
  sector_options.roller_shear = options.roller_shear || options.shear;
  f.sector = sector_model(m, structure, materials, sector_options, laws, *load_case.direction, *load_case.position);
  f.centre_distance = *m.centre_distance;
  f.rollers = m.rollers;
  f.load = load_case.spatial;
  f.axial_force = load_case.axial_force;

  const double first = f.sector.position, last = first + (f.threads() - 1) * f.sector.pitch;
  f.loaded_section = first - f.sector.free_length;
  f.thrust = f.sector.thrust;
  const double reach = 0.5 * f.sector.pitch + f.sector.end_length;
  f.roller_ends = {first - reach, last + reach};
  set_rollers(
      f, options,
      {m,
       deviations,
       materials,
       laws,
       *load_case.direction,
       turn,
       first,
       {thread_offsets(m, deviations, materials, Part::screw), thread_offsets(m, deviations, materials, Part::nut)},
       thread_offsets(m, deviations, materials, Part::roller)});

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
  for (const auto i : indices(line.outer_radius))
    f.nut.push_back(
        {line.sections[i], line.sections[i + 1], section(Part::nut, line.outer_radius[i], radii.nut.root[i])});
  if (has_wall) {
    const NutLoad equal_loads{f.sense(), laws.nut.normal_angle};
    f.nut_wall = {
        line,
        nut_shell(line, thrust_ring(line, structure.nut, radii.nut), radii.nut, equal_loads, materials.nut, 1,
                  options.refined),
        options.refined.hoop ? nut_harmonics(line, radii.nut, materials.nut, f.rollers) : std::vector<NutHarmonic>{}};
  }

  const Rings& rings = structure.roller.rings;
  f.carrier = rings.carrier.value_or(carrier_part(m.type) == Part::nut ? Rings::Carrier::nut : Rings::Carrier::screw);
  f.ring_stiffness = rings.stiffness;
  f.housing = structure.nut.housing;
  f.bearings = structure.screw.bearings;
  return f;
}

std::vector<NutHarmonic> nut_harmonics(const NutLine& line, const NutBore& bore, const Material& material, int rollers,
                                       int highest) {
  std::vector<int> same;
  set_alike_segments(line, bore, same);
  std::vector<NutHarmonic> harmonics;
  for (int n = 2; n <= highest; ++n) {
    if (n % rollers == 0) continue;
    NutHarmonic harmonic{n, {}};
    for (const auto i : indices(same))
      harmonic.segments.push_back(
          same[i] < static_cast<int>(i)
              ? item_at(harmonic.segments, same[i])
              : fe::stiffness_matrix(fe::oval_tube(n, bore.pitch, bore.root[i], line.outer_radius[i],
                                                   material.youngs_modulus, material.poisson_ratio),
                                     line.length(i)));
    harmonics.push_back(std::move(harmonic));
  }
  return harmonics;
}

}  // namespace prs
