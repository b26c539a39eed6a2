#pragma once

#include "contact/journal_bearing.h"
#include "contact/patch_formulas.h"
#include "prs/slip/result/slip_result.h"

/// The balance of one roller (Sandu 2018, section 3.2): formulas for numbers, for batches with one
/// screw per lane, and for either with slopes along the slip ratio.
namespace prs {

/// Directions at the contacts of an interface.
template <class Real>
struct ContactFrameOf {
  contact::Vector3<Real> normal{};      ///< n, outward normal of the roller.
  contact::Vector3<Real> major_axis{};  ///< t_1
  contact::Vector3<Real> minor_axis{};  ///< t_2 = n x t_1
};

/// Friction of a roller's head in its bearing in addition to that of a full film; see `HeadFriction`.
template <class Real>
struct HeadFrictionOf {
  Real touches{};       ///< 1: mixed or coulomb; 0: hydrodynamic.
  Real friction_arm{};  ///< mu d/2 [m]
  Real roughness{}, exponent{};
};

/// One roller and its loads besides the friction of its threads. SI units.
template <class Real>
struct RollerModelOf {
  KinematicGeometryOf<Real> geometry{};  ///< Points of the faces that touch under the force.
  PerInterface<ContactFrameOf<Real>> frames{};
  Real speed{};  ///< omega_s/n [rad/s]
  Real rollers = 1.0;
  // Torques of the carrier, as magnitudes [N m].
  Real screw_torque{};
  Real nut_torque{};
  Real roller_torque{};
  contact::JournalBearingOf<Real> bearing{};  ///< Used in place of `roller_torque` if it has a diameter.
  Real bearing_viscosity{};                   ///< 0 without oil [Pa s]
  HeadFrictionOf<Real> head_friction{};
  Real gear_tangent{};  ///< Tangent of the pressure angle.
  Real roller_mass{};   ///< [kg]

  simd::Lanes<Real> has_bearing() const { return bearing.diameter > Real(0.0); }
};

/// Forces and moment of the threads of an interface on one roller.
template <class Number>
struct InterfaceForces {
  contact::Vector3<Number> force{};
  Number spin_torque{};
  /// Moment along z, about the interface's point, of forces that do not act at that point [N m].
  Number couple = Number(simd::ValueOf<Number>(0.0));
};

/// All forces on one roller at one slip ratio.
template <class Number>
struct RollerBalanceOf {
  KinematicsOf<Number> motion{};
  PerInterface<contact::PatchMotionOf<Number>> sliding{};
  PerInterface<InterfaceForces<Number>> interfaces{};
  RollerForcesOf<Number> forces{};
  RollerMomentsOf<Number> moments{};
  contact::JournalBearingStateOf<Number> bearing{};
  Number carrier_roller_torque{};  ///< C_P/R on the roller, signed [N m]
};
using RollerBalance = RollerBalanceOf<double>;

/// Sliding, as a share of the rolling speed, that is rounding of a contact without slip.
inline constexpr double kNoSlip = 1e-12;

template <class Number, class Real>
Number dot(const contact::Vector3<Number>& a, const contact::Vector3<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Number, class Real>
contact::PatchMotionOf<Number> patch_motion(const ContactFrameOf<Real>& frame, const ContactMotionOf<Number>& motion) {
  using simd::max, simd::select, simd::sqrt, simd::value;
  const Number u_n = dot(motion.rolling, frame.normal);
  const Number u_1 = dot(motion.rolling, frame.major_axis);
  const Number rolling = dot(motion.rolling, motion.rolling);
  const Number sliding = dot(motion.sliding, motion.sliding);
  const auto slides = value(sliding) > kNoSlip * kNoSlip * value(rolling);
  const Number none(Real(0.0)), tangential = rolling - u_n * u_n;
  const auto rolls = value(tangential) > Real(0.0);
  return {select(slides, dot(motion.sliding, frame.major_axis), none),
          select(slides, dot(motion.sliding, frame.minor_axis), none), motion.spin * frame.normal.z,
          select(rolls, sqrt(tangential), none), select(rolls, Number(u_1 * u_1 / tangential), none)};
}

/// Normal load of a patch and its forces on the roller, with its friction.
template <class Number>
struct PatchForces {
  Number normal_load{};
  InterfaceForces<Number> on_roller{};
};

/// Direction of the force on the roller, m = n - T/N (3.5).
template <class Number, class Real>
contact::Vector3<Number> turned_normal(const ContactFrameOf<Real>& frame,
                                       const contact::PatchFrictionOf<Number>& friction) {
  const auto &n = frame.normal, &t_1 = frame.major_axis, &t_2 = frame.minor_axis;
  const Number &f_1 = friction.traction_major, &f_2 = friction.traction_minor;
  return {n.x - f_1 * t_1.x - f_2 * t_2.x, n.y - f_1 * t_1.y - f_2 * t_2.y, n.z - f_1 * t_1.z - f_2 * t_2.z};
}

/// Forces of all the threads `alike` that the patch represents, from the normal load of each.
template <class Number, class Real>
PatchForces<Number> forces_of(const ContactFrameOf<Real>& frame, const contact::PatchFrictionOf<Number>& friction,
                              const contact::Vector3<Number>& m, const Number& normal_load, const Real& alike) {
  const Number all = normal_load * alike;
  return {normal_load, {{-(all * m.x), -(all * m.y), -(all * m.z)}, all * friction.spin_arm * frame.normal.z}};
}

/// Forces of a patch under its axial load, which gives the dynamic normal load (3.11), (3.12).
template <class Number, class Real>
PatchForces<Number> patch_forces(const ContactFrameOf<Real>& frame, const contact::PatchFrictionOf<Number>& friction,
                                 const Real& axial_load, const Real& alike) {
  using simd::copysign;
  const contact::Vector3<Number> m = turned_normal<Number, Real>(frame, friction);
  return forces_of(frame, friction, m, Number(axial_load / (m.z * copysign(Real(1.0), frame.normal.z))), alike);
}

/// Whether a normal load exists: friction can exceed a contact's capacity, and numbers overflow.
template <class Number>
auto is_possible(const Number& normal_load) {
  using Real = simd::ValueOf<Number>;
  const Real load = simd::value(normal_load);
  return load >= Real(0.0) && load - load == Real(0.0);
}

/// Operating pitch radius of the roller's gear [m].
template <class Real>
Real roller_gear_radius(const KinematicGeometryOf<Real>& g) {
  using simd::select;
  const Real& gamma = g.gear_ratio;
  return g.centre_distance * gamma / select(g.carrier_on_nut(), Real(1.0 - gamma), Real(1.0 + gamma));
}

/// Gears and carrier for a torque of the carrier on the roller, signed [N m].
template <class Number, class Real>
RollerForcesOf<Number> forces_with(const RollerModelOf<Real>& m, const RollerBalanceOf<Number>& b,
                                   const Number& roller_torque) {
  using simd::abs, simd::copysign, simd::select;
  const Real& c = m.geometry.centre_distance;
  const Number orbit_speed = against_frame(m.geometry.carrier_on_nut(), Number(b.motion.slip_ratio * m.speed),
                                           m.speed);  // Speed of omega_p/n.
  const Real carrier_torque = copysign(Real(1.0), m.speed) * (m.nut_torque - m.screw_torque);
  RollerForcesOf<Number> f;
  f.contacts_x = b.interfaces.screw.force.x + b.interfaces.nut.force.x;
  f.contacts_y = b.interfaces.screw.force.y + b.interfaces.nut.force.y;
  f.centrifugal = m.roller_mass * c * orbit_speed * orbit_speed;
  f.carrier_y = (m.rollers * roller_torque + carrier_torque) / (c * m.rollers);
  f.gears_y = f.carrier_y - f.contacts_y;
  f.gears_x = select(m.geometry.carrier_on_nut(), Real(-1.0), Real(1.0)) * abs(f.gears_y) * m.gear_tangent;
  f.carrier_x = f.gears_x + f.contacts_x + f.centrifugal;
  return f;
}

/// M_h and the eccentricity of a head at a speed under the load F_h,
///
///     M_h = (1 - s) M_hydrodynamic + s mu F_h d/2,
///     s = (1 + radial_clearance (1 - eccentricity)/roughness)^-exponent,
///
/// s = 0 for a full film and s = 1 without oil.
template <class Number, class Real>
contact::JournalBearingStateOf<Number> head_state(const RollerModelOf<Real>& m, const Number& speed,
                                                  const Number& load) {
  using simd::any, simd::select;
  const HeadFrictionOf<Real>& h = m.head_friction;
  const auto oiled = m.bearing_viscosity > Real(0.0), touches = h.touches > Real(0.0);
  const Number none(Real(0.0));
  contact::JournalBearingStateOf<Number> film{none, none};
  if (any(oiled)) film = contact::short_bearing(m.bearing, m.bearing_viscosity, speed, load);
  if (!any(touches)) return film;
  const Number dry = h.friction_arm * load;
  const Number ratio = m.bearing.radial_clearance * (1.0 - film.eccentricity_ratio) / h.roughness;
  const Number share = contact::boundary_share(ratio, h.exponent);
  const Number mixed = (1.0 - share) * film.torque + share * dry;
  return {select(oiled, film.eccentricity_ratio, none), select(touches, select(oiled, mixed, dry), film.torque)};
}

/// Both heads of a roller, each under half of the carrier's force.
template <class Number, class Real>
contact::JournalBearingStateOf<Number> equal_heads(const RollerModelOf<Real>& m, const RollerForcesOf<Number>& f,
                                                   const Number& speed) {
  const Number load(0.5 * simd::length(f.carrier_x, f.carrier_y));
  const auto state = head_state(m, speed, load);
  return {state.eccentricity_ratio, 2.0 * state.torque};
}

/// Balance in which the bearings' torque depends on their loads and, slightly, the loads on the torque. `heads(m,
/// forces, speed)`: torque of both heads and the larger eccentricity.
template <class Number, class Real, class Heads>
void balance_carrier(const RollerModelOf<Real>& m, RollerBalanceOf<Number>& b, Heads heads) {
  using simd::abs, simd::any, simd::copysign, simd::select, simd::value;
  const Real sense = copysign(Real(1.0), m.speed);
  Number torque(m.roller_torque);
  auto active = m.has_bearing();
  for (int i = 0; i < 30 && any(active); ++i) {
    const RollerForcesOf<Number> f = forces_with(m, b, Number(sense * torque));
    const contact::JournalBearingStateOf<Number> state = heads(m, f, b.motion.roller_to_carrier);
    const Real before = value(torque);
    b.bearing.eccentricity_ratio = select(active, state.eccentricity_ratio, b.bearing.eccentricity_ratio);
    b.bearing.torque = select(active, state.torque, b.bearing.torque);
    torque = select(active, state.torque, torque);
    active = active && abs(value(torque) - before) > 1e-15 * value(torque);
  }
  b.carrier_roller_torque = sense * torque;
  b.forces = forces_with(m, b, b.carrier_roller_torque);
}

/// Moment of a force about an axis along z through `axis_x` on the x axis.
template <class Number, class Real>
Number moment_z(const contact::Vector2<Real>& point, const Real& axis_x, const contact::Vector3<Number>& force) {
  return (point.x - axis_x) * force.y - point.y * force.x;
}

/// Balances all except the moment about the roller's axis, see `balance_at`. `spin`: see `kinematics`.
/// `forces_at(i, sliding)`: `InterfaceForces` of the threads of an interface. `heads`: see `balance_carrier`.
template <class Number, class Real, class Forces, class Heads>
RollerBalanceOf<Number> roller_balance(const RollerModelOf<Real>& m, const Number& slip_ratio, const Number& spin,
                                       Forces forces_at, Heads heads) {
  using simd::select;
  RollerBalanceOf<Number> b;
  b.motion = kinematics(m.geometry, m.speed, slip_ratio, spin);
  b.moments.contacts = b.moments.spin = Number(Real(0.0));
  for (const Interface i : kInterfaces) {
    b.sliding[i] = patch_motion(m.frames[i], contact_motion(m.geometry, b.motion, i));
    b.interfaces[i] = forces_at(i, b.sliding[i]);
    b.moments.contacts +=
        moment_z(m.geometry.points[i], m.geometry.centre_distance, b.interfaces[i].force) + b.interfaces[i].couple;
    b.moments.spin += b.interfaces[i].spin_torque;
  }
  b.bearing = {Number(Real(0.0)), Number(Real(0.0))};
  balance_carrier(m, b, heads);
  b.moments.carrier = b.carrier_roller_torque;
  b.moments.gears =
      select(m.geometry.carrier_on_nut(), Real(1.0), Real(-1.0)) * roller_gear_radius(m.geometry) * b.forces.gears_y;
  return b;
}

}  // namespace prs
