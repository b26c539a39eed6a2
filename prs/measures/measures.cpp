#include "prs/measures/measures.h"

#include <initializer_list>
#include <map>

#include "prs/life/analyze_life.h"
#include "prs/loads/full_result.h"
#include "prs/slip/slip_at_speed.h"

namespace prs {
namespace {

MeasureOptions options_of(const Conditions& c) { return c.measures.value_or(MeasureOptions{}); }

/// Normal angle used in the load distribution: the case's own, else that of the geometry.
std::optional<double> normal_angle(const Conditions& c, const Contacts& contacts, Interface i) {
  if (c.contact.normal_angle[i]) return c.contact.normal_angle[i];
  const InterfaceContact& contact = contacts.interfaces[i];
  return contact.geometry.ok() ? std::optional(contact.normal_angle()) : std::nullopt;
}

std::optional<double> axial_hertz_coefficient(const Conditions& c, const Contacts& contacts, Interface i) {
  const std::optional<double> angle = normal_angle(c, contacts, i);
  if (!angle) return std::nullopt;
  if (c.contact.hertz_constant[i]) return prs::axial_hertz_coefficient(*c.contact.hertz_constant[i], *angle);
  const InterfaceContact& contact = contacts.interfaces[i];
  if (!contact.has_hertz()) return std::nullopt;
  return prs::axial_hertz_coefficient(contact.hertz.hertz_constant, *angle);
}

/// Number of loaded contacts of all rollers at one interface.
int contact_count(const Mechanism& m) { return loaded_rollers(m) * m.contacts_per_roller; }

template <class... T>
std::optional<double> sum(const T&... values) {
  return (values && ...) ? std::optional((*values + ...)) : std::nullopt;
}

std::optional<double> product(const std::optional<double>& a, double b) {
  return a ? std::optional(*a * b) : std::nullopt;
}

std::optional<double> ratio(const std::optional<double>& a, const std::optional<double>& b) {
  return a && b ? std::optional(*a / *b) : std::nullopt;
}

/// Smallest of the known values.
std::optional<double> smallest(std::initializer_list<std::optional<double>> values) {
  std::optional<double> least;
  for (const std::optional<double>& v : values)
    if (v && (!least || *v < *least)) least = v;
  return least;
}

std::optional<double> largest(const std::vector<double>& values) {
  return values.empty() ? std::nullopt : std::optional(*std::max_element(values.begin(), values.end()));
}

/// Speed of the screw against the nut [rad/s], >= 0.
std::optional<double> speed_of(const Conditions& c, const LoadCase& load_case) {
  std::optional<double> speed = load_case.speed;
  if (!speed && c.operation) speed = c.operation->speed;
  return speed ? std::optional(std::abs(*speed)) : std::nullopt;
}

bool runs(const Conditions& c, const LoadCase& load_case) { return speed_of(c, load_case).value_or(0.0) > 0.0; }

void find_transmission(const Conditions& c, const Contacts& contacts, Measures& m) {
  const Mechanism& mechanism = contacts.mechanism;
  m.velocity_ratio = velocity_ratio(mechanism.lead);
  const PlanetaryRatios ratios = planetary_ratios(mechanism.type, gear_ratio(mechanism));
  if (ratios.carrier > 0.0 && ratios.carrier < 1.0) {
    m.roller_ratio = ratios.roller;
    m.carrier_ratio = ratios.carrier;
  }
  const std::optional<double> friction = options_of(c).friction_coefficient;
  if (!friction) return;
  const double diameter = *mechanism.pitch_diameter.screw;
  m.efficiency = efficiency(mechanism.lead, diameter, *friction);
  m.back_driving_efficiency = back_driving_efficiency(mechanism.lead, diameter, *friction);
}

void find_stiffness(const Conditions& c, const Contacts& contacts, Measures& m) {
  if (!c.structure || !c.materials) return;
  const PerPart<double> section = section_stiffness(contacts.mechanism, *c.structure, *c.materials);
  const std::optional<double> width = options_of(c).loaded_width;
  for (const Part p : kParts) {
    m.section_stiffness[p] = section[p];
    if (width) m.tooth_stiffness[p] = tooth_stiffness(contacts.mechanism, *c.structure, *c.materials, p, *width);
  }
}

/// The angle of Lemor's formula; none where a contact has none.
std::optional<double> lemor_angle(const Conditions& c, const Contacts& contacts) {
  const auto screw = normal_angle(c, contacts, Interface::screw), nut = normal_angle(c, contacts, Interface::nut);
  return screw && nut ? std::optional(contact_angle({*screw, *nut})) : std::nullopt;
}

void find_dynamic_capacity(const Conditions& c, const Contacts& contacts, Measures& m) {
  if (const auto angle = lemor_angle(c, contacts); angle && (!c.materials || is_steel(*c.materials)))
    if (const auto lemor = lemor_capacity(lemor_geometry(contacts.mechanism, *angle))) {
      m.geometry_factor = lemor->factor;
      m.element_diameter = lemor->element_diameter;
      m.dynamic_capacity = lemor->capacity;
      m.dynamic_capacity_low = lemor->capacity_range.least;
      m.dynamic_capacity_high = lemor->capacity_range.greatest;
    }
  if (c.life && c.life->dynamic_capacity)
    m.dynamic_capacity = m.dynamic_capacity_low = m.dynamic_capacity_high = c.life->dynamic_capacity;
}

std::optional<double> stated_static_capacity(const Conditions& c) {
  return c.life ? c.life->static_capacity : std::nullopt;
}

void find_static_capacity(const Conditions& c, const Contacts& contacts, Measures& m) {
  for (const Interface i : kInterfaces) {
    const std::optional<double> angle = normal_angle(c, contacts, i);
    if (!angle) continue;
    const double per_normal_load = std::cos(*angle) * contact_count(contacts.mechanism);
    const StaticLimits limits = static_limits(c.materials, contacts, i);
    m.pressure_capacity[i] = product(limits.pressure, per_normal_load);
    m.deformation_capacity[i] = product(limits.deformation, per_normal_load);
    m.interface_flank_edge_load[i] = product(limits.flank_edge, per_normal_load);
  }
  m.flank_edge_load = smallest({m.interface_flank_edge_load.screw, m.interface_flank_edge_load.nut});
  m.static_capacity = stated_static_capacity(c);
  if (!m.static_capacity)
    m.static_capacity = smallest(
        {m.deformation_capacity.screw, m.deformation_capacity.nut, m.pressure_capacity.screw, m.pressure_capacity.nut});
}

/// Static rating of one interface with equal shares.
std::optional<StaticRating> interface_static_rating(const Conditions& c, const Measures& m, Interface i) {
  return static_rating(m.pressure_capacity[i], stated_static_capacity(c));
}

/// Static rating of the mechanism with equal shares.
std::optional<StaticRating> equal_shares_static_rating(const Conditions& c, const Measures& m) {
  const auto screw = interface_static_rating(c, m, Interface::screw),
             nut = interface_static_rating(c, m, Interface::nut);
  return screw && nut ? smaller(screw, nut) : std::nullopt;
}

/// Computes inertias at the turning part from the masses of the parts.
void find_inertia(const Conditions& c, const Contacts& contacts, Measures& m) {
  const Mechanism& mechanism = contacts.mechanism;
  const PerPart<std::optional<double>> density = {c.materials->screw.density, c.materials->roller.density,
                                                  c.materials->nut.density};
  m.nut_inertia = product(density.nut, nut_body(mechanism, c.structure->nut).polar_moment);
  std::optional<double> screw_weight;
  if (const auto shaft = options_of(c).shaft) {
    const RoundBody screw = screw_body(mechanism, c.structure->screw, shaft->length);
    screw_weight = product(density.screw, screw.volume);
    m.screw_inertia = product(density.screw, screw.polar_moment);
  }
  const bool on_nut = carrier_part(mechanism.type) == Part::nut;
  // Rollers in a recirculating nut lag behind it until they are led back.
  const double lag = contact::is_grooved(mechanism.type) ? m.carrier_ratio.value_or(0.0) : 0.0;
  if (const auto mass = sum(product(m.roller_weight, (1.0 - lag) * (1.0 - lag)), on_nut ? m.nut_weight : screw_weight))
    m.travel_inertia = travel_inertia(*mass, mechanism.lead);
  if (density.roller && m.roller_ratio) {
    const RoundBody roller = roller_body(mechanism, c.structure->roller);
    m.roller_inertia = roller_inertia(mechanism.rollers, *density.roller * roller.volume,
                                      *density.roller * roller.polar_moment, *mechanism.centre_distance,
                                      ratios_to_frame(mechanism.type, {*m.roller_ratio, *m.carrier_ratio}));
  }
  m.equivalent_inertia = sum(m.roller_inertia, m.travel_inertia, on_nut ? m.screw_inertia : m.nut_inertia);
}

void find_bodies(const Conditions& c, const Contacts& contacts, Measures& m) {
  if (!c.structure) return;
  const Mechanism& mechanism = contacts.mechanism;
  const double nut = nut_body(mechanism, c.structure->nut).volume;
  const double rollers = mechanism.rollers * roller_body(mechanism, c.structure->roller).volume;
  m.material_volume = nut + rollers;
  m.envelope_volume = envelope_volume(c.structure->nut);
  if (!c.materials) return;
  m.nut_weight = product(c.materials->nut.density, nut);
  m.roller_weight = product(c.materials->roller.density, rollers);
  m.weight = sum(m.nut_weight, m.roller_weight);
  m.screw_weight_per_length =
      product(c.materials->screw.density, screw_body(mechanism, c.structure->screw, 1.0).volume);
  m.force_density = ratio(m.dynamic_capacity, m.weight);
  find_inertia(c, contacts, m);
}

void find_shaft(const Conditions& c, const Contacts& contacts, Measures& m) {
  const MeasureOptions options = options_of(c);
  if (!options.shaft || !c.structure || !c.materials) return;
  const Material& material = c.materials->screw;
  const ShaftSection core = core_section(contacts.mechanism, c.structure->screw);
  m.shaft_stiffness = section_stiffness(contacts.mechanism, *c.structure, *c.materials).screw *
                      axial_pitch(contacts.mechanism) / options.shaft->length;
  if (!(core.diameter > core.bore)) return;
  m.buckling_load = buckling_load(core, material.youngs_modulus, *options.shaft, options.yield_strength);
  if (material.density && carrier_part(contacts.mechanism.type) == Part::nut)
    m.critical_speed = critical_speed(core, material.youngs_modulus, *material.density, *options.shaft);
}

void find_load_stiffness(const Conditions& c, const Contacts& contacts, const Measures& measures, double force,
                         LoadMeasures& m) {
  const int threads = contact_count(contacts.mechanism);
  PerInterface<std::optional<double>> coefficient;
  for (const Interface i : kInterfaces) {
    coefficient[i] = axial_hertz_coefficient(c, contacts, i);
    if (coefficient[i]) m.hertz_stiffness[i] = thread_stiffness(force, threads, *coefficient[i], 0.0);
  }
  const std::optional<double> both = sum(coefficient.screw, coefficient.nut);
  if (!both) return;
  // A roller's tooth deforms at both of its contacts.
  double teeth = 0.0;
  for (const Part p : {Part::screw, Part::roller, Part::roller, Part::nut})
    if (measures.tooth_stiffness[p]) teeth += 1.0 / *measures.tooth_stiffness[p];
  m.thread_stiffness = thread_stiffness(force, threads, *both, teeth);
}

void find_yang_distribution(const Conditions& c, const Contacts& contacts, const LoadCase& load_case, LoadMeasures& m) {
  if (!c.structure || !c.materials || !load_case.direction || !load_case.position) return;
  const Structure::Thrust& sections = c.structure->nut.thrust;
  const std::optional<double>& thrust =
      *load_case.direction == Direction::tension ? sections.tension : sections.compression;
  const auto coefficient =
      sum(axial_hertz_coefficient(c, contacts, Interface::screw), axial_hertz_coefficient(c, contacts, Interface::nut));
  if (!thrust || !coefficient) return;
  const double roller_force = std::abs(load_case.axial_force) / loaded_rollers(contacts.mechanism);
  m.yang_load_rate =
      yang_distribution(roller_force, *coefficient,
                        thread_gaps(contacts.mechanism, *c.structure, *c.materials, *thrust, *load_case.position));
  for (double& load : m.yang_load_rate) load /= roller_force;
  m.yang_largest_load_rate = largest(m.yang_load_rate);
}

void find_pressures(const Conditions& c, const Contacts& contacts, double force, LoadMeasures& m) {
  for (const Interface i : kInterfaces) {
    const InterfaceContact& contact = contacts.interfaces[i];
    const std::optional<double> angle = normal_angle(c, contacts, i);
    if (!contact.has_hertz() || !angle) continue;
    const double normal_load = force / (contact_count(contacts.mechanism) * std::cos(*angle));
    m.mean_peak_pressure[i] = contact::at_load(contact.hertz, normal_load).peak_pressure;
  }
}

/// Computes measures from the loads of the threads, solved or equal.
void find_most_loaded(const Conditions& c, const Contacts& contacts, const Measures& measures,
                      const LoadCaseResult& result, LoadMeasures& m) {
  if (!result.threads) return;
  PerInterface<std::optional<double>> axial_load;
  for (const Interface i : kInterfaces) {
    const InterfaceLoads& loads = (*result.threads)[i];
    axial_load[i] = largest(loads.axial_load);
    m.largest_peak_pressure[i] = largest(loads.peak_pressure);
    if (result.solve) m.largest_load_rate[i] = largest(loads.load_rate);
    if (!axial_load[i] || !(*axial_load[i] > 0.0) || !equal_shares_static_rating(c, measures)) continue;
    const auto rating = interface_static_rating(c, measures, i);
    const double safety = rating->limit == StaticLimit::given
                              ? rating->force / std::abs(result.load_case.axial_force)
                              : rating->force / (contact_count(contacts.mechanism) * *axial_load[i]);
    if (m.thread_static_safety && *m.thread_static_safety <= safety) continue;
    m.thread_static_safety = safety;
    m.thread_static_safety_limit = rating->limit;
  }
  const std::optional<double> width = options_of(c).loaded_width;
  if (!width || !axial_load.screw || !axial_load.nut) return;
  const PerPart<double> load = {*axial_load.screw, std::max(*axial_load.screw, *axial_load.nut), *axial_load.nut};
  for (const Part p : kParts) {
    ToothSection tooth = tooth_section(contacts.mechanism, p);
    if (const auto widths = thread_widths(thread_of(contacts.threads, p)))
      tooth.root_width = widths->root.value_or(tooth.root_width);
    const RootStress stress = root_stress(tooth, load[p], *width);
    m.root_shear_stress[p] = stress.shear;
    m.root_bending_stress[p] = stress.bending;
  }
}

/// Static ratings of all load cases; forces of one sense at one place share one solve.
class StaticRatings {
 public:
  StaticRatings(const Conditions& c, const Contacts& contacts) : c_(c), contacts_(contacts) {}

  void rate(const LoadCase& load, LoadMeasures& m) {
    const bool is_along_axis = load.spatial == SpatialLoad{} && !load.travel;
    if ((c_.model.all_rollers() && !is_along_axis) || !load.direction || !load.position ||
        load.share != LoadCase::Share::solved || !(load.axial_force > 0.0))
      return;
    const auto [known, is_new] = ratings_.try_emplace({*load.direction, *load.position});
    if (is_new) {
      Conditions plain = c_;
      plain.preload.reset();
      known->second = solved_static_forces(plain, contacts_, *load.direction, *load.position, load.axial_force);
    }
    m.flank_edge_margin = product(known->second.flank_edge_load, 1.0 / load.axial_force);
    if (!known->second.rating) return;
    m.solved_static_safety = known->second.rating->force / load.axial_force;
    m.solved_static_safety_limit = known->second.rating->limit;
  }

 private:
  const Conditions& c_;
  const Contacts& contacts_;
  std::map<std::pair<Direction, double>, StaticForces> ratings_;
};

}  // namespace

std::vector<Warning> unusual_measures(const Conditions& c, const Contacts& contacts, const Measures& m) {
  std::vector<Warning> warnings;
  const auto add = [&](const char* path, std::optional<Warning> warning) {
    if (!warning) return;
    warning->path = path;
    warnings.push_back(std::move(*warning));
  };
  if (m.geometry_factor && m.dynamic_capacity && !(c.life && c.life->dynamic_capacity))
    warnings = beside_lemor_range(*lemor_angle(c, contacts), *contacts.mechanism.pitch_diameter.screw);
  if (m.dynamic_capacity && m.static_capacity)
    add("mechanism.profile",
        dynamic_above_static(*m.dynamic_capacity, *m.static_capacity, c.life && c.life->static_capacity));
  if (options_of(c).shaft && c.structure && c.materials && !m.buckling_load)
    warnings.push_back({"structure.screw.bore", "bored_through",
                        "the bore of the screw reaches the roots of its thread: no "
                        "buckling load, no critical speed"});
  return warnings;
}

std::vector<Warning> unusual_load_measures(const Conditions& c, const Contacts& contacts, const Measures& m,
                                           const LoadMeasures& load_measures, const LoadCaseResult& result) {
  std::vector<Warning> warnings;
  const std::string path = path_in(result.load_case, "axial_force");
  const auto add = [&](std::optional<Warning> warning, std::string_view before = {}) {
    if (!warning) return;
    warning->path = path;
    warning->code.insert(0, before);
    warnings.push_back(std::move(*warning));
  };
  const double force = std::abs(result.load_case.axial_force);
  if (m.dynamic_capacity) add(beyond_life_formula(force, *m.dynamic_capacity));
  const std::optional<double>& solved = load_measures.solved_static_safety;
  if (solved) {
    const StaticRating rating{*solved * force, *load_measures.solved_static_safety_limit};
    add(beyond_static_rating(force, rating));
    if (load_measures.flank_edge_margin)
      add(flank_edge_near("an ellipse", *load_measures.flank_edge_margin * force, rating.force, force));
  } else if (const auto rating = equal_shares_static_rating(c, m)) {
    add(beyond_static_rating(force, *rating, "with equal thread loads, "));
  }
  for (const Interface i : kInterfaces)
    if (!solved && m.interface_flank_edge_load[i] && m.static_capacity)
      add(flank_edge_near(fmt::format("with equal thread loads, the {} ellipse", label(i)),
                          *m.interface_flank_edge_load[i], *m.static_capacity, force),
          fmt::format("{}_", name(i)));
  if (runs(c, result.load_case))
    for (const Interface i : kInterfaces)
      if (load_measures.largest_peak_pressure[i])
        add(running_pressure_warning(path, i, *load_measures.largest_peak_pressure[i], contacts));
  if (load_measures.thread_stiffness && result.axial_stiffness &&
      *load_measures.thread_stiffness < *result.axial_stiffness)
    warnings.push_back(
        Warning{"measures.loaded_width", "soft_threads",
                "the threads alone ({value}) come out softer than the whole screw of the model "
                "({limit}), which has no such teeth: Yamamoto's count twice what Hertz has",
                "leave out measures.loaded_width"}
            .with(*load_measures.thread_stiffness, *result.axial_stiffness, "N/µm"_unit, Warning::Worse::smaller));
  return warnings;
}

Measures measures_of(const Conditions& c, const Contacts& contacts) {
  Measures m;
  find_transmission(c, contacts, m);
  find_stiffness(c, contacts, m);
  find_dynamic_capacity(c, contacts, m);
  find_static_capacity(c, contacts, m);
  find_bodies(c, contacts, m);
  find_shaft(c, contacts, m);
  return m;
}

LoadMeasures load_measures_of(const Conditions& c, const Contacts& contacts, const Measures& measures,
                              const LoadCaseResult& result, Detail detail) {
  LoadMeasures m;
  const LoadCase& load_case = result.load_case;
  const double force = std::abs(load_case.axial_force), lead = contacts.mechanism.lead;
  if (!(force > 0.0)) return m;
  find_load_stiffness(c, contacts, measures, force, m);
  if (options_of(c).system && result.axial_stiffness) {
    MeasureOptions::System system = *options_of(c).system;
    if (c.bearings && c.bearings->fixed.stiffness) system.support_bearing = c.bearings->fixed.stiffness;
    m.system_stiffness =
        system_stiffness(*result.axial_stiffness, system,
                         {*contacts.mechanism.pitch_diameter.screw, c.structure->screw.bore}, c.materials->screw, lead);
  }
  if (detail == Detail::complete) find_yang_distribution(c, contacts, load_case, m);
  find_pressures(c, contacts, force, m);
  find_most_loaded(c, contacts, measures, result, m);
  if (const auto rating = equal_shares_static_rating(c, measures)) {
    m.static_safety = rating->force / force;
    m.static_safety_limit = rating->limit;
  }
  if (axial_force_on_nut(load_case) < 0.0) m.buckling_safety = product(measures.buckling_load, 1.0 / force);

  const std::optional<double> speed = speed_of(c, load_case);
  if (measures.dynamic_capacity) {
    m.life = rating_life(*measures.dynamic_capacity, force);
    m.life_travel = *m.life * std::abs(lead);
    if (speed && *speed > 0.0) m.life_hours = *m.life * 2.0 * std::numbers::pi / *speed / 3600.0;
  }
  if (measures.efficiency) m.drive_torque = drive_torque(force, lead, *measures.efficiency);
  if (detail == Detail::complete) m.back_driving_efficiency = prs::back_driving_efficiency(c, contacts, result);
  if (speed && *speed > 0.0) m.speed_safety = ratio(measures.critical_speed, speed);
  const std::optional<ModesResult> none;
  const std::optional<ModesResult>& modes = result.full ? result.full->modes : none;
  if (modes && !modes->modes.empty() && !c.structure->masses.empty()) {
    m.lowest_frequency = modes->modes.front().frequency;
    for (const MotionOrder& order : modes->orders)
      m.speeds_to_avoid.push_back(2.0 * std::numbers::pi * *m.lowest_frequency / order.order);
    std::ranges::sort(m.speeds_to_avoid);
  }
  return m;
}

MeasuresResult measured(const Conditions& c, Result analysis, Detail detail) {
  MeasuresResult result;
  result.analysis = std::move(analysis);
  const Contacts& contacts = result.analysis.contacts;
  result.measures = measures_of(c, contacts);
  if (detail == Detail::complete)
    for (Warning& note : unusual_measures(c, contacts, result.measures))
      result.analysis.warnings.push_back(std::move(note));
  StaticRatings ratings(c, contacts);
  for (LoadCaseResult& load_case : result.analysis.load_cases) {
    if (!load_case.converged()) {
      result.load_measures.push_back(std::nullopt);
      continue;
    }
    LoadMeasures& measures =
        *result.load_measures.emplace_back(load_measures_of(c, contacts, result.measures, load_case, detail));
    if (detail != Detail::complete) continue;
    ratings.rate(load_case.load_case, measures);
    for (Warning& note : unusual_load_measures(c, result.analysis.contacts, result.measures, measures, load_case))
      load_case.warnings.push_back(std::move(note));
  }
  return result;
}

MeasuresResult analyze_measures(const Conditions& c, Contacts found, AnalysisOptions options) {
  return measured(c,
                  c.load_cases.empty() ? analyze_contacts(c, std::move(found), options.detail)
                                       : analyze(c, std::move(found), options),
                  options.detail);
}

using std::numbers::pi;

namespace {

/// pi d mu/l: tangent of the friction angle over that of the lead angle.
double friction_over_lead(double lead, double diameter, double friction) {
  return pi * diameter * friction / std::abs(lead);
}

}  // namespace

double velocity_ratio(double lead) { return std::abs(lead) / (2.0 * pi); }

PlanetaryRatios planetary_ratios(Mechanism::Type type, double gear_ratio) {
  KinematicGeometry g;
  g.type = type;
  g.gear_ratio = gear_ratio;
  const double slip_ratio = slip_estimates(g).simple;
  // With the nut at rest the carrier turns by the slip ratio.
  return {kinematics(g, 1.0, slip_ratio).roller_to_carrier + slip_ratio, slip_ratio};
}

PlanetaryRatios ratios_to_frame(Mechanism::Type type, const PlanetaryRatios& nut_at_rest) {
  const auto of = [&](double against_nut) {
    return against_frame(carrier_part(type) == Part::nut, against_nut, 1.0) / turning_speed(type, 1.0);
  };
  return {of(nut_at_rest.roller), of(nut_at_rest.carrier)};
}

double efficiency(double lead, double diameter, double friction) {
  return 1.0 / (1.0 + friction_over_lead(lead, diameter, friction));
}

std::optional<double> back_driving_efficiency(double lead, double diameter, double friction) {
  const double efficiency = 1.0 - friction_over_lead(lead, diameter, friction);
  return efficiency > 0.0 ? std::optional(efficiency) : std::nullopt;
}

double drive_torque(double force, double lead, double efficiency) { return force * velocity_ratio(lead) / efficiency; }

double roller_inertia(int rollers, double mass, double inertia, double centre_distance,
                      const PlanetaryRatios& to_frame) {
  const double orbit = centre_distance * to_frame.carrier;
  return rollers * (inertia * to_frame.roller * to_frame.roller + mass * orbit * orbit);
}

double travel_inertia(double mass, double lead) {
  const double ratio = velocity_ratio(lead);
  return mass * ratio * ratio;
}

}  // namespace prs
