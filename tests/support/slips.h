#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include "prs/slip/slip.h"
#include "tests/support/plain_slip.h"

namespace test {

/// Sandu 2018, table 3.2, with equal shares; E* = 115.385 GPa is half his E' of 230.77 GPa.
inline prs::Case sandu_reference() {
  constexpr double degree = std::numbers::pi / 180.0;
  prs::Case c;
  prs::Mechanism& m = c.mechanism;
  m.type = prs::Mechanism::Type::standard;
  m.geometry = prs::Mechanism::Geometry::design;
  m.lead = 10e-3;
  m.starts = {5, 1};
  m.flank_angle = {45 * degree, 45 * degree, 45 * degree};
  m.pitch_diameter.screw = 30e-3;
  m.profile.roller = {prs::Profile::Shape::convex, 6e-3};
  m.rollers = 9;
  m.contacts_per_roller = 28;
  const prs::Material steel{210e9, 0.3, {}};
  c.materials = prs::Materials{steel, steel, steel};
  prs::LoadCase load;
  load.name = "reference";
  load.axial_force = 35e3;
  load.share = prs::LoadCase::Share::equal;
  c.load_cases = {load};
  c.lubricant.emplace();
  c.lubricant->viscosity = 0.1665;
  c.lubricant->pressure_viscosity = 30e-9;
  c.lubricant->eyring_stress = 12e6;
  c.friction.emplace();
  c.operation = prs::Operation{400 * std::numbers::pi / 30, {}};
  return c;
}

inline prs::Case with_coulomb(prs::Case c, double coefficient) {
  c.friction = prs::friction_by(contact::Coulomb{prs::at_both(coefficient)});
  return c;
}

inline prs::Case with_mixed_friction(prs::Case c, double boundary, double exponent) {
  c.friction = prs::friction_by(contact::Mixed{prs::at_both(boundary), prs::at_both(exponent)});
  if (!c.roughness) c.roughness = prs::PerPart<double>{0.3e-6, 0.4e-6, 0.2e-6};
  return c;
}

inline prs::Case reversed(prs::Case c) {
  for (prs::LoadCase& load : c.load_cases) load.axial_force = -load.axial_force;
  c.operation->speed = -c.operation->speed;
  return c;
}

inline prs::Case inverted(prs::Case c) {
  c.mechanism.type = prs::Mechanism::Type::inverted;
  return c;
}

/// A recirculating screw of 20 x 2 mm with one start, four of whose five rollers carry.
inline prs::Case recirculating() {
  prs::Case c = sandu_reference();
  prs::Mechanism& m = c.mechanism;
  m.type = prs::Mechanism::Type::recirculating;
  m.geometry = prs::Mechanism::Geometry::simulation;
  m.lead = 2e-3;
  m.starts = {1, 0};
  m.pitch_diameter = {20e-3, 16e-3, 52e-3};
  m.centre_distance = 18e-3;
  m.profile.roller = {prs::Profile::Shape::convex, 10e-3};
  m.rollers = 5;
  m.contacts_per_roller = 20;
  c.load_cases[0].axial_force = 20e3;
  return c;
}

/// The case with the load driving in place of the screw.
inline prs::Case turned_back(prs::Case c) {
  c.operation->speed = -c.operation->speed;
  return c;
}

inline prs::Case left_handed(prs::Case c) {
  c.mechanism.lead = -c.mechanism.lead;
  return c;
}

/// Cases around the reference: type, hand, sense, size, materials, load, speed, lubricant, torques and patch differ;
/// some impose the slip ratio.
inline prs::Case random_slip(std::mt19937_64& random) {
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  const auto log_uniform = [&](double a, double b) { return std::exp(uniform(std::log(a), std::log(b))); };
  const auto whole = [&](int a, int b) { return std::uniform_int_distribution<int>(a, b)(random); };

  prs::Case c = sandu_reference();
  prs::Mechanism& m = c.mechanism;
  if (whole(0, 1) == 1) m.type = prs::Mechanism::Type::inverted;
  m.starts.screw = whole(3, 6);
  m.pitch_diameter.screw = uniform(12e-3, 60e-3);
  const double pitch = *m.pitch_diameter.screw * uniform(0.03, 0.08);
  m.lead = pitch * m.starts.screw;
  const double flank = uniform(35.0, 55.0) * std::numbers::pi / 180.0;
  m.flank_angle = {flank, flank, flank};
  const bool standard = m.type == prs::Mechanism::Type::standard;
  const double roller_radius = 0.5 * *m.pitch_diameter.screw / (standard ? m.starts.screw - 2 : m.starts.screw);
  m.profile.roller.radius = roller_radius / std::sin(flank) * uniform(0.7, 1.3);
  m.backlash = {uniform(-0.02, 0.05) * pitch, uniform(-0.02, 0.05) * pitch};
  m.rollers = whole(1, standard && m.starts.screw == 3 ? 5 : 6);  // Roller as thick as the screw.
  m.contacts_per_roller = whole(2, 9);
  c.lubricant->viscosity = log_uniform(5e-3, 1.0);
  c.lubricant->pressure_viscosity = uniform(10e-9, 40e-9);
  c.lubricant->eyring_stress = uniform(2e6, 15e6);
  c.load_cases[0].axial_force =
      m.rollers * m.contacts_per_roller * log_uniform(20.0, 400.0) * std::pow(*m.pitch_diameter.screw / 30e-3, 2.0);
  c.operation->speed = log_uniform(0.5, 300.0);
  if (whole(0, 2) == 0) {
    // Scale: the torque for the load alone.
    const double torque = c.load_cases[0].axial_force * m.lead / (2.0 * std::numbers::pi);
    c.carrier.roller_torque = uniform(0.0, 0.002) * torque / m.rollers;
    c.carrier.screw_torque = uniform(0.0, 0.005) * torque;
    c.carrier.nut_torque = uniform(0.0, 0.005) * torque;
  }
  if (whole(0, 3) == 0) c = with_coulomb(c, uniform(0.01, 0.15));
  if (whole(0, 1) == 1) c = reversed(c);
  if (whole(0, 2) == 0) c = left_handed(c);
  if (whole(0, 1) == 1) c = turned_back(c);  // half of the cases of either hand are driven by their load
  c.materials->nut = {uniform(100e9, 210e9), uniform(0.25, 0.35), {}};
  if (whole(0, 1) == 1) c.materials->roller.density = uniform(4000.0, 8000.0);
  c.model.patch_points = whole(1, 30);
  return c;
}

/// Input of the plain calculation from a result: its contact points and ellipses, on the faces that touch, with loads
/// and all friction computed anew.
inline plain::Case plain_case(const prs::Case& c, const prs::Result& result, std::size_t k = 0) {
  const prs::LoadCaseResult& loaded = result.load_cases[k];
  plain::Case p;
  p.standard = c.mechanism.type == prs::Mechanism::Type::standard;
  p.lead = c.mechanism.lead;
  p.gear_ratio = static_cast<plain::Real>(c.mechanism.starts.roller) / c.mechanism.starts.screw;
  p.centre_distance = result.contacts.threads.centre_distance;
  p.rollers = c.mechanism.rollers;
  p.force_on_nut = axial_force_on_nut(loaded.load_case);
  p.speed = loaded.load_case.speed ? *loaded.load_case.speed : c.operation->speed;
  for (const prs::Interface i : prs::kInterfaces) {
    const prs::InterfaceContact& contact = result.contacts.interfaces[i];
    const contact::InterfaceGeometry g =
        p.force_on_nut > 0 ? contact.geometry : contact::on_other_faces(contact.geometry);
    const auto vec = [](const contact::Vector3<double>& v) { return plain::Vec{v.x, v.y, v.z}; };
    plain::Interface& side = i == prs::Interface::screw ? p.screw : p.nut;
    side.x = g.point.position.x;
    side.y = g.point.position.y;
    side.normal = vec(g.point.normal);
    side.major = vec(g.major_axis);
    side.larger_curvature = g.relative.second;
    side.curvature_ratio = g.relative.first / side.larger_curvature;
    side.relative_modulus = 2 * contact.contact_modulus;
    if (c.friction->kind == contact::kind_of<contact::Coulomb>) side.coulomb = c.friction->coefficient[i];
    if (c.roughness)
      side.roughness = std::hypot(static_cast<plain::Real>((*c.roughness)[prs::body_of(i)]),
                                  static_cast<plain::Real>(c.roughness->roller));
    for (const double load : (*loaded.threads)[i].axial_load) {
      const contact::HertzContact e = contact::at_load(contact.hertz, load / std::abs(g.point.normal.z));
      side.threads.push_back({load, e.semi_major, e.semi_minor, e.peak_pressure});
    }
  }
  if (c.lubricant)
    p.lubricant = {*c.lubricant->viscosity, *c.lubricant->pressure_viscosity, *c.lubricant->eyring_stress};
  if (c.lubricant) p.film_along_rolling = c.lubricant->film.direction == contact::FilmDirection::rolling;
  if (c.friction->kind == contact::kind_of<contact::Mixed>) p.boundary = c.friction->boundary.screw;
  p.exponent = c.friction->exponent.screw;
  p.carrier_roller_torque = c.carrier.roller_torque;
  p.carrier_screw_torque = c.carrier.screw_torque;
  p.carrier_nut_torque = c.carrier.nut_torque;
  p.gear_pressure_angle = c.carrier.gear_pressure_angle;
  if (const auto& density = c.materials->roller.density) {
    // A cylinder on the pitch diameter, as long as the thread; the cases here have no ends.
    const plain::Real radius = result.contacts.threads.roller.pitch_radius;
    p.roller_mass =
        *density * plain::pi * radius * radius * result.contacts.threads.roller.pitch * c.mechanism.contacts_per_roller;
  }
  p.patch_points = c.model.patch_points;
  return p;
}

}  // namespace test
