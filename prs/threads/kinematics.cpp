#include "prs/threads/kinematics.h"

#include <cmath>
#include <numbers>

namespace prs {
namespace {

using Eigen::Vector3d;

/// Velocity of a point of a part that turns about the z axis through `axis` and moves along it.
Vector3d velocity(double rotation, double advance, const Vector3d& from_axis) {
  return {-rotation * from_axis.y(), rotation * from_axis.x(), advance};
}

bool standard(const KinematicGeometry& g) { return g.type == Mechanism::Type::standard; }

}  // namespace

Kinematics kinematics(const KinematicGeometry& g, double speed, double slip_ratio) {
  const double advance = -g.lead / (2.0 * std::numbers::pi) * speed;  // of the nut on the screw
  Kinematics k;
  k.slip_ratio = slip_ratio;
  k.screw_to_carrier = (1.0 - slip_ratio) * speed;
  k.nut_to_carrier = -slip_ratio * speed;
  k.roller_to_carrier = -(standard(g) ? slip_ratio : 1.0 - slip_ratio) / g.gear_ratio * speed;
  (standard(g) ? k.screw_advance : k.nut_advance) = standard(g) ? -advance : advance;
  return k;
}

ContactMotion contact_motion(const KinematicGeometry& g, const Kinematics& k, Interface i) {
  const bool at_screw = i == Interface::screw;
  const double body_rotation = at_screw ? k.screw_to_carrier : k.nut_to_carrier;
  const double body_advance = at_screw ? k.screw_advance : k.nut_advance;
  const Vector3d& point = g.points[i];
  const Vector3d body = velocity(body_rotation, body_advance, point);
  const Vector3d roller =
      velocity(k.roller_to_carrier, 0.0, point - g.centre_distance * Vector3d::UnitX());
  return {body - roller, body + roller, body_rotation - k.roller_to_carrier};
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
