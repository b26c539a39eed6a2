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

template <class Number>
struct RollerHeadOf {
  Number guide_force{}, bearing_force{};
  contact::JournalBearingStateOf<Number> state{};
};

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
    const LoadedThreads::Contact& contact = threads.contacts[k];
    const auto& frame = roller.frames[i];
    const PatchForces<Number> at =
        contact.normal_load
            ? forces_of(frame, friction, turned_normal<Number, double>(frame, friction),
                        Number(*contact.normal_load), threads.alike)
            : patch_forces(frame, friction, contact.axial_load, threads.alike);
    possible =
        is_possible(at.normal_load) && value(at.on_roller.force.z) * frame.normal.z <= 0.0;
    sum.force.x += at.on_roller.force.x;
    sum.force.y += at.on_roller.force.y;
    sum.force.z += at.on_roller.force.z;
    sum.spin_torque += at.on_roller.spin_torque;
    take(k, friction, at);
  }
  return sum;
}

/// Forces and friction of the heads of one roller whose guides push it with these forces.
template <class Number>
std::array<RollerHeadOf<Number>, 2> heads_of(const SlipModel& model,
                                             const RollerNumbers<double>& roller,
                                             const RollerForcesOf<Number>& f, const Number& speed,
                                             const std::optional<std::array<double, 2>>& guides) {
  std::array<RollerHeadOf<Number>, 2> heads;
  for (std::size_t h = 0; h < 2; ++h) {
    RollerHeadOf<Number>& head = heads[h];
    head.guide_force = guides ? Number((*guides)[h]) : -0.5 * f.contacts_x;
    if (!guides || !model.guides.carry_centrifugal) head.guide_force -= 0.5 * f.centrifugal;
    head.bearing_force =
        simd::length(Number(head.guide_force - 0.5 * f.gears_x), Number(0.5 * f.carrier_y));
    if (model.bearing) head.state = head_state(roller.head, speed, head.bearing_force);
  }
  return heads;
}

/// Calls visit(heads) for each roller whose heads are known by themselves.
template <class Number, class Visit>
void for_each_roller(const SlipModel& model, const RollerNumbers<double>& roller,
                     const RollerForcesOf<Number>& f, const Number& speed, Visit visit) {
  if (model.guides.of_roller.empty()) visit(heads_of<Number>(model, roller, f, speed, {}));
  for (const auto& guides : model.guides.of_roller)
    visit(heads_of<Number>(model, roller, f, speed, guides));
}

/// See `balance_carrier`: the mean torque of all rollers.
template <class Number>
contact::JournalBearingStateOf<Number> both_heads(const SlipModel& model,
                                                  const RollerNumbers<double>& roller,
                                                  const RollerForcesOf<Number>& f,
                                                  const Number& speed) {
  if (model.guides.of_roller.empty()) return equal_heads(roller, f, speed);
  contact::JournalBearingStateOf<Number> mean{Number(0.0), Number(0.0)};
  for_each_roller(model, roller, f, speed, [&](const auto& heads) {
    for (const auto& head : heads) {
      if (mean.eccentricity_ratio < head.state.eccentricity_ratio)
        mean.eccentricity_ratio = head.state.eccentricity_ratio;
      mean.torque += head.state.torque / static_cast<double>(model.guides.of_roller.size());
    }
  });
  return mean;
}

template <class Number>
auto heads_in(const SlipModel& model) {
  return [&model](const RollerNumbers<double>& roller, const RollerForcesOf<Number>& f,
                  const Number& speed) { return both_heads(model, roller, f, speed); };
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
      }, heads_in<double>(model));
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
                     },
                     heads_in<Number>(model));
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
    const HeadFriction& friction = m.head_friction;
    HeadNumbers<double>& head = roller.head;
    head.bearing = {m.bearing->length, m.bearing->diameter, m.bearing->radial_clearance};
    head.has_oil = friction.model == HeadFriction::Model::coulomb ? 0.0 : 1.0;
    head.touches = friction.model == HeadFriction::Model::hydrodynamic ? 0.0 : 1.0;
    if (head.has_oil > 0.0) head.viscosity = m.oils.carrier->viscosity;
    head.friction_arm = 0.5 * friction.coefficient * m.bearing->diameter;
    head.roughness = friction.roughness;
    head.exponent = friction.exponent;
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

SlipEquilibrium find_slip_equilibrium(const SlipModel& model, const std::optional<double>& near) {
  const RollerNumbers<double> roller = numbers_of(model);
  SlipSearch search(slip_range(model.geometry), model.speed, model.imposed_slip_ratio,
                    near);
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
  if (near && found.status == SlipStatus::no_equilibrium) return find_slip_equilibrium(model);
  return found;
}

void set_heads(std::vector<std::array<RollerHead, 2>>& heads, const SlipModel& model,
               const SlipBalance& b) {
  const RollerForces& f = b.forces;
  heads.clear();
  for_each_roller(model, numbers_of(model),
                  RollerForcesOf<double>{f.contacts_x, f.contacts_y, f.gears_x, f.gears_y,
                                         f.carrier_x, f.carrier_y, f.centrifugal},
                  std::abs(b.motion.roller_to_carrier), [&](const auto& of_roller) {
                    auto& added = heads.emplace_back();
                    for (std::size_t h = 0; h < 2; ++h)
                      added[h] = {of_roller[h].guide_force, of_roller[h].bearing_force,
                                  of_roller[h].state.torque,
                                  of_roller[h].state.eccentricity_ratio};
                  });
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
