#include "prs/threads/kinematics.h"

#include <cmath>

#include "prs/threads/kinematics_formulas.h"

namespace prs {
namespace {

using Eigen::Vector3d;

bool standard(const KinematicGeometry& g) { return g.type == Mechanism::Type::standard; }

KinematicNumbers<double> numbers_of(const KinematicGeometry& g) {
  const auto plane = [](const Vector3d& p) { return contact::Vector2<double>{p.x(), p.y()}; };
  return {standard(g) ? 1.0 : 0.0,
          g.lead,
          g.gear_ratio,
          g.centre_distance,
          {plane(g.points.screw), plane(g.points.nut)}};
}

Vector3d vector(const contact::Vector3<double>& v) { return {v.x, v.y, v.z}; }

}  // namespace

double against_frame(Mechanism::Type type, double against_nut, double speed) {
  return against_frame_of<double, double>(type == Mechanism::Type::standard, against_nut, speed);
}

double turning_speed(Mechanism::Type type, double speed) {
  const double part = type == Mechanism::Type::standard ? speed : 0.0;  // Against the nut.
  return against_frame(type, part, speed);
}

Kinematics kinematics(const KinematicGeometry& g, double speed, double slip_ratio) {
  const KinematicsOf<double> k = kinematics_of(numbers_of(g), speed, slip_ratio);
  return {k.slip_ratio,     k.screw_to_carrier, k.roller_to_carrier,
          k.nut_to_carrier, k.screw_advance,    k.nut_advance};
}

ContactMotion contact_motion(const KinematicGeometry& g, const Kinematics& k, Interface i) {
  const ContactMotionOf<double> m =
      contact_motion_of<double>(numbers_of(g),
                                {k.slip_ratio, k.screw_to_carrier, k.roller_to_carrier,
                                 k.nut_to_carrier, k.screw_advance, k.nut_advance},
                                i);
  return {vector(m.sliding), vector(m.rolling), m.spin};
}

double ideal_slip_ratio(const KinematicGeometry& g) {
  // The sliding velocity is linear in the slip ratio: v = v_0 + epsilon v'.
  const Interface i = sliding_interface(g.type);
  const Vector3d at_0 = contact_motion(g, kinematics(g, 1.0, 0.0), i).sliding;
  const Vector3d rate = contact_motion(g, kinematics(g, 1.0, 1.0), i).sliding - at_0;
  return -at_0.dot(rate) / rate.squaredNorm();
}

SlipEstimates slip_estimates(const KinematicGeometry& g) {
  const double gamma = g.gear_ratio;
  if (!standard(g)) return {1.0 / (2.0 * (1.0 + gamma)), std::nullopt};
  const Vector3d& on_screw = g.points.screw;
  const Vector3d on_roller = on_screw - g.centre_distance * Vector3d::UnitX();
  const double c = g.centre_distance, k = 1.0 / gamma - 1.0;
  const double jones =
      (c * on_screw.x() - k * on_roller.head<2>().dot(on_screw.head<2>())) /
      (k * k * on_roller.head<2>().squaredNorm() + c * c - 2.0 * c * k * on_roller.x());
  return {(1.0 - 2.0 * gamma) / (2.0 * (1.0 - gamma)), jones};
}

SlipRange slip_range(const KinematicGeometry& g) {
  return {standard(g) ? 0.0 : 1.0, ideal_slip_ratio(g)};
}

double optimality(const SlipRange& range, double slip_ratio) {
  return std::abs(slip_ratio - range.pure_sliding) / std::abs(range.ideal - range.pure_sliding);
}

}  // namespace prs
