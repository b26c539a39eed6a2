#include "contact/interface_geometry.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "contact/flank_edge.h"

namespace contact {

namespace {

/// Unit tangent of the helix through a point of a thread, towards growing theta.
Eigen::Vector3d helix_tangent(const ThreadSurface& surface, const Eigen::Vector2d& from_axis) {
  return Eigen::Vector3d(-from_axis.y(), from_axis.x(), surface.reduced_lead).normalized();
}

/// The contact point as one of the two flanks sees it.
struct FlankSpot {
  const ThreadSurface* surface;
  bool of_roller;
  double radius;             ///< From the axis of its part [m].
  Eigen::Vector2d outwards;  ///< Unit vector.
};

std::array<FlankSpot, 2> spots_on_flanks(const ThreadPair& pair, const InterfaceGeometry& g) {
  const Eigen::Vector2d on_body = g.point.position;
  const Eigen::Vector2d on_roller = on_body - Eigen::Vector2d(pair.centre_distance, 0.0);
  return {{{&pair.body, false, on_body.norm(), on_body.normalized()},
           {&pair.roller, true, on_roller.norm(), on_roller.normalized()}}};
}

/// Largest radial distance of the ellipse's points from its centre, in the tangent plane [m].
double radial_reach(const InterfaceGeometry& g, const FlankSpot& spot, double semi_major,
                    double semi_minor) {
  return std::hypot(semi_major * g.major_axis.head<2>().dot(spot.outwards),
                    semi_minor * g.minor_axis.head<2>().dot(spot.outwards));
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
  for (const FlankSpot& spot : spots_on_flanks(pair, interface)) {
    const double reach = radial_reach(interface, spot, semi_major, semi_minor);
    violations.add(*spot.surface, spot.of_roller, spot.radius - reach, spot.radius + reach);
  }
  return violations;
}

FlankEdge nearest_flank_edge(const ThreadPair& pair, const InterfaceGeometry& interface,
                             double semi_major, double semi_minor) {
  FlankEdge nearest{.scale = std::numeric_limits<double>::infinity()};
  for (const FlankSpot& spot : spots_on_flanks(pair, interface)) {
    const double reach = radial_reach(interface, spot, semi_major, semi_minor);
    const bool internal = spot.surface->side < 0.0;
    const double inwards = (spot.radius - spot.surface->smallest_radius) / reach;
    const double outwards = (spot.surface->largest_radius - spot.radius) / reach;
    if (inwards < nearest.scale)
      nearest = {spot.of_roller, internal ? FlankEnd::crest : FlankEnd::root, inwards};
    if (outwards < nearest.scale)
      nearest = {spot.of_roller, internal ? FlankEnd::root : FlankEnd::crest, outwards};
  }
  return nearest;
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
