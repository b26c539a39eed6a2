#include "prs/slip/slip_equilibrium.h"

#include <cmath>
#include <numbers>

#include "prs/slip/slip_search.h"

namespace prs {
namespace {

using simd::Dual, simd::value;

double sign(double x) { return std::copysign(1.0, x); }

/// Forces of the patches of an interface; `take(k, friction, forces)` of each. Not possible where
/// one has no normal load.
template <class Number, class Take>
InterfaceForces<Number> interface_forces(const SlipModel& model, Interface i,
                                         const contact::PatchMotionOf<Number>& sliding,
                                         bool& possible, Take take) {
  const LoadedThreads& threads = model.threads[i];
  InterfaceForces<Number> sum;
  for (std::size_t k = 0; k < threads.patches.size() && possible; ++k) {
    const contact::PatchFrictionOf<Number> friction = threads.patches[k].friction(sliding);
    const PatchForces<Number> at =
        patch_forces(model.frames[i], friction, threads.contacts[k].axial_load, threads.alike);
    possible = is_possible(at.normal_load);
    sum.force = sum.force + at.on_roller.force;
    sum.spin_torque += at.on_roller.spin_torque;
    take(k, friction, at);
  }
  return sum;
}

/// R_z with its slope along the slip ratio; none where a contact jams.
std::optional<Dual<double>> residue_with_slope(const SlipModel& model, double slip_ratio) {
  using Number = Dual<double>;
  bool possible = true;
  const RollerBalanceOf<Number> found =
      roller_balance(model, Number(slip_ratio, 1.0),
                     [&](Interface i, const contact::PatchMotionOf<Number>& sliding) {
                       return interface_forces(model, i, sliding, possible,
                                               [](std::size_t, const auto&, const auto&) {});
                     });
  if (!possible) return std::nullopt;
  return found.moments.residue() / residue_unit(model);
}

}  // namespace

bool balance_at(const SlipModel& model, double slip_ratio, SlipBalance& b) {
  bool possible = true;
  b.RollerBalance::operator=(
      roller_balance(model, slip_ratio, [&](Interface i, const contact::PatchMotion& sliding) {
        PatchBalance& at = b.patches[i];
        const LoadedThreads& threads = model.threads[i];
        at.friction.resize(threads.patches.size());
        at.normal_load.resize(threads.patches.size());
        at.power = 0.0;
        return interface_forces(model, i, sliding, possible,
                                [&](std::size_t k, const contact::PatchFriction& friction,
                                    const PatchForces<double>& forces) {
                                  at.friction[k] = friction;
                                  at.normal_load[k] = forces.normal_load;
                                  at.power +=
                                      threads.alike * forces.normal_load * friction.power_per_load;
                                });
      }));
  return possible;
}

double residue_unit(const SlipModel& m) {
  return m.geometry.centre_distance * std::abs(m.axial_force) / m.rollers;
}

double relative_residue(const SlipModel& m, const SlipBalance& b) {
  return b.moments.residue() / residue_unit(m);
}

SlipEquilibrium find_slip_equilibrium(const SlipModel& model) {
  SlipSearch search(slip_range(model.geometry), model.speed, model.imposed_slip_ratio);
  SlipEquilibrium found;
  while (!search.done()) {
    if (search.wants_slope()) {
      if (const auto residue = residue_with_slope(model, search.slip_ratio()))
        search.take(residue->value, residue->slope);
      else
        search.jam();
    } else if (balance_at(model, search.slip_ratio(), found.balance)) {
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
    return moment_z(m.geometry.points[i], 0.0, b.interfaces[i].force) + b.interfaces[i].spin_torque;
  };
  const double c = m.geometry.centre_distance;
  const double roller_gear = roller_gear_radius(m.geometry);
  const double gear_arm = m.geometry.is_standard() ? c + roller_gear : c - roller_gear;
  const double gears = gear_arm * b.forces.gears_y;
  return {m.rollers * (about_axis(Interface::screw) + (m.geometry.is_standard() ? 0.0 : gears)) +
              sign(m.speed) * m.screw_torque,
          m.rollers * (about_axis(Interface::nut) + (m.geometry.is_standard() ? gears : 0.0)) -
              sign(m.speed) * m.nut_torque};
}

PowerBySource lost_power(const SlipModel& m, const SlipBalance& b) {
  return {m.rollers * b.patches.screw.power, m.rollers * b.patches.nut.power,
          m.rollers * std::abs(b.carrier_roller_torque * b.motion.roller_to_carrier),
          m.screw_torque * std::abs(b.motion.screw_to_carrier),
          m.nut_torque * std::abs(b.motion.nut_to_carrier)};
}

PowerFlow power_flow(const SlipModel& m, const DriveTorques& torques) {
  const double advance = -m.geometry.lead / (2.0 * std::numbers::pi) * m.speed;  // (2.5)
  return {(m.geometry.is_standard() ? torques.screw : torques.nut) *
              turning_speed(m.geometry.type, m.speed),
          m.axial_force * advance};
}

std::optional<double> PowerFlow::efficiency() const {
  if (load < 0.0 && shaft > 0.0) return -load / shaft;
  if (load > 0.0 && shaft < 0.0) return -shaft / load;
  return std::nullopt;
}

}  // namespace prs
