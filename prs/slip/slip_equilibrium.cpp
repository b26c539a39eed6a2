#include "prs/slip/slip_equilibrium.h"

#include <cmath>
#include <numbers>

#include "prs/slip/slip_search.h"

namespace prs {
namespace {

using Eigen::Vector3d;
using simd::Dual, simd::value;

double sign(double x) { return std::copysign(1.0, x); }
bool standard(const SlipModel& m) { return m.geometry.type == Mechanism::Type::standard; }

Vector3d vector(const contact::Vector3<double>& v) { return {v.x, v.y, v.z}; }
contact::Vector3<double> numbers(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }
contact::Vector2<double> in_plane(const Vector3d& point) { return {point.x(), point.y()}; }

/// Forces of the patches of an interface; `take(k, friction, forces)` of each. Not possible where
/// one has no normal load.
template <class Number, class Take>
InterfaceForces<Number> interface_forces(const RollerNumbers<double>& roller,
                                         const LoadedThreads& threads, Interface i,
                                         const contact::PatchMotionOf<Number>& sliding,
                                         bool& possible, Take take) {
  InterfaceForces<Number> sum;
  for (std::size_t k = 0; k < threads.patches.size() && possible; ++k) {
    const contact::PatchFrictionOf<Number> friction = threads.patches[k].friction(sliding);
    const PatchForces<Number> at =
        patch_forces(roller.frames[i], friction, threads.contacts[k].axial_load, threads.alike);
    possible = is_possible(at.normal_load);
    sum.force.x += at.on_roller.force.x;
    sum.force.y += at.on_roller.force.y;
    sum.force.z += at.on_roller.force.z;
    sum.spin_torque += at.on_roller.spin_torque;
    take(k, friction, at);
  }
  return sum;
}

bool balance_roller(const RollerNumbers<double>& roller, const SlipModel& model, double slip_ratio,
                    SlipBalance& b) {
  bool possible = true;
  const RollerBalanceOf<double> found =
      roller_balance(roller, slip_ratio, [&](Interface i, const contact::PatchMotion& sliding) {
        InterfaceBalance& at = b.interfaces[i];
        const LoadedThreads& threads = model.threads[i];
        at.friction.resize(threads.patches.size());
        at.normal_load.resize(threads.patches.size());
        at.power = 0.0;
        return interface_forces(roller, threads, i, sliding, possible,
                                [&](std::size_t k, const contact::PatchFriction& friction,
                                    const PatchForces<double>& forces) {
                                  at.friction[k] = friction;
                                  at.normal_load[k] = forces.normal_load;
                                  at.power +=
                                      threads.alike * forces.normal_load * friction.power_per_load;
                                });
      });
  set_roller(b, found);
  return possible;
}

/// R_z with its slope along the slip ratio; none where a contact jams.
std::optional<Dual<double>> residue_with_slope(const RollerNumbers<double>& roller,
                                               const SlipModel& model, double slip_ratio) {
  using Number = Dual<double>;
  bool possible = true;
  const RollerBalanceOf<Number> found =
      roller_balance(roller, Number(slip_ratio, 1.0),
                     [&](Interface i, const contact::PatchMotionOf<Number>& sliding) {
                       return interface_forces(roller, model.threads[i], i, sliding, possible,
                                               [](std::size_t, const auto&, const auto&) {});
                     });
  if (!possible) return std::nullopt;
  return found.moments.residue() / residue_unit(model);
}

}  // namespace

RollerNumbers<double> numbers_of(const SlipModel& m) {
  const KinematicGeometry& g = m.geometry;
  RollerNumbers<double> roller;
  roller.geometry = {standard(m) ? 1.0 : 0.0,
                     g.lead,
                     g.gear_ratio,
                     g.centre_distance,
                     {in_plane(g.points.screw), in_plane(g.points.nut)}};
  for (const Interface i : kInterfaces)
    roller.frames[i] = {numbers(m.threads[i].normal), numbers(m.threads[i].major_axis),
                        numbers(m.threads[i].minor_axis)};
  roller.speed = m.speed;
  roller.rollers = m.rollers;
  roller.screw_torque = m.screw_torque;
  roller.nut_torque = m.nut_torque;
  roller.roller_torque = m.roller_torque;
  if (m.bearing) {
    roller.has_bearing = 1.0;
    roller.bearing = {m.bearing->length, m.bearing->diameter, m.bearing->radial_clearance};
    roller.bearing_viscosity = m.oils.carrier->viscosity;
  }
  roller.gear_tangent = std::tan(m.gear_pressure_angle);
  roller.roller_mass = m.roller_mass;
  return roller;
}

void set_roller(SlipBalance& b, const RollerBalanceOf<double>& roller) {
  const KinematicsOf<double>& k = roller.motion;
  b.motion = {k.slip_ratio,     k.screw_to_carrier, k.roller_to_carrier,
              k.nut_to_carrier, k.screw_advance,    k.nut_advance};
  for (const Interface i : kInterfaces) {
    b.interfaces[i].motion = roller.sliding[i];
    b.interfaces[i].force = vector(roller.interfaces[i].force);
    b.interfaces[i].spin_torque = roller.interfaces[i].spin_torque;
  }
  const RollerForcesOf<double>& f = roller.forces;
  b.forces = {f.contacts_x, f.contacts_y, f.gears_x,    f.gears_y,
              f.carrier_x,  f.carrier_y,  f.centrifugal};
  const RollerMomentsOf<double>& m = roller.moments;
  b.moments = {m.contacts, m.spin, m.carrier, m.gears};
  b.bearing = {roller.bearing.eccentricity_ratio, roller.bearing.torque};
  b.carrier_roller_torque = roller.carrier_roller_torque;
}

bool balance_at(const SlipModel& model, double slip_ratio, SlipBalance& b) {
  return balance_roller(numbers_of(model), model, slip_ratio, b);
}

double residue_unit(const SlipModel& m) {
  return m.geometry.centre_distance * std::abs(m.axial_force) / m.rollers;
}

double relative_residue(const SlipModel& m, const SlipBalance& b) {
  return b.moments.residue() / residue_unit(m);
}

SlipEquilibrium find_slip_equilibrium(const SlipModel& model) {
  const RollerNumbers<double> roller = numbers_of(model);
  SlipSearch search(slip_range(model.geometry), model.speed, model.imposed_slip_ratio);
  SlipEquilibrium found;
  while (!search.done()) {
    if (search.wants_slope()) {
      if (const auto residue = residue_with_slope(roller, model, search.slip_ratio()))
        search.take(residue->value, residue->slope);
      else
        search.jam();
    } else if (balance_roller(roller, model, search.slip_ratio(), found.balance)) {
      search.take(relative_residue(model, found.balance), 0.0);
    } else {
      search.jam();
    }
  }
  found.status = search.status();
  found.evaluations = search.evaluations();
  return found;
}

DriveTorques drive_torques(const SlipModel& m, const SlipBalance& b) {
  // What acts on a roller, taken about the screw's axis, acts back on screw and nut.
  const auto about_axis = [&](Interface i) {
    return moment_z(in_plane(m.geometry.points[i]), 0.0, numbers(b.interfaces[i].force)) +
           b.interfaces[i].spin_torque;
  };
  const double c = m.geometry.centre_distance;
  const double roller_gear = roller_gear_radius(numbers_of(m).geometry);
  const double gear_arm = standard(m) ? c + roller_gear : c - roller_gear;
  const double gears = gear_arm * b.forces.gears_y;
  return {m.rollers * (about_axis(Interface::screw) + (standard(m) ? 0.0 : gears)) +
              sign(m.speed) * m.screw_torque,
          m.rollers * (about_axis(Interface::nut) + (standard(m) ? gears : 0.0)) -
              sign(m.speed) * m.nut_torque};
}

PowerBySource lost_power(const SlipModel& m, const SlipBalance& b) {
  return {m.rollers * b.interfaces.screw.power, m.rollers * b.interfaces.nut.power,
          m.rollers * std::abs(b.carrier_roller_torque * b.motion.roller_to_carrier),
          m.screw_torque * std::abs(b.motion.screw_to_carrier),
          m.nut_torque * std::abs(b.motion.nut_to_carrier)};
}

PowerFlow power_flow(const SlipModel& m, const DriveTorques& torques) {
  const double advance = -m.geometry.lead / (2.0 * std::numbers::pi) * m.speed;  // (2.5)
  return {(standard(m) ? torques.screw : torques.nut) * turning_speed(m.geometry.type, m.speed),
          m.axial_force * advance};
}

std::optional<double> PowerFlow::efficiency() const {
  if (load < 0.0 && shaft > 0.0) return -load / shaft;
  if (load > 0.0 && shaft < 0.0) return -shaft / load;
  return std::nullopt;
}

}  // namespace prs
