#include "prs/slip/slip_model.h"

#include <numeric>

#include "prs/indices.h"
#include "prs/loads/full_result.h"
#include "prs/loads/load_case_result.h"

namespace prs {
namespace {

/// The faces that a force closes; the sign of a force of 0 is that of its direction.
contact::InterfaceGeometry touching(const contact::InterfaceGeometry& i1_j2, double force) {
  return std::signbit(force) ? contact::on_other_faces(i1_j2) : i1_j2;
}

PerInterface<ContactFrameOf<double>> frames_of(const Contacts& contacts, double force) {
  PerInterface<ContactFrameOf<double>> frames;
  for (const Interface i : kInterfaces) {
    const contact::InterfaceGeometry g = touching(contacts.interfaces[i].geometry, force);
    frames[i] = {g.point.normal, g.major_axis, g.minor_axis};
  }
  return frames;
}

}  // namespace

KinematicGeometry kinematic_geometry(const Contacts& contacts, double force) {
  KinematicGeometry g;
  g.type = contacts.mechanism.type;
  g.lead = contacts.threads.screw.lead;
  g.gear_ratio = gear_ratio(contacts.mechanism);
  g.lead_excess = contacts.threads.nut.lead - contacts.threads.screw.lead;
  const contact::Thread& geared = thread_of(contacts.threads, carrier_part(g.type));
  const double roller_pitch = contact::is_grooved(g.type) ? 0.0 : contacts.threads.roller.pitch;
  g.migration_lead = std::copysign(1.0, g.lead) * contacts.mechanism.starts.screw * (roller_pitch - geared.pitch);
  g.centre_distance = contacts.threads.centre_distance;
  for (const Interface i : kInterfaces) g.points[i] = touching(contacts.interfaces[i].geometry, force).point.position;
  return g;
}

namespace {

/// Mass of a roller [kg], with heads as long as their bearings where its ends are not given; 0
/// without density.
double roller_mass(const Conditions& c, const Mechanism& m) {
  const std::optional<double>& density = c.materials->roller.density;
  if (!density) return 0.0;
  Structure::Roller roller;
  if (c.structure) {
    roller = c.structure->roller;
  } else if (c.carrier.bearing) {
    roller.end_diameter = c.carrier.bearing->diameter;
    roller.end_length = c.carrier.bearing->length;
  }
  return *density * roller_body(m, roller).volume;
}

/// Roller and body; none if conductivity, density or specific heat of one is not known.
std::optional<std::array<contact::HeatedBody, 2>> heated_bodies(const Materials& materials, Part body) {
  std::array<contact::HeatedBody, 2> bodies;
  const Part parts[] = {Part::roller, body};
  for (const auto k : up_to(2)) {
    const Material& m = materials[parts[k]];
    if (!m.conductivity || !m.density || !m.specific_heat) return std::nullopt;
    bodies[k] = {*m.conductivity, *m.density, *m.specific_heat};
  }
  return bodies;
}

/// A patch under a normal load, by default that of its static axial one.
LoadedThreads::Contact contact_of(const SlipModel& model, const InterfaceContact& contact, Interface i,
                                  double axial_load, const std::optional<double>& known = {}) {
  const double normal_load = known.value_or(axial_load / std::abs(model.frames[i].normal.z));
  const contact::PrincipalValues& relative = contact.geometry.relative;
  contact::FrictionLaw law = model.friction.at(i);
  law.oil = model.oils.threads[i].value_or(contact::Lubricant{});
  law.film = {.normal_load = normal_load,
              .curvature = relative.second,
              .contact_modulus = contact.contact_modulus,
              .curvature_ratio = relative.first / relative.second,
              .direction = model.film_direction,
              .thinning = model.film_thinning};
  law.roughness = model.roughness[i].value_or(0.0);
  return {axial_load, std::nullopt, false, contact::at_load(contact.hertz, normal_load), law};
}

}  // namespace

std::shared_ptr<const contact::PatchGrid> grid_of(int points) {
  thread_local std::pair<int, std::shared_ptr<const contact::PatchGrid>> last;
  if (last.first != points) last = {points, std::make_shared<const contact::PatchGrid>(points)};
  return last.second;
}

Oils oils_in_operation(const Conditions& c) {
  if (!c.lubricant || !has_operating_point(*c.lubricant)) return {};
  const contact::Lubricant oil = in_operation(*c.lubricant);
  return {{oil, oil}, oil};
}

Oils oils_at(const Lubricant& lubricant, const PerInterface<double>& temperature) {
  return {{at_temperature(lubricant, temperature.screw), at_temperature(lubricant, temperature.nut)},
          at_temperature(lubricant, 0.5 * (temperature.screw + temperature.nut))};
}

Oils oils_of(const Conditions& c, const LoadCaseResult& loaded) {
  return c.lubricant && loaded.heat && loaded.heat->oil ? oils_at(*c.lubricant, *loaded.heat->oil)
                                                        : oils_in_operation(c);
}

std::optional<double> composite_roughness(const Conditions& c, Interface i) {
  if (!c.roughness) return std::nullopt;
  return std::hypot((*c.roughness)[body_of(i)], c.roughness->roller);
}

SlipModels::SlipModels(const Conditions& c, const Contacts& contacts, std::optional<Oils> oils)
    : conditions_(c),
      contacts_(contacts),
      grid_(grid_of(c.model.patch_points)),
      oils_(oils ? std::move(*oils) : oils_in_operation(c)) {}

void set_conditions(SlipModel& m, const Conditions& c, const Mechanism& mechanism, const LoadCase& load_case,
                    const Oils& oils) {
  m.axial_force = axial_force_on_nut(load_case);
  m.speed = screw_speed(c, load_case);
  m.rollers = loaded_rollers(mechanism);
  if (c.model.all_rollers() && load_case.share == LoadCase::Share::solved)
    m.rollers -= static_cast<int>(c.deviations.missing_rollers.size());
  m.screw_torque = c.carrier.screw_torque;
  m.nut_torque = c.carrier.nut_torque;
  m.roller_torque = c.carrier.roller_torque;
  m.bearing = c.carrier.bearing.value_or(HeadBearing{});
  m.head_friction = {};
  m.oils = oils;
  m.bearing_viscosity = 0.0;
  if (const auto& bearing = c.carrier.bearing) {
    const HeadFriction& f = bearing->friction;
    if (c.carrier.is_oiled()) m.bearing_viscosity = oils.carrier->viscosity;
    if (f.model == HeadFriction::Model::coulomb) m.head_friction = {1.0, 0.5 * f.coefficient * bearing->diameter};
    if (f.model == HeadFriction::Model::mixed)
      m.head_friction = {1.0, 0.5 * f.mixed.boundary * bearing->diameter, f.mixed.roughness, f.mixed.exponent};
  }
  m.gear_tangent = contact::is_grooved(mechanism.type) ? 0.0 : std::tan(c.carrier.gear_pressure_angle);
  m.roller_mass = roller_mass(c, mechanism);
  m.friction = *c.friction;
  m.film_direction = c.lubricant ? c.lubricant->film.direction : contact::FilmDirection::minor_axis;
  if (c.lubricant) {
    const Lubricant::Film& film = c.lubricant->film;
    m.film_thinning = {film.starvation.value_or(1.0), film.inlet_heating ? film.inlet_heating->conductivity : 0.0};
  }
  for (const Interface i : kInterfaces) m.heated[i] = heated_bodies(*c.materials, body_of(i));
  m.wear = c.wear;
  for (const Interface i : kInterfaces) m.roughness[i] = composite_roughness(c, i);
  m.imposed_slip_ratio = c.operation ? c.operation->slip_ratio : std::nullopt;
}

void set_geometry(SlipModel& m, const Contacts& contacts) {
  m.geometry = kinematic_geometry(contacts, m.axial_force);
  m.frames = frames_of(contacts, m.axial_force);
  const contact::Thread& geared = thread_of(contacts.threads, carrier_part(contacts.mechanism.type));
  m.pitch_excess = std::abs(contacts.threads.roller.pitch_radius / m.geometry.gear_ratio - geared.pitch_radius);
  if (m.pitch_excess <= contact::kSamePitch * geared.pitch_radius) m.pitch_excess = 0.0;
}

void set_equal_contacts(SlipModel& m, const Contacts& contacts) {
  const int alike = contacts.mechanism.contacts_per_roller;
  for (const Interface i : kInterfaces) {
    m.threads[i].alike = alike;
    m.threads[i].patch_of_thread.assign(static_cast<std::size_t>(alike), 0);
    m.threads[i].contacts.assign(1,
                                 contact_of(m, contacts.interfaces[i], i, std::abs(m.axial_force) / m.rollers / alike));
  }
}

SlipModel SlipModels::of(const LoadCaseResult& loaded) const {
  if (loaded.load_case.share == LoadCase::Share::equal) return equal_shares(loaded.load_case);

  SlipModel model = unloaded(loaded.load_case);
  const auto flank = static_cast<std::size_t>(contacts_.mechanism.contacts_per_roller);
  if (loaded.other_flank)
    model.other_flank = {kinematic_geometry(contacts_, -model.axial_force), frames_of(contacts_, -model.axial_force)};
  for (const Interface i : kInterfaces) {
    LoadedThreads& threads = model.threads[i];
    const int row = (*loaded.threads)[i].threads_per_roller;
    threads.threads_per_roller = row;
    if (row > 0) threads.alike = 1.0 / model.rollers;
    const auto add = [&](const std::vector<double>& axial, const std::vector<double>& normal) {
      for (const auto k : indices(normal)) {
        const bool other = loaded.other_flank && threads.patch_of_thread.size() >= flank;
        threads.patch_of_thread.push_back(std::nullopt);
        if (normal[k] <= 0.0) continue;
        threads.patch_of_thread.back() = threads.contacts.size();
        const InterfaceContact& contact = contacts_.interfaces[i];
        LoadedThreads::Contact& added = threads.contacts.emplace_back(
            contact_of(model, contact, i, axial[k], loaded.running ? std::optional(normal[k]) : std::nullopt));
        added.other_flank = other;
        // Sector and geometry agree on the normal unless the file states its angle.
        if (loaded.running && !conditions_.contact.normal_angle[i]) added.normal_load = normal[k];
        if (loaded.other_flank && i == Interface::screw)
          model.carried = model.carried.value_or(0.0) + model.rollers * axial[k];
      }
    };
    add((*loaded.threads)[i].axial_load, (*loaded.threads)[i].normal_load);
    if (loaded.other_flank) add(loaded.other_flank->threads[i].axial_load, loaded.other_flank->threads[i].normal_load);
  }
  model.guides = guides_of(loaded);
  add_patches(model);
  return model;
}

GuideForces SlipModels::guides_of(const LoadCaseResult& loaded) const {
  GuideForces guides;
  const bool full = loaded.full != nullptr;
  if (full) guides.missing = conditions_.deviations.missing_rollers;
  if (loaded.running) {
    guides.of_roller = loaded.running->guide_force;
    guides.carry_centrifugal = true;
  } else if (loaded.other_flank) {
    guides.of_roller = loaded.other_flank->guide_force;
  } else if (conditions_.model.roller == ModelOptions::Roller::rigid_bending) {
    return guides;
  } else if (full) {
    for (int r = 0; r < contacts_.mechanism.rollers; ++r)
      if (!contains(guides.missing, r + 1))
        guides.of_roller.push_back(
            {item_at(loaded.full->rings[0].rollers, r), item_at(loaded.full->rings[1].rollers, r)});
  } else if (!loaded.guides.empty()) {
    guides.of_roller.push_back(loaded.guides.front().of_ends());
  } else {
    std::optional<RollerGuides>& known = roller_guides_[*loaded.load_case.direction];
    if (!known)
      known.emplace(build_sector(contacts_.mechanism, *conditions_.structure, *conditions_.materials, conditions_.model,
                                 contact_laws(conditions_, contacts_), *loaded.load_case.direction,
                                 *loaded.load_case.position, conditions_.deviations));
    const std::vector<double> none(loaded.threads->screw.normal_load.size(), 0.0);
    guides.of_roller.push_back(known->forces({loaded.threads->screw.normal_load, loaded.threads->nut.normal_load},
                                             {{none, none}, {none, none}}));
  }
  return guides;
}

std::vector<SlipModel> SlipModels::of_nuts(const LoadCaseResult& loaded) const {
  std::vector<SlipModel> models;
  if (!loaded.other_flank || !loaded.other_flank->of_second_roller) {
    models.push_back(of(loaded));
    return models;
  }
  const auto threads = static_cast<std::ptrdiff_t>(contacts_.mechanism.contacts_per_roller);
  const Direction named = *loaded.load_case.direction;
  for (const Direction d : {Direction::compression, Direction::tension}) {
    const std::ptrdiff_t row = d == named ? 0 : 1;
    LoadCaseResult nut;
    nut.load_case = loaded.load_case;
    nut.load_case.direction = d;
    nut.threads.emplace();
    for (const Interface i : kInterfaces) {
      const FlankThreads& other = loaded.other_flank->threads[i];
      const auto part = [&](const std::vector<double>& first, const std::vector<double>& second) {
        std::vector<double> all = first;
        append(all, second);
        return std::vector<double>(all.begin() + row * threads, all.begin() + (row + 1) * threads);
      };
      const InterfaceLoads& loads = (*loaded.threads)[i];
      (*nut.threads)[i].normal_load = part(loads.normal_load, other.normal_load);
      (*nut.threads)[i].axial_load = part(loads.axial_load, other.axial_load);
    }
    const std::vector<double>& axial = nut.threads->screw.axial_load;
    nut.load_case.axial_force = loaded_rollers(contacts_.mechanism) * std::accumulate(axial.begin(), axial.end(), 0.0);
    const auto guide = static_cast<std::size_t>(row);
    if (loaded.running) {
      nut.running.emplace();
      if (loaded.running->guide_force.size() > guide) nut.running->guide_force = {loaded.running->guide_force[guide]};
    } else {
      nut.other_flank.emplace();
      if (loaded.other_flank->guide_force.size() > guide)
        nut.other_flank->guide_force = {loaded.other_flank->guide_force[guide]};
    }
    models.push_back(of(nut));
  }
  return models;
}

SlipModel SlipModels::of_nut_that_carries(const LoadCaseResult& loaded) const {
  std::vector<SlipModel> nuts = of_nuts(loaded);
  return std::move(nuts[nuts.size() == 2 && *loaded.load_case.direction == Direction::tension ? 1 : 0]);
}

SlipModel SlipModels::equal_shares(const LoadCase& load_case, const Oils* oils) const {
  SlipModel model = unloaded(load_case, oils);
  set_equal_contacts(model, contacts_);
  add_patches(model);
  return model;
}

SlipModel SlipModels::unloaded(const LoadCase& load_case, const Oils* oils) const {
  SlipModel m;
  set_conditions(m, conditions_, contacts_.mechanism, load_case, oils ? *oils : oils_);
  set_geometry(m, contacts_);
  return m;
}

void SlipModels::add_patches(SlipModel& model) const {
  for (const Interface i : kInterfaces)
    for (const LoadedThreads::Contact& c : model.threads[i].contacts)
      model.threads[i].patches.emplace_back(*grid_, c.ellipse, c.friction);
}

}  // namespace prs
