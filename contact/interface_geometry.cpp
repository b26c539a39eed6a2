#include "contact/interface_geometry.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace contact {

namespace {

/// Unit tangent of the helix through a point of a thread, towards growing theta.
Eigen::Vector3d helix_tangent(const ThreadSurface& surface, const Eigen::Vector2d& from_axis) {
  return Eigen::Vector3d(-from_axis.y(), from_axis.x(), surface.reduced_lead).normalized();
}

}  // namespace

Eigen::Vector3d InterfaceGeometry::direction(double angle) const {
  return std::cos(angle) * helix_tangent + std::sin(angle) * point.normal.cross(helix_tangent);
}

double InterfaceGeometry::first_directions_angle() const {
  return std::abs(std::remainder(body.angle - roller.angle, std::numbers::pi));
}

InterfaceGeometry interface_geometry(const ThreadPair& pair, RollerFace face) {
  InterfaceGeometry g;
  g.point = find_contact_point(pair, face);
  if (!g.ok()) return g;

  const Eigen::Vector2d on_body = g.point.position;
  const Eigen::Vector2d on_roller = on_body - Eigen::Vector2d(pair.centre_distance, 0.0);
  const Eigen::Vector3d& n = g.point.normal;
  const Eigen::Vector3d body_tangent = helix_tangent(pair.body, on_body);
  g.helix_tangent = helix_tangent(pair.roller, on_roller);

  // Both tensors in the frame (roller's helix tangent, n x it). A screw's own frame is seen from
  // its other side here, since its normal is -n; the air in a nut has the roller's normal.
  const double turn =
      std::atan2(n.dot(g.helix_tangent.cross(body_tangent)), g.helix_tangent.dot(body_tangent));
  const SymmetricTensor of_roller = curvature_tensor(pair.roller, g.point.radius_on_roller);
  const SymmetricTensor in_own_frame = curvature_tensor(pair.body, g.point.radius_on_body);
  const SymmetricTensor of_body =
      in_turned_axes(pair.body.side > 0.0 ? mirrored(in_own_frame) : in_own_frame, -turn);

  g.body = principal_by_magnitude(of_body);
  g.roller = principal_by_magnitude(of_roller);
  g.relative = principal_ascending(of_body + of_roller);
  g.major_axis = g.direction(g.relative.angle);
  g.minor_axis = n.cross(g.major_axis);
  return g;
}

FlankViolations ellipse_beyond_flanks(const ThreadPair& pair, const InterfaceGeometry& interface,
                                      double semi_major, double semi_minor) {
  FlankViolations violations;
  const Eigen::Vector2d on_body = interface.point.position;
  const Eigen::Vector2d on_roller = on_body - Eigen::Vector2d(pair.centre_distance, 0.0);
  const auto add = [&](const ThreadSurface& surface, bool of_roller, const Eigen::Vector2d& point) {
    const double radius = point.norm();
    const Eigen::Vector2d outwards = point / radius;
    const double reach = std::hypot(semi_major * interface.major_axis.head<2>().dot(outwards),
                                    semi_minor * interface.minor_axis.head<2>().dot(outwards));
    violations.add(surface, of_roller, radius - reach, radius + reach);
  };
  add(pair.body, false, on_body);
  add(pair.roller, true, on_roller);
  return violations;
}

InterfaceGeometry on_other_faces(const InterfaceGeometry& interface) {
  // A half turn about x, (x, y, z) -> (x, -y, -z), then all tangents reversed, so that the one of
  // the helix points to growing theta again. Angles about the normal stay.
  const auto turned = [](const Eigen::Vector3d& tangent) {
    return Eigen::Vector3d(-tangent.x(), tangent.y(), tangent.z());
  };
  InterfaceGeometry other = interface;
  other.point = on_other_faces(interface.point);
  other.helix_tangent = turned(interface.helix_tangent);
  other.major_axis = turned(interface.major_axis);
  other.minor_axis = turned(interface.minor_axis);
  return other;
}

}  // namespace contact
