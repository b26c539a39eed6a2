#include "prs/slip/slip_model.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace prs {
namespace {

contact::InterfaceGeometry touching(const contact::InterfaceGeometry& i1_j2, double force) {
  return force > 0.0 ? i1_j2 : contact::on_other_faces(i1_j2);
}

KinematicGeometry kinematic_geometry(const Contacts& contacts, double force) {
  KinematicGeometry g;
  g.type = contacts.mechanism.type;
  g.lead = contacts.threads.screw.lead;
  g.gear_ratio = contact::kinematic_consistency(contacts.threads).gear_ratio_by_leads;
  g.centre_distance = contacts.threads.centre_distance;
  for (const Interface i : kInterfaces)
    g.points[i].head<2>() = touching(contacts.interfaces[i].geometry, force).point.position;
  return g;
}

/// Mass of a roller as cylinders: thread at its pitch diameter and both ends [kg]; 0 without
/// density.
double roller_mass(const Conditions& c, const Mechanism& m) {
  const std::optional<double>& density = c.materials->roller.density;
  if (!density) return 0.0;
  const auto cylinder = [](double diameter, double length) {
    return 0.25 * std::numbers::pi * diameter * diameter * length;
  };
  double volume = cylinder(*m.pitch_diameter.roller, m.contacts_per_roller * axial_pitch(m));
  if (c.structure)
    volume += 2.0 * cylinder(c.structure->roller.end_diameter, c.structure->roller.end_length);
  else if (c.carrier.bearing)
    volume += 2.0 * cylinder(c.carrier.bearing->diameter, c.carrier.bearing->length);
  return *density * volume;
}

/// The grid of a thread's last design is kept: all designs of a study have it, as a rule.
std::shared_ptr<const contact::PatchGrid> grid_of(int points) {
  thread_local std::pair<int, std::shared_ptr<const contact::PatchGrid>> last;
  if (last.first != points) last = {points, std::make_shared<const contact::PatchGrid>(points)};
  return last.second;
}

}  // namespace

Oils oils_in_operation(const Conditions& c) {
  if (!c.lubricant || !has_operating_point(*c.lubricant)) return {};
  const contact::Lubricant oil = in_operation(*c.lubricant);
  return {{oil, oil}, oil};
}

Oils oils_at(const Lubricant& lubricant, const PerInterface<double>& temperature) {
  return {
      {at_temperature(lubricant, temperature.screw), at_temperature(lubricant, temperature.nut)},
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

SlipModels::SlipModels(const Conditions& c, const Contacts& contacts)
    : SlipModels(c, contacts, oils_in_operation(c)) {}

SlipModels::SlipModels(const Conditions& c, const Contacts& contacts, Oils oils)
    : conditions_(c),
      contacts_(contacts),
      grid_(grid_of(c.model.patch_points)),
      oils_(std::move(oils)) {}

SlipModel SlipModels::of(const LoadCaseResult& loaded, const Oils& oils) const {
  if (loaded.load_case.share == LoadCase::Share::equal) return equal_shares(loaded.load_case, oils);
  SlipModel model = unloaded(loaded.load_case, oils);
  for (const Interface i : kInterfaces) {
    const int row = (*loaded.threads)[i].threads_per_roller;
    model.threads[i].threads_per_roller = row;
    if (row > 0) model.threads[i].alike = 1.0 / model.rollers;
    for (const double load : (*loaded.threads)[i].axial_load) {
      std::vector<std::optional<std::size_t>>& patch_of = model.threads[i].patch_of_thread;
      patch_of.push_back(std::nullopt);
      if (load <= 0.0) continue;
      patch_of.back() = model.threads[i].patches.size();
      add_patch(model, i, load);
    }
  }
  return model;
}

SlipModel SlipModels::equal_shares(const LoadCase& load_case, const Oils& oils) const {
  SlipModel model = unloaded(load_case, oils);
  const int alike = contacts_.mechanism.contacts_per_roller;
  for (const Interface i : kInterfaces) {
    model.threads[i].alike = alike;
    model.threads[i].patch_of_thread.assign(static_cast<std::size_t>(alike), 0);
    add_patch(model, i, std::abs(load_case.axial_force) / model.rollers / alike);
  }
  return model;
}

SlipModel SlipModels::unloaded(const LoadCase& load_case, const Oils& oils) const {
  SlipModel m;
  m.axial_force = axial_force_on_nut(load_case);
  m.speed = load_case.speed ? *load_case.speed : conditions_.operation->speed;
  m.geometry = kinematic_geometry(contacts_, m.axial_force);
  m.rollers = contacts_.mechanism.rollers;
  if (conditions_.model.mechanism == ModelOptions::Mechanism::full &&
      load_case.share == LoadCase::Share::solved)
    m.rollers -= static_cast<int>(conditions_.deviations.missing_rollers.size());
  for (const Interface i : kInterfaces) {
    const contact::InterfaceGeometry g = touching(contacts_.interfaces[i].geometry, m.axial_force);
    m.threads[i].normal = g.point.normal;
    m.threads[i].major_axis = g.major_axis;
    m.threads[i].minor_axis = g.minor_axis;
  }
  m.screw_torque = conditions_.carrier.screw_torque;
  m.nut_torque = conditions_.carrier.nut_torque;
  m.roller_torque = conditions_.carrier.roller_torque;
  m.bearing = conditions_.carrier.bearing;
  m.oils = oils;
  m.gear_pressure_angle = conditions_.carrier.gear_pressure_angle;
  m.roller_mass = roller_mass(conditions_, contacts_.mechanism);
  return m;
}

void SlipModels::add_patch(SlipModel& model, Interface i, double axial_load) const {
  const InterfaceContact& contact = contacts_.interfaces[i];
  LoadedThreads& threads = model.threads[i];
  const double static_load = axial_load / std::abs(threads.normal.z());
  const contact::HertzContact ellipse = contact::at_load(contact.hertz, static_load);
  const contact::PrincipalValues& relative = contact.geometry.relative;
  threads.axial_load.push_back(axial_load);
  threads.films.push_back({.normal_load = static_load,
                           .curvature = relative.second,
                           .contact_modulus = contact.contact_modulus,
                           .curvature_ratio = relative.first / relative.second});
  const Friction& friction = *conditions_.friction;
  const contact::FilmContact& film = threads.films.back();
  switch (friction.model) {
    case Friction::Model::coulomb:
      threads.patches.emplace_back(*grid_, ellipse, friction.coefficient);
      break;
    case Friction::Model::jacod:
      threads.patches.emplace_back(*grid_, ellipse, *model.oils.threads[i], film);
      break;
    case Friction::Model::mixed:
      threads.patches.emplace_back(
          *grid_, ellipse, *model.oils.threads[i], film,
          contact::TouchingFlanks{friction.mixed.boundary, friction.mixed.exponent,
                                  *composite_roughness(conditions_, i)});
  }
}

}  // namespace prs
