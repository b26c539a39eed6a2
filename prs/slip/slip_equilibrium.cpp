#include "prs/slip/slip_equilibrium.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <numbers>

namespace prs {
namespace {

using Eigen::Vector3d;

/// Tolerance of the slip ratio.
constexpr double kSlipTolerance = 1e-14;
constexpr int kMostEvaluations = 100;

/// Sliding below this share of the rolling speed is the rounding of a contact without slip.
constexpr double kNoSlip = 1e-12;

/// Moments below this share of c |F_N|/N_R are rounding.
constexpr double kNoMoment = 1e-15;

double sign(double x) { return std::copysign(1.0, x); }
bool standard(const SlipModel& m) { return m.geometry.type == Mechanism::Type::standard; }

/// Moment of a force about an axis along z through `axis_x` on the x axis.
double moment_z(const Vector3d& point, double axis_x, const Vector3d& force) {
  return (point.x() - axis_x) * force.y() - point.y() * force.x();
}

/// Operating pitch radius of the roller's gear [m].
double roller_gear_radius(const SlipModel& m) {
  const double gamma = m.geometry.gear_ratio;
  return m.geometry.centre_distance * gamma / (standard(m) ? 1.0 - gamma : 1.0 + gamma);
}

contact::PatchMotion patch_motion(const LoadedThreads& threads, const ContactMotion& motion) {
  const double u_n = motion.rolling.dot(threads.normal);
  const bool slides = motion.sliding.norm() > kNoSlip * motion.rolling.norm();
  const Vector3d sliding = slides ? motion.sliding : Vector3d::Zero();
  return {sliding.dot(threads.major_axis), sliding.dot(threads.minor_axis),
          motion.spin * threads.normal.z(),
          std::sqrt(std::max(motion.rolling.squaredNorm() - u_n * u_n, 0.0))};
}

bool balance_interface(const SlipModel& model, const Kinematics& motion, Interface i,
                       InterfaceBalance& b) {
  const LoadedThreads& threads = model.threads[i];
  b.motion = patch_motion(threads, contact_motion(model.geometry, motion, i));
  b.friction.resize(threads.patches.size());
  b.normal_load.resize(threads.patches.size());
  b.force.setZero();
  b.spin_torque = b.power = 0.0;
  const double alike = threads.alike;
  for (std::size_t k = 0; k < threads.patches.size(); ++k) {
    const contact::PatchFriction& f = b.friction[k] = threads.patches[k].friction(b.motion);
    // m = n - T/N (3.5)
    const Vector3d m = threads.normal - f.traction_major * threads.major_axis -
                       f.traction_minor * threads.minor_axis;
    const double normal_load = threads.axial_load[k] / (m.z() * sign(threads.normal.z()));
    if (!(normal_load >= 0.0 && std::isfinite(normal_load))) return false;
    b.normal_load[k] = normal_load;
    b.force -= alike * normal_load * m;
    b.spin_torque += alike * normal_load * f.spin_arm * threads.normal.z();
    b.power += alike * normal_load * f.power_per_load;
  }
  return true;
}

/// Gears and carrier for a torque of the carrier on the roller, signed [N m].
RollerForces forces_with(const SlipModel& model, const SlipBalance& b, double roller_torque) {
  const Vector3d contacts = b.interfaces.screw.force + b.interfaces.nut.force;
  const double c = model.geometry.centre_distance;
  const double orbit_speed = b.motion.slip_ratio * model.speed;  // omega_p/n
  RollerForces f;
  f.contacts_x = contacts.x();
  f.contacts_y = contacts.y();
  f.centrifugal = model.roller_mass * c * orbit_speed * orbit_speed;
  const double carrier_torque = sign(model.speed) * (model.nut_torque - model.screw_torque);
  f.carrier_y = (model.rollers * roller_torque + carrier_torque) / (c * model.rollers);
  f.gears_y = f.carrier_y - f.contacts_y;
  f.gears_x =
      (standard(model) ? -1.0 : 1.0) * std::abs(f.gears_y) * std::tan(model.gear_pressure_angle);
  f.carrier_x = f.gears_x + f.contacts_x + f.centrifugal;
  return f;
}

/// The bearing's torque depends on its load and, a little, its load on the torque.
void balance_carrier(const SlipModel& model, SlipBalance& b) {
  double torque = model.roller_torque;
  for (int i = 0; model.bearing && i < 30; ++i) {
    const RollerForces f = forces_with(model, b, sign(model.speed) * torque);
    b.bearing = contact::short_bearing(*model.bearing, model.oils.carrier->viscosity,
                                       std::abs(b.motion.roller_to_carrier),
                                       0.5 * std::hypot(f.carrier_x, f.carrier_y));
    const double before = std::exchange(torque, 2.0 * b.bearing.torque);  // two heads
    if (std::abs(torque - before) <= 1e-15 * torque) break;
  }
  b.carrier_roller_torque = sign(model.speed) * torque;
  b.forces = forces_with(model, b, b.carrier_roller_torque);
}

}  // namespace

bool balance_at(const SlipModel& model, double slip_ratio, SlipBalance& b) {
  b.motion = kinematics(model.geometry, model.speed, slip_ratio);
  for (const Interface i : kInterfaces)
    if (!balance_interface(model, b.motion, i, b.interfaces[i])) return false;
  balance_carrier(model, b);
  b.moments = {};
  for (const Interface i : kInterfaces) {
    b.moments.contacts +=
        moment_z(model.geometry.points[i], model.geometry.centre_distance, b.interfaces[i].force);
    b.moments.spin += b.interfaces[i].spin_torque;
  }
  b.moments.carrier = b.carrier_roller_torque;
  b.moments.gears = (standard(model) ? 1.0 : -1.0) * roller_gear_radius(model) * b.forces.gears_y;
  return true;
}

double relative_residue(const SlipModel& m, const SlipBalance& b) {
  return b.moments.residue() * m.rollers / (m.geometry.centre_distance * std::abs(m.axial_force));
}

SlipEquilibrium find_slip_equilibrium(const SlipModel& model) {
  const SlipRange range = slip_range(model.geometry);
  SlipEquilibrium found;
  // The search parameter t is 0 at the ideal slip ratio and 1 at pure sliding. Where friction alone
  // resists, the moment has the sense of the speed at t = 0 and the root lies at t > 0 (3.45); a
  // carrier that is dragged along can push it to t < 0, at most to where the carrier turns with the
  // driving part.
  const auto slip_ratio = [&](double t) {
    return range.ideal + t * (range.pure_sliding - range.ideal);
  };
  bool balanced = true;
  double residue_there = 0.0;
  const auto residue = [&](double t) {
    ++found.evaluations;
    balanced = balanced && balance_at(model, slip_ratio(t), found.balance);
    residue_there = balanced ? sign(model.speed) * relative_residue(model, found.balance) : 0.0;
    return residue_there;
  };
  const auto end_as = [&](SlipStatus status) {
    found.status = balanced ? status : SlipStatus::jammed;
    return found;
  };

  double near = 0.0, near_residue = residue(near);
  if (std::abs(near_residue) <= kNoMoment) return end_as(SlipStatus::converged);
  const double end = near_residue > 0.0 ? 1.0
                                        : (1.0 - range.pure_sliding - range.ideal) /
                                              (range.pure_sliding - range.ideal);
  double far = std::copysign(2e-3, end), far_residue = residue(far);
  while (balanced && far_residue * near_residue > 0.0 && far != end) {
    near = far, near_residue = far_residue;
    far = std::abs(10.0 * far) < std::abs(end) ? 10.0 * far : end, far_residue = residue(far);
  }
  if (!balanced || far_residue * near_residue > 0.0) return end_as(SlipStatus::no_equilibrium);

  const double width = kSlipTolerance / std::abs(range.pure_sliding - range.ideal);
  const double negligible = width * std::abs((far_residue - near_residue) / (far - near));
  // The last residue belongs to one of the ends: where it is negligible, that end is the root.
  const auto close_enough = [&](double a, double b) {
    return b - a <= width || std::abs(residue_there) <= negligible;
  };
  boost::uintmax_t evaluations = kMostEvaluations;
  const auto [a, b] =
      near < far ? boost::math::tools::toms748_solve(residue, near, far, near_residue, far_residue,
                                                     close_enough, evaluations)
                 : boost::math::tools::toms748_solve(residue, far, near, far_residue, near_residue,
                                                     close_enough, evaluations);
  if (std::abs(residue_there) > negligible) residue(0.5 * (a + b));
  return end_as(evaluations < kMostEvaluations ? SlipStatus::converged
                                               : SlipStatus::iteration_limit);
}

DriveTorques drive_torques(const SlipModel& m, const SlipBalance& b) {
  // What acts on a roller, taken about the screw's axis, acts back on screw and nut.
  const auto about_axis = [&](Interface i) {
    return moment_z(m.geometry.points[i], 0.0, b.interfaces[i].force) + b.interfaces[i].spin_torque;
  };
  const double c = m.geometry.centre_distance, roller_gear = roller_gear_radius(m);
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
  return {standard(m) ? torques.screw * m.speed : -torques.nut * m.speed, m.axial_force * advance};
}

std::optional<double> PowerFlow::efficiency() const {
  if (load < 0.0 && shaft > 0.0) return -load / shaft;
  if (load > 0.0 && shaft < 0.0) return -shaft / load;
  return std::nullopt;
}

}  // namespace prs
